//! The command line.
use crate::failure::Failure;
use crate::scenes::{BUILT_IN, Changes, load};
use crate::{bench, compare, error_study, plan_view, run, showcase};
use clap::{Args, Parser, Subcommand, ValueEnum};
use std::path::PathBuf;

/// A deterministic, fixed-capacity SPH fluid: run it, compare its backends bit for bit, weigh error against run time.
///
/// Without a command: the showcase, in a few minutes.
#[derive(Debug, Parser)]
#[command(name = "millpond", version)]
pub struct Cli {
    #[command(subcommand)]
    command: Option<Command>,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// Run a scene, draw it if asked
    Run(run::Options),
    /// Run a scene on every path, scalar, lanes, threads, both grids, GPU, and compare every bit at every step
    Compare(compare::Options),
    /// Time the steps of a scene, pass by pass
    Bench(bench::Options),
    /// Show what a scene needs, and what it leaves out
    Plan(plan_view::Options),
    /// Weigh error against run time
    Error(error_study::Options),
    /// List the built-in scenes
    Scenes {
        /// One JSON document on stdout
        #[arg(long)]
        json: bool,
    },
}

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
    /// As steps, `otherwise` seconds where nothing was said.
    ///
    /// # Errors
    /// A time that is none.
    pub fn in_steps(self, otherwise: f64, time_step: f32) -> Result<u64, Failure> {
        let seconds = self.time.unwrap_or(otherwise);
        match self.steps {
            Some(steps) => Ok(steps),
            None if seconds.is_finite() && seconds >= 0.0 => Ok((seconds / f64::from(time_step)).round() as u64),
            None => Err(Failure::Call(format!("--time {seconds} is no length of time"))),
        }
    }
}

/// Where results go.
#[derive(Clone, Debug, Default, Args)]
pub struct Out {
    /// Folder for pictures and reports
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
}

impl Cli {
    /// Does what was asked; false where a promise failed.
    ///
    /// # Errors
    /// What could not be done, with its exit status.
    pub fn execute(self) -> Result<bool, Failure> {
        match self.command {
            None => showcase::execute(),
            Some(Command::Run(options)) => run::execute(&options),
            Some(Command::Compare(options)) => compare::execute(&options),
            Some(Command::Bench(options)) => bench::execute(&options),
            Some(Command::Plan(options)) => plan_view::execute(&options),
            Some(Command::Error(options)) => error_study::execute(&options),
            Some(Command::Scenes { json }) => list_scenes(json),
        }
    }
}

fn list_scenes(json: bool) -> Result<bool, Failure> {
    let mut all = Vec::new();
    for (name, _) in BUILT_IN {
        let file = load(name, &Changes::default())?.file;
        let (particles, duration_s) = (file.scene.particle_count(), file.duration);
        if !json {
            println!("{name:14} {particles:6} particles, {duration_s} s: {}", file.about);
        }
        all.push(serde_json::json!({
            "name": name, "about": file.about, "particles": particles, "duration_s": duration_s
        }));
    }
    if json {
        println!("{}", serde_json::Value::Array(all));
    }
    Ok(true)
}
