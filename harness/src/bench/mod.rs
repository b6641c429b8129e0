//! `bench`: how long a step takes, pass by pass.
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
    /// Time the scene at 4096, 32768, 262144 and 1000000 particles and fit how the time grows with their number
    #[arg(long, conflicts_with = "particles")]
    scaling: bool,
    /// Time another build of this program too, in turn with this one, and compare their shortest steps
    #[arg(long, value_name = "BINARY", conflicts_with_all = ["scaling", "structures"])]
    against: Option<PathBuf>,
    /// Time the scene at every SIMD level of this processor, in turn, with one thread and with --threads of them
    #[arg(long, conflicts_with_all = ["scaling", "structures", "against", "simd"])]
    levels: bool,
    /// Measure what this machine can compute and move at most, and say how near each pass comes to it
    #[arg(long, conflicts_with_all = ["scaling", "against"])]
    roofline: bool,
    /// With --against: how often each of the two builds is run
    #[arg(long, default_value_t = 5, value_name = "N", requires = "against", value_parser = clap::value_parser!(u32).range(1..))]
    rounds: u32,
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
    /// Shortest time of each pass, on a GPU by the device's own clock; empty where a device cannot time them.
    pub passes: Vec<PassTime>,
    /// Time of a step, ms, where a GPU is given all steps at once and asked for nothing in between.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ms_per_step_at_once: Option<f64>,
    /// Shortest step divided by the number of particles, ns.
    pub ns_per_particle_step: f64,
    /// Bytes of the solver's memory per particle.
    pub bytes_per_particle: f64,
    /// Neighbours of a particle, itself counted.
    pub average_neighbours: FirstLast,
    /// Simulated time over the time it took, by the shortest step.
    pub real_time_factor: f64,
    /// The neighbour lists of the last step, on the CPU.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub lists: Option<ListView>,
    /// With `--roofline`: what the machine can do at most.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ceilings: Option<Ceilings>,
    /// With `--levels`: the scene at each level.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub levels: Vec<LevelTime>,
    /// Arrays that exist, with their bytes.
    pub arrays: Vec<ArrayView>,
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
    /// With `--roofline`: how near that is to what the machine can do.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub roof: Option<Roof>,
}

/// What a pass computes and moves, beside what the machine can.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Roof {
    /// Operations on numbers, without addresses and unused lanes; only of the passes over pairs that every scene has, and
    /// only where all groups have lists.
    pub operations: Option<u64>,
    /// Their rate over that of the machine's sums and products.
    pub share_of_arithmetic: Option<f64>,
    /// Bytes of the arrays that it reads and writes, each once; unknown where pressure is iterated.
    pub bytes: Option<u64>,
    /// Their rate over the machine's.
    pub share_of_memory: Option<f64>,
}

/// What a machine can do at most, measured with the threads and at the level of the benchmark.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Ceilings {
    /// Sums and products a second in registers, in units of 1e9.
    pub gigaoperations_per_second: f64,
    /// Bytes that a triad of long arrays moves, in units of 1e9 a second.
    pub gigabytes_per_second: f64,
}

/// Time at a level, with so many threads.
#[derive(Clone, Debug, Serialize)]
pub struct LevelTime {
    /// The level, as `--simd` names it.
    pub simd: String,
    /// Number of threads.
    pub threads: usize,
    /// Time of a step, the levels being taken in turn.
    pub ms_per_step: Milliseconds,
}

/// How full the neighbour lists are.
#[derive(Clone, Debug, Serialize)]
pub struct ListView {
    /// Groups of four particles.
    pub groups: usize,
    /// Those that have lists; the others have too many neighbours or candidates, or their lists do not fit into memory.
    pub listed: usize,
    /// Share of the places of the lists that hold a pair: how full the lanes are.
    pub filling: f64,
    /// Listed pairs over the shortest step.
    pub million_pairs_per_second: f64,
    /// Pairs that were tried to find them, over the shortest step.
    pub million_tested_pairs_per_second: f64,
}

/// Time with a grid structure.
#[derive(Clone, Debug, Serialize)]
pub struct StructureTime {
    /// Which.
    pub structure: String,
    /// Time of a step, steps with the two structures being taken in turn.
    pub ms_per_step: Milliseconds,
    /// Bytes of the solver's memory per particle.
    pub bytes_per_particle: f64,
}

/// How time grows with the number of particles.
#[derive(Clone, Debug, Serialize)]
pub struct Scaling {
    /// Particles, pairs of neighbours, and shortest step, ms.
    pub sizes: Vec<(usize, f64, f64)>,
    /// Exponent of the power law of time over particles, between the smallest and the largest.
    pub exponent: f64,
    /// The same over pairs: of few particles, more are at a surface and have fewer neighbours.
    pub exponent_of_pairs: f64,
}

/// Sizes of `--scaling`.
const SCALING_SIZES: [u64; 4] = [4096, 32_768, 262_144, 1_000_000];

/// Runs `bench`.
///
/// # Errors
/// A scene that cannot run, a step that cannot be made.
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
            return Err(Failure::Call("--simd is for the CPU: leave --backend gpu out".into()));
        }
        if simd.or_best() != simd {
            let name = format!("{name:?}").to_lowercase();
            return Err(Failure::Call(format!("--simd {name}: this processor has no such level: leave --simd out")));
        }
        solver = solver.at_level(simd);
    }
    let cpus = [(options.structures, "structures"), (options.levels, "levels"), (options.roofline, "roofline")];
    if let Some((_, name)) = cpus.iter().find(|(asked, _)| *asked && options.backend == BackendName::Gpu) {
        return Err(Failure::Call(format!("--{name} is for the CPU: leave --backend gpu out")));
    }
    if options.roofline && scene.grid.traversal == Traversal::HalfStencil {
        let why = "--roofline counts the pairs of neighbour lists, and grid.traversal HalfStencil makes none: leave one of them out";
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
            million_tested_pairs_per_second: rate(solver.tested_pairs()),
        }),
        ceilings,
        levels: if options.levels { levels(named, options)? } else { Vec::new() },
        arrays: arrays(&needs),
        structures: if options.structures { structures(named, simd, &pool, options)? } else { Vec::new() },
        scaling: None,
    })
}
