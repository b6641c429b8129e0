//! An executor for the core crate that runs on rayon's threads.
use crate::failure::Failure;
use millpond_core::Executor;
use rayon::prelude::*;

/// A pool of threads.
#[derive(Debug)]
pub struct Pool(rayon::ThreadPool);

impl Pool {
    /// Creates a pool of `threads` threads; with 0, one thread per core.
    ///
    /// # Errors
    /// Threads that the operating system cannot create.
    pub fn new(threads: usize) -> Result<Pool, Failure> {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
        pool.map(Pool).map_err(|e| Failure::System(format!("cannot start {threads} threads: {e}")))
    }

    /// Applies `work` to all items in parallel. The results are in the order of the items.
    pub fn map<T: Sync, R: Send>(&self, items: &[T], work: impl Fn(&T) -> R + Sync + Send) -> Vec<R> {
        self.0.install(|| items.par_iter().with_max_len(1).map(&work).collect())
    }
}

impl Executor for Pool {
    fn width(&self) -> usize {
        self.0.current_num_threads()
    }

    fn run<J: Send>(&self, jobs: &mut [J], work: impl Fn(&mut J) + Sync) {
        // one thread needs no pool, and waking it would cost some microseconds per pass
        if self.width() == 1 {
            jobs.iter_mut().for_each(work);
        } else {
            self.0.install(|| jobs.par_iter_mut().with_max_len(1).for_each(&work));
        }
    }

    fn enter<T: Send>(&self, step: impl FnOnce(&Self) -> T + Send) -> T {
        // starting the jobs of a pass takes about ten microseconds from outside of the pool, and two from one of its
        // own threads
        if self.width() == 1 { step(self) } else { self.0.install(|| step(self)) }
    }
}
