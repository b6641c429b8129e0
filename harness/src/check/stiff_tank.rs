//! `stiff-tank`: a column collapses and sloshes for 5 s. Its speed of sound is 20 times the fastest flow, and the time
//! step is adaptive (Pirovano, section 2.3.5; Roy, section 3.3, step 5).
use super::flow::{fluid, larger};
use super::{Context, Metric, Outcome};
use crate::failure::Failure;
use crate::fluid::start;
use crate::outcome::table;
use crate::output::progress;
use crate::scenes::{Changes, load};
use millpond_core::OwnedMemory;
use millpond_core::Solver;
use millpond_core::scene::WallShape;

const NAME: &str = "stiff-tank";

/// Share of the time that a quick study runs: to the first splash.
const QUICK_SHARE: f64 = 0.1;

/// Required limits: speed of sound over the fastest flow, and mean density error.
const STIFFNESS: f64 = 20.0;
const DENSITY_LIMIT: f64 = 0.01;

/// Limit of the rise of energy, over that at the start. Energy may only be lost, apart from rounding.
const ENERGY_LIMIT: f64 = 1e-3;

/// Relative rounding error of a ratio of two time steps in f32.
const ROUNDING: f64 = 1e-6;

/// Samples of density, speed and energy per simulated second.
const SAMPLES_PER_SECOND: f64 = 200.0;

pub(super) fn run(context: &Context) -> Result<Outcome, Failure> {
    let named = load(NAME, &Changes::default())?;
    let scene = &named.checked()?;
    let end = named.file.duration * if context.quick { QUICK_SHARE } else { 1.0 };
    let reject_ratio = scene.adaptive.and_then(|adaptive| adaptive.reject_ratio).map_or(f64::INFINITY, f64::from);
    let mut heap = OwnedMemory::of(scene);
    let mut solver = start(NAME, scene, &mut heap)?;
    let before = energy(&solver);
    let (mut mean, mut fastest, mut gained, mut overrun) = (0.0f64, 0.0f64, 0.0f64, 0.0f64);
    let (mut shortest, mut longest) = (f32::INFINITY, 0.0f32);
    let bar = progress(NAME, (end * SAMPLES_PER_SECOND) as u64);
    let mut sample = 0.0;
    while solver.time() < end {
        solver.step(&context.pool)?;
        let clock = solver.time_report();
        overrun = larger(overrun, f64::from(clock.time_step) / f64::from(clock.wanted));
        (shortest, longest) = (shortest.min(clock.time_step), longest.max(clock.time_step));
        if clock.time * SAMPLES_PER_SECOND >= sample {
            sample += 1.0;
            mean = larger(mean, solver.density_error().mean);
            let speed = |fastest, x: &millpond_core::Particle| larger(fastest, f64::from(x.velocity.length()));
            fastest = larger(fastest, fluid(&solver).iter().fold(0.0, speed));
            gained = larger(gained, (energy(&solver) - before) / before);
            bar.set_position(sample as u64);
        }
    }
    bar.finish_and_clear();
    let outside = fluid(&solver).iter().filter(|particle| !is_inside(scene, particle.position.to_array())).count();
    let figures = vec![
        Metric::above(
            "speed of sound over the fastest flow",
            f64::from(scene.fluids[0].speed_of_sound) / fastest,
            STIFFNESS,
        ),
        Metric::below("largest mean density error", mean, DENSITY_LIMIT),
        Metric::below("largest rise of energy, over that at the start", gained, ENERGY_LIMIT),
        Metric::below("particles outside of the tank", outside as f64, 0.0),
        Metric::below("largest step over the one that its end state allows", overrun, reject_ratio * (1.0 + ROUNDING)),
        Metric::below("steps held at the smallest step", f64::from(solver.time_report().clamped_steps), 0.0),
    ];
    let rows = [
        ["steps".into(), format!("{} in {:.3} s", solver.steps(), solver.time())],
        ["time step".into(), format!("{shortest:.2e} to {longest:.2e} s")],
        ["rejected steps".into(), solver.time_report().rejected_steps.to_string()],
        ["fastest flow".into(), format!("{fastest:.2} m/s")],
    ];
    Ok(Outcome::new(NAME, figures, vec![table(["quantity", "value"], rows)]))
}

/// Returns the sum of kinetic and potential energy, J/m.
fn energy(solver: &Solver<'_>) -> f64 {
    let energies = solver.energies();
    energies.kinetic + energies.potential
}

/// Returns whether a position is between the walls; an open side is no limit.
fn is_inside(scene: &millpond_core::scene::Scene, x: [f32; 3]) -> bool {
    scene.walls.iter().all(|wall| match &wall.shape {
        WallShape::Box { low, high, open } => millpond_core::scene::Face::ALL.iter().all(|face| {
            let axis = face.axis();
            let beyond = if face.is_high() { x[axis] > high[axis] } else { x[axis] < low[axis] };
            axis >= scene.dimension.count() || open.contains(face) || !beyond
        }),
        WallShape::Plane { .. } => true,
    })
}
