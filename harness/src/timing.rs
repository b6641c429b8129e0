//! Times of steps, told by their minimum and their median: the machine's speed changes while one measures.
use serde::Serialize;
use std::time::Instant;

/// Milliseconds a step.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Milliseconds {
    /// The shortest.
    pub min: f64,
    /// The middle one.
    pub median: f64,
}

impl Milliseconds {
    /// Of a list of times; zero of none.
    #[must_use]
    pub fn of(times: &[f64]) -> Milliseconds {
        let mut sorted = times.to_vec();
        sorted.sort_by(f64::total_cmp);
        let at = |i: usize| sorted.get(i).copied().unwrap_or_default();
        Milliseconds { min: at(0), median: at(sorted.len() / 2) }
    }
}

/// Does `work`, returns its result and how many milliseconds it took.
pub fn timed<T>(work: impl FnOnce() -> T) -> (T, f64) {
    let start = Instant::now();
    let result = work();
    (result, start.elapsed().as_secs_f64() * 1e3)
}
