//! Core's executor over rayon's threads.
use crate::failure::Failure;
use millpond_core::Executor;
use rayon::prelude::*;

/// A pool of threads.
#[derive(Debug)]
pub struct Pool(rayon::ThreadPool);

impl Pool {
    /// With this many threads; as many as there are cores where it is 0.
    ///
    /// # Errors
    /// The system gives no threads.
    pub fn new(threads: usize) -> Result<Pool, Failure> {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
        pool.map(Pool).map_err(|e| Failure::System(format!("no pool of {threads} threads: {e}")))
    }

    /// What `work` makes of each item, side by side; in the order of the items, whoever is done first.
    pub fn map<T: Sync, R: Send>(&self, items: &[T], work: impl Fn(&T) -> R + Sync + Send) -> Vec<R> {
        self.0.install(|| items.par_iter().with_max_len(1).map(&work).collect())
    }
}

impl Executor for Pool {
    fn width(&self) -> usize {
        self.0.current_num_threads()
    }

    fn run<J: Send>(&self, jobs: &mut [J], work: impl Fn(&mut J) + Sync) {
        // one thread needs no pool, and waking it would cost each pass some microseconds
        if self.width() == 1 {
            jobs.iter_mut().for_each(work);
        } else {
            self.0.install(|| jobs.par_iter_mut().with_max_len(1).for_each(&work));
        }
    }

    fn enter<T: Send>(&self, step: impl FnOnce(&Self) -> T + Send) -> T {
        // from outside, handing over the jobs of a pass takes some ten microseconds; from one of the pool's own threads, two
        if self.width() == 1 { step(self) } else { self.0.install(|| step(self)) }
    }
}
