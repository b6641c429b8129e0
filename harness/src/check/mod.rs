//! `check`: numerical studies. Each study compares the fluid with a reference, which is a theory, an experiment or a
//! published table, and reports the errors.
//!
//! A study has its own file, with its settings and limits at the top. It returns an [`Outcome`]: figures, each with a
//! limit, and notes without limits. A study passes if all figures are within their limits. A limit is called required
//! if the project fixed it before the study was written; the docs of all other limits say where they come from.
//!
//! Cases such as H1 or D1 are those of the project's validation catalogue, a list of reference cases with set-ups and
//! limits. The catalogue is not part of this repository; its tables are in `harness/data`, each with its source in the
//! first line.
//!
//! The files use these terms. The support radius is the radius beyond which a kernel vanishes (2 h in most textbooks),
//! and the number of neighbours is the number of particles inside of it, the particle itself included. Each study names
//! its walls.
//!
//! The studies share `flow` (starting and stepping), `column` (a tank at rest), `drop` (a drop at rest), `strata` (two
//! fluids at rest), `form` (walls and formulas), `formulas` (choices of formulas), `cases` (short reference cases) and
//! `reference` (tables and series). Longer theory is in `ripple` and `swing`.
mod air;
mod bar;
mod cases;
mod channel;
mod column;
mod containment;
mod dam_break_front;
mod drop;
mod elastic;
mod emission;
mod enclosure;
mod evaluation;
mod evidence;
mod extremes;
mod flow;
mod form;
mod formulas;
mod hydrostatic;
mod impact;
pub mod integrators;
mod kernels;
mod laplace_drop;
mod lattice;
mod lid;
pub mod matrix;
mod oscillating_drop;
mod other_forms;
mod pressure_correction;
mod rayleigh_taylor;
mod recipes;
mod reference;
mod ripple;
mod solids;
mod standing_wave;
mod stiff_tank;
mod still_tank;
mod strata;
mod swing;
mod taylor_green;
mod tensile;
mod two_fluids;
mod water_jet;

pub use crate::outcome::{Metric, Outcome, Sense};

use crate::arguments::number_of_threads;
use crate::failure::Failure;
use crate::output::{make_folder, print_json, say, write_text};
use crate::pool::Pool;
use serde::Serialize;
use std::path::PathBuf;

/// Options of `check`.
#[derive(Clone, Debug, clap::Args)]
pub struct Options {
    /// Name of a study, or all, which leaves out matrix and the evidence studies; without a name, the studies are
    /// listed
    name: Option<String>,
    /// Coarser and shorter runs, for studies that have them
    #[arg(long)]
    quick: bool,
    /// Threads of the CPU backend (0: one for each core)
    #[arg(long, default_value_t = 0, value_name = "N", value_parser = number_of_threads())]
    threads: usize,
    /// One JSON document on stdout, everything else on stderr
    #[arg(long)]
    json: bool,
    /// Folder for reports and figures
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
}

/// Settings for the run of a study.
#[derive(Debug)]
pub struct Context {
    /// Threads that step the fluid.
    pub pool: Pool,
    /// Whether runs are coarser and shorter.
    pub quick: bool,
    /// Folder for figures and tables, if they are written.
    pub folder: Option<PathBuf>,
}

/// A named study.
#[derive(Clone, Copy, Debug)]
pub struct Study {
    /// Name on the command line.
    pub name: &'static str,
    /// One sentence about what is measured.
    pub about: &'static str,
    run: fn(&Context) -> Result<Outcome, Failure>,
}

/// Studies that `all` leaves out, since each takes minutes.
pub const LONG_STUDIES: &[Study] = &[
    Study {
        name: "matrix",
        about: "every pair of choices that goes together gives the same bits on all paths",
        run: matrix::run,
    },
    Study {
        name: "evidence-surface",
        about: "error against run time of walls, densities, diffusions and shiftings, for free surfaces",
        run: evidence::of_surfaces,
    },
    Study {
        name: "evidence-filled",
        about: "error against run time of densities, diffusions and shiftings, for domains that the fluid fills",
        run: evidence::of_filled_domains,
    },
    Study {
        name: "evidence-friction",
        about: "error against run time of walls, densities, diffusions and shiftings, for viscous channels",
        run: evidence::of_friction,
    },
    Study {
        name: "evidence-fluids",
        about: "error against run time of walls, densities, diffusions and shiftings, for two fluids at rest",
        run: evidence::of_two_fluids,
    },
];

/// All other studies, the quick ones first.
pub const STUDIES: &[Study] = &[
    Study {
        name: "kernels",
        about: "normalisation, derivatives, lattice sums and tabulated forms of all kernels",
        run: kernels::run,
    },
    Study {
        name: "integrators",
        about: "ten integrators on damped oscillators: stability limits, orders, areas; Pirovano's tables 2.1 to 2.4",
        run: integrators::run,
    },
    Study {
        name: "tensile",
        about: "a cube of water without gravity becomes a sphere, and near pressure prevents clustering",
        run: tensile::run,
    },
    Study {
        name: "elastic",
        about: "an elastic cube bounces and recovers its shape; two particles oscillate with their spring's period",
        run: elastic::run,
    },
    Study {
        name: "extremes",
        about: "extreme inputs end in a valid state, or in a named error that leaves the state unchanged",
        run: extremes::run,
    },
    Study {
        name: "emission",
        about: "what emitters make, and an exact ledger of the particles that come and go",
        run: emission::run,
    },
    Study {
        name: "containment",
        about: "shaken water stays in containers of every shape and model, and thrown water does not pass a thin plate",
        run: containment::run,
    },
    Study {
        name: "solids",
        about: "water at rest in and around solids of every shape: weight, lift (Archimedes), pressure over depth",
        run: solids::run,
    },
    Study { name: "hydrostatic", about: "pressure in a tank at rest, against rho0 g (H - y)", run: hydrostatic::run },
    Study {
        name: "still-tank",
        about: "a tank of water at rest stays at rest, for up to a minute",
        run: still_tank::run,
    },
    Study {
        name: "stiff-tank",
        about: "a collapsing column, its speed of sound 20 times its fastest flow, with adaptive time steps",
        run: stiff_tank::run,
    },
    Study {
        name: "pressure-correction",
        about: "a column of water at 1500 m/s, with the time step of an equation of state at 30 m/s",
        run: pressure_correction::run,
    },
    Study {
        name: "poiseuille",
        about: "start-up of a channel flow driven by a body force, against the series of Morris et al. 1997",
        run: channel::poiseuille,
    },
    Study {
        name: "couette",
        about: "start-up of a channel flow driven by a moving wall, against the series of Morris et al. 1997",
        run: channel::couette,
    },
    Study {
        name: "standing-wave",
        about: "period and decay of a standing wave in a closed tank, against linear theory",
        run: standing_wave::run,
    },
    Study {
        name: "lid",
        about: "a lid slides over a cavity and its side walls for 25 s, and no wall changes its density",
        run: lid::run,
    },
    Study {
        name: "other-forms",
        about: "a wind, buoyancy and a gas, against theory; viscosities, pressure forces, XSPH and variable support",
        run: other_forms::run,
    },
    Study {
        name: "recipes",
        about: "the recipes for kinds of flow on the reference cases of their kind",
        run: recipes::run,
    },
    Study { name: "taylor-green", about: "decaying vortices, against the exact solution", run: taylor_green::run },
    Study {
        name: "laplace-drop",
        about: "the pressure jump of a drop at rest, against sigma / R (Laplace)",
        run: laplace_drop::run,
    },
    Study {
        name: "oscillating-drop",
        about: "the period of an oscillating drop, against the theory for its surface tension (Rayleigh; Lamb)",
        run: oscillating_drop::run,
    },
    Study {
        name: "two-fluids",
        about: "a light fluid at rest over a heavy one, with density ratios up to 1000",
        run: two_fluids::run,
    },
    Study {
        name: "air",
        about: "a layer of air around a square drop, and the spurious surface tension of a free surface",
        run: air::run,
    },
    Study {
        name: "rayleigh-taylor",
        about: "growth of a ripple between two fluids, against linear theory; a drop of oil rises through water",
        run: rayleigh_taylor::run,
    },
    Study {
        name: "impact",
        about: "pressure of a dam break on the far wall, against the experiment of Lobovsky et al. 2014",
        run: impact::run,
    },
    Study {
        name: "water-jet",
        about: "a jet of water falls: its axis, its section and its flow, against theory",
        run: water_jet::run,
    },
    Study {
        name: "dam-break-front",
        about: "the front of a collapsing column, against the experiments of Martin and Moyce 1952",
        run: dam_break_front::run,
    },
];

/// Result of all studies together.
#[derive(Clone, Debug, Serialize)]
struct All {
    name: &'static str,
    passed: bool,
    /// Figures of all studies, each with the study's name before its own.
    figures: Vec<Metric>,
    studies: Vec<Outcome>,
}

/// Runs `check`. Returns false if a study is outside of its limits.
///
/// # Errors
/// The study does not exist, a scene cannot start, or a file cannot be written.
pub fn execute(options: &Options) -> Result<bool, Failure> {
    let Some(name) = &options.name else { return list(options.json) };
    let context = Context { pool: Pool::new(options.threads)?, quick: options.quick, folder: options.out.clone() };
    if name == "all" {
        return check_all(options, &context);
    }
    let every = || STUDIES.iter().chain(LONG_STUDIES);
    let Some(study) = every().find(|study| study.name == name) else {
        let known: Vec<&str> = every().map(|study| study.name).collect();
        return Err(Failure::Call(format!("no study {name:?}: use all, or one of {}", known.join(", "))));
    };
    let outcome = check(study, &context)?;
    let words = outcome.words(study.about);
    keep(options, study.name, &words)?;
    let said = if options.json { print_json(&outcome) } else { say(&words) };
    said?;
    Ok(outcome.passed)
}

/// Runs one study. A failed step counts as a study outside of its limits, so that the other studies still run.
///
/// # Errors
/// A scene cannot start; any other failure, except a failed step.
pub fn check(study: &Study, context: &Context) -> Result<Outcome, Failure> {
    match (study.run)(context) {
        Err(Failure::Step(error)) => {
            let figure = Metric::below("failed steps", 1.0, 0.0);
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
        // each result is printed at once, since all studies together take minutes
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
            if passed { "all studies pass".into() } else { format!("outside their limits: {}", short.join(", ")) };
        say(&words)?;
    }
    Ok(passed)
}

/// Writes the report into the output folder, if there is one.
fn keep(options: &Options, name: &str, words: &str) -> Result<(), Failure> {
    let Some(folder) = &options.out else { return Ok(()) };
    make_folder(folder)?;
    write_text(&folder.join(format!("check-{name}.md")), words)
}

fn list(json: bool) -> Result<bool, Failure> {
    let every = STUDIES.iter().chain(LONG_STUDIES);
    if json {
        let all: Vec<_> = every.map(|s| serde_json::json!({ "name": s.name, "about": s.about })).collect();
        print_json(&all)?;
    } else {
        let lines: Vec<String> = every.map(|s| format!("{:20} {}", s.name, s.about)).collect();
        say(&lines.join("\n"))?;
    }
    Ok(true)
}
