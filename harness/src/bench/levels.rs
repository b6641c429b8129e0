//! A scene at every SIMD level of this processor, timed alternately, with one thread and with all threads.
use super::{LevelTime, Options};
use crate::failure::Failure;
use crate::fluid::start;
use crate::pool::Pool;
use crate::scenes::LoadedScene;
use crate::timing::{Milliseconds, timed};
use millpond_core::{Executor, OwnedMemory, Simd};

/// Times the scene at each level.
pub(super) fn levels(named: &LoadedScene, options: &Options) -> Result<Vec<LevelTime>, Failure> {
    let scene = &named.checked()?;
    let mut pools = vec![Pool::new(1)?, Pool::new(options.common.threads)?];
    pools.dedup_by_key(|pool| pool.width());
    let all: Vec<Simd> = Simd::available().collect();
    let mut heaps: Vec<OwnedMemory> = all.iter().map(|_| OwnedMemory::of(scene)).collect();
    let mut solvers = Vec::new();
    for (simd, heap) in all.iter().zip(&mut heaps) {
        let mut solver = start(&named.name, scene, heap)?;
        // warm up at the best level with all threads: all levels give the same bits
        for _ in 0..options.warm_up {
            solver.step(&pools[pools.len() - 1])?;
        }
        solvers.push(solver.at_level(*simd));
    }
    let mut times = vec![vec![Vec::new(); pools.len()]; solvers.len()];
    for _ in 0..options.steps {
        for (solver, times) in solvers.iter_mut().zip(&mut times) {
            for (pool, times) in pools.iter().zip(times) {
                let (result, ms) = timed(|| solver.step(pool));
                result?;
                times.push(ms);
            }
        }
    }
    let with = |simd: Simd, pool: &Pool, times: &Vec<f64>| LevelTime {
        simd: format!("{simd:?}").to_lowercase(),
        threads: pool.width(),
        ms_per_step: Milliseconds::of(times),
    };
    let of_level = |(simd, times): (&Simd, &Vec<Vec<f64>>)| {
        pools.iter().zip(times).map(|(pool, times)| with(*simd, pool, times)).collect::<Vec<_>>()
    };
    Ok(all.iter().zip(&times).flat_map(of_level).collect())
}
