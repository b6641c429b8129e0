//! `pressure-correction`: the pressure correction of Pirovano, section 3.2.2. A column of water at its real speed of
//! sound, 1500 m/s, must be stable with the time step of an equation of state at 30 m/s. That step is fifty times as
//! long as the one that an equation of state at 1500 m/s would allow.
use super::column::{Column, Profile, REGULAR};
use super::enclosure::Enclosure;
use super::flow::{checked, start_with, step, steps_to};
use super::formulas::ROWS_STAY;
use super::{Context, Metric, Outcome};
use crate::failure::Failure;
use crate::outcome::table;
use glam::Vec3;
use millpond_core::OwnedMemory;
use millpond_core::scene::{Correction, PressureForce, PressureSolver, Wind};

const NAME: &str = "pressure-correction";

/// Speeds of sound, m/s: of water, and of the equation of state whose time step is used.
const SPEED_OF_SOUND: f32 = 1500.0;
const TAIT_SPEED: f64 = 30.0;

/// Share of the support radius that sound at 30 m/s travels in a step; at 1500 m/s it travels 12 support radii.
const COURANT: f64 = 0.25;

/// Spacing, m, in a full and in a quick study; width and depth of the column, m; gravity, m/s2.
const SPACING: f32 = 0.025;
const QUICK_SPACING: f32 = 0.05;
const WIDTH: f32 = 0.5;
const DEPTH: f32 = 0.9;
const GRAVITY: f32 = 9.81;

/// Dynamic viscosity of a thin oil, Pa s, and drag of the air, 1/s. They damp the sloshing that the start excites.
const VISCOSITY: f32 = 1.0;
const DRAG: f32 = 5.0;

/// Time from which the water counts as settled, and end of the run, s.
const SETTLED: f64 = 1.0;
const END: f64 = 2.0;
const STEPS_PER_SAMPLE: u64 = 5;

/// Required limit: density error below 1 %.
const LIMIT: f64 = 0.01;

/// Limit of the loss of mean height. A column that its pressure does not carry collapses into itself; a loss of 1 % is
/// what 1 % of density allows.
const SINKING: f64 = 0.01;

pub(super) fn run(context: &Context) -> Result<Outcome, Failure> {
    let column = Column {
        walls: Enclosure::MIRRORED,
        spacing: if context.quick { QUICK_SPACING } else { SPACING },
        width: WIDTH,
        depth: DEPTH,
        gravity: GRAVITY,
        speed_of_sound: SPEED_OF_SOUND,
        courant: COURANT * f64::from(SPEED_OF_SOUND) / TAIT_SPEED,
        // Particles do not pair with this kernel. An iteration that may do so fills a volume with pairs, which have a
        // smaller density sum.
        model: REGULAR,
        neighbours: ROWS_STAY,
        jitter: 0.0,
    };
    let mut scene = column.scene();
    scene.fluids[0].dynamic_viscosity = VISCOSITY;
    scene.model.pressure_solver = PressureSolver::PressureCorrection;
    scene.model.pressure_force = PressureForce::Monaghan;
    scene.model.initialize_hydrostatic = true;
    scene.wind = Some(Wind { velocity: Vec3::ZERO, drag: DRAG });
    let Correction { iteration, iterations, tolerance } = scene.model.correction;

    let scene = checked(NAME, &scene)?;
    let mut heap = OwnedMemory::of(&scene);
    let mut solver = start_with(NAME, &scene, scene.initial_particles().collect(), &mut heap)?;
    let start = Column::mean_height(&solver);
    let (mut profile, mut mean, mut largest, mut residual) = (Profile::default(), 0.0f64, 0.0f64, 0.0f32);
    step(NAME, context, &mut solver, steps_to(&scene, END), STEPS_PER_SAMPLE, |solver| {
        if solver.time() > SETTLED {
            let error = solver.density_error();
            (mean, largest) = (mean.max(error.mean), largest.max(error.max));
            residual = residual.max(solver.correction().residual);
            profile.add(solver);
        }
    })?;
    let sunk = (1.0 - Column::mean_height(&solver) / start).abs();
    let used = solver.correction().total_iterations as f64 / solver.steps() as f64;
    let miss = profile.miss(&column);
    let figures = vec![
        Metric::below("mean compression", mean, LIMIT),
        Metric::below("largest compression", largest, LIMIT),
        Metric::below("relative loss of mean height", sunk, SINKING),
        Metric::below("iterations per step", used, f64::from(iterations)),
    ];
    let travelled = f64::from(SPEED_OF_SOUND) * f64::from(scene.time_step) / f64::from(column.spacing);
    let rows = [
        ["time step".into(), format!("{:.2e} s: sound travels {travelled:.0} spacings", scene.time_step)],
        ["iteration".into(), format!("{iteration:?}, {iterations} at most, to {tolerance}")],
        ["iterations per step".into(), format!("{used:.1}")],
        ["largest density error left".into(), format!("{:.3} %", residual * 100.0)],
        ["pressure, largest error of a layer".into(), format!("{:.2} % of rho g H", miss.largest * 100.0)],
        ["pressure, rms error over the layers".into(), format!("{:.2} % of rho g H", miss.rms * 100.0)],
    ];
    Ok(Outcome::new(NAME, figures, vec![table(["quantity", "value"], rows)]))
}
