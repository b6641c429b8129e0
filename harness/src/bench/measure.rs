//! Times of steps and passes, on the CPU or on a GPU.
use super::{Options, PassTime};
use crate::failure::Failure;
use crate::pool::Pool;
use crate::snapshot::Snapshot;
use crate::timing::timed;
use millpond_core::backend::ListReport;
use millpond_core::{Pass, Solver};
use millpond_gpu::{Gpu, GpuError, GpuSolver, Mode};
use std::time::Instant;

/// Result of a measurement: name of the SIMD level or device, times of steps and passes (ms), first and last state.
pub(super) struct Timed {
    pub path: String,
    pub steps: Vec<f64>,
    pub passes: Vec<PassTime>,
    pub ms_at_once: Option<f64>,
    /// Filling of the neighbour lists after the last step; `None` on a GPU, which makes no lists.
    pub lists: Option<ListReport>,
    pub first: Snapshot,
    pub last: Snapshot,
}

pub(super) fn time_cpu(
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
        lists: solver.lists(),
        first,
        last: Snapshot::of_cpu(solver),
    })
}

/// Shortest time of each pass over all steps, ms.
struct Shortest([f64; Pass::ALL.len()]);

impl Default for Shortest {
    fn default() -> Shortest {
        Shortest([f64::INFINITY; Pass::ALL.len()])
    }
}

impl Shortest {
    /// Adds the times of a step, ms. For a pass that runs several times in a step, the times are summed.
    fn add_step(&mut self, times: impl Iterator<Item = (Pass, f64)>) {
        let mut took = [None; Pass::ALL.len()];
        for (pass, ms) in times {
            *took[pass as usize].get_or_insert(0.0) += ms;
        }
        for (best, took) in self.0.iter_mut().zip(took) {
            *best = took.map_or(*best, |took| best.min(took));
        }
    }

    /// Returns the times of the passes that ran.
    fn passes(&self) -> Vec<PassTime> {
        let ran = Pass::ALL.into_iter().zip(self.0).filter(|(_, ms)| ms.is_finite());
        ran.map(|(pass, ms)| PassTime { name: pass.name(), ms, roof: None }).collect()
    }
}

pub(super) fn time_gpu(solver: &Solver<'_>, options: &Options, bar: &indicatif::ProgressBar) -> Result<Timed, Failure> {
    let gpu = Gpu::open(None, Mode::Strict)?;
    // the steps are made three times: one by one, all at once, and with a timer for each pass
    bar.set_length(3 * (u64::from(options.warm_up) + u64::from(options.steps)));
    let warm = || {
        let mut fluid = GpuSolver::new(&gpu, solver)?;
        fluid.step(options.warm_up)?;
        bar.inc(u64::from(options.warm_up));
        Ok::<_, GpuError>(fluid)
    };
    // drivers compile a shader when it first runs
    GpuSolver::new(&gpu, solver)?.step(1)?;
    let mut fluid = warm()?;
    let first = Snapshot::of_gpu(&fluid)?;
    let mut steps = Vec::new();
    for _ in 0..options.steps {
        let (result, ms) = timed(|| fluid.step(1));
        result?;
        steps.push(ms);
        bar.inc(1);
    }
    let last = Snapshot::of_gpu(&fluid)?;
    let mut fluid = warm()?;
    let (result, ms) = timed(|| fluid.step(options.steps));
    result?;
    bar.inc(u64::from(options.steps));
    let ms_at_once = Some(ms / f64::from(options.steps));
    let mut fluid = warm()?;
    let mut shortest = Shortest::default();
    for _ in 0..options.steps {
        match fluid.step_timed() {
            Ok(times) => shortest.add_step(times.into_iter()),
            Err(error @ (GpuError::NoPassTimes { .. } | GpuError::TooManyPasses { .. })) => {
                eprintln!("the passes were not timed: {error}");
                break;
            }
            Err(error) => return Err(error.into()),
        }
        bar.inc(1);
    }
    Ok(Timed { path: gpu.name(), steps, passes: shortest.passes(), ms_at_once, lists: None, first, last })
}
