//! Who does the work: the host's job system, or nobody else.
//!
//! Passes are cut into jobs that write disjoint parts of their outputs. How many there are and who runs which never
//! changes a bit.
use core::ops::Range;
use heapless::Vec;

/// Most jobs that a pass is cut into.
pub const MOST_JOBS: usize = 64;

/// The jobs of a pass.
pub(crate) type Jobs<J> = Vec<J, MOST_JOBS>;

/// Runs the jobs of a pass, side by side if it can. Implement it over your own threads.
///
/// ```
/// use millpond_core::Executor;
///
/// /// Two threads of the standard library, made anew for each pass.
/// struct Halves;
/// impl Executor for Halves {
///     fn width(&self) -> usize {
///         2
///     }
///     fn run<J: Send>(&self, jobs: &mut [J], work: impl Fn(&mut J) + Sync) {
///         let (left, right) = jobs.split_at_mut(jobs.len() / 2);
///         std::thread::scope(|scope| {
///             scope.spawn(|| left.iter_mut().for_each(&work));
///             right.iter_mut().for_each(&work);
///         });
///     }
/// }
/// ```
pub trait Executor {
    /// How many jobs may run at once.
    fn width(&self) -> usize;

    /// Does `work` once for each of `jobs`, in any order, and returns when all are done. Optimised, a job takes some 40
    /// KB of stack: the candidates of a cell, and the neighbours of four particles.
    fn run<J: Send>(&self, jobs: &mut [J], work: impl Fn(&mut J) + Sync);

    /// Does `step`, which is a whole time step: it calls [`Executor::run`] for each pass that is cut into jobs, and does the
    /// rest itself, on as much stack as a job takes. The default does it
    /// on the calling thread. Where handing jobs to a pool from outside costs more than from one of its own threads, do
    /// it on one of those: a step then enters the pool once, and not in every pass.
    fn enter<T: Send>(&self, step: impl FnOnce(&Self) -> T + Send) -> T {
        step(self)
    }
}

/// One job after the other, on the calling thread.
#[derive(Clone, Copy, Debug, Default)]
pub struct Serial;

impl Executor for Serial {
    fn width(&self) -> usize {
        1
    }

    fn run<J: Send>(&self, jobs: &mut [J], work: impl Fn(&mut J) + Sync) {
        jobs.iter_mut().for_each(work);
    }
}

/// Jobs to cut a pass into: a few for each that can run at once, so that none waits long for the slowest.
pub(crate) fn parts(executor: &impl Executor) -> usize {
    match executor.width() {
        0 | 1 => 1,
        width => width.saturating_mul(4).min(MOST_JOBS),
    }
}

/// Cuts `0..count` into `parts` runs of about the same length.
pub(crate) fn shares(count: usize, parts: usize) -> impl Iterator<Item = Range<usize>> {
    (0..parts).map(move |i| share_of(count, i, parts)..share_of(count, i + 1, parts))
}

/// `whole * part / parts`, in numbers wide enough on every target.
pub(crate) fn share_of(whole: usize, part: usize, parts: usize) -> usize {
    (whole as u64 * part as u64 / parts as u64) as usize
}

/// The first `count` items of what is left to hand out; empty where there are not so many, which no caller asks for.
#[expect(clippy::mut_mut, reason = "what is left is handed on, shorter")]
pub(crate) fn take<'a, T>(rest: &mut &'a mut [T], count: usize) -> &'a mut [T] {
    rest.split_off_mut(..count).unwrap_or_default()
}
