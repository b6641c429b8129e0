//! `error`: error against run time of a case, over resolutions, time steps and formulas.
use crate::arguments::Common;
use crate::failure::Failure;
use crate::output::{deliver, make_folder, progress};
use crate::plot::{Mark, front_plot};
use crate::pool::Pool;
use crate::scenes::{LoadedScene, load};
use millpond_core::OwnedMemory;
use millpond_core::Solver;
use millpond_core::backend::hash::tree_sum;
use millpond_core::scene::{EquationOfState, Scene};
use serde::Serialize;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::time::Instant;

/// Options of `error`.
#[derive(Clone, Debug, clap::Args)]
pub struct Options {
    #[command(flatten)]
    common: Common,
    /// Use coarser particles: about half a minute
    #[arg(long)]
    quick: bool,
    /// Simulated time of each run, s
    #[arg(long, value_name = "SECONDS")]
    time: Option<f64>,
}

/// Result of `error`.
#[derive(Clone, Debug, Serialize)]
pub struct Study {
    /// Name of the case.
    pub case: String,
    /// All runs, in the order in which they were made.
    pub runs: Vec<Run>,
    /// Labels of the runs that no other run beats in both error and time, fastest first.
    pub pareto: Vec<String>,
    /// The reference solution, in words.
    pub reference: String,
    /// Path of the plot, if a folder was given.
    pub plot: Option<PathBuf>,
}

/// One run of a study.
#[derive(Clone, Debug, Serialize)]
pub struct Run {
    /// Name in tables and plots.
    pub label: String,
    /// Values of the varied settings.
    pub choice: BTreeMap<&'static str, String>,
    /// Number of particles.
    pub particles: usize,
    /// Time step, s.
    pub dt: f64,
    /// Wall time per simulated second, s.
    pub wall_s: f64,
    /// L2 error of the pressure, divided by the pressure at the floor; absent if the run failed.
    pub error: Option<f64>,
    /// Why the run failed.
    pub failure: Option<String>,
}

/// Values of the varied settings: particle spacings, and time steps as multiples of `spacing / speed_of_sound`.
#[derive(Clone, Copy, Debug)]
pub struct Ladder {
    spacings: [f32; 3],
    courant: [f32; 2],
    seconds: f64,
}

/// Name of the only case.
pub const CASE: &str = "still-tank";

/// Longest simulated time of a run, s.
const LONGEST: f64 = 1000.0;

/// Fields that the study sets itself, so that `--set` must not.
const STUDIED: [&str; 3] = ["particle_spacing", "time_step", "equation_of_state"];

const FULL: Ladder = Ladder { spacings: [0.025, 0.0125, 0.00625], courant: [0.4, 0.2], seconds: 1.0 };
/// Coarse and short runs, for `--quick` and the showcase.
pub const QUICK: Ladder = Ladder { spacings: [0.05, 0.025, 0.0125], courant: [0.4, 0.2], seconds: 1.0 };

/// Steps between two samples of the mean profile, which is taken over the second half of a run. The column still
/// oscillates a little, so a single state would depend on the phase of the sound wave.
const STEPS_PER_SAMPLE: u64 = 5;

/// Runs `error`. Returns false if a run failed.
///
/// # Errors
/// An unknown case, options that the study does not allow, or files that cannot be written.
pub fn execute(options: &Options) -> Result<bool, Failure> {
    let common = &options.common;
    if common.scene != CASE {
        return Err(Failure::Call(format!("no case {:?}: the only one is {CASE}", common.scene)));
    }
    if common.changes.particles.is_some() {
        return Err(Failure::Call("--particles has no meaning here: the study varies the particle spacing".into()));
    }
    let own = |change: &&String| STUDIED.iter().any(|f| change.split('=').next().is_some_and(|path| path.ends_with(f)));
    if let Some(change) = common.changes.set.iter().find(own) {
        return Err(Failure::Call(format!("--set {change} has no meaning here: it is what the study varies")));
    }
    let mut ladder = if options.quick { QUICK } else { FULL };
    ladder.seconds = options.time.unwrap_or(ladder.seconds);
    if !(ladder.seconds > 0.0 && ladder.seconds <= LONGEST) {
        return Err(Failure::Call(format!("--time {} must be larger than 0 and at most {LONGEST} s", ladder.seconds)));
    }
    let base = load(CASE, &common.changes)?;
    // times vary least with one thread
    let study = study(&base, &ladder, &Pool::new(common.threads.max(1))?, common.out.as_deref())?;
    deliver(common, "error-still-tank.md", &study, &table(&study))?;
    Ok(study.runs.iter().all(|run| run.error.is_some()))
}

/// Measures the hydrostatic profile of `still-tank` for three spacings, two time steps and two equations of state (Tait
/// and linear).
///
/// # Errors
/// Files that cannot be written.
pub fn study(base: &LoadedScene, ladder: &Ladder, pool: &Pool, folder: Option<&Path>) -> Result<Study, Failure> {
    let choices = ladder.spacings.iter().flat_map(|spacing| {
        let courant = ladder.courant.iter();
        courant.flat_map(move |c| [EquationOfState::Tait, EquationOfState::Linear].map(|eos| (*spacing, *c, eos)))
    });
    let choices: Vec<_> = choices.collect();
    let bar = progress("error still-tank", choices.len() as u64);
    let mut runs = Vec::new();
    for (spacing, courant, equation_of_state) in choices {
        let mut scene = base.file.scene.clone();
        scene.particle_spacing = spacing;
        scene.time_step = courant * spacing / scene.fluids[0].speed_of_sound;
        scene.model.equation_of_state = equation_of_state;
        let label = format!("{equation_of_state:?}, {spacing} m, C {courant}");
        let mut run = Run {
            label,
            choice: BTreeMap::from([
                ("equation_of_state", format!("{equation_of_state:?}")),
                ("particle_spacing", spacing.to_string()),
                ("courant_number", courant.to_string()),
            ]),
            particles: scene.check().map_or(0, |scene| scene.derived().particles()),
            dt: f64::from(scene.time_step),
            wall_s: 0.0,
            error: None,
            failure: None,
        };
        match measure(base, &scene, pool, ladder.seconds) {
            Ok((error, wall_s)) => (run.error, run.wall_s) = (Some(error), wall_s),
            Err(failure) => run.failure = Some(failure.to_string()),
        }
        runs.push(run);
        bar.inc(1);
    }
    bar.finish_and_clear();
    let pareto = pareto(&runs);
    let reference =
        "hydrostatic pressure p = rho0 g (H - y), H being the initial depth; compared: mean over the second half"
            .into();
    let mut study = Study { case: CASE.into(), runs, pareto, reference, plot: None };
    if let Some(folder) = folder {
        make_folder(folder)?;
        let path = folder.join("error-still-tank.svg");
        plot(&study, &path)?;
        study.plot = Some(path);
    }
    Ok(study)
}

/// Returns the error of the mean profile and the wall time per simulated second, s.
fn measure(base: &LoadedScene, scene: &Scene, pool: &Pool, seconds: f64) -> Result<(f64, f64), Failure> {
    let checked = scene.check().map_err(|error| Failure::Scene { origin: base.name.clone(), error })?;
    let mut heap = OwnedMemory::of(&checked);
    let mut solver = crate::fluid::start(&base.name, scene, &mut heap)?;
    let steps = (seconds / f64::from(scene.time_step)).round() as u64;
    let settled = steps / 2;
    let mut profile = Profile::new(solver.slots().len());
    let mut wall = 0.0;
    for step in 1..=steps {
        let start = Instant::now();
        solver.step(pool)?;
        wall += start.elapsed().as_secs_f64();
        if step > settled && step.is_multiple_of(STEPS_PER_SAMPLE) {
            profile.add(&solver);
        }
    }
    let error = profile.hydrostatic_error(scene);
    if !error.is_finite() {
        return Err(Failure::Call(format!("no profile after {steps} steps: time too short, or no gravity along -y")));
    }
    Ok((error, wall / (steps as f64 * f64::from(scene.time_step))))
}

/// Sums over time of each particle's height and pressure.
struct Profile {
    sums: Vec<[f64; 2]>,
    samples: f64,
}

impl Profile {
    fn new(particles: usize) -> Profile {
        Profile { sums: vec![[0.0; 2]; particles], samples: 0.0 }
    }

    fn add(&mut self, solver: &Solver<'_>) {
        self.samples += 1.0;
        for (sum, particle) in self.sums.iter_mut().zip(solver.particles()) {
            sum[0] += f64::from(particle.position.y);
            sum[1] += f64::from(particle.pressure);
        }
    }

    /// Returns the L2 error of the mean pressure against `rho0 g (H - y)`, divided by the pressure at the floor. All
    /// particles count, also those at the walls.
    fn hydrostatic_error(&self, scene: &Scene) -> f64 {
        let depth = f64::from(scene.blocks.iter().map(|b| b.corner[1] + b.size[1]).fold(0.0, f32::max));
        let weight = f64::from(scene.fluids[0].rest_density) * f64::from(-scene.gravity[1]);
        let square = |i: usize| {
            let [height, pressure] = self.sums[i].map(|sum| sum / self.samples);
            (pressure - weight * (depth - height).max(0.0)).powi(2)
        };
        let count = self.sums.len();
        (tree_sum(count, &square) / count as f64).sqrt() / (weight * depth)
    }
}

/// Returns the labels of the runs that no other run beats in both error and time, fastest first.
fn pareto(runs: &[Run]) -> Vec<String> {
    let mut done: Vec<(&Run, f64)> = runs.iter().filter_map(|run| run.error.map(|error| (run, error))).collect();
    done.sort_by(|(a, _), (b, _)| a.wall_s.total_cmp(&b.wall_s));
    let mut best = f64::INFINITY;
    let mut front = Vec::new();
    for (run, error) in done {
        if error < best {
            best = error;
            front.push(run.label.clone());
        }
    }
    front
}

fn plot(study: &Study, path: &Path) -> Result<(), Failure> {
    let marks: Vec<Mark> = study
        .runs
        .iter()
        .filter_map(|run| {
            let on_front = study.pareto.contains(&run.label);
            let choice = |key: &str| run.choice.get(key).cloned().unwrap_or_default();
            let series = format!("{}, C {}", choice("equation_of_state"), choice("courant_number"));
            let label = format!("{} m", choice("particle_spacing"));
            run.error.map(|y| Mark { series, label, x: run.wall_s, y, on_front })
        })
        .collect();
    let axes = ["wall time per simulated second, s", "L2 error of pressure / floor pressure"];
    front_plot(path, "still tank: error against run time", axes, &marks)
}

/// Formats the study as a Markdown page.
#[must_use]
pub fn table(study: &Study) -> String {
    let mut out = format!("# {}: error against run time\n\nReference: {}.\n\n", study.case, study.reference);
    out += "| run | particles | dt, s | wall s per s | error | front |\n| --- | --- | --- | --- | --- | --- |\n";
    for run in &study.runs {
        let error =
            run.error.map_or_else(|| run.failure.clone().unwrap_or_default(), |e| format!("{:.2} %", e * 100.0));
        let front = if study.pareto.contains(&run.label) { "*" } else { "" };
        out += &format!(
            "| {} | {} | {:.2e} | {:.2} | {error} | {front} |\n",
            run.label, run.particles, run.dt, run.wall_s
        );
    }
    out
}
