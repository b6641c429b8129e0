//! The commands.
use crate::failure::Failure;
use crate::output::{print_json, say};
use crate::scenes::{BUILT_IN, Changes, load};
use crate::{bench, check, compare, error_study, plan_view, run, showcase, stability};
use clap::{Parser, Subcommand};

/// A deterministic, fixed-capacity SPH fluid: run it, compare its backends bit for bit, weigh error against run time.
///
/// Without a command: the showcase, in about a minute.
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
    /// Hold the fluid against references from outside: named studies with limits
    Check(check::Options),
    /// Map the largest stable time step of a scene over axes such as stiffness and integrator; of `tower`, Hinsch's figures
    Stability(stability::Options),
    /// List the built-in scenes
    Scenes {
        /// One JSON document on stdout
        #[arg(long)]
        json: bool,
    },
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
            Some(Command::Check(options)) => check::execute(&options),
            Some(Command::Stability(options)) => stability::execute(&options),
            Some(Command::Scenes { json }) => list_scenes(json),
        }
    }
}

fn list_scenes(json: bool) -> Result<bool, Failure> {
    let (mut all, mut words) = (Vec::new(), String::new());
    for (name, _) in BUILT_IN {
        let named = load(name, &Changes::default())?;
        let (file, particles) = (&named.file, named.checked()?.derived().particles());
        let duration_s = file.duration;
        words += &format!("{name:14} {particles:6} particles, {duration_s} s: {}\n", file.about);
        all.push(serde_json::json!({
            "name": name, "about": file.about, "particles": particles, "duration_s": duration_s
        }));
    }
    if json {
        print_json(&all)?;
    } else {
        say(&words)?;
    }
    Ok(true)
}
