//! The arguments that commands share.
use crate::failure::Failure;
use crate::scenes::Changes;
use clap::{Args, ValueEnum};
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

/// More steps than anybody means who names a time: a week of them.
const MOST_STEPS: f64 = 1e9;

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
    /// As steps, `otherwise` seconds where nothing was said.
    ///
    /// # Errors
    /// A time that is none.
    pub fn in_steps(self, otherwise: f64, time_step: f32) -> Result<u64, Failure> {
        let seconds = self.time.unwrap_or(otherwise);
        let steps = (seconds / f64::from(time_step)).round();
        match self.steps {
            Some(steps) => Ok(steps),
            None if (0.0..MOST_STEPS).contains(&steps) => Ok(steps as u64),
            None if steps >= MOST_STEPS => {
                Err(Failure::Call(format!("{seconds} s in steps of {time_step} s are {steps:e} steps: name --steps")))
            }
            None => Err(Failure::Call(format!("--time {seconds} is no length of time"))),
        }
    }
}
