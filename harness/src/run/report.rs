//! What `run` has to say.
use crate::scenes::LoadedScene;
use crate::state_summary::{FirstLast, MeanMax};
use crate::timing::Milliseconds;
use serde::Serialize;
use std::path::PathBuf;

/// Result of `run`.
#[derive(Clone, Debug, Serialize)]
pub struct Outcome {
    /// The scene.
    pub scene: String,
    /// What it ran on.
    pub backend: String,
    /// Particles, those of walls too, and air that is not there.
    pub particles: usize,
    /// Of these, walls'.
    pub wall_particles: usize,
    /// Steps made.
    pub steps: u64,
    /// Time that passed in the scene, s.
    pub simulated_s: f64,
    /// Time that passed here, pictures included, s.
    pub wall_s: f64,
    /// Time of a step; on a GPU, means over the steps between two looks at its status.
    pub ms_per_step: Milliseconds,
    /// Neighbours of a particle, itself counted.
    pub average_neighbours: FirstLast,
    /// Time steps that were made, s.
    pub time_step: TimeSteps,
    /// Courant numbers of the last step, on the support radius.
    pub courant: Courant,
    /// Compression beyond the rest density, as a share of it, after the last step.
    pub density_error: MeanMax,
    /// Energies before the first and after the last step, J (per metre of depth in 2D).
    pub energy: Energy,
    /// Iterations of pressure; absent with an equation of state.
    pub pressure_correction: Option<PressureCorrection>,
    /// The coat of air after the last step; absent where the scene has none.
    pub air: Option<Air>,
    /// State hash after the last step.
    pub hash: String,
    /// What a user should know.
    pub warnings: Vec<String>,
    /// Pictures drawn.
    pub pictures: Vec<PathBuf>,
}

/// Time steps of a run. On a GPU the smallest and largest are of those between two looks at its status.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct TimeSteps {
    /// Smallest, s.
    pub smallest: f64,
    /// Largest, s.
    pub largest: f64,
    /// The last, s.
    pub last: f64,
    /// Steps that were undone and made again, shorter.
    pub rejected_steps: u32,
    /// Steps that should have been shorter than the shortest allowed.
    pub held: u32,
}

/// Courant numbers: what [`AdaptiveTimeStep`](millpond_core::scene::AdaptiveTimeStep) limits.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Courant {
    /// `v dt / H` of the fastest particle.
    pub speed: f64,
    /// `dt sqrt(a / H)` of the one that is accelerated most.
    pub acceleration: f64,
    /// `c dt / H`; 0 where pressure is corrected.
    pub sound: f64,
    /// `nu dt / H^2`.
    pub viscosity: f64,
}

impl From<millpond_core::backend::report::Courant> for Courant {
    fn from(courant: millpond_core::backend::report::Courant) -> Courant {
        let millpond_core::backend::report::Courant { speed, acceleration, sound, viscosity } = courant;
        Courant { speed, acceleration, sound, viscosity }
    }
}

/// Energies of the fluid.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Energy {
    /// Of motion.
    pub kinetic: FirstLast,
    /// Thermal; absent where the scene keeps no account of it.
    pub internal: Option<FirstLast>,
    /// In the field of gravity.
    pub potential: FirstLast,
    /// In springs; absent where the scene has none.
    pub elastic: Option<FirstLast>,
}

/// What iterating pressure came to.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct PressureCorrection {
    /// Iterations of a step, in the mean.
    pub mean_iterations: f64,
    /// Of the last step.
    pub last_iterations: u32,
    /// Largest density miss that the last step was left with, over the rest density.
    pub residual: f32,
}

/// What became of the coat of air.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Air {
    /// Particles that there are.
    pub alive: u32,
    /// Births for which none was left, in all steps.
    pub refused: u64,
}

/// The outcome as a page.
#[must_use]
pub fn report(named: &LoadedScene, outcome: &Outcome) -> String {
    let o = outcome;
    let mut out = format!("# {}: {}\n\n", o.scene, named.file.about);
    out += "| what | value |\n| --- | --- |\n";
    let mut row = |what: &str, value: String| out += &format!("| {what} | {value} |\n");
    row("backend", o.backend.clone());
    row("particles", o.particles.to_string());
    row("steps", format!("{} ({:.3} s simulated, {:.1} s here)", o.steps, o.simulated_s, o.wall_s));
    row("ms a step", format!("{:.2} at least, {:.2} median", o.ms_per_step.min, o.ms_per_step.median));
    let TimeSteps { smallest, largest, last, rejected_steps, .. } = o.time_step;
    if smallest < largest || rejected_steps > 0 {
        let words = format!("{smallest:.2e} to {largest:.2e} s, the last {last:.2e} s, {rejected_steps} made again");
        row("time step", words);
    }
    let Courant { speed, acceleration, sound, viscosity } = o.courant;
    let numbers =
        format!("speed {speed:.3}, acceleration {acceleration:.3}, sound {sound:.3}, viscosity {viscosity:.4}");
    row("Courant numbers", numbers);
    row("neighbours", format!("{:.1} first, {:.1} last", o.average_neighbours.first, o.average_neighbours.last));
    let MeanMax { mean, max } = o.density_error;
    row("compression", format!("{:.2} % mean, {:.1} % largest", mean * 100.0, max * 100.0));
    let energy = o.energy;
    row("kinetic energy", format!("{:.4e} J first, {:.4e} J last", energy.kinetic.first, energy.kinetic.last));
    if let Some(internal) = energy.internal {
        row("thermal energy", format!("{:.4e} J first, {:.4e} J last", internal.first, internal.last));
    }
    row("potential energy", format!("{:.4e} J first, {:.4e} J last", energy.potential.first, energy.potential.last));
    if let Some(elastic) = energy.elastic {
        row("elastic energy", format!("{:.4e} J first, {:.4e} J last", elastic.first, elastic.last));
    }
    if let Some(p) = o.pressure_correction {
        let (mean, last, left) = (p.mean_iterations, p.last_iterations, p.residual * 100.0);
        row("iterations of pressure", format!("{mean:.1} a step, {last} in the last, which leaves {left:.2} %"));
    }
    if let Some(Air { alive, refused }) = o.air {
        row("coat of air", format!("{alive} particles, {refused} births refused"));
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
