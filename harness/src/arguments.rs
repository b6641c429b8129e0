//! The arguments that commands share.
use crate::failure::Failure;
use crate::run_length::RunLength;
use crate::scenes::Changes;
use clap::{Args, ValueEnum};
use millpond_core::scene::Scene;
use std::path::PathBuf;

/// Where a scene runs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum BackendName {
    /// The CPU, by lanes and threads.
    Cpu,
    /// A wgpu device, in strict mode.
    Gpu,
}

/// What every command about a scene takes.
#[derive(Clone, Debug, Args)]
pub struct Common {
    /// A built-in scene's name, or a scene file
    pub scene: String,
    #[command(flatten)]
    #[expect(missing_docs, reason = "its fields say it to the user")]
    pub changes: Changes,
    /// Threads of the CPU backend (0: as many as there are cores)
    #[arg(long, default_value_t = 0, value_name = "N")]
    pub threads: usize,
    /// One JSON document on stdout, everything else on stderr
    #[arg(long)]
    pub json: bool,
    /// Folder for reports, plots and pictures
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
}

/// How long a scene runs.
#[derive(Clone, Copy, Debug, Default, Args)]
pub struct Length {
    /// Time steps to make
    #[arg(long, value_name = "N", conflicts_with = "time")]
    pub steps: Option<u64>,
    /// Simulated seconds to run
    #[arg(long, value_name = "SECONDS")]
    pub time: Option<f64>,
}

impl Length {
    /// As a span, `otherwise` where nothing was said.
    ///
    /// # Errors
    /// A time that is none.
    pub fn of(
        self,
        scene: &Scene,
        otherwise: impl FnOnce() -> Result<RunLength, Failure>,
    ) -> Result<RunLength, Failure> {
        match (self.steps, self.time) {
            (Some(steps), _) => Ok(RunLength::Steps(steps)),
            (None, Some(seconds)) => RunLength::of_seconds(scene, seconds),
            (None, None) => otherwise(),
        }
    }
}
