//! `run`: a scene on one backend, with pictures if asked.
use crate::arguments::{BackendName, Common, Length};
use crate::census::{FirstLast, MeanMax, census};
use crate::failure::Failure;
use crate::fluid::{Fluid, Snapshot};
use crate::frames::Film;
use crate::memory::Heap;
use crate::output::{deliver, make_folder, progress};
use crate::pool::Pool;
use crate::scenes::{Named, load};
use crate::span::Span;
use crate::timing::{Milliseconds, timed};
use crate::warnings::{gained, warnings};
use millpond_core::guided::particle_mass;
use millpond_core::layout::f32x4;
use millpond_core::scene::{EquationOfState, Kind, Scene, kind_of};
use millpond_core::{AirReport, CorrectionReport, TimeReport};
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
    /// Particles, those of walls too, and air that is not there.
    pub particles: usize,
    /// Of these, walls'.
    pub wall_particles: usize,
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
    /// Time steps that were made, s.
    pub time_step: TimeSteps,
    /// Courant numbers of the last step, on the support radius.
    pub courant: Courant,
    /// Compression beyond the rest density, as a share of it, after the last step.
    pub density_error: MeanMax,
    /// Energies before the first and after the last step, J (per metre of depth in 2D).
    pub energy: Energy,
    /// Iterations of pressure; absent with an equation of state.
    pub pressure_correction: Option<PressureCorrection>,
    /// The coat of air after the last step; absent where the scene has none.
    pub air: Option<Air>,
    /// State hash after the last step.
    pub hash: String,
    /// What a user should know.
    pub warnings: Vec<String>,
    /// Pictures drawn.
    pub pictures: Vec<PathBuf>,
}

/// Time steps of a run. On a GPU the smallest and largest are of those between two looks at its status.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct TimeSteps {
    /// Smallest, s.
    pub smallest: f64,
    /// Largest, s.
    pub largest: f64,
    /// The last, s.
    pub last: f64,
    /// Steps that were undone and made again, shorter.
    pub redone: u32,
    /// Steps that should have been shorter than the shortest allowed.
    pub held: u32,
}

/// Courant numbers: what [`Adaptive`](millpond_core::scene::Adaptive) limits.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Courant {
    /// `v dt / H` of the fastest particle.
    pub speed: f64,
    /// `dt sqrt(a / H)` of the one that is accelerated most.
    pub acceleration: f64,
    /// `c dt / H`; 0 where pressure is corrected.
    pub sound: f64,
    /// `nu dt / H^2`.
    pub viscosity: f64,
}

impl From<millpond_core::report::Courant> for Courant {
    fn from(courant: millpond_core::report::Courant) -> Courant {
        let millpond_core::report::Courant { speed, acceleration, sound, viscosity } = courant;
        Courant { speed, acceleration, sound, viscosity }
    }
}

/// Energies of the fluid.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Energy {
    /// Of motion.
    pub kinetic: FirstLast,
    /// Thermal; absent where the scene keeps no account of it.
    pub internal: Option<FirstLast>,
    /// In the field of gravity.
    pub potential: FirstLast,
    /// In springs; absent where the scene has none.
    pub elastic: Option<FirstLast>,
}

/// What iterating pressure came to.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct PressureCorrection {
    /// Iterations of a step, in the mean.
    pub mean_iterations: f64,
    /// Of the last step.
    pub last_iterations: u32,
    /// Largest density miss that the last step was left with, over the rest density.
    pub residual: f32,
}

/// What became of the coat of air.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Air {
    /// Particles that there are.
    pub alive: u32,
    /// Births for which none was left, in all steps.
    pub refused: u64,
}

/// Steps that a GPU makes between two looks at its status, and time is taken.
const STEPS_AT_ONCE: u64 = 16;

/// Runs `run`.
///
/// # Errors
/// A scene that cannot run, a step that cannot be made, files that cannot be written.
pub fn execute(options: &Options) -> Result<bool, Failure> {
    let named = load(&options.common.scene, &options.common.changes)?;
    let scene = &named.file.scene;
    let span = options.length.of(scene, || Span::of_seconds(scene, named.file.duration))?;
    let pool = Pool::new(options.common.threads)?;
    let frames = options.frames.unwrap_or(1);
    let folder = options.common.out.as_deref();
    let outcome = run(&named, options.backend, &pool, span, folder.map(|folder| (folder, frames)))?;
    deliver(&options.common, "report.md", &outcome, &report(&named, &outcome))?;
    Ok(true)
}

/// Runs a scene for so long, with so many pictures in that folder.
///
/// # Errors
/// As for [`execute`].
pub fn run(
    named: &Named,
    backend: BackendName,
    pool: &Pool,
    span: Span,
    pictures: Option<(&Path, u64)>,
) -> Result<Outcome, Failure> {
    let scene = &named.file.scene;
    let mut heap = Heap::of(scene);
    let mut fluid = Fluid::start(named, backend, &mut heap, pool)?;
    let first = fluid.snapshot()?;
    let first_census = census(scene, &first)?;
    let first_elastic = fluid.elastic_energy(&first);
    let mut film = Film::none();
    if let Some((folder, count)) = pictures {
        make_folder(folder)?;
        film = Film::new(named, folder, count, span);
    }

    // a bar counts whole numbers: steps, or thousandths of a time
    let per_unit = if matches!(span, Span::Steps(_)) { 1.0 } else { 1000.0 / span.length() };
    let bar = progress(&format!("run {}", named.name), (span.length() * per_unit) as u64);
    let mut times = Vec::new();
    let mut done = 0;
    let mut clock = fluid.time_report()?;
    let mut lengths = Vec::new();
    film.shoot(0.0, 0.0, &first)?;
    let start = std::time::Instant::now();
    while span.passed(done, clock.time) < span.length() {
        let until = film.next().unwrap_or(span.length()).min(span.length());
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
            film.shoot(passed, clock.time, &fluid.snapshot()?)?;
        }
    }
    let wall_s = start.elapsed().as_secs_f64();
    bar.finish_and_clear();

    let last = fluid.snapshot()?;
    let pressure_correction = if scene.model.equation_of_state == EquationOfState::PressureCorrection {
        let CorrectionReport { iterations, total_iterations, residual } = fluid.correction()?;
        let mean_iterations = total_iterations as f64 / done.max(1) as f64;
        Some(PressureCorrection { mean_iterations, last_iterations: iterations, residual })
    } else {
        None
    };
    let air = match scene.air {
        Some(_) => {
            let AirReport { alive, refused } = fluid.air()?;
            Some(Air { alive, refused })
        }
        None => None,
    };
    let last_census = census(scene, &last)?;
    let neighbours = FirstLast { first: first_census.average_neighbours, last: last_census.average_neighbours };
    let refused = air.map_or(0, |air: Air| air.refused);
    let mut warnings = warnings(scene, &last_census, refused);
    warnings.extend(held(&clock));
    warnings.extend(gained(scene, &first_census, &last_census));
    Ok(Outcome {
        scene: named.name.clone(),
        backend: fluid.backend(),
        particles: last.position.len(),
        wall_particles: scene.wall_count(),
        steps: done,
        simulated_s: clock.time,
        wall_s,
        ms_per_step: Milliseconds::of(&times),
        average_neighbours: neighbours,
        time_step: TimeSteps {
            smallest: f64::from(lengths.iter().copied().fold(clock.time_step, f32::min)),
            largest: f64::from(lengths.iter().copied().fold(clock.time_step, f32::max)),
            last: f64::from(clock.time_step),
            redone: clock.redone,
            held: clock.held,
        },
        courant: last_census.courant.into(),
        density_error: last_census.density_error.into(),
        energy: Energy {
            kinetic: FirstLast { first: first_census.energies.kinetic, last: last_census.energies.kinetic },
            internal: scene
                .model
                .thermal_energy
                .then_some(FirstLast { first: thermal_energy(scene, &first), last: thermal_energy(scene, &last) }),
            potential: FirstLast { first: first_census.energies.potential, last: last_census.energies.potential },
            elastic: scene
                .fluids()
                .any(|fluid| fluid.elastic_stiffness > 0.0)
                .then(|| FirstLast { first: first_elastic, last: fluid.elastic_energy(&last) }),
        },
        pressure_correction,
        air,
        hash: format!("{:016x}", last.hash()),
        warnings,
        pictures: film.finish(),
    })
}

/// Was a step longer than it should have been, because none may be shorter?
fn held(clock: &TimeReport) -> Option<String> {
    (clock.held > 0).then(|| {
        let (held, wanted) = (clock.held, clock.wanted);
        format!("{held} steps should have been shorter than adaptive.smallest (the last one wanted {wanted:.1e} s)")
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
    let TimeSteps { smallest, largest, last, redone, .. } = o.time_step;
    if smallest < largest || redone > 0 {
        let words = format!("{smallest:.2e} to {largest:.2e} s, the last {last:.2e} s, {redone} made again");
        row("time step", words);
    }
    let Courant { speed, acceleration, sound, viscosity } = o.courant;
    let numbers =
        format!("speed {speed:.3}, acceleration {acceleration:.3}, sound {sound:.3}, viscosity {viscosity:.4}");
    row("Courant numbers", numbers);
    row("neighbours", format!("{:.1} first, {:.1} last", o.average_neighbours.first, o.average_neighbours.last));
    let MeanMax { mean, max } = o.density_error;
    row("compression", format!("{:.2} % mean, {:.1} % largest", mean * 100.0, max * 100.0));
    let energy = o.energy;
    row("kinetic energy", format!("{:.4e} J first, {:.4e} J last", energy.kinetic.first, energy.kinetic.last));
    if let Some(internal) = energy.internal {
        row("thermal energy", format!("{:.4e} J first, {:.4e} J last", internal.first, internal.last));
    }
    row("potential energy", format!("{:.4e} J first, {:.4e} J last", energy.potential.first, energy.potential.last));
    if let Some(elastic) = energy.elastic {
        row("elastic energy", format!("{:.4e} J first, {:.4e} J last", elastic.first, elastic.last));
    }
    if let Some(p) = o.pressure_correction {
        let (mean, last, left) = (p.mean_iterations, p.last_iterations, p.residual * 100.0);
        row("iterations of pressure", format!("{mean:.1} a step, {last} in the last, which leaves {left:.2} %"));
    }
    if let Some(Air { alive, refused }) = o.air {
        row("coat of air", format!("{alive} particles, {refused} births refused"));
    }
    row("hash", o.hash.clone());
    for warning in &o.warnings {
        out += &format!("\nWarning: {warning}.\n");
    }
    if let (Some(first), Some(last)) = (o.pictures.first(), o.pictures.last()) {
        out += &format!("\n{} pictures: {} to {}\n", o.pictures.len(), first.display(), last.display());
    }
    out
}

/// Thermal energy of a state, J.
fn thermal_energy(scene: &Scene, state: &Snapshot) -> f64 {
    let mass = particle_mass(scene) / f64::from(scene.fluid.rest_density);
    let density = |v: &f32x4| match kind_of(v[3] as u32, scene) {
        Some(Kind::Fluid(fluid)) => f64::from(scene.fluid_of(fluid).rest_density),
        _ => 0.0,
    };
    let fluid = state.heat.iter().zip(&state.position).zip(&state.velocity);
    fluid.map(|((heat, x), v)| mass * density(v) * f64::from(x[3]) * f64::from(heat[0])).sum()
}
