//! `emission`: what emitters make, and the ledger of particles that come and go.
//!
//! A jet flies through empty space. The mass that has left the opening follows from its size, the speed and the time,
//! to the layer. Then particles are made and taken away again many times: the ledger must be exact after every step, and
//! the generations of all ids must add up to the particles that were made.
use super::flow::{checked, start_with};
use super::{Context, Metric, Outcome};
use crate::failure::Failure;
use crate::fluid::device_if_any;
use crate::outcome::table;
use glam::Vec3;
use millpond_core::scene::{AdaptiveTimeStep, Block, Dimension, Drain, Emitter, Fluid, Opening, Scene};
use millpond_core::{Census, OwnedMemory};
use millpond_gpu::GpuSolver;

const NAME: &str = "emission";

const SPACING: f32 = 0.02;
const SPEED: f32 = 3.0;
const SOUND: f32 = 30.0;
const TIME_STEP: f32 = 1.7e-4;

/// Simulated time of the jets, s.
const TIME: f64 = 1.003;

/// Particles that are made in the test of the ledger, in a full and in a quick study. The full number is required.
const MADE: u64 = 100_000;
const QUICK_MADE: u64 = 10_000;

/// Life of particles in the test of the ledger, s, and the step after which the ledger of a GPU is compared.
const LIFE: f32 = 0.03;
const STEPS_ON_DEVICE: u32 = 2000;

/// Returns a jet through empty space, far from a block of fluid.
fn jet(dimension: Dimension, opening: f32, spares: u32) -> Scene {
    let block = Block { corner: Vec3::new(-9.0, 0.0, 0.0), size: Vec3::splat(2.0 * SPACING), ..Block::default() };
    let mut scene =
        Scene::of(dimension, SPACING, TIME_STEP, Fluid { speed_of_sound: SOUND, ..Fluid::default() }, block);
    scene.emitters = [Emitter::jet(Vec3::ZERO, Vec3::X, SPEED, Opening::Square(opening))].into_iter().collect();
    scene.spare_particles = spares;
    let layers = if dimension == Dimension::Three { 16 } else { 1 };
    scene.grid.cells = [128, 32, layers];
    scene
}

/// Returns the particles that a jet has made after [`TIME`], and those that should have left its opening.
fn made(context: &Context, scene: &Scene, points: f64) -> Result<[f64; 2], Failure> {
    let checked = checked(NAME, scene)?;
    let mut heap = OwnedMemory::of(&checked);
    let mut solver = start_with(NAME, &checked, checked.initial_particles().collect(), &mut heap)?;
    while solver.time() < TIME {
        solver.step(&context.pool)?;
    }
    // the first layer leaves at the start
    let layers = (1.0 + solver.time() * f64::from(SPEED) / f64::from(SPACING)).floor();
    Ok([solver.census().flux.born as f64, layers * points])
}

/// Result of the test of the ledger.
struct Ledger {
    made: u64,
    steps: u64,
    /// Steps after which the ledger did not agree with the particles.
    wrong: u64,
    /// Sum of the generations of all ids.
    generations: u64,
    /// Whether a GPU has the same ledger; `None` without one.
    device: Option<bool>,
}

fn ledger(context: &Context) -> Result<Ledger, Failure> {
    let least = if context.quick { QUICK_MADE } else { MADE };
    let mut scene = jet(Dimension::Two, 0.4, 200);
    scene.emitters[0].life = Some(LIFE);
    // a half of the jet never comes to the end of its life
    scene.drains =
        [Drain::Box { low: Vec3::new(0.04, 0.0, 0.0), high: Vec3::new(0.1, 0.3, 0.0) }].into_iter().collect();
    let checked = checked(NAME, &scene)?;
    let mut heap = OwnedMemory::of(&checked);
    let mut solver = start_with(NAME, &checked, checked.initial_particles().collect(), &mut heap)?;
    let mut device = match device_if_any()? {
        Some(gpu) => Some(GpuSolver::new(&gpu, &solver)?),
        None => None,
    };
    let start = i64::from(solver.census().active);
    let (mut wrong, mut same) = (0, None);
    while solver.census().flux.born < least {
        solver.step(&context.pool)?;
        let Census { active, flux } = solver.census();
        wrong += u64::from(i64::from(active) != start + flux.born as i64 - flux.removed as i64);
        let is_time = solver.steps() == u64::from(STEPS_ON_DEVICE);
        if let Some(device) = device.as_mut().filter(|_| is_time) {
            device.step(STEPS_ON_DEVICE)?;
            same = Some(device.census()? == solver.census());
        }
    }
    let ids = 0..solver.slots().len() as u32;
    let generations = ids.filter_map(|id| solver.generation(id)).map(u64::from).sum();
    Ok(Ledger { made: solver.census().flux.born, steps: solver.steps(), wrong, generations, device: same })
}

pub(super) fn run(context: &Context) -> Result<Outcome, Failure> {
    let adaptive = AdaptiveTimeStep { largest: 5e-4, ..AdaptiveTimeStep::default() };
    let cases = [
        ("one particle wide, 2D", Dimension::Two, SPACING, 1.0, None),
        ("one particle wide, 2D, adaptive time step", Dimension::Two, SPACING, 1.0, Some(adaptive)),
        ("ten particles wide, 2D", Dimension::Two, 10.0 * SPACING, 10.0, None),
        ("four by four particles, 3D", Dimension::Three, 4.0 * SPACING, 16.0, None),
    ];
    let (mut figures, mut lines) = (Vec::new(), Vec::new());
    for (name, dimension, opening, points, adaptive) in cases {
        let mut scene = jet(dimension, opening, (200.0 * points) as u32);
        scene.adaptive = adaptive;
        let [made, due] = made(context, &scene, points)?;
        figures.push(Metric::below(
            format!("{name}: layers made, off those that have left"),
            (made - due).abs() / points,
            0.0,
        ));
        lines.push([name.to_owned(), format!("{made:.0}"), format!("{due:.0}")]);
    }
    let Ledger { made, steps, wrong, generations, device } = ledger(context)?;
    figures.push(Metric::below(format!("of {steps} steps, those with a wrong ledger"), wrong as f64, 0.0));
    let off = (generations as f64 - made as f64).abs();
    figures.push(Metric::below(format!("generations of all ids, off the {made} particles that were made"), off, 0.0));
    let mut notes = vec![table(["jet", "particles made", "particles that have left"], lines)];
    match device {
        Some(same) => figures.push(Metric::below("ledgers of a GPU that differ", f64::from(u8::from(!same)), 0.0)),
        None => notes.push("There is no GPU here: only the ledger of the CPU was checked.".into()),
    }
    Ok(Outcome::new(NAME, figures, notes))
}
