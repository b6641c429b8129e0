//! Arguments shared by several commands.
use crate::failure::Failure;
use crate::run_length::RunLength;
use crate::scenes::Changes;
use clap::builder::RangedU64ValueParser;
use clap::{Args, ValueEnum};
use millpond_core::scene::Scene;
use std::path::PathBuf;

/// The backend that a scene runs on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum BackendName {
    /// The CPU, with SIMD and threads
    Cpu,
    /// A GPU by way of wgpu, in strict mode
    Gpu,
}

/// Arguments of every command that takes a scene.
#[derive(Clone, Debug, Args)]
pub struct Common {
    /// Name of a built-in scene, or path of a scene file
    pub scene: String,
    #[command(flatten)]
    #[expect(missing_docs, reason = "its fields say it to the user")]
    pub changes: Changes,
    /// Number of threads of the CPU backend (0: one per core; in `compare` two, in `error` one)
    #[arg(long, default_value_t = 0, value_name = "N", value_parser = number_of_threads())]
    pub threads: usize,
    /// Print one JSON document on stdout, and everything else on stderr
    #[arg(long)]
    pub json: bool,
    /// Folder to write reports, plots and pictures to
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
}

/// Returns the parser of a number of threads.
#[must_use]
pub fn number_of_threads() -> RangedU64ValueParser<usize> {
    RangedU64ValueParser::new().range(0..=MOST_THREADS)
}

/// Largest number of threads: more than any machine has that runs this program, and few enough to start.
const MOST_THREADS: u64 = 1024;

/// How long a scene runs.
#[derive(Clone, Copy, Debug, Default, Args)]
pub struct Length {
    /// Number of time steps to make (default: `run` makes the steps of the scene's duration, `compare` 200)
    #[arg(long, value_name = "N", conflicts_with = "time", allow_negative_numbers = true)]
    pub steps: Option<u64>,
    /// Simulated time to run, s
    #[arg(long, value_name = "SECONDS", allow_negative_numbers = true)]
    pub time: Option<f64>,
}

impl Length {
    /// Returns the run length that the user asked for, or that of `otherwise` if neither option was given.
    ///
    /// # Errors
    /// A time that is negative, not finite or too long.
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
