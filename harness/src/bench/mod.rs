//! `bench`: times of a step and of its passes.
mod against;
mod levels;
mod measure;
mod operations;
mod roofline;
mod structures;
mod table;

use crate::arguments::{BackendName, Common};
use crate::failure::Failure;
use crate::fluid::start;
use crate::output::{deliver, progress};
use crate::plan_view::{ArrayView, arrays};
use crate::pool::Pool;
use crate::scenes::{Changes, LoadedScene, load};
use crate::state_summary::{FirstLast, summarize};
use crate::timing::Milliseconds;
use levels::levels;
use measure::{time_cpu, time_gpu};
use millpond_core::scene::Traversal;
use millpond_core::{Executor, OwnedMemory, Requirements, Simd};
use roofline::{ceilings, costs};
use serde::Serialize;
use std::path::PathBuf;
use structures::structures;
use table::table;

/// Options of `bench`.
#[derive(Clone, Debug, clap::Args)]
pub struct Options {
    #[command(flatten)]
    common: Common,
    /// Number of steps to time
    #[arg(long, default_value_t = 50, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    steps: u32,
    /// Number of steps to make before the timed ones
    #[arg(long, default_value_t = 0, value_name = "N")]
    warm_up: u32,
    /// Backend to run on
    #[arg(long, value_enum, default_value = "cpu")]
    backend: BackendName,
    /// SIMD level of the CPU backend (default: the best that this processor has)
    #[arg(long, value_enum)]
    simd: Option<SimdName>,
    /// Also time the scene with each grid structure, alternately
    #[arg(long, conflicts_with = "scaling")]
    structures: bool,
    /// Time the scene with 4096, 32768, 262144 and 1000000 particles, and fit how the time grows with their number
    #[arg(long, conflicts_with = "particles")]
    scaling: bool,
    /// Run another build of this program alternately with this one, and compare their shortest steps
    #[arg(long, value_name = "BINARY", conflicts_with_all = ["scaling", "structures"])]
    against: Option<PathBuf>,
    /// Also time the scene at every SIMD level of this processor, alternately, with one thread and with --threads
    /// threads
    #[arg(long, conflicts_with_all = ["scaling", "structures", "against", "simd"])]
    levels: bool,
    /// Measure the peak rates of arithmetic and memory of this machine, and show which share of them each pass reaches
    #[arg(long, conflicts_with_all = ["scaling", "against"])]
    roofline: bool,
    /// With --against: number of runs of each build
    #[arg(long, default_value_t = 5, value_name = "N", requires = "against",
        value_parser = clap::value_parser!(u32).range(1..))]
    rounds: u32,
}

/// A SIMD level of the CPU.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum SimdName {
    /// No SIMD: one particle at a time
    Scalar,
    /// SIMD with the base instructions of the target
    Base,
    /// SIMD with AVX2
    Avx2,
    /// SIMD with AVX-512
    Avx512,
}

/// Result of `bench`.
#[derive(Clone, Debug, Serialize)]
pub struct Bench {
    /// Name of the scene.
    pub scene: String,
    /// Number of particles.
    pub particles: usize,
    /// Number of threads.
    pub threads: usize,
    /// SIMD level of the CPU, or name of the GPU.
    pub simd: String,
    /// Time of a step, ms.
    pub ms_per_step: Milliseconds,
    /// Shortest time of each pass, on a GPU by its own clock; empty if the GPU cannot measure it.
    pub passes: Vec<PassTime>,
    /// Time per step if a GPU is given all steps at once and its status is not read in between, ms.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ms_per_step_at_once: Option<f64>,
    /// Shortest step divided by the number of particles, ns.
    pub ns_per_particle_step: f64,
    /// Bytes of the solver's memory per particle.
    pub bytes_per_particle: f64,
    /// Mean number of neighbours of a particle, the particle itself included.
    pub average_neighbours: FirstLast,
    /// Simulated time divided by wall time, for the shortest step.
    pub real_time_factor: f64,
    /// The neighbour lists after the last step, on the CPU.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub lists: Option<ListView>,
    /// With `--roofline`: peak rates of the machine.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ceilings: Option<Ceilings>,
    /// With `--levels`: times at each SIMD level.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub levels: Vec<LevelTime>,
    /// Allocated arrays and their sizes.
    pub arrays: Vec<ArrayView>,
    /// With `--structures`: times with each grid structure.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub structures: Vec<StructureTime>,
    /// With `--scaling`: times for several numbers of particles.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub scaling: Option<Scaling>,
}

/// Time of a pass.
#[derive(Clone, Debug, Serialize)]
pub struct PassTime {
    /// Name of the pass.
    pub name: &'static str,
    /// Shortest time, ms.
    pub ms: f64,
    /// With `--roofline`: the pass compared with the peak rates.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub roof: Option<Roof>,
}

/// Arithmetic and memory traffic of a pass, compared with the peak rates of the machine.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Roof {
    /// Number of floating-point operations, without address computations and unused lanes. Known only for the passes
    /// over pairs that every scene has, and only if all groups have neighbour lists.
    pub operations: Option<u64>,
    /// Their rate divided by the peak rate of additions and multiplications.
    pub share_of_arithmetic: Option<f64>,
    /// Bytes of the arrays that the pass reads and writes, each counted once; unknown with the pressure correction.
    pub bytes: Option<u64>,
    /// Their rate divided by the peak rate of memory.
    pub share_of_memory: Option<f64>,
}

/// Peak rates of the machine, measured with the threads and at the SIMD level of the benchmark.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Ceilings {
    /// Additions and multiplications in registers, 1e9 per second.
    pub gigaoperations_per_second: f64,
    /// Bytes moved by a triad (a = b + s c) of long arrays, 1e9 per second.
    pub gigabytes_per_second: f64,
}

/// Time of a step at a SIMD level with a number of threads.
#[derive(Clone, Debug, Serialize)]
pub struct LevelTime {
    /// The SIMD level, as named by `--simd`.
    pub simd: String,
    /// Number of threads.
    pub threads: usize,
    /// Time of a step, ms; the levels take turns.
    pub ms_per_step: Milliseconds,
}

/// Filling of the neighbour lists.
#[derive(Clone, Debug, Serialize)]
pub struct ListView {
    /// Number of groups of four particles.
    pub groups: usize,
    /// Number of groups with lists. The others have too many neighbours or candidates, or their lists do not fit into
    /// memory.
    pub listed: usize,
    /// Share of the places in the lists that hold a pair, which is the share of lanes in use.
    pub filling: f64,
    /// Listed pairs divided by the time of the shortest step.
    pub million_pairs_per_second: f64,
    /// Candidate pairs tested to find them, divided by the time of the shortest step.
    pub million_tested_pairs_per_second: f64,
}

/// Time of a step with a grid structure.
#[derive(Clone, Debug, Serialize)]
pub struct StructureTime {
    /// The grid structure.
    pub structure: String,
    /// Time of a step, ms; the two structures take turns.
    pub ms_per_step: Milliseconds,
    /// Bytes of the solver's memory per particle.
    pub bytes_per_particle: f64,
}

/// Growth of the time with the number of particles.
#[derive(Clone, Debug, Serialize)]
pub struct Scaling {
    /// Number of particles, number of pairs of neighbours, and shortest step (ms).
    pub sizes: Vec<(usize, f64, f64)>,
    /// Exponent of the power law of time over the number of particles, from the smallest and the largest size.
    pub exponent: f64,
    /// Exponent of the power law of time over the number of pairs. It differs because in a small scene more particles
    /// are at a surface and have fewer neighbours.
    pub exponent_of_pairs: f64,
}

/// Numbers of particles for `--scaling`.
const SCALING_SIZES: [u64; 4] = [4096, 32_768, 262_144, 1_000_000];

/// Runs `bench`.
///
/// # Errors
/// Options that do not fit together, a scene that cannot run, or a step that fails.
pub fn execute(options: &Options) -> Result<bool, Failure> {
    if let Some(other) = &options.against {
        return against::execute(options, other);
    }
    let result = if options.scaling {
        let mut benches = Vec::new();
        for particles in SCALING_SIZES {
            let changes = Changes { particles: Some(particles), ..options.common.changes.clone() };
            benches.push(bench(&load(&options.common.scene, &changes)?, options)?);
        }
        let pairs = |b: &Bench| b.particles as f64 * b.average_neighbours.last;
        let sizes: Vec<_> = benches.iter().map(|b| (b.particles, pairs(b), b.ms_per_step.min)).collect();
        let [(n0, pairs0, t0), .., (n1, pairs1, t1)] = sizes[..] else {
            return Err(Failure::Call("nothing to scale".into()));
        };
        let exponent = (t1 / t0).ln() / (n1 as f64 / n0 as f64).ln();
        let exponent_of_pairs = (t1 / t0).ln() / (pairs1 / pairs0).ln();
        let last = benches.pop().ok_or_else(|| Failure::Call("nothing to scale".into()))?;
        Bench { scaling: Some(Scaling { sizes, exponent, exponent_of_pairs }), ..last }
    } else {
        bench(&load(&options.common.scene, &options.common.changes)?, options)?
    };
    deliver(&options.common, "bench.txt", &result, &table(&result))?;
    Ok(true)
}

/// Times one scene.
fn bench(named: &LoadedScene, options: &Options) -> Result<Bench, Failure> {
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
        if options.backend == BackendName::Gpu {
            return Err(Failure::Call("--simd is only for the CPU: remove --backend gpu".into()));
        }
        if simd.or_best() != simd {
            let name = format!("{name:?}").to_lowercase();
            return Err(Failure::Call(format!("--simd {name}: this processor does not have this level")));
        }
        solver = solver.at_level(simd);
    }
    let cpus = [(options.structures, "structures"), (options.levels, "levels"), (options.roofline, "roofline")];
    if let Some((_, name)) = cpus.iter().find(|(asked, _)| *asked && options.backend == BackendName::Gpu) {
        return Err(Failure::Call(format!("--{name} is only for the CPU: remove --backend gpu")));
    }
    if options.roofline && scene.grid.traversal == Traversal::HalfStencil {
        let why = "--roofline needs neighbour lists, and grid.traversal HalfStencil makes none: remove one of them";
        return Err(Failure::Call(why.into()));
    }
    let simd = solver.simd();
    let bar = progress(&format!("bench {}", named.name), u64::from(options.warm_up) + u64::from(options.steps));
    let mut timed = match options.backend {
        BackendName::Cpu => time_cpu(&mut solver, &pool, options, &bar)?,
        BackendName::Gpu => time_gpu(&solver, options, &bar)?,
    };
    bar.finish_and_clear();
    let needs = Requirements::of(scene);
    let ms_per_step = Milliseconds::of(&timed.steps);
    let ceilings = options.roofline.then(|| ceilings(simd, &pool));
    if let Some(ceilings) = &ceilings {
        let costs = costs(&mut solver, &needs, timed.lists);
        for pass in &mut timed.passes {
            pass.roof = Some(costs.roof(pass, ceilings));
        }
    }
    let rate = |pairs: u64| pairs as f64 / ms_per_step.min * 1e-3;
    let [first, last] = [&timed.first, &timed.last].map(|state| summarize(scene, state).map(|c| c.average_neighbours));
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
        lists: timed.lists.map(|lists| ListView {
            groups: lists.groups,
            listed: lists.listed,
            filling: lists.pairs as f64 / lists.places.max(1) as f64,
            million_pairs_per_second: rate(lists.pairs),
            million_tested_pairs_per_second: rate(solver.neighbours().tested_pairs()),
        }),
        ceilings,
        levels: if options.levels { levels(named, options)? } else { Vec::new() },
        arrays: arrays(&needs),
        structures: if options.structures { structures(named, simd, &pool, options)? } else { Vec::new() },
        scaling: None,
    })
}
