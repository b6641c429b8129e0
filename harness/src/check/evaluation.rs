//! Tabulated kernels (Pirovano, section 4.2.3) against kernels by formula: the difference that they make in one step,
//! and their cost. Part of the study `kernels`.
use super::flow::{checked, fluid, grid, mean, start_with};
use super::formulas::{PIROVANO, WENDLAND};
use super::{Context, Metric};
use crate::failure::Failure;
use crate::outcome::table;
use crate::output::progress;
use crate::timing::{Milliseconds, timed};
use glam::Vec3;
use millpond_core::OwnedMemory;
use millpond_core::Particle;
use millpond_core::scene::{Block, Dimension, Evaluation, Fluid, Formulation, Scene};

/// Particles along an edge of a cube, in a full and in a quick study; spacing, m; random displacement in spacings, so
/// that there are pairs at all distances; time step, s.
const EDGE: u16 = 16;
const QUICK_EDGE: u16 = 8;
const SPACING: f32 = 0.05;
const JITTER: f32 = 0.4;
const TIME_STEP: f32 = 0.001;

/// Number of timed steps.
const STEPS: u32 = 20;

/// Limits of our own choice, for the relative errors of density and velocity. A table of a thousand linear segments has
/// an error of about 1e-6 of a kernel. The relative error of a velocity is larger, since the forces of about thirty
/// neighbours nearly cancel.
const DENSITY_LIMIT: f64 = 1e-4;
const VELOCITY_LIMIT: f64 = 1e-3;

/// A way to evaluate kernels, and its results.
struct Evaluated {
    evaluation: Evaluation,
    /// Particles after one step.
    particles: Vec<Particle>,
    times: Milliseconds,
}

/// Returns the figures of both kinds of table, for Pirovano's kernels and for Wendland's, and a table of all results.
///
/// # Errors
/// A scene cannot start, or a step fails.
pub(super) fn figures(context: &Context) -> Result<(Vec<Metric>, String), Failure> {
    let models = [("Pirovano's", PIROVANO), ("Wendland's", WENDLAND)];
    let mut figures = Vec::new();
    let mut lines = Vec::new();
    let bar = progress("kernels, tabulated", 3 * models.len() as u64);
    for (name, model) in models {
        let mut ways = Vec::new();
        for evaluation in [Evaluation::Direct, Evaluation::Table, Evaluation::SquaredTable] {
            ways.push(way(context, Formulation { evaluation, ..model })?);
            bar.inc(1);
        }
        let Some((direct, tables)) = ways.split_first() else { continue };
        let time = |times: Milliseconds| format!("{:.2}, {:.2}", times.min, times.median);
        let nothing = || "-".to_owned();
        lines.push([name.into(), format!("{:?}", direct.evaluation), nothing(), nothing(), time(direct.times)]);
        for way in tables {
            let [density, velocity] = apart(&direct.particles, &way.particles);
            let what = format!("{name} kernels, {:?}", way.evaluation);
            figures.push(Metric::below(format!("density error, {what}"), density, DENSITY_LIMIT));
            figures.push(Metric::below(format!("velocity error, {what}"), velocity, VELOCITY_LIMIT));
            let [density, velocity] = [density, velocity].map(|x| format!("{x:.1e}"));
            lines.push([name.into(), format!("{:?}", way.evaluation), density, velocity, time(way.times)]);
        }
    }
    bar.finish_and_clear();
    let titles = ["kernels", "evaluation", "density error", "velocity error over rms speed", "ms a step, min, median"];
    Ok((figures, table(titles, lines)))
}

fn way(context: &Context, model: Formulation) -> Result<Evaluated, Failure> {
    let edge = f32::from(if context.quick { QUICK_EDGE } else { EDGE }) * SPACING;
    let water = Fluid { dynamic_viscosity: 1.0, ..Fluid::default() };
    let block = Block { size: Vec3::splat(edge), jitter: JITTER, ..Block::default() };
    let mut scene = Scene::of(Dimension::Three, SPACING, TIME_STEP, water, block);
    scene.model = model;
    scene.grid = grid(Dimension::Three, 16);
    let scene = checked("kernels", &scene)?;
    let mut heap = OwnedMemory::of(&scene);
    let mut solver = start_with("kernels", &scene, scene.initial_particles().collect(), &mut heap)?;
    solver.step(&context.pool)?;
    let particles = fluid(&solver);
    let mut times = Vec::new();
    for _ in 0..STEPS {
        let (result, ms) = timed(|| solver.step(&context.pool));
        result?;
        times.push(ms);
    }
    Ok(Evaluated { evaluation: model.evaluation, particles, times: Milliseconds::of(&times) })
}

/// Returns the largest relative difference of a density, and the largest difference of a velocity over the rms speed.
fn apart(direct: &[Particle], other: &[Particle]) -> [f64; 2] {
    let speed = mean(direct, |particle| f64::from(particle.velocity.length_squared())).sqrt();
    let pairs = || direct.iter().zip(other);
    let density = pairs().map(|(a, b)| f64::from((a.density - b.density).abs() / a.density)).fold(0.0, f64::max);
    let velocity = pairs().map(|(a, b)| f64::from(a.velocity.distance(b.velocity))).fold(0.0, f64::max);
    [density, velocity / speed]
}
