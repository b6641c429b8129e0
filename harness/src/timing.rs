//! Times of steps, given by their minimum and median, since the speed of the machine varies during a measurement.
use serde::Serialize;
use std::time::Instant;

/// Times of a step, ms.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Milliseconds {
    /// Shortest time.
    pub min: f64,
    /// Median time.
    pub median: f64,
}

impl Milliseconds {
    /// Returns minimum and median of a list of times, or 0 for an empty list.
    #[must_use]
    pub fn of(times: &[f64]) -> Milliseconds {
        let mut sorted = times.to_vec();
        sorted.sort_by(f64::total_cmp);
        let at = |i: usize| sorted.get(i).copied().unwrap_or_default();
        Milliseconds { min: at(0), median: at(sorted.len() / 2) }
    }
}

/// Runs `work` and returns its result and the time that it took, ms.
pub fn timed<T>(work: impl FnOnce() -> T) -> (T, f64) {
    let start = Instant::now();
    let result = work();
    (result, start.elapsed().as_secs_f64() * 1e3)
}
