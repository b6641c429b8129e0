//! `other-forms`: formulas that no other study holds to a reference: a wind, buoyancy, a gas, the viscosities other
//! than that of Morris et al., the pressure forces, XSPH and a variable support.
use super::cases::{Case, sliding_wall, standing_wave, tank_settles};
use super::enclosure::Enclosure;
use super::flow::{checked, fluid, grid, larger, mean, start_with, step, steps_to};
use super::form::Form;
use super::{Context, Metric, Outcome};
use crate::failure::Failure;
use crate::outcome::table;
use glam::Vec3;
use millpond_core::OwnedMemory;
use millpond_core::scene::{
    Block, Container, DensityDiffusion, Dimension, EquationOfState, Fluid, Formulation, Kernel, PressureForce, Recipe,
    Scene, SupportRange, Viscosity, Wind,
};

const NAME: &str = "other-forms";

/// A block in empty space: its speed after a time is known exactly. Gravity, m/s2, density of the medium over that of
/// the block, drag of the wind, 1/s, its speed, m/s, and the time, s.
const GRAVITY: f32 = 10.0;
const MEDIUM: f32 = 0.25;
const DRAG: f32 = 2.0;
const WIND: f32 = 3.0;
const TIME: f64 = 0.5;

/// Limits of the relative error of a speed. The drag k is that of the speed half a step before, which makes an error of
/// `k dt / 2` times `k t / (exp(k t) - 1)`, 5.8e-4 with steps of 1 ms. Gravity is constant: the rounding of 500 sums.
const WIND_SPEED: f64 = 6e-4;
const SPEED: f64 = 5e-5;

/// A gas in a closed box: speed of sound over `sqrt(g H)`, spacing in a full and in a quick study, m, and required
/// limit of the error of a layer's density, over that at the floor. The error is that of the walls, which continue the
/// pressure linearly, and of first order: 2.65 and 1.46 %.
const GAS_SOUND: f32 = 1.0;
const SPACING: f32 = 0.02;
const QUICK_SPACING: f32 = 0.04;
const GAS: f64 = 0.02;
const GAS_TIME: f64 = 2.0;
const LAYERS: f32 = 10.0;
const QUICK_GAS: f64 = GAS * (QUICK_SPACING / SPACING) as f64;

/// Formulas that are tried on a case, and reported.
type Trial = (&'static str, Case, Form);

pub(super) fn run(context: &Context) -> Result<Outcome, Failure> {
    let gas_limit = if context.quick { QUICK_GAS } else { GAS };
    let figures = vec![
        Metric::below("speed of a block in a wind, relative error", blown(context)?, WIND_SPEED),
        Metric::below("speed of a block that falls through a medium, relative error", sunk(context)?, SPEED),
        Metric::below(
            "density of a layer of gas, off exp(-g y / c^2), over that at the floor",
            gas(context)?,
            gas_limit,
        ),
    ];
    let notes = if context.quick { Vec::new() } else { vec![reported(context)] };
    Ok(Outcome::new(NAME, figures, notes))
}

/// Runs the formulas that have no limit. Returns the table of their errors.
fn reported(context: &Context) -> String {
    let mut lines = Vec::new();
    for (name, case, form) in trials() {
        let result = match case.error_of(context, &form) {
            Ok(error) if error.is_nan() => "no result".into(),
            Ok(error) if case.limit < 1.0 => format!("{:.2} %", error * 100.0),
            Ok(error) => format!("{error:.2}"),
            Err(failure) => failure.to_string(),
        };
        lines.push([name.to_owned(), case.name.to_owned(), case.error.to_owned(), result]);
    }
    table(["formula", "case", "error", "result"], lines)
}

/// Returns the formulas that are reported.
fn trials() -> Vec<Trial> {
    let (water, viscous) = (Formulation::of(Recipe::FreeSurface), Formulation::of(Recipe::Viscous));
    let closed = |model| Form { walls: Enclosure::CLOSED_FORM, model };
    let mirrored = |model| Form { walls: Enclosure::MIRRORED, model };
    let rubbing = |name, viscosity, model: Formulation| -> Trial {
        (name, sliding_wall(), mirrored(Formulation { viscosity, ..model }))
    };
    let pressing =
        |name, pressure_force| -> Trial { (name, tank_settles(), closed(Formulation { pressure_force, ..water })) };
    let laplacian = Formulation { viscosity_kernel: Kernel::Viscosity, ..viscous };
    let adapted = Formulation { pressure_force: PressureForce::MonaghanAdapted, ..laplacian };
    vec![
        rubbing("viscosity Morris", Viscosity::Morris, viscous),
        rubbing("viscosity Mueller", Viscosity::Mueller, laplacian),
        rubbing("viscosity MuellerAdapted", Viscosity::MuellerAdapted, adapted),
        rubbing("viscosity MonaghanGingold", Viscosity::MonaghanGingold, viscous),
        rubbing("viscosity MorrisAndArtificial", Viscosity::MorrisAndArtificial, viscous),
        pressing("pressure_force Monaghan", PressureForce::Monaghan),
        pressing("pressure_force Mueller", PressureForce::Mueller),
        pressing("pressure_force Canonical", PressureForce::Canonical),
        pressing("pressure_force Difference", PressureForce::Difference),
        pressing("pressure_force MuellerAdapted", PressureForce::MuellerAdapted),
        pressing("pressure_force MonaghanAdapted", PressureForce::MonaghanAdapted),
        pressing("pressure_force DensityWeighted", PressureForce::DensityWeighted),
        ("xsph 0", standing_wave(), closed(water)),
        ("xsph 0.5", standing_wave(), closed(Formulation { xsph: 0.5, ..water })),
        ("variable_support 0.8 to 1.2", tank_settles(), closed(varying(water))),
        ("variable_support 0.8 to 1.2", standing_wave(), closed(varying(water))),
    ]
}

fn varying(model: Formulation) -> Formulation {
    Formulation { variable_support: Some(SupportRange { smallest: 0.8, largest: 1.2 }), ..model }
}

/// Returns a block of fluid in empty space, in two dimensions.
fn block(gravity: f32) -> Scene {
    let block = Block { size: Vec3::new(0.5, 0.5, 0.0), ..Block::default() };
    let mut scene = Scene::of(Dimension::Two, 0.05, 0.001, Fluid::default(), block);
    scene.gravity = Vec3::new(0.0, -gravity, 0.0);
    scene.model = Formulation {
        // it assumes that the weight is carried, which a falling block does not do
        density_diffusion: DensityDiffusion::Off,
        ..scene.model
    };
    scene.grid = grid(Dimension::Two, 32);
    scene
}

/// Returns the relative error of the mean velocity at the end, along an axis. The particles of the block act on each
/// other too, but their forces cancel in the mean.
fn off(context: &Context, scene: &Scene, axis: usize, exact: f64) -> Result<f64, Failure> {
    let scene = checked(NAME, scene)?;
    let mut heap = OwnedMemory::of(&scene);
    let mut solver = start_with(NAME, &scene, scene.initial_particles().collect(), &mut heap)?;
    let steps = steps_to(&scene, TIME);
    step(NAME, context, &mut solver, steps, steps, |_| ())?;
    Ok((mean(&fluid(&solver), |p| f64::from(p.velocity[axis])) / exact - 1.0).abs())
}

fn blown(context: &Context) -> Result<f64, Failure> {
    let mut scene = block(0.0);
    scene.wind = Some(Wind { velocity: Vec3::new(WIND, 0.0, 0.0), drag: DRAG });
    off(context, &scene, 0, f64::from(WIND) * (1.0 - (-f64::from(DRAG) * TIME).exp()))
}

fn sunk(context: &Context) -> Result<f64, Failure> {
    let mut scene = block(GRAVITY);
    scene.ambient_density = MEDIUM * scene.fluids[0].rest_density;
    off(context, &scene, 1, -f64::from(GRAVITY) * f64::from(1.0 - MEDIUM) * TIME)
}

/// Lets a gas settle in a closed box. Returns the largest error of the density of a layer, over that at the floor.
fn gas(context: &Context) -> Result<f64, Failure> {
    let spacing = if context.quick { QUICK_SPACING } else { SPACING };
    let sound = GAS_SOUND * GRAVITY.sqrt();
    let gas = Fluid { rest_density: 1.0, speed_of_sound: sound, ..Fluid::default() };
    let mut scene = Scene::of(
        Dimension::Two,
        spacing,
        spacing / 20.0,
        gas,
        Block { size: Vec3::new(0.4, 1.0, 0.0), jitter: 0.1, ..Block::default() },
    );
    scene.gravity = Vec3::new(0.0, -GRAVITY, 0.0);
    scene.container = Some(Container::closed(Vec3::ZERO, Vec3::new(0.4, 1.0, 0.0)));
    scene.model = Formulation {
        equation_of_state: EquationOfState::IdealGas,
        // the hydrostatic one is for liquids, whose density hardly changes with the depth
        density_diffusion: DensityDiffusion::Off,
        alpha: 0.1,
        ..Formulation::of(Recipe::FreeSurface)
    };
    scene.wind = Some(Wind { velocity: Vec3::ZERO, drag: 5.0 });
    scene.grid = grid(Dimension::Two, 32);
    let scene = checked(NAME, &scene)?;
    let mut heap = OwnedMemory::of(&scene);
    let mut solver = start_with(NAME, &scene, scene.initial_particles().collect(), &mut heap)?;
    let steps = steps_to(&scene, GAS_TIME);
    step(NAME, context, &mut solver, steps, steps, |_| ())?;
    // the mass of a metre of depth is 0.4 kg, of a column 1 kg/m2: the density at the floor is k / (1 - exp(-k H))
    let k = f64::from(GRAVITY / (sound * sound));
    let floor = k / (1.0 - (-k).exp());
    let mut layers = [(0.0, 0.0, 0.0); LAYERS as usize];
    for p in fluid(&solver) {
        if let Some((height, density, count)) = layers.get_mut((p.position.y * LAYERS) as usize) {
            *height += f64::from(p.position.y);
            *density += f64::from(p.density);
            *count += 1.0;
        }
    }
    let of = |(height, density, count): &(f64, f64, f64)| density / count / floor - (-k * height / count).exp();
    Ok(layers.iter().map(|layer| of(layer).abs()).fold(0.0, larger))
}
