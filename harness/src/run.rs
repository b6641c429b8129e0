//! `run`: a scene on one backend, with pictures if asked.
use crate::arguments::{BackendName, Common, Length};
use crate::census::{FirstLast, MeanMax, census};
use crate::failure::Failure;
use crate::fluid::Fluid;
use crate::frames::Film;
use crate::memory::Heap;
use crate::output::{deliver, make_folder, progress};
use crate::pool::Pool;
use crate::scenes::{Named, load};
use crate::timing::{Milliseconds, timed};
use millpond_core::guided::support_radius;
use millpond_core::scene::NearPressure;
use serde::Serialize;
use std::path::{Path, PathBuf};

/// Options of `run`.
#[derive(Clone, Debug, clap::Args)]
pub struct Options {
    #[command(flatten)]
    common: Common,
    #[command(flatten)]
    length: Length,
    /// Where it runs
    #[arg(long, value_enum, default_value = "cpu")]
    backend: BackendName,
    /// Pictures to draw, evenly over the run (with --out; default 1, the last state)
    #[arg(long, value_name = "N", requires = "out")]
    frames: Option<u64>,
}

/// Result of `run`.
#[derive(Clone, Debug, Serialize)]
pub struct Outcome {
    /// The scene.
    pub scene: String,
    /// What it ran on.
    pub backend: String,
    /// Particles.
    pub particles: usize,
    /// Steps made.
    pub steps: u64,
    /// Time that passed in the scene, s.
    pub simulated_s: f64,
    /// Time that passed here, pictures included, s.
    pub wall_s: f64,
    /// Time of a step; on a GPU, means over the steps between two looks at its status.
    pub ms_per_step: Milliseconds,
    /// Neighbours of a particle, itself counted.
    pub average_neighbours: FirstLast,
    /// Compression beyond the rest density, as a share of it, after the last step.
    pub density_error: MeanMax,
    /// State hash after the last step.
    pub hash: String,
    /// What a user should know.
    pub warnings: Vec<String>,
    /// Pictures drawn.
    pub pictures: Vec<PathBuf>,
}

/// Largest share of its support that sound and the fastest particle together may cross in a step: past it explicit
/// integration loses pairs it should have felt (Monaghan 1992).
const COURANT_LIMIT: f64 = 0.4;

/// Steps that a GPU makes between two looks at its status, and time is taken.
const STEPS_AT_ONCE: u64 = 16;

/// Runs `run`.
///
/// # Errors
/// A scene that cannot run, a step that cannot be made, files that cannot be written.
pub fn execute(options: &Options) -> Result<bool, Failure> {
    let named = load(&options.common.scene, &options.common.changes)?;
    let steps = options.length.in_steps(named.file.duration, named.file.scene.time_step)?;
    let pool = Pool::new(options.common.threads)?;
    let frames = options.frames.unwrap_or(1);
    let folder = options.common.out.as_deref();
    let outcome = run(&named, options.backend, &pool, steps, folder.map(|folder| (folder, frames)))?;
    deliver(&options.common, "report.md", &outcome, &report(&named, &outcome))?;
    Ok(true)
}

/// Runs a scene for `steps` steps, with so many pictures in that folder.
///
/// # Errors
/// As for [`execute`].
pub fn run(
    named: &Named,
    backend: BackendName,
    pool: &Pool,
    steps: u64,
    pictures: Option<(&Path, u64)>,
) -> Result<Outcome, Failure> {
    let scene = &named.file.scene;
    let mut heap = Heap::of(scene);
    let mut fluid = Fluid::start(named, backend, &mut heap, pool)?;
    let first = fluid.snapshot()?;
    let first_census = census(scene, &first)?;
    let mut film = Film::none();
    if let Some((folder, count)) = pictures {
        make_folder(folder)?;
        film = Film::new(named, folder, count, steps);
    }

    let bar = progress(&format!("run {}", named.name), steps);
    let mut times = Vec::new();
    let mut done = 0;
    film.shoot(0, &first)?;
    let start = std::time::Instant::now();
    while done < steps {
        let until = film.next_step().unwrap_or(steps).clamp(done + 1, steps);
        let at_once = if backend == BackendName::Gpu { STEPS_AT_ONCE } else { 1 };
        let count = at_once.min(until - done);
        let (result, ms) = timed(|| fluid.step(count as u32));
        result?;
        times.push(ms / count as f64);
        done += count;
        bar.inc(count);
        if film.next_step() == Some(done) {
            film.shoot(done, &fluid.snapshot()?)?;
        }
    }
    let wall_s = start.elapsed().as_secs_f64();
    bar.finish_and_clear();

    let last = fluid.snapshot()?;
    let last_census = census(scene, &last)?;
    let neighbours = FirstLast { first: first_census.average_neighbours, last: last_census.average_neighbours };
    let sound = f64::from(scene.fluid.speed_of_sound);
    let courant = (sound + last_census.fastest) * f64::from(scene.time_step) / support_radius(scene);
    let mut warnings = Vec::new();
    if courant > COURANT_LIMIT {
        warnings.push(format!(
            "Courant number {courant:.2} is larger than {COURANT_LIMIT}: a smaller time_step or speed_of_sound is safer"
        ));
    }
    if scene.model.near_pressure != NearPressure::Off && !scene.model.suction {
        warnings
            .push("near pressure without suction has nothing to balance it: this liquid will expand like a gas".into());
    }
    if last_census.density_error.mean > 0.03 {
        let percent = last_census.density_error.mean * 100.0;
        warnings.push(format!(
            "the fluid is compressed by {percent:.1} % on average: a larger speed_of_sound holds better"
        ));
    }
    Ok(Outcome {
        scene: named.name.clone(),
        backend: fluid.backend(),
        particles: last.position.len(),
        steps: done,
        simulated_s: done as f64 * f64::from(scene.time_step),
        wall_s,
        ms_per_step: Milliseconds::of(&times),
        average_neighbours: neighbours,
        density_error: last_census.density_error.into(),
        hash: format!("{:016x}", last.hash()),
        warnings,
        pictures: film.finish(),
    })
}

/// The outcome as a page.
#[must_use]
pub fn report(named: &Named, outcome: &Outcome) -> String {
    let o = outcome;
    let mut out = format!("# {}: {}\n\n", o.scene, named.file.about);
    out += "| what | value |\n| --- | --- |\n";
    let mut row = |what: &str, value: String| out += &format!("| {what} | {value} |\n");
    row("backend", o.backend.clone());
    row("particles", o.particles.to_string());
    row("steps", format!("{} ({:.3} s simulated, {:.1} s here)", o.steps, o.simulated_s, o.wall_s));
    row("ms a step", format!("{:.2} at least, {:.2} median", o.ms_per_step.min, o.ms_per_step.median));
    row("neighbours", format!("{:.1} first, {:.1} last", o.average_neighbours.first, o.average_neighbours.last));
    let MeanMax { mean, max } = o.density_error;
    row("compression", format!("{:.2} % mean, {:.1} % largest", mean * 100.0, max * 100.0));
    row("hash", o.hash.clone());
    for warning in &o.warnings {
        out += &format!("\nWarning: {warning}.\n");
    }
    if let (Some(first), Some(last)) = (o.pictures.first(), o.pictures.last()) {
        out += &format!("\n{} pictures: {} to {}\n", o.pictures.len(), first.display(), last.display());
    }
    out
}
