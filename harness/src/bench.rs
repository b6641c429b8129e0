//! `bench`: how long a step takes, pass by pass.
use crate::arguments::{BackendName, Common};
use crate::census::{FirstLast, census};
use crate::failure::Failure;
use crate::fluid::start;
use crate::output::{deliver, progress};
use crate::plan_view::USUAL_PLACES;
use crate::pool::Pool;
use crate::scenes::{Changes, Named, load};
use crate::snapshot::Snapshot;
use crate::timing::{Milliseconds, timed};
use millpond_core::OwnedMemory;
use millpond_core::scene::GridStructure;
use millpond_core::{Checked, Executor, Pass, Requirements, Simd, Solver};
use millpond_gpu::{Gpu, GpuError, GpuSolver, Mode};
use serde::Serialize;
use std::time::Instant;

/// Options of `bench`.
#[derive(Clone, Debug, clap::Args)]
pub struct Options {
    #[command(flatten)]
    common: Common,
    /// Steps to time
    #[arg(long, default_value_t = 50, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    steps: u32,
    /// Steps to make before
    #[arg(long, default_value_t = 0, value_name = "N")]
    warm_up: u32,
    /// Where it runs
    #[arg(long, value_enum, default_value = "cpu")]
    backend: BackendName,
    /// How the CPU computes (default: the best it can)
    #[arg(long, value_enum)]
    simd: Option<SimdName>,
    /// Time the scene with both grid structures, in turn
    #[arg(long, conflicts_with = "scaling")]
    structures: bool,
    /// Time the scene at 4096, 32768 and 262144 particles and fit how the time grows with their number
    #[arg(long, conflicts_with = "particles")]
    scaling: bool,
}

/// A level of the CPU.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum SimdName {
    /// One particle at a time.
    Scalar,
    /// Lanes in the target's base instructions.
    Base,
    /// Lanes in AVX2.
    Avx2,
    /// Lanes in AVX-512.
    Avx512,
}

/// Result of `bench`.
#[derive(Clone, Debug, Serialize)]
pub struct Bench {
    /// The scene.
    pub scene: String,
    /// Particles.
    pub particles: usize,
    /// Threads that worked.
    pub threads: usize,
    /// Level of the CPU, or the device.
    pub simd: String,
    /// Time of a step.
    pub ms_per_step: Milliseconds,
    /// Shortest time of each pass, on a GPU by the device's own clock; empty on a GPU that has none.
    pub passes: Vec<PassTime>,
    /// Time of a step, ms, where a GPU is given all steps at once and asked for nothing in between.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ms_per_step_at_once: Option<f64>,
    /// Shortest step over the particles, ns.
    pub ns_per_particle_step: f64,
    /// Memory of the solver over the particles.
    pub bytes_per_particle: f64,
    /// Neighbours of a particle, itself counted.
    pub average_neighbours: FirstLast,
    /// Simulated time over the time it took, by the shortest step.
    pub real_time_factor: f64,
    /// With `--structures`: the scene with either grid structure.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub structures: Vec<StructureTime>,
    /// With `--scaling`: the sizes timed.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub scaling: Option<Scaling>,
}

/// Time of a pass.
#[derive(Clone, Debug, Serialize)]
pub struct PassTime {
    /// Which.
    pub name: &'static str,
    /// Shortest, ms.
    pub ms: f64,
}

/// Time with a grid structure.
#[derive(Clone, Debug, Serialize)]
pub struct StructureTime {
    /// Which.
    pub structure: String,
    /// Time of a step, steps with the two structures being taken in turn.
    pub ms_per_step: Milliseconds,
    /// Memory of the solver over the particles.
    pub bytes_per_particle: f64,
}

/// How time grows with the number of particles.
#[derive(Clone, Debug, Serialize)]
pub struct Scaling {
    /// Particles and shortest step, ms.
    pub sizes: Vec<(usize, f64)>,
    /// Exponent of the power law between the smallest and the largest.
    pub exponent: f64,
}

/// Sizes of `--scaling`.
const SCALING_SIZES: [u64; 3] = [4096, 32_768, 262_144];

/// Runs `bench`.
///
/// # Errors
/// A scene that cannot run, a step that cannot be made.
pub fn execute(options: &Options) -> Result<bool, Failure> {
    let result = if options.scaling {
        let mut benches = Vec::new();
        for particles in SCALING_SIZES {
            let changes = Changes { particles: Some(particles), ..options.common.changes.clone() };
            benches.push(bench(&load(&options.common.scene, &changes)?, options)?);
        }
        let sizes: Vec<(usize, f64)> = benches.iter().map(|b| (b.particles, b.ms_per_step.min)).collect();
        let [(n0, t0), .., (n1, t1)] = sizes[..] else { return Err(Failure::Call("nothing to scale".into())) };
        let exponent = (t1 / t0).ln() / (n1 as f64 / n0 as f64).ln();
        let last = benches.pop().ok_or_else(|| Failure::Call("nothing to scale".into()))?;
        Bench { scaling: Some(Scaling { sizes, exponent }), ..last }
    } else {
        bench(&load(&options.common.scene, &options.common.changes)?, options)?
    };
    deliver(&options.common, "bench.txt", &result, &table(&result))?;
    Ok(true)
}

/// Times one scene.
fn bench(named: &Named, options: &Options) -> Result<Bench, Failure> {
    let scene = &named.checked()?;
    let pool = Pool::new(options.common.threads)?;
    let mut heap = OwnedMemory::of(scene);
    let mut solver = start(&named.name, scene, &mut heap)?;
    if let Some(name) = options.simd {
        let simd = match name {
            SimdName::Scalar => Simd::Scalar,
            SimdName::Base => Simd::Base,
            SimdName::Avx2 => Simd::Avx2,
            SimdName::Avx512 => Simd::Avx512,
        };
        if options.backend == BackendName::Gpu || simd.or_best() != simd {
            return Err(Failure::Call(format!("--simd {name:?} is not available here").to_lowercase()));
        }
        solver = solver.at_level(simd);
    }
    if options.structures && options.backend == BackendName::Gpu {
        return Err(Failure::Call("--structures times the CPU alone: leave --backend gpu out".into()));
    }
    let simd = solver.simd();
    let bar = progress(&format!("bench {}", named.name), u64::from(options.warm_up) + u64::from(options.steps));
    let timed = match options.backend {
        BackendName::Cpu => time_cpu(&mut solver, &pool, options, &bar)?,
        BackendName::Gpu => time_gpu(&solver, options, &bar)?,
    };
    bar.finish_and_clear();
    let needs = Requirements::of(scene);
    let ms_per_step = Milliseconds::of(&timed.steps);
    let [first, last] = [&timed.first, &timed.last].map(|state| census(scene, state).map(|c| c.average_neighbours));
    Ok(Bench {
        scene: named.name.clone(),
        particles: needs.counts.particles,
        threads: pool.width(),
        simd: timed.path,
        ms_per_step,
        passes: timed.passes,
        ms_per_step_at_once: timed.ms_at_once,
        ns_per_particle_step: ms_per_step.min * 1e6 / needs.counts.particles.max(1) as f64,
        bytes_per_particle: needs.bytes() as f64 / needs.counts.particles.max(1) as f64,
        average_neighbours: FirstLast { first: first?, last: last? },
        real_time_factor: f64::from(timed.last.clock.time_step) * 1e3 / ms_per_step.min,
        structures: if options.structures { structures(named, simd, &pool, options)? } else { Vec::new() },
        scaling: None,
    })
}

/// Times the scene with both grid structures, in turn.
fn structures(named: &Named, simd: Simd, pool: &Pool, options: &Options) -> Result<Vec<StructureTime>, Failure> {
    let lists = match named.file.scene.grid.structure {
        GridStructure::IndexSort => GridStructure::CellLists { places: USUAL_PLACES },
        lists @ GridStructure::CellLists { .. } => lists,
    };
    let scenes = [GridStructure::IndexSort, lists].map(|structure| {
        let mut scene = named.file.scene.clone();
        scene.grid.structure = structure;
        scene
    });
    let refused = |error| Failure::Scene { origin: named.name.clone(), error };
    let checked = scenes.iter().map(|scene| scene.check().map_err(refused)).collect::<Result<Vec<_>, _>>()?;
    let mut heaps = [OwnedMemory::of(&checked[0]), OwnedMemory::of(&checked[1])];
    let mut solvers = Vec::new();
    for (scene, heap) in checked.iter().zip(&mut heaps) {
        solvers.push(start(&named.name, scene, heap)?.at_level(simd));
    }
    for solver in &mut solvers {
        for _ in 0..options.warm_up {
            solver.step(pool)?;
        }
    }
    let mut times = [Vec::new(), Vec::new()];
    for _ in 0..options.steps {
        for (solver, times) in solvers.iter_mut().zip(&mut times) {
            let (result, ms) = timed(|| solver.step(pool));
            result?;
            times.push(ms);
        }
    }
    let of = |(scene, times): (&Checked<'_>, &Vec<f64>)| {
        let requirements = Requirements::of(scene);
        StructureTime {
            structure: format!("{:?}", scene.grid.structure),
            ms_per_step: Milliseconds::of(times),
            bytes_per_particle: requirements.bytes() as f64 / requirements.counts.particles.max(1) as f64,
        }
    };
    Ok(checked.iter().zip(&times).map(of).collect())
}

/// What was timed.
struct Timed {
    path: String,
    steps: Vec<f64>,
    passes: Vec<PassTime>,
    ms_at_once: Option<f64>,
    first: Snapshot,
    last: Snapshot,
}

fn time_cpu(
    solver: &mut Solver<'_>,
    pool: &Pool,
    options: &Options,
    bar: &indicatif::ProgressBar,
) -> Result<Timed, Failure> {
    for _ in 0..options.warm_up {
        solver.step(pool)?;
        bar.inc(1);
    }
    let first = Snapshot::of_cpu(solver);
    let mut steps = Vec::new();
    let mut shortest = Shortest::default();
    for _ in 0..options.steps {
        let mut marks: Vec<(Pass, Instant)> = Vec::with_capacity(Pass::ALL.len());
        let (result, ms) = timed(|| solver.step_observed(pool, &mut |pass| marks.push((pass, Instant::now()))));
        let end = Instant::now();
        result?;
        steps.push(ms);
        let ends = marks.iter().skip(1).map(|(_, begin)| *begin).chain([end]);
        let took = marks.iter().zip(ends).map(|((pass, begin), end)| (*pass, (end - *begin).as_secs_f64() * 1e3));
        shortest.add_step(took);
        bar.inc(1);
    }
    Ok(Timed {
        path: format!("{:?}", solver.simd()).to_lowercase(),
        steps,
        passes: shortest.passes(),
        ms_at_once: None,
        first,
        last: Snapshot::of_cpu(solver),
    })
}

/// The shortest time of each pass over the steps.
struct Shortest([f64; Pass::ALL.len()]);

impl Default for Shortest {
    fn default() -> Shortest {
        Shortest([f64::INFINITY; Pass::ALL.len()])
    }
}

impl Shortest {
    /// Takes in the times of a step. A pass that runs more than once in it takes as long as all of its runs.
    fn add_step(&mut self, times: impl Iterator<Item = (Pass, f64)>) {
        let mut took = [None; Pass::ALL.len()];
        for (pass, ms) in times {
            *took[pass as usize].get_or_insert(0.0) += ms;
        }
        for (best, took) in self.0.iter_mut().zip(took) {
            *best = took.map_or(*best, |took| best.min(took));
        }
    }

    /// Those of the passes that ran.
    fn passes(&self) -> Vec<PassTime> {
        let ran = Pass::ALL.into_iter().zip(self.0).filter(|(_, ms)| ms.is_finite());
        ran.map(|(pass, ms)| PassTime { name: pass.name(), ms }).collect()
    }
}

fn time_gpu(solver: &Solver<'_>, options: &Options, bar: &indicatif::ProgressBar) -> Result<Timed, Failure> {
    let gpu = Gpu::open(None, Mode::Strict)?;
    let mut solver = GpuSolver::new(&gpu, solver)?;
    // the first step makes the driver compile
    solver.step(options.warm_up.max(1))?;
    bar.inc(u64::from(options.warm_up));
    let first = Snapshot::of_gpu(&solver)?;
    let mut steps = Vec::new();
    for _ in 0..options.steps {
        let (result, ms) = timed(|| solver.step(1));
        result?;
        steps.push(ms);
        bar.inc(1);
    }
    let last = Snapshot::of_gpu(&solver)?;
    let (result, ms) = timed(|| solver.step(options.steps));
    result?;
    let ms_at_once = Some(ms / f64::from(options.steps));
    let mut shortest = Shortest::default();
    for _ in 0..options.steps {
        match solver.step_timed() {
            Ok(times) => shortest.add_step(times.into_iter()),
            Err(GpuError::NoPassTimes { .. } | GpuError::TooManyPasses { .. }) => break,
            Err(error) => return Err(error.into()),
        }
    }
    Ok(Timed { path: gpu.name(), steps, passes: shortest.passes(), ms_at_once, first, last })
}

/// The times in words.
fn table(b: &Bench) -> String {
    let mut out = format!("{}: {} particles, {} threads, {}\n", b.scene, b.particles, b.threads, b.simd);
    out += &format!("  {:8.3} ms a step at least, {:.3} median\n", b.ms_per_step.min, b.ms_per_step.median);
    if let Some(ms) = b.ms_per_step_at_once {
        out += &format!("  {ms:8.3} ms a step where the device is given all of them at once\n");
    }
    for pass in &b.passes {
        out += &format!("  {:8.3} ms {}\n", pass.ms, pass.name);
    }
    out += &format!(
        "  {:8.1} ns a particle and step, {:.0} bytes a particle\n",
        b.ns_per_particle_step, b.bytes_per_particle
    );
    out += &format!("  {:8.2} neighbours first, {:.2} last\n", b.average_neighbours.first, b.average_neighbours.last);
    out += &format!("  {:8.3} of real time\n", b.real_time_factor);
    for of in &b.structures {
        let (ms, bytes) = (of.ms_per_step, of.bytes_per_particle);
        out += &format!(
            "  {:8.3} ms a step at least, {:.3} median, {bytes:.0} bytes a particle with {}\n",
            ms.min, ms.median, of.structure
        );
    }
    if let Some(scaling) = &b.scaling {
        for (particles, ms) in &scaling.sizes {
            out += &format!("  {ms:8.3} ms a step at {particles} particles\n");
        }
        out += &format!("  time grows with the number of particles to the power {:.3}\n", scaling.exponent);
    }
    out
}
