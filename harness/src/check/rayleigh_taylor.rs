//! `rayleigh-taylor`: case M2, the set-up of Grenier et al. 2009. A heavy fluid lies over a light one, and a ripple of
//! their interface grows with a known rate while it is small. A second run shows buoyancy, which drives the
//! instability: a drop of oil rises through water.
//!
//! The usual formula for the rate is that of irrotational flow, less the effect of viscosity on this flow: 1.165 1/s.
//! But two viscous fluids do not slide past each other as in irrotational flow. If velocities and stresses are
//! continuous across the interface, linear theory gives 1.050 1/s (Chandrasekhar 1961, chapter 10; see `ripple`). The
//! particles are compared with this rate. The table also has the errors against the usual formula.
use super::flow::{checked, fluid, grid, mean, start_with, step, steps_to};
use super::formulas::SEVERAL_FLUIDS;
use super::reference::{entry, number, rows};
use super::ripple::{DENSITIES, DEPTH, GRAVITY, Mode, NU, WAVE_NUMBER, formula};
use super::{Context, Metric, Outcome};
use crate::failure::Failure;
use crate::outcome::table;
use glam::Vec3;
use millpond_core::OwnedMemory;
use millpond_core::backend::derive::support_radius;
use millpond_core::scene::{
    Block, DensityForm, Dimension, Face, Fluid, Formulation, InitialParticle, Kernel, Periodic, PressureForce, Scene,
    Wall, WallPressure, WallShape,
};
use millpond_core::{Checked, Particle, Solver};

const NAME: &str = "rayleigh-taylor";

/// Speed of sound of the light fluid, m/s: ten times `sqrt(2 g)`. The heavy fluid is as hard to compress.
const SPEED_OF_SOUND: f64 = 14.0;

/// Share of the support radius that sound travels in a step.
const COURANT: f64 = 0.2;

/// Particles along a wavelength, fine and coarse.
const FINE: u16 = 100;
const COARSE: u16 = 50;

/// Amplitude of the ripple at the start, m, and number of parts in which particles are displaced, so that volume is
/// conserved.
const AMPLITUDE: f64 = 0.01;
const PARTS: u16 = 20;

/// The rate is fitted from this time on, s, while the amplitude is below this share of `1 / k`. It is larger at the end
/// of the run.
const SETTLED: f64 = 0.1;
const SMALL: f64 = 0.3;
const END: f64 = 1.6;
const STEPS_PER_SAMPLE: u64 = 5;

/// Required limit: 10 % of the rate, with 100 particles along a wavelength.
const LIMIT: f64 = 0.10;

/// Limit for the formula against the reference table, which has six digits.
const FORMULA_LIMIT: f64 = 1e-5;

/// Kernel of all sums, and number of neighbours. A lattice under a pressure P resists shear as if it had a shear
/// modulus. With these values it is 0.1 % of P. With the usual 32 neighbours and Wendland's C2 it is -2 % of P, and the
/// ripple then grows too fast, at 1.35 1/s (`millpond check kernels` prints the table).
const KERNEL: Kernel = Kernel::WendlandC4;
const NEIGHBOURS: f32 = 64.0;

type Form = (DensityForm, PressureForce);

/// Compared forms; the first one has the limit.
const FORMS: [Form; 5] = [
    (DensityForm::SummationAdapted, PressureForce::DensityWeighted),
    (DensityForm::ContinuityAdapted, PressureForce::DensityWeighted),
    (DensityForm::SummationAdapted, PressureForce::MonaghanAdapted),
    (DensityForm::Summation, PressureForce::Monaghan),
    (DensityForm::Continuity, PressureForce::Monaghan),
];

/// The drop of oil: densities of water and oil, kg/m3; dynamic viscosity of both, Pa s; size of the closed tank, centre
/// and radius of the drop, m.
const WATER: f32 = 1000.0;
const OIL: f32 = 600.0;
const OIL_VISCOSITY: f32 = 0.5;
const TANK: [f32; 2] = [0.6, 1.0];
const CENTRE: [f32; 2] = [0.3, 0.3];
const RADIUS: f32 = 0.1;

/// Spacing, m, which divides the tank evenly; speed of sound of water, m/s, ten times `sqrt(g H)`.
const OIL_SPACING: f32 = 0.02;
const WATER_SOUND: f32 = 10.0;

/// End of the run, s, and the interval near its start in which the acceleration is measured, s. Sound has then crossed
/// the tank.
const RISE_END: f64 = 6.0;
const STARTING: [f64; 2] = [0.1, 0.4];

/// Least rise of the oil's centroid, in radii of the drop; there is room for six.
const RISE: f64 = 2.0;

pub(super) fn run(context: &Context) -> Result<Outcome, Failure> {
    let mode = Mode::growing(NU);
    let across = if context.quick { COARSE } else { FINE };
    let judged = growth(context, across, FORMS[0], &mode)?;
    let name = format!("error of the growth rate, {across} particles along a wave, {}", FORMS[0].0.name());
    let mut figures = vec![
        Metric::below("formula against the reference table", formula_error()?, FORMULA_LIMIT),
        Metric::below(name, (judged / mode.rate - 1.0).abs(), LIMIT),
    ];
    let mut lines = vec![line(across, FORMS[0], &mode, &Ok(judged))];
    if !context.quick {
        for form in FORMS {
            lines.push(line(COARSE, form, &mode, &growth(context, COARSE, form, &mode)));
        }
    }
    let titles = ["along a wave", "density, pressure force", "rate, 1/s", "error", "error against the usual formula"];
    let note = format!(
        "Linear theory: {:.4} 1/s between viscous fluids, {:.4} 1/s by the usual formula, {:.4} 1/s without \
         viscosity. Fitted from {SETTLED} s on, while k a < {SMALL}.",
        mode.rate,
        formula(NU),
        formula(0.0)
    );
    let (risen, words) = rise(context)?;
    figures.push(Metric::above("rise of the oil through water, over its radius", risen, RISE));
    Ok(Outcome::new(NAME, figures, vec![note, table(titles, lines), words]))
}

fn line(across: u16, form: Form, mode: &Mode, rate: &Result<f64, Failure>) -> [String; 5] {
    let off = |rate: f64, exact: f64| format!("{:+.1} %", (rate / exact - 1.0) * 100.0);
    let [words, exact, by_formula] = match rate {
        Ok(rate) => [format!("{rate:.4}"), off(*rate, mode.rate), off(*rate, formula(NU))],
        Err(failure) => [failure.to_string(), String::new(), String::new()],
    };
    [across.to_string(), format!("{}, {}", form.0.name(), form.1.name()), words, exact, by_formula]
}

/// Returns the largest relative error of the formula against the first two rows of the reference table, with viscosity
/// and without.
fn formula_error() -> Result<f64, Failure> {
    let mut worst = 0.0f64;
    let table = rows(include_str!("../../data/rayleigh-taylor.csv"));
    for (row, nu) in table.zip([NU, 0.0]) {
        let expected = number(entry(&row, 3)?)?;
        worst = worst.max((formula(nu) / expected - 1.0).abs());
    }
    Ok(worst)
}

fn scene(across: u16, (density, pressure_force): Form) -> Scene {
    let fluid = |i: usize| Fluid {
        rest_density: DENSITIES[i] as f32,
        speed_of_sound: (SPEED_OF_SOUND * (DENSITIES[0] / DENSITIES[i]).sqrt()) as f32,
        dynamic_viscosity: (NU * DENSITIES[i]) as f32,
        ..Fluid::default()
    };
    let depth = DEPTH as f32;
    let below = Block { size: Vec3::new(1.0, depth, 0.0), ..Block::default() };
    let above = Block { fluid: 1, corner: Vec3::new(0.0, depth, 0.0), ..below };
    let mut scene = Scene::of(Dimension::Two, 1.0 / f32::from(across), 1.0, fluid(0), below);
    scene.fluids.extend([fluid(1)]);
    scene.blocks = [below, above].into_iter().collect();
    scene.average_neighbours = Some(NEIGHBOURS);
    scene.time_step = (COURANT * support_radius(&scene) / SPEED_OF_SOUND) as f32;
    scene.gravity = Vec3::new(0.0, -GRAVITY as f32, 0.0);
    scene.periodic =
        Some(Periodic { low: Vec3::ZERO, high: Vec3::new(1.0, 2.0 * depth, 0.0), axes: [true, false, false] });
    let wall = |fluid: u32, face, y| {
        let shape = WallShape::Plane { face, low: Vec3::new(0.0, y, 0.0), high: Vec3::new(1.0, y, 0.0) };
        Wall { fluid, ..Wall::still(shape) }
    };
    scene.walls = [wall(0, Face::Floor, 0.0), wall(1, Face::Ceiling, 2.0 * depth)].into_iter().collect();
    scene.model = model((density, pressure_force));
    scene.grid = grid(Dimension::Two, 64);
    scene
}

/// Returns the model. The pressure that carries the weight is there from the start, so that no sound disturbs the
/// ripple.
fn model((density, pressure_force): Form) -> Formulation {
    Formulation {
        density,
        pressure_force,
        density_kernel: KERNEL,
        pressure_kernel: KERNEL,
        viscosity_kernel: KERNEL,
        initialize_hydrostatic: true,
        normalize_mass: true,
        ..SEVERAL_FLUIDS
    }
}

/// Returns the lattice, displaced by the mode and with the velocities of the mode. Masses and densities are those of
/// the flat fluids.
fn rippled(scene: &Checked<'_>, mode: &Mode) -> Vec<InitialParticle> {
    let fluid = scene.derived().fluid_particles;
    let moved = |place: InitialParticle| {
        let (own, [x, y, _]) = (usize::from(place.material == 1), place.position.to_array().map(f64::from));
        let mut at = [x, y];
        for _ in 0..PARTS {
            let by = mode.displacement(at, own).map(|by| by * AMPLITUDE / f64::from(PARTS));
            at = [at[0] + by[0], at[1] + by[1]];
        }
        let [u, v] = mode.displacement(at, own).map(|by| (by * AMPLITUDE * mode.rate) as f32);
        InitialParticle {
            position: [at[0].rem_euclid(1.0) as f32, at[1] as f32, 0.0].into(),
            velocity: Vec3::new(u, v, 0.0),
            ..place
        }
    };
    scene.initial_particles().enumerate().map(|(i, place)| if i < fluid { moved(place) } else { place }).collect()
}

/// Returns the growth rate of the ripple, 1/s.
fn growth(context: &Context, across: u16, form: Form, mode: &Mode) -> Result<f64, Failure> {
    let scene = scene(across, form);
    let scene = checked(NAME, &scene)?;
    let mut heap = OwnedMemory::of(&scene);
    let mut solver = start_with(NAME, &scene, rippled(&scene, mode), &mut heap)?;
    let (mut samples, mut small) = (Vec::new(), true);
    let title = format!("{NAME} {across} {}", form.0.name());
    step(&title, context, &mut solver, steps_to(&scene, END), STEPS_PER_SAMPLE, |solver| {
        let amplitude = amplitude(solver, usize::from(across));
        // once the amplitude is too large, or NaN, later samples are ignored too
        small = small && amplitude * WAVE_NUMBER < SMALL;
        if small && solver.time() >= SETTLED {
            samples.push([solver.time(), amplitude.ln()]);
        }
    })?;
    Ok(slope(&samples))
}

/// Returns the amplitude of the ripple, m: the sine component of the two rows at the interface, over the positions at
/// which their particles started. The mean height of the rows does not contribute.
fn amplitude(solver: &Solver<'_>, across: usize) -> f64 {
    let rows = solver.particles().skip(across * (across - 1)).take(2 * across);
    let part = |(i, particle): (usize, Particle)| {
        let x = ((i % across) as f64 + 0.5) / across as f64;
        2.0 * f64::from(particle.position.y) * (WAVE_NUMBER * x).sin()
    };
    let parts: Vec<f64> = rows.enumerate().map(part).collect();
    mean(&parts, |part| *part)
}

/// Returns the slope of the line of best fit.
fn slope(points: &[[f64; 2]]) -> f64 {
    let centre = [0, 1].map(|i| mean(points, |point| point[i]));
    let product = |i: usize, j: usize| mean(points, |point| (point[i] - centre[i]) * (point[j] - centre[j]));
    product(0, 1) / product(0, 0)
}

/// Returns how far a drop of oil rises in water, in radii, and a sentence that compares its initial acceleration with
/// `g (r1 - r2) / (r2 + C r1)`. The added mass coefficient C is 1: a cylinder carries as much water along as it
/// displaces.
fn rise(context: &Context) -> Result<(f64, String), Failure> {
    let scene = oil_in_water();
    // All particles start as water, and those in the circle become oil. At equal pressure both are compressed by as
    // much.
    let centre = CENTRE;
    let relabelled = |place: InitialParticle| {
        let [x, y, _] = place.position.to_array();
        let inside = (x - centre[0]).hypot(y - centre[1]) < RADIUS;
        if inside { InitialParticle { material: 1, ..place } } else { place }
    };
    let scene = checked(NAME, &scene)?;
    let start = scene.initial_particles().enumerate();
    let count = scene.derived().fluid_particles;
    let start = start.map(|(i, place)| if i < count { relabelled(place) } else { place }).collect();
    let mut heap = OwnedMemory::of(&scene);
    let mut solver = start_with(NAME, &scene, start, &mut heap)?;
    let before = oil(&solver)[0];
    let mut speeds = Vec::new();
    let steps = steps_to(&scene, RISE_END);
    step("oil in water", context, &mut solver, steps, STEPS_PER_SAMPLE, |solver| {
        if solver.time() >= STARTING[0] && solver.time() <= STARTING[1] {
            speeds.push([solver.time(), oil(solver)[1]]);
        }
    })?;
    let risen = (oil(&solver)[0] - before) / f64::from(RADIUS);
    let [heavy, light] = [WATER, OIL].map(f64::from);
    let words = format!(
        "Oil of {light} kg/m3 in water rose by {risen:.2} radii in {RISE_END} s. Its acceleration at the start was \
         {:.3} m/s2; that of a cylinder in unbounded water without viscosity is {:.3} m/s2.",
        slope(&speeds),
        GRAVITY * (heavy - light) / (light + heavy)
    );
    Ok((risen, words))
}

fn oil_in_water() -> Scene {
    let water = Fluid {
        rest_density: WATER,
        speed_of_sound: WATER_SOUND,
        dynamic_viscosity: OIL_VISCOSITY,
        ..Fluid::default()
    };
    let oil = Fluid { rest_density: OIL, speed_of_sound: WATER_SOUND * (WATER / OIL).sqrt(), ..water };
    let [width, height] = TANK;
    let block = Block { size: Vec3::new(width, height, 0.0), ..Block::default() };
    let mut scene = Scene::of(Dimension::Two, OIL_SPACING, 1.0, water, block);
    scene.fluids.extend([oil]);
    scene.average_neighbours = Some(NEIGHBOURS);
    scene.time_step = (COURANT * support_radius(&scene) / f64::from(oil.speed_of_sound)) as f32;
    scene.gravity = Vec3::new(0.0, -GRAVITY as f32, 0.0);
    let tank = WallShape::Box { low: Vec3::ZERO, high: Vec3::new(width, height, 0.0), open: [].into_iter().collect() };
    scene.walls = [Wall::still(tank)].into_iter().collect();
    // mirrored walls would supply energy to fluid that moves along them
    scene.model = Formulation { negative_pressure: false, wall_pressure: WallPressure::Dynamic, ..model(FORMS[0]) };
    scene.grid = grid(Dimension::Two, 32);
    scene
}

/// Returns the mean height of the oil, m, and its mean upward velocity, m/s.
fn oil(solver: &Solver<'_>) -> [f64; 2] {
    let mut oil = fluid(solver);
    oil.retain(|particle| particle.fluid == 1);
    [mean(&oil, |p| f64::from(p.position.y)), mean(&oil, |p| f64::from(p.velocity.y))]
}
