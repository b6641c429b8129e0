//! First slot of each cell: the running sum of the counts (S1 section 6.2).

/// Fills `begin`.
pub(crate) fn run(counter: &[u32], begin: &mut [u32]) {
    let mut slot = 0;
    for (begin, count) in begin.iter_mut().zip(counter) {
        *begin = slot;
        slot += count;
    }
}
