//! `stability`: finds the largest stable time step as other parameters vary, such as stiffness, viscosity and
//! integrator.
//!
//! Every combination of the values on the axes is a point. If the time step is an axis, each point is run once and
//! classified. Otherwise each point is bisected for its largest stable time step. Points run in parallel, each on one
//! thread, and are reported in the order of the axes. With an output folder, finished points are kept and not run
//! again.
//!
//! Module `axis` defines what varies. `point` runs a point; `classify`, `energy` and `bounds` decide what is stable,
//! and `bisect` searches for the limit. `resume` keeps finished points. `map` and `picture` show the result. `tower` is
//! a separate suite.
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
use crate::scene_file::SceneFile;
use crate::scenes::load;
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
    /// What varies; may be given several times: a name alone (integrator, equation_of_state, average_neighbours,
    /// speed_of_sound, stiffness, viscosity, density_ratio, drop_speed, time_step), or any field, with its values.
    /// Without time_step each point is bisected for its largest stable time step
    #[arg(long, value_name = "NAME[=VALUE,VALUE]")]
    axis: Vec<String>,
    /// Simulated seconds of each run (default the scene's own)
    #[arg(long, value_name = "SECONDS")]
    time: Option<f64>,
    /// Largest number of steps of a run; a point that needs more is skipped and reported
    #[arg(long, value_name = "N", default_value_t = 200_000)]
    most_steps: u64,
    /// Run finished points again
    #[arg(long, requires = "out")]
    fresh: bool,
}

/// Outcome of a point.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Outcome {
    /// The time step is stable, or a stable one was found.
    Stable,
    /// The time step is unstable, or no stable one was found.
    Unstable,
    /// The scene cannot run, or would take too many steps.
    Refused,
}

impl Outcome {
    /// Returns its name.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Outcome::Stable => "stable",
            Outcome::Unstable => "unstable",
            Outcome::Refused => "refused",
        }
    }
}

/// Courant numbers of a time step: the distance that sound travels in one step.
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
    /// Its choice on one line.
    pub label: String,
    /// The value on each axis.
    pub choice: BTreeMap<String, String>,
    /// Its outcome.
    pub outcome: Outcome,
    /// Explanation of the outcome.
    pub detail: String,
    /// The criterion that this time step breaks, or the smallest unstable one; absent if no step broke a criterion.
    pub criterion: Option<Criterion>,
    /// Whether it was refused because it takes more steps than are allowed.
    pub too_long: bool,
    /// Its time step, or the largest stable one that was found, s; absent if there is none.
    pub time_step: Option<f32>,
    /// The smallest unstable time step that was found above it, s.
    pub unstable_time_step: Option<f32>,
    /// Courant numbers of `time_step`; absent with a pressure solver, since the speed of sound does not limit the time
    /// step then.
    pub courant: Option<Courant>,
    /// Number of particles, wall particles included.
    pub particles: usize,
    /// Number of steps made, all trials included.
    pub steps: u64,
}

/// Result of `stability`.
#[derive(Clone, Debug, Serialize)]
pub struct Suite {
    /// Name of the scene.
    pub suite: String,
    /// The axes.
    pub axes: Vec<Axis>,
    /// Simulated time of each run, s.
    pub time_s: f64,
    /// All points, in the order of the axes.
    pub runs: Vec<Run>,
    /// Why the criterion of energy growth does not apply; absent if it applies.
    pub energy_not_judged: Option<String>,
    /// File of the map; absent without an output folder.
    pub picture: Option<PathBuf>,
}

/// Longest simulated time that may be asked for, s.
const LONGEST: f64 = 1000.0;

/// Largest number of points of a map: more could not be read.
const MOST_POINTS: usize = 10_000;

/// Runs the study and returns whether all points were run: false if some were skipped.
///
/// # Errors
/// Returns an error for an unknown scene, an invalid axis, or a file that cannot be written.
pub fn execute(options: &Options) -> Result<bool, Failure> {
    let common = &options.common;
    let base = load(&common.scene, &common.changes)?;
    let seconds = options.time.unwrap_or(base.file.duration);
    if !(seconds > 0.0 && seconds <= LONGEST) {
        return Err(Failure::Call(format!("--time {seconds} must be above 0 and at most {LONGEST} seconds")));
    }
    let pool = Pool::new(common.threads)?;
    if common.scene == tower::NAME && options.axis.is_empty() {
        if options.fresh {
            return Err(Failure::Call(
                "--fresh does not apply to the tower: it takes seconds and keeps no finished points".into(),
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

/// Returns the points of all combinations of values, each with its scene.
fn points(axes: &[Axis], file: &SceneFile) -> Result<Vec<Point>, Failure> {
    let count = axes.iter().fold(1usize, |count, axis| count.saturating_mul(axis.values.len()));
    if count > MOST_POINTS {
        return Err(Failure::Call(format!(
            "the axes have {count} points, but a map has at most {MOST_POINTS}: give fewer values"
        )));
    }
    let point = |choice| Ok(Point { scene: choose(file, &choice)?.scene, choice });
    choices(axes).into_iter().map(point).collect()
}
