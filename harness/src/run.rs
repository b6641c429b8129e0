//! `run`: runs a scene on one backend and draws pictures if asked to.
use crate::arguments::{BackendName, Common, Length};
use crate::failure::Failure;
use crate::fluid::Fluid;
use crate::frames::FrameRecorder;
use crate::gauges::Record;
use crate::output::{deliver, make_folder, progress};
use crate::pool::Pool;
use crate::run_length::RunLength;
use crate::scenes::{LoadedScene, load};
use crate::snapshot::Snapshot;
use crate::state_summary::{FirstLast, StateSummary, summarize};
use crate::timing::{Milliseconds, timed};
use crate::warnings::{gained, warnings};
use millpond_core::OwnedMemory;
use millpond_core::backend::derive::{Material, material_of};
use millpond_core::backend::layout::f32x4;
use millpond_core::{AirReport, Census, Checked, CorrectionReport, Flux, TimeReport};
use std::path::Path;

mod report;
pub use report::{Air, Courant, Energy, Outcome, PressureCorrection, TimeSteps, Turnover, report};

/// Options of `run`.
#[derive(Clone, Debug, clap::Args)]
pub struct Options {
    #[command(flatten)]
    common: Common,
    #[command(flatten)]
    length: Length,
    /// Backend to run on
    #[arg(long, value_enum, default_value = "cpu")]
    backend: BackendName,
    /// Number of pictures to draw, at equal intervals (needs --out; default 1: the final state)
    #[arg(long, value_name = "N", requires = "out")]
    frames: Option<u64>,
    /// Simulated time between two samples of the scene's gauges (default: a thousandth of the run)
    #[arg(long, value_name = "SECONDS", requires = "out")]
    gauges_every: Option<f64>,
}

/// Number of steps that a GPU makes between two reads of its status. Times are taken there.
const STEPS_AT_ONCE: u64 = 16;

/// Runs `run`.
///
/// # Errors
/// A scene that cannot run, a step that cannot be made, files that cannot be written.
pub fn execute(options: &Options) -> Result<bool, Failure> {
    let named = load(&options.common.scene, &options.common.changes)?;
    let scene = &named.file.scene;
    let span = options.length.of(scene, || RunLength::of_seconds(scene, named.file.duration))?;
    let pool = Pool::new(options.common.threads)?;
    let frames = options.frames.unwrap_or(1);
    let folder = options.common.out.as_deref();
    let record = Record::new(scene, &named.file.gauges, span, options.gauges_every)?;
    let outcome = run(&named, options.backend, &pool, span, folder.map(|folder| (folder, frames)), record)?;
    deliver(&options.common, "report.md", &outcome, &report(&named, &outcome))?;
    Ok(true)
}

/// Runs a scene. `pictures` is the folder and the number of pictures, and `record` takes the samples of its gauges.
///
/// # Errors
/// As for [`execute`].
pub fn run(
    named: &LoadedScene,
    backend: BackendName,
    pool: &Pool,
    span: RunLength,
    pictures: Option<(&Path, u64)>,
    mut record: Record<'_>,
) -> Result<Outcome, Failure> {
    let scene = &named.checked()?;
    let mut heap = OwnedMemory::of(scene);
    let mut fluid = Fluid::start(named, backend, &mut heap, pool)?;
    let first = fluid.snapshot()?;
    let first_summary = summarize(scene, &first)?;
    let first_elastic = fluid.elastic_energy(&first);
    let mut film = FrameRecorder::none();
    if let Some((folder, count)) = pictures {
        make_folder(folder)?;
        film = FrameRecorder::new(named, folder, count, span);
    }

    // a progress bar counts integers: steps, or thousandths of the simulated time
    let per_unit = if matches!(span, RunLength::Steps(_)) { 1.0 } else { 1000.0 / span.length() };
    let bar = progress(&format!("run {}", named.name), (span.length() * per_unit) as u64);
    let mut times = Vec::new();
    let mut done = 0;
    let mut clock = fluid.time_report()?;
    let mut lengths = Vec::new();
    film.capture(0.0, 0.0, &first)?;
    if record.next().is_some() {
        record.sample(0.0, 0.0, fluid.measured()?);
    }
    let start = std::time::Instant::now();
    while span.passed(done, clock.time) < span.length() {
        let due = film.next().into_iter().chain(record.next());
        let until = due.fold(span.length(), f64::min);
        let at_once = if backend == BackendName::Gpu { STEPS_AT_ONCE } else { 1 };
        let count = span.steps_to(until, done, clock, scene, at_once);
        let (result, ms) = timed(|| fluid.step(count as u32));
        result?;
        times.push(ms / count as f64);
        done += count;
        clock = fluid.time_report()?;
        lengths.push(clock.time_step);
        let passed = span.passed(done, clock.time);
        bar.set_position((passed * per_unit) as u64);
        if film.next().is_some_and(|due| passed >= due) {
            film.capture(passed, clock.time, &fluid.snapshot()?)?;
        }
        if record.next().is_some_and(|due| passed >= due) {
            record.sample(passed, clock.time, fluid.measured()?);
        }
    }
    let wall_s = start.elapsed().as_secs_f64();
    bar.finish_and_clear();

    let last = fluid.snapshot()?;
    let pressure_correction = if scene.corrects_pressure() {
        let CorrectionReport { iterations, total_iterations, residual } = fluid.correction()?;
        let mean_iterations = total_iterations as f64 / done.max(1) as f64;
        Some(PressureCorrection { mean_iterations, last_iterations: iterations, residual })
    } else {
        None
    };
    let air = match scene.air {
        Some(_) => {
            let AirReport { active, refused } = fluid.air()?;
            Some(Air { alive: active, refused })
        }
        None => None,
    };
    let turnover = turnover(scene, &fluid)?;
    let last_summary = summarize(scene, &last)?;
    let neighbours = FirstLast { first: first_summary.average_neighbours, last: last_summary.average_neighbours };
    // air and emitters share the inactive particles, and one count of those that were missing
    let refused = air.filter(|_| turnover.is_none()).map_or(0, |air: Air| air.refused);
    let mut warnings = warnings(scene, &last_summary, refused);
    warnings.extend(held(&clock));
    warnings.extend(turnover.and_then(not_made));
    warnings.extend(gained(scene, &first_summary, &last_summary));
    let elastic = FirstLast { first: first_elastic, last: fluid.elastic_energy(&last) };
    Ok(Outcome {
        scene: named.name.clone(),
        backend: fluid.backend(),
        particles: last.position().len(),
        wall_particles: scene.derived().wall_particles,
        steps: done,
        simulated_s: clock.time,
        wall_s,
        ms_per_step: Milliseconds::of(&times),
        average_neighbours: neighbours,
        time_step: TimeSteps {
            smallest: f64::from(lengths.iter().copied().fold(clock.time_step, f32::min)),
            largest: f64::from(lengths.iter().copied().fold(clock.time_step, f32::max)),
            last: f64::from(clock.time_step),
            rejected_steps: clock.rejected_steps,
            clamped_steps: clock.clamped_steps,
            halvings: clock.halvings,
        },
        courant: last_summary.courant.into(),
        density_error: last_summary.density_error.into(),
        energy: energies(scene, [&first, &last], [&first_summary, &last_summary], elastic),
        pressure_correction,
        air,
        turnover,
        hash: format!("{:016x}", last.hash()),
        warnings,
        pictures: film.finish(),
        gauges: record.shown(),
        series: pictures.map(|(folder, _)| record.write(folder)).transpose()?.flatten(),
    })
}

/// Returns a warning if steps had the smallest allowed length and should have been shorter.
fn held(clock: &TimeReport) -> Option<String> {
    (clock.clamped_steps > 0).then(|| {
        let (held, wanted) = (clock.clamped_steps, clock.wanted);
        format!("{held} steps should have been shorter than adaptive.smallest (the last limit was {wanted:.1e} s)")
    })
}

/// Returns what came and went, in a scene with emitters or drains.
fn turnover(scene: &Checked<'_>, fluid: &Fluid<'_>) -> Result<Option<Turnover>, Failure> {
    if scene.emitters.is_empty() && scene.drains.is_empty() {
        return Ok(None);
    }
    let Census { active, flux: Flux { born, removed, blocked, refused, .. } } = fluid.census()?;
    Ok(Some(Turnover { active, born, removed, blocked, refused }))
}

/// Returns a warning if emitters could not make all particles.
fn not_made(turnover: Turnover) -> Option<String> {
    let Turnover { born, blocked, refused, .. } = turnover;
    if refused > 0 {
        return Some(format!(
            "{refused} particles were not made, because no inactive particle was left: increase spare_particles, or air.capacity"
        ));
    }
    // a few are blocked where a jet starts beside other fluid
    (blocked * 100 > born).then(|| {
        format!(
            "{blocked} particles were not made, because their place was taken: let the fluid leave the emitter faster"
        )
    })
}

/// Returns the energies of the first and the last state.
fn energies(scene: &Checked<'_>, states: [&Snapshot; 2], summaries: [&StateSummary; 2], elastic: FirstLast) -> Energy {
    let of =
        |number: &dyn Fn(&StateSummary) -> f64| FirstLast { first: number(summaries[0]), last: number(summaries[1]) };
    let internal = FirstLast { first: internal_energy(scene, states[0]), last: internal_energy(scene, states[1]) };
    Energy {
        kinetic: of(&|summary| summary.energies.kinetic),
        internal: scene.model.internal_energy.then_some(internal),
        potential: of(&|summary| summary.energies.potential),
        elastic: scene.fluids.iter().any(|fluid| fluid.elastic_stiffness > 0.0).then_some(elastic),
    }
}

/// Returns the internal energy of a state, J.
fn internal_energy(scene: &Checked<'_>, state: &Snapshot) -> f64 {
    let mass = scene.derived().particle_mass / f64::from(scene.fluids[0].rest_density);
    let density = |v: &f32x4| match material_of(v[3] as u32, scene) {
        Some(Material::Fluid(fluid)) => f64::from(scene.fluid_of(fluid).rest_density),
        _ => 0.0,
    };
    let fluid = state.internal_energy().iter().zip(state.position()).zip(state.velocity());
    fluid.map(|((heat, x), v)| mass * density(v) * f64::from(x[3]) * f64::from(heat[0])).sum()
}
