//! `check`: named studies, each of which holds the fluid against a reference from outside and says by how much it is off.
//!
//! A study has a file of its own, with its settings and limits at the top; [`Outcome`] is what all of them hand back. What
//! they share: `flow` (starting and stepping), `column` (a tank at rest), `drop` (a drop at rest), `strata` (two fluids at rest),
//! `reference` (tables and series). Theory that takes a page stands by itself, in `ripple` and `swing`.
mod air;
mod channel;
mod column;
mod dam_break_front;
mod drop;
mod elastic;
mod evaluation;
mod extremes;
mod flow;
mod hydrostatic;
pub mod integrators;
mod kernels;
mod laplace_drop;
mod lattice;
mod oscillating_drop;
mod pressure_correction;
mod rayleigh_taylor;
mod recipes;
mod reference;
mod ripple;
mod stiff_tank;
mod still_tank;
mod strata;
mod swing;
mod taylor_green;
mod tensile;
mod two_fluids;

pub use crate::outcome::{Metric, Outcome, Sense};

use crate::failure::Failure;
use crate::output::{make_folder, print_json, say, write_text};
use crate::pool::Pool;
use serde::Serialize;
use std::path::PathBuf;

/// Options of `check`.
#[derive(Clone, Debug, clap::Args)]
pub struct Options {
    /// A study's name, or all; without one, the studies are listed
    name: Option<String>,
    /// Coarser and shorter, where a study allows it
    #[arg(long)]
    quick: bool,
    /// Threads of the CPU backend (0: as many as there are cores)
    #[arg(long, default_value_t = 0, value_name = "N")]
    threads: usize,
    /// One JSON document on stdout, everything else on stderr
    #[arg(long)]
    json: bool,
    /// Folder for reports and figures
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
}

/// What a study works with.
#[derive(Debug)]
pub struct Context {
    /// Who works.
    pub pool: Pool,
    /// Coarser and shorter.
    pub quick: bool,
    /// Where figures and tables go, if anywhere.
    pub folder: Option<PathBuf>,
}

/// A named study.
#[derive(Clone, Copy, Debug)]
pub struct Study {
    /// Its name.
    pub name: &'static str,
    /// One sentence about it.
    pub about: &'static str,
    run: fn(&Context) -> Result<Outcome, Failure>,
}

/// All studies, the quick ones first.
pub const STUDIES: &[Study] = &[
    Study {
        name: "kernels",
        about: "kernels by quadrature, by differences, on lattices, and from tables",
        run: kernels::run,
    },
    Study {
        name: "integrators",
        about: "ten integrators on Pirovano's oscillators: limits, orders, areas, and Pirovano's tables 2.1 to 2.4 beside ours",
        run: integrators::run,
    },
    Study {
        name: "tensile",
        about: "a cube of water without gravity becomes a sphere, and its particles do not cluster",
        run: tensile::run,
    },
    Study {
        name: "elastic",
        about: "an elastic cube bounces and has its shape again; a pair swings with the period of its spring",
        run: elastic::run,
    },
    Study {
        name: "extremes",
        about: "what nobody should ask for ends in a sound state, or in a refusal by name that changes nothing",
        run: extremes::run,
    },
    Study { name: "hydrostatic", about: "pressure in a tank at rest rises as its depth", run: hydrostatic::run },
    Study { name: "still-tank", about: "a tank at rest stays at rest for five seconds", run: still_tank::run },
    Study {
        name: "stiff-tank",
        about: "a falling column at twenty times its speed of sound, in steps that follow from the state",
        run: stiff_tank::run,
    },
    Study {
        name: "pressure-correction",
        about: "a column at the real speed of sound, with the time step of a soft one",
        run: pressure_correction::run,
    },
    Study {
        name: "poiseuille",
        about: "a channel driven by a force, against its series (Morris et al. 1997)",
        run: channel::poiseuille,
    },
    Study {
        name: "couette",
        about: "a channel driven by its lid, against its series (Morris et al. 1997)",
        run: channel::couette,
    },
    Study { name: "taylor-green", about: "decaying vortices, against the exact solution", run: taylor_green::run },
    Study {
        name: "laplace-drop",
        about: "the pressure in a drop at rest is sigma / R above that around it",
        run: laplace_drop::run,
    },
    Study {
        name: "oscillating-drop",
        about: "a drop swings with the period that its tension gives it (Rayleigh; Lamb)",
        run: oscillating_drop::run,
    },
    Study {
        name: "two-fluids",
        about: "a light fluid rests on a heavy one, up to a thousand times as heavy",
        run: two_fluids::run,
    },
    Study {
        name: "air",
        about: "a coat of air around a square drop, and what it does to the tension that a free surface has of itself",
        run: air::run,
    },
    Study {
        name: "rayleigh-taylor",
        about: "a ripple between two fluids grows as linear theory says, and oil rises through water",
        run: rayleigh_taylor::run,
    },
    Study {
        name: "dam-break-front",
        about: "the front of a collapsing column, against Martin and Moyce 1952",
        run: dam_break_front::run,
    },
];

/// Studies together, as one result.
#[derive(Clone, Debug, Serialize)]
struct All {
    name: &'static str,
    passed: bool,
    /// Those of all studies, with the study's name before each.
    figures: Vec<Metric>,
    studies: Vec<Outcome>,
}

/// Runs `check`; false where a study falls short.
///
/// # Errors
/// No such study, a scene that cannot start, files that cannot be written.
pub fn execute(options: &Options) -> Result<bool, Failure> {
    let Some(name) = &options.name else { return list(options.json) };
    let context = Context { pool: Pool::new(options.threads)?, quick: options.quick, folder: options.out.clone() };
    if name == "all" {
        return check_all(options, &context);
    }
    let Some(study) = STUDIES.iter().find(|study| study.name == name) else {
        let known: Vec<&str> = STUDIES.iter().map(|study| study.name).collect();
        return Err(Failure::Call(format!("no study {name:?}: there are {}, and all", known.join(", "))));
    };
    let outcome = check(study, &context)?;
    let words = outcome.words(study.about);
    keep(options, study.name, &words)?;
    let said = if options.json { print_json(&outcome) } else { say(&words) };
    said?;
    Ok(outcome.passed)
}

/// Runs one study. A step that could not be made is a study that fell short: the others still run.
///
/// # Errors
/// A scene that cannot start, whatever else went wrong.
pub fn check(study: &Study, context: &Context) -> Result<Outcome, Failure> {
    match (study.run)(context) {
        Err(Failure::Step(error)) => {
            let figure = Metric::below("steps that could not be made", 1.0, 0.0);
            Ok(Outcome::new(study.name, vec![figure], vec![error.to_string()]))
        }
        done => done,
    }
}

fn check_all(options: &Options, context: &Context) -> Result<bool, Failure> {
    let mut studies = Vec::new();
    for study in STUDIES {
        let outcome = check(study, context)?;
        let words = outcome.words(study.about);
        keep(options, study.name, &words)?;
        // as they come: all of them take minutes
        if !options.json {
            say(&words)?;
        }
        studies.push(outcome);
    }
    let passed = studies.iter().all(|outcome| outcome.passed);
    let named = |outcome: &Outcome| {
        let name = outcome.name.clone();
        let figures = outcome.figures.clone().into_iter();
        figures.map(move |figure| Metric { name: format!("{name}: {}", figure.name), ..figure })
    };
    let figures = studies.iter().flat_map(named).collect();
    if options.json {
        print_json(&All { name: "all", passed, figures, studies })?;
    } else {
        let short: Vec<&str> = studies.iter().filter(|o| !o.passed).map(|o| o.name.as_str()).collect();
        let words =
            if passed { "all studies pass".into() } else { format!("short of their limits: {}", short.join(", ")) };
        say(&words)?;
    }
    Ok(passed)
}

/// Leaves the words in the folder, where there is one.
fn keep(options: &Options, name: &str, words: &str) -> Result<(), Failure> {
    let Some(folder) = &options.out else { return Ok(()) };
    make_folder(folder)?;
    write_text(&folder.join(format!("check-{name}.md")), words)
}

fn list(json: bool) -> Result<bool, Failure> {
    if json {
        let all: Vec<_> = STUDIES.iter().map(|s| serde_json::json!({ "name": s.name, "about": s.about })).collect();
        print_json(&all)?;
    } else {
        let lines: Vec<String> = STUDIES.iter().map(|s| format!("{:20} {}", s.name, s.about)).collect();
        say(&lines.join("\n"))?;
    }
    Ok(true)
}
