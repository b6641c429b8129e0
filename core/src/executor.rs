//! Execution of passes: on the calling thread, or by the job system of your program.
//!
//! Passes are divided into jobs that write disjoint parts of their outputs. Neither the number of jobs nor the threads
//! that run them change a bit of the result.
use core::ops::Range;
use heapless::Vec;

/// Largest number of jobs per pass.
pub const MOST_JOBS: usize = 64;

/// The jobs of a pass.
pub(crate) type Jobs<J> = Vec<J, MOST_JOBS>;

/// Runs the jobs of a pass, in parallel if it can. Implement it for your own threads.
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
    /// Number of jobs that can run at once.
    fn width(&self) -> usize;

    /// Calls `work` once for each of `jobs`, in any order, and returns when all are done. In optimised builds a job
    /// needs about 40 KB of stack, for the candidates of a cell and the neighbours of four particles.
    fn run<J: Send>(&self, jobs: &mut [J], work: impl Fn(&mut J) + Sync);

    /// Runs `step`, which is a whole time step: it calls [`Executor::run`] for each pass that is divided into jobs, and
    /// does everything else itself, on as much stack as a job needs. The default runs it on the calling thread. If
    /// submitting jobs to a thread pool costs more from outside than from one of its own threads, run `step` on one of
    /// those: a step then enters the pool once, and not in every pass.
    fn enter<T: Send>(&self, step: impl FnOnce(&Self) -> T + Send) -> T {
        step(self)
    }
}

/// Runs one job after the other on the calling thread.
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

/// An executor whose type is not known. Passes are written against it, and so they are compiled once, in this crate and
/// optimised as this crate is, whichever executor a program brings.
pub(crate) trait AnyExecutor {
    /// Number of jobs that can run at once.
    fn width(&self) -> usize;

    /// Calls each job once, in any order.
    fn call(&self, jobs: &mut [&mut (dyn FnMut() + Send)]);
}

impl<E: Executor> AnyExecutor for E {
    fn width(&self) -> usize {
        Executor::width(self)
    }

    fn call(&self, jobs: &mut [&mut (dyn FnMut() + Send)]) {
        self.run(jobs, |job| job());
    }
}

impl dyn AnyExecutor + '_ {
    /// Calls `work` once for each of `jobs`, in any order.
    pub(crate) fn run<J: Send>(&self, jobs: &mut [J], work: impl Fn(&mut J) + Sync) {
        let work = &work;
        for jobs in jobs.chunks_mut(MOST_JOBS) {
            let mut calls: Jobs<_> = jobs.iter_mut().map(|job| move || work(job)).collect();
            let mut jobs: Jobs<&mut (dyn FnMut() + Send)> = calls.iter_mut().map(|call| call as _).collect();
            self.call(&mut jobs);
        }
    }
}

/// Number of jobs into which a pass is divided: a few for each that can run at once, so that little time is spent
/// waiting for the slowest.
pub(crate) fn parts(executor: &dyn AnyExecutor) -> usize {
    match executor.width() {
        0 | 1 => 1,
        width => width.saturating_mul(4).min(MOST_JOBS),
    }
}

/// Divides `0..count` into `parts` ranges of about the same length.
pub(crate) fn shares(count: usize, parts: usize) -> impl Iterator<Item = Range<usize>> {
    (0..parts).map(move |i| share_of(count, i, parts)..share_of(count, i + 1, parts))
}

/// `whole * part / parts`, computed in 64 bits on every target.
pub(crate) fn share_of(whole: usize, part: usize, parts: usize) -> usize {
    (whole as u64 * part as u64 / parts as u64) as usize
}

/// Splits off the first `count` items of the rest of a slice; empty if there are fewer items, which no caller asks for.
#[expect(clippy::mut_mut, reason = "what is left is handed on, shorter")]
pub(crate) fn take<'a, T>(rest: &mut &'a mut [T], count: usize) -> &'a mut [T] {
    rest.split_off_mut(..count).unwrap_or_default()
}
