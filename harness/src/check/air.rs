//! `air`: effect of a layer of air particles on the spurious surface tension of a free surface (Pirovano,
//! section 3.4.2; the set-up is Pirovano test 1 in two dimensions). The outermost row of a liquid lacks half of its
//! neighbours, so its summed density is too low and its pressure negative, and this error pulls the drop together.
//! Pirovano proposes to surround the liquid with air particles, and to count them with density forms that are adapted
//! to density contrasts.
//!
//! The study evolves a square drop at rest, without gravity and without a model of surface tension. Limits are set only
//! for what is certain of soft air (air that is easy to compress): the density error of the outermost row becomes
//! smaller, each exposed particle gets an air particle, no spawn request is refused, and the drop moves less. All other
//! results, and those of other kinds of air, are reported without limits.
use super::flow::{checked, fluid, grid, larger, mean, rms_speed, start_with, step, steps_to};
use super::formulas::SEVERAL_FLUIDS;
use super::{Context, Metric, Outcome};
use crate::failure::Failure;
use crate::outcome::table;
use glam::Vec3;
use millpond_core::OwnedMemory;
use millpond_core::scene::{Air, Block, DensityForm, Dimension, Fluid, Formulation, PressureForce, Scene};
use millpond_core::{AirReport, Particle, SceneError, Solver};

const NAME: &str = "air";

/// Particles along an edge, and particle spacing, m.
const EDGE: u16 = 20;
const SPACING: f32 = 0.05;

/// Rest density, kg/m3, speed of sound, m/s, and dynamic viscosity, Pa s, of the water.
const WATER: f32 = 1000.0;
const SOUND: f32 = 10.0;
const VISCOSITY: f32 = 2.0;

/// Time step, s. At the highest speed of sound in the air, sound travels 0.1 support radii in a step.
const TIME_STEP: f32 = 0.0005;
const END: f64 = 1.0;
const QUICK_END: f64 = 0.5;
const STEPS_PER_SAMPLE: u64 = 20;

/// Steps after which the air layer has been created and counted once, while nothing has moved yet.
const FIRST: u64 = 2;

/// Rows next to the surface that are excluded from the mean pressure inside the drop.
const MARGIN: usize = 5;

/// Capacity for air: air particles for each particle of the drop's outermost row.
const ROOM: u32 = 4;

/// Share of its rest density below which an air particle vanishes; an isolated row has 0.47 of it.
const MINIMUM: f32 = 0.4;

/// Air: how many times lighter than water it is, its speed of sound, m/s, and the threshold of the normal above which a
/// particle is exposed. It has the dynamic viscosity of water.
#[derive(Clone, Copy, Debug)]
struct Coat {
    ratio: f32,
    sound: f32,
    threshold: f32,
}

/// Speeds of sound of the air, m/s. At a density ratio of 10 the first makes it as stiff as the water (equal
/// `rho c^2`), and the second a thousand times less stiff.
const HARD: f32 = 31.623;
const SOFT: f32 = 1.0;

/// Compared cases. The first two have no air. The third has the limits, relative to the second.
const CASES: [(DensityForm, Option<Coat>); 8] = [
    (DensityForm::Summation, None),
    (DensityForm::SummationAdapted, None),
    coated(10.0, SOFT, 1.2),
    coated(10.0, SOFT, 1.0),
    coated(10.0, SOFT, 0.5),
    coated(1.0, SOFT, 1.2),
    coated(100.0, SOFT, 1.2),
    coated(10.0, HARD, 1.2),
];

const fn coated(ratio: f32, sound: f32, threshold: f32) -> (DensityForm, Option<Coat>) {
    (DensityForm::SummationAdapted, Some(Coat { ratio, sound, threshold }))
}

/// Conclusions, printed below the table.
const NOTE: &str = "With air the outermost row counts nearly all of the neighbours that it should have, and with \
    soft air and a threshold of about 1 the drop is calmer. Air does not remove the error: the air layer has a free \
    surface too, with the same low density, and air is still created long after the first steps. With a threshold \
    below that of a surface with one row of air, or with air as stiff as the water, air is created until none is left.";

/// Results of a run.
#[derive(Clone, Copy, Debug)]
struct Drop {
    /// Mean density of the outermost row over rest density, less 1, at the start.
    row: f64,
    /// Mean pressure inside the drop in the second half of the run, Pa.
    pressure: f64,
    /// [`roundness`] at start and end.
    roundness: [f64; 2],
    /// Largest rms speed of the water, m/s.
    speed: f64,
    /// Air particles after the first steps.
    first: AirReport,
    /// Air particles at the end.
    last: AirReport,
}

pub(super) fn run(context: &Context) -> Result<Outcome, Failure> {
    let drops = CASES.map(|case| evolve(context, case));
    let lines: Vec<_> = CASES.iter().zip(&drops).map(|(case, drop)| line(*case, drop.as_ref())).collect();
    let [_, bare, coated, ..] = drops;
    let (bare, coated) = (bare?, coated?);
    let face = f64::from(4 * (EDGE - 1));
    let figures = vec![
        Metric::below("density error of the outermost row, with air over without", (coated.row / bare.row).abs(), 1.0),
        Metric::above(
            "air particles created at first, over particles of the outermost row",
            f64::from(coated.first.active) / face,
            1.0,
        ),
        Metric::below("largest rms speed, with air over without", coated.speed / bare.speed, 1.0),
        Metric::below("spawn requests of air refused", coated.last.refused as f64, 0.0),
    ];
    let titles = [
        "density",
        "air: density ratio, speed of sound in m/s, threshold",
        "density error of the outermost row",
        "pressure inside, Pa",
        "extent along diagonals over axes",
        "largest rms speed, m/s",
        "air particles at first, at last, refused",
    ];
    Ok(Outcome::new(NAME, figures, vec![table(titles, lines), NOTE.into()]))
}

fn line((density, coat): (DensityForm, Option<Coat>), drop: Result<&Drop, &Failure>) -> [String; 7] {
    let air = coat.map_or("none".into(), |c| format!("{}, {:.0}, {}", c.ratio, c.sound, c.threshold));
    let rest = match drop {
        Ok(drop) => [
            format!("{:.1} %", drop.row * 100.0),
            format!("{:.0}", drop.pressure),
            format!("{:.3} to {:.3}", drop.roundness[0], drop.roundness[1]),
            format!("{:.3}", drop.speed),
            format!("{}, {}, {}", drop.first.active, drop.last.active, drop.last.refused),
        ],
        Err(failure) => [failure.to_string(), String::new(), String::new(), String::new(), String::new()],
    };
    let [row, pressure, round, speed, air_count] = rest;
    [density.name().into(), air, row, pressure, round, speed, air_count]
}

fn scene((density, coat): (DensityForm, Option<Coat>)) -> Result<Scene, SceneError> {
    let edge = f32::from(EDGE) * SPACING;
    let water = Fluid { rest_density: WATER, speed_of_sound: SOUND, dynamic_viscosity: VISCOSITY, ..Fluid::default() };
    let block = Block { corner: Vec3::new(-edge / 2.0, -edge / 2.0, 0.0), size: Vec3::splat(edge), ..Block::default() };
    let mut scene = Scene::of(Dimension::Two, SPACING, TIME_STEP, water, block);
    scene.model = Formulation { density, ..SEVERAL_FLUIDS };
    if density == DensityForm::Summation {
        scene.model.pressure_force = PressureForce::Monaghan;
    }
    scene.model.normalize_mass = true;
    scene.grid = grid(Dimension::Two, 16);
    if let Some(Coat { ratio, sound, threshold }) = coat {
        let (rest_density, dynamic_viscosity) = (WATER / ratio, VISCOSITY);
        let air = Fluid { rest_density, speed_of_sound: sound, dynamic_viscosity, ..Fluid::default() };
        let fluid = scene.add_fluid(air)?;
        let capacity = ROOM * 4 * u32::from(EDGE);
        scene.air = Some(Air { fluid, capacity, threshold, minimum_density: MINIMUM });
    }
    Ok(scene)
}

fn evolve(context: &Context, case: (DensityForm, Option<Coat>)) -> Result<Drop, Failure> {
    let scene = scene(case).map_err(|error| Failure::Scene { origin: NAME.into(), error })?;
    let scene = checked(NAME, &scene)?;
    let mut heap = OwnedMemory::of(&scene);
    let mut solver = start_with(NAME, &scene, scene.initial_particles().collect(), &mut heap)?;
    let before = roundness(&water(&solver));
    let title = format!("{NAME} {}", case.0.name());
    step(&title, context, &mut solver, FIRST, FIRST, |_| ())?;
    let off = |p: &Particle| f64::from(p.density) / f64::from(WATER) - 1.0;
    let row = mean(&part(&solver, 0, 1), off);
    let first = solver.air();
    let end = if context.quick { QUICK_END } else { END };
    let (mut speed, mut pressures) = (0.0, Vec::new());
    step(&title, context, &mut solver, steps_to(&scene, end) - FIRST, STEPS_PER_SAMPLE, |solver| {
        speed = larger(speed, rms_speed(solver));
        if solver.time() > end / 2.0 {
            pressures.push(mean(&part(solver, MARGIN, usize::from(EDGE)), |p| f64::from(p.pressure)));
        }
    })?;
    Ok(Drop {
        row,
        pressure: mean(&pressures, |pressure| *pressure),
        roundness: [before, roundness(&water(&solver))],
        speed,
        first,
        last: solver.air(),
    })
}

/// Returns the drop's particles, in the order of the lattice.
fn water(solver: &Solver<'_>) -> Vec<Particle> {
    fluid(solver).into_iter().filter(|particle| particle.fluid == 0).collect()
}

/// Returns the drop's particles that started at least `from` and less than `to` rows away from the nearest side of the
/// square.
fn part(solver: &Solver<'_>, from: usize, to: usize) -> Vec<Particle> {
    let edge = usize::from(EDGE);
    let depth = |id: usize| [id % edge, id / edge].map(|i| i.min(edge - 1 - i)).into_iter().min().unwrap_or(0);
    water(solver).into_iter().filter(|p| (from..to).contains(&depth(p.id as usize))).collect()
}

/// Returns the extent of the particles from their centre along the diagonals of a square, divided by that along its
/// axes: 1.41 for a square, 1 for a circle.
fn roundness(particles: &[Particle]) -> f64 {
    let of = |axis: usize| mean(particles, |particle| f64::from(particle.position[axis]));
    let centre = [of(0), of(1)];
    let reach = |turn: f64| {
        let (y, x) = turn.sin_cos();
        let along =
            |p: &Particle| x * (f64::from(p.position[0]) - centre[0]) + y * (f64::from(p.position[1]) - centre[1]);
        particles.iter().map(along).fold(0.0, f64::max)
    };
    let quarter = std::f64::consts::FRAC_PI_2;
    let [axes, diagonals] =
        [0.0, 0.5].map(|first| (0..4).map(|i| reach((f64::from(i) + first) * quarter)).sum::<f64>());
    diagonals / axes
}
