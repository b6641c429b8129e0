//! The result of `run`, and its report.
use crate::gauges::Shown;
use crate::scenes::LoadedScene;
use crate::state_summary::{FirstLast, MeanMax};
use crate::timing::Milliseconds;
use serde::Serialize;
use std::path::PathBuf;

/// Result of `run`.
#[derive(Clone, Debug, Serialize)]
pub struct Outcome {
    /// Name of the scene.
    pub scene: String,
    /// Description of the backend.
    pub backend: String,
    /// Number of particles, including wall particles and inactive air particles.
    pub particles: usize,
    /// Number of wall particles among them.
    pub wall_particles: usize,
    /// Number of steps made.
    pub steps: u64,
    /// Simulated time, s.
    pub simulated_s: f64,
    /// Wall time, including pictures, s.
    pub wall_s: f64,
    /// Time of a step, ms; on a GPU, means over the steps between two reads of its status.
    pub ms_per_step: Milliseconds,
    /// Mean number of neighbours of a particle, the particle itself included.
    pub average_neighbours: FirstLast,
    /// Time steps of the run, s.
    pub time_step: TimeSteps,
    /// Courant numbers of the last step, based on the support radius.
    pub courant: Courant,
    /// Compression after the last step, as a share of the rest density.
    pub density_error: MeanMax,
    /// Energies before the first and after the last step, J (per metre of depth in 2D).
    pub energy: Energy,
    /// Iterations of the pressure correction; absent with an equation of state.
    pub pressure_correction: Option<PressureCorrection>,
    /// The layer of air after the last step; absent if the scene has no air.
    pub air: Option<Air>,
    /// Particles that came and went; absent in scenes without emitters and drains.
    pub turnover: Option<Turnover>,
    /// State hash after the last step.
    pub hash: String,
    /// Warnings about the scene and the run.
    pub warnings: Vec<String>,
    /// Paths of the pictures.
    pub pictures: Vec<PathBuf>,
    /// What the gauges showed.
    pub gauges: Vec<Shown>,
    /// Path of the time series of the gauges.
    pub series: Option<PathBuf>,
}

/// Time steps of a run. On a GPU, smallest and largest are those of the steps at which its status was read.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct TimeSteps {
    /// Smallest time step, s.
    pub smallest: f64,
    /// Largest time step, s.
    pub largest: f64,
    /// Last time step, s.
    pub last: f64,
    /// Number of steps that were undone and repeated with a shorter time step.
    pub rejected_steps: u32,
    /// Number of steps that should have been shorter than the smallest allowed.
    pub clamped_steps: u32,
    /// Number of times that a step was halved because it could not be made.
    pub halvings: u32,
}

/// Courant numbers, the quantities that [`AdaptiveTimeStep`](millpond_core::scene::AdaptiveTimeStep) limits. H is the
/// support radius.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Courant {
    /// `v dt / H`, v being the largest speed of a particle.
    pub speed: f64,
    /// `dt sqrt(a / H)`, a being the largest acceleration of a particle.
    pub acceleration: f64,
    /// `c dt / H`, c being the largest speed of sound; 0 with the pressure correction.
    pub sound: f64,
    /// `nu dt / H^2`, nu being the largest kinematic viscosity.
    pub viscosity: f64,
}

impl From<millpond_core::backend::report::Courant> for Courant {
    fn from(courant: millpond_core::backend::report::Courant) -> Courant {
        let millpond_core::backend::report::Courant { speed, acceleration, sound, viscosity } = courant;
        Courant { speed, acceleration, sound, viscosity }
    }
}

/// Energies of the fluid, J.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Energy {
    /// Kinetic energy.
    pub kinetic: FirstLast,
    /// Internal energy; absent if the scene does not compute it.
    pub internal: Option<FirstLast>,
    /// Potential energy of gravity.
    pub potential: FirstLast,
    /// Energy of springs; absent if no fluid is elastic.
    pub elastic: Option<FirstLast>,
}

/// Iterations of the pressure correction.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct PressureCorrection {
    /// Mean number of iterations per step.
    pub mean_iterations: f64,
    /// Number of iterations of the last step.
    pub last_iterations: u32,
    /// Largest density error left after the last step, divided by the rest density.
    pub residual: f32,
}

/// State of the layer of air.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Air {
    /// Number of active air particles.
    pub alive: u32,
    /// Number of spawn requests, over all steps, for which no inactive air particle was left.
    pub refused: u64,
}

/// Particles that came and went during the run.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Turnover {
    /// Number of active particles at the end.
    pub active: u32,
    /// Particles that emitters made.
    pub born: u64,
    /// Particles that drains took, or whose life ended.
    pub removed: u64,
    /// Particles that were not made because their place was taken.
    pub blocked: u64,
    /// Particles that were not made because no spare particle was left.
    pub refused: u64,
}

/// Formats the result as a Markdown page.
#[must_use]
pub fn report(named: &LoadedScene, outcome: &Outcome) -> String {
    let o = outcome;
    let mut out = format!("# {}: {}\n\n", o.scene, named.file.about);
    out += "| quantity | value |\n| --- | --- |\n";
    let mut row = |what: &str, value: String| out += &format!("| {what} | {value} |\n");
    row("backend", o.backend.clone());
    row("particles", o.particles.to_string());
    row("steps", format!("{} ({:.3} s simulated, {:.1} s wall time)", o.steps, o.simulated_s, o.wall_s));
    row("ms per step", format!("{:.2} minimum, {:.2} median", o.ms_per_step.min, o.ms_per_step.median));
    let TimeSteps { smallest, largest, last, rejected_steps, .. } = o.time_step;
    if smallest < largest || rejected_steps > 0 {
        let words = format!("{smallest:.2e} to {largest:.2e} s, the last {last:.2e} s, {rejected_steps} rejected");
        row("time step", words);
    }
    let Courant { speed, acceleration, sound, viscosity } = o.courant;
    let numbers =
        format!("speed {speed:.3}, acceleration {acceleration:.3}, sound {sound:.3}, viscosity {viscosity:.4}");
    row("Courant numbers", numbers);
    row("neighbours", format!("{:.1} first, {:.1} last", o.average_neighbours.first, o.average_neighbours.last));
    let MeanMax { mean, max } = o.density_error;
    row("compression", format!("{:.2} % mean, {:.1} % maximum", mean * 100.0, max * 100.0));
    let energy = o.energy;
    row("kinetic energy", format!("{:.4e} J first, {:.4e} J last", energy.kinetic.first, energy.kinetic.last));
    if let Some(internal) = energy.internal {
        row("internal energy", format!("{:.4e} J first, {:.4e} J last", internal.first, internal.last));
    }
    row("potential energy", format!("{:.4e} J first, {:.4e} J last", energy.potential.first, energy.potential.last));
    if let Some(elastic) = energy.elastic {
        row("elastic energy", format!("{:.4e} J first, {:.4e} J last", elastic.first, elastic.last));
    }
    if let Some(p) = o.pressure_correction {
        let (mean, last, left) = (p.mean_iterations, p.last_iterations, p.residual * 100.0);
        row("pressure iterations", format!("{mean:.1} per step, {last} in the last, density error {left:.2} %"));
    }
    if let Some(Air { alive, refused }) = o.air {
        row("air", format!("{alive} particles, {refused} spawn requests refused"));
    }
    if let Some(Turnover { active, born, removed, blocked, refused }) = o.turnover {
        row("particles that came and went", format!("{born} made, {removed} removed, {active} active at the end"));
        row("particles not made", format!("{blocked} whose place was taken, {refused} without a spare particle"));
    }
    for Shown { name, unit, smallest, largest, last } in &o.gauges {
        row(name, format!("{last} {unit} last, {smallest} to {largest}"));
    }
    row("hash", o.hash.clone());
    for warning in &o.warnings {
        out += &format!("\nWarning: {warning}.\n");
    }
    if let (Some(first), Some(last)) = (o.pictures.first(), o.pictures.last()) {
        out += &format!("\n{} pictures: {} to {}\n", o.pictures.len(), first.display(), last.display());
    }
    out
}
