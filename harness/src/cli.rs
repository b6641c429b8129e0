//! The command line: subcommands and their dispatch.
use crate::failure::Failure;
use crate::output::{print_json, say};
use crate::scenes::{BUILT_IN, Changes, load};
use crate::{bench, check, compare, error_study, guide_view, plan_view, run, showcase, stability};
use clap::{Parser, Subcommand};

/// Runs a deterministic, fixed-capacity SPH fluid, compares its backends bit for bit, and measures error against run
/// time
///
/// Without a command, millpond runs the showcase, which takes a few minutes.
#[derive(Debug, Parser)]
#[command(name = "millpond", version, after_help = EXIT_STATUSES)]
pub struct Cli {
    #[command(subcommand)]
    command: Option<Command>,
}

/// What the exit status of the program says.
const EXIT_STATUSES: &str = "Exit status: 0 done and every promise kept; 1 a promise or a time step failed; \
2 the arguments or the scene are wrong; 3 no such backend on this machine; 4 a result could not be written.";

#[derive(Debug, Subcommand)]
enum Command {
    /// Run a scene, and draw pictures of it with --out
    Run(run::Options),
    /// Run a scene on every path (scalar, SIMD, threads, both grid structures, GPU) and compare every bit after every
    /// step
    Compare(compare::Options),
    /// Measure the time of a step, in total and for each pass
    Bench(bench::Options),
    /// Show which passes and arrays a scene needs, and which it does without
    Plan(plan_view::Options),
    /// Measure error against run time for several resolutions, time steps and formulas
    Error(error_study::Options),
    /// Check the fluid against theory and experiments: named studies with limits
    Check(check::Options),
    /// Map the largest stable time step of a scene over axes such as stiffness and integrator; for `tower`, reproduce
    /// the analysis of Hinsch 2024
    Stability(stability::Options),
    /// Derive a scene from the size of a volume of fluid, its properties and one number for the resolution
    Guide(guide_view::Options),
    /// List the built-in scenes
    Scenes {
        /// Print the list as JSON on stdout
        #[arg(long)]
        json: bool,
    },
}

impl Cli {
    /// Runs the given command. Returns false if a promise was not kept, such as equal bits on two backends.
    ///
    /// # Errors
    /// Why the command could not be carried out; [`Failure::exit_status`] gives the exit status.
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
            Some(Command::Guide(options)) => guide_view::execute(&options),
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
