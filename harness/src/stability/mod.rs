//! `stability`: how large a time step may be, over axes such as stiffness, viscosity and integrator.
//!
//! Every combination of the axes' values is a point. Where the time step is an axis, each point is run and classified;
//! where it is not, each is bisected for its largest stable step. Points run side by side, each on one thread, and are
//! told in the order of the axes. With a folder, a point that is finished is not run again.
//!
//! `axis` says what varies, `point` runs a point, by `classify`, `energy` and `bounds` (what is stable) and `bisect`; `resume` keeps
//! what is done, `map` and `picture` show it. `tower` is a suite of its own.
mod axis;
mod bisect;
mod bounds;
mod classify;
mod map;
mod picture;
mod point;
mod resume;
mod tower;

pub use axis::Axis;
pub use classify::Criterion;

use crate::arguments::Common;
use crate::energy::driven_by;
use crate::failure::Failure;
use crate::output::{deliver, make_folder, progress, write_json};
use crate::pool::Pool;
use crate::scenes::{SceneFile, load};
use axis::{choices, choose, parse_all};
use point::{Limits, Point};
use resume::ResumeLog;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::path::PathBuf;

/// Options of `stability`.
#[derive(Clone, Debug, clap::Args)]
pub struct Options {
    #[command(flatten)]
    common: Common,
    /// What varies, as often as wanted: a name alone (integrator, equation_of_state, average_neighbours, speed_of_sound,
    /// stiffness, viscosity, density_ratio, drop_speed, time_step) or any field, with its values. Without time_step each
    /// point is bisected for its largest stable one
    #[arg(long, value_name = "NAME[=VALUE,VALUE]")]
    axis: Vec<String>,
    /// Simulated seconds of each run (default the scene's own)
    #[arg(long, value_name = "SECONDS")]
    time: Option<f64>,
    /// Most steps of a run: a point that needs more is left undone, and told
    #[arg(long, value_name = "N", default_value_t = 200_000)]
    most_steps: u64,
    /// Run finished points again
    #[arg(long, requires = "out")]
    fresh: bool,
}

/// What a point came to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Outcome {
    /// Its step is stable, or there is one that is.
    Stable,
    /// It is not, or there is none.
    Unstable,
    /// It cannot run, or would take too many steps.
    Refused,
}

impl Outcome {
    /// In a word.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Outcome::Stable => "stable",
            Outcome::Unstable => "unstable",
            Outcome::Refused => "refused",
        }
    }
}

/// Courant numbers of a time step: how far sound travels in it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Courant {
    /// In support radii, `c dt / H`.
    pub support: f32,
    /// In particle spacings, `c dt / dx`.
    pub spacing: f32,
}

/// A point of the map.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Run {
    /// Its choice in a line.
    pub label: String,
    /// A value for each axis.
    pub choice: BTreeMap<String, String>,
    /// What it came to.
    pub outcome: Outcome,
    /// The same in words.
    pub detail: String,
    /// What a step that is too long breaks, here or above the largest stable one; absent where none did.
    pub criterion: Option<Criterion>,
    /// Refused because it takes more steps than are allowed?
    pub too_long: bool,
    /// Its time step, or the largest stable one, s; absent where there is none.
    pub time_step: Option<f32>,
    /// The smallest unstable step that was found above it, s.
    pub unstable_time_step: Option<f32>,
    /// Courant numbers of `time_step`; absent where pressure is iterated, as no sound then limits the step.
    pub courant: Option<Courant>,
    /// Particles, those of walls too.
    pub particles: usize,
    /// Steps that were made, in all trials.
    pub steps: u64,
}

/// Result of `stability`.
#[derive(Clone, Debug, Serialize)]
pub struct Suite {
    /// The scene.
    pub suite: String,
    /// What varied.
    pub axes: Vec<Axis>,
    /// Simulated time of each run, s.
    pub time_s: f64,
    /// All points, in the order of the axes.
    pub runs: Vec<Run>,
    /// Why energy is not judged; absent where it is.
    pub energy_not_judged: Option<String>,
    /// The map, where a folder was given.
    pub picture: Option<PathBuf>,
}

/// Longest run that one may ask for, s.
const LONGEST: f64 = 1000.0;

/// Points of a map at most: more than anybody looks at.
const MOST_POINTS: usize = 10_000;

/// Runs `stability`; false where points were left undone.
///
/// # Errors
/// A scene or an axis that is none, files that cannot be written.
pub fn execute(options: &Options) -> Result<bool, Failure> {
    let common = &options.common;
    let base = load(&common.scene, &common.changes)?;
    let seconds = options.time.unwrap_or(base.file.duration);
    if !(seconds > 0.0 && seconds <= LONGEST) {
        return Err(Failure::Call(format!("--time {seconds} is not between 0 and {LONGEST} s")));
    }
    let pool = Pool::new(common.threads)?;
    if common.scene == tower::NAME && options.axis.is_empty() {
        if options.fresh {
            return Err(Failure::Call(
                "--fresh has no meaning for the tower, which takes seconds and keeps nothing".into(),
            ));
        }
        return tower::execute(common, &base, seconds, options.most_steps, &pool);
    }
    let axes = parse_all(&options.axis)?;
    let points = points(&axes, &base.file)?;
    let ledger = match &common.out {
        Some(folder) => {
            make_folder(folder)?;
            ResumeLog::open(&folder.join("stability.jsonl"), options.fresh)?
        }
        None => ResumeLog::default(),
    };
    let bar = progress(&format!("stability {}", base.name), points.len() as u64);
    let limits = Limits { seconds, most_steps: options.most_steps };
    let runs = pool.map(&points, |point| {
        let run = limits.run(point, &ledger);
        bar.inc(1);
        run
    });
    let runs = runs.into_iter().collect::<Result<Vec<Run>, Failure>>()?;
    bar.finish_and_clear();
    let driven = points.iter().find_map(|point| driven_by(&point.scene));
    let energy_not_judged = driven.map(|what| format!("{what} does work on the fluid"));
    let mut suite = Suite { suite: base.name, axes, time_s: seconds, runs, energy_not_judged, picture: None };
    let map = map::Map::of(&suite.axes, &suite.runs);
    if let Some(folder) = &common.out {
        let path = folder.join("stability.svg");
        picture::draw(&path, &suite, &map)?;
        suite.picture = Some(path);
        write_json(&folder.join("stability.json"), &suite)?;
    }
    deliver(common, "stability.md", &suite, &map::words(&suite, &map))?;
    Ok(suite.runs.iter().all(|run| !run.too_long))
}

/// Every point of the axes, its choice made.
fn points(axes: &[Axis], file: &SceneFile) -> Result<Vec<Point>, Failure> {
    let count = axes.iter().fold(1usize, |count, axis| count.saturating_mul(axis.values.len()));
    if count > MOST_POINTS {
        return Err(Failure::Call(format!("the axes have {count} points, and a map has at most {MOST_POINTS}")));
    }
    let point = |choice| Ok(Point { scene: choose(file, &choice)?.scene, choice });
    choices(axes).into_iter().map(point).collect()
}
