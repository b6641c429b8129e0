//! How many particles each cell gets, and the how-manieth of its cell each particle is.
//!
//! Serial: it is one increment a particle. On a GPU the ranks depend on who comes first; `p06_order` undoes that.

/// Fills `counter` and `rank`.
pub(crate) fn run(cell: &[u32], rank: &mut [u32], counter: &mut [u32]) {
    counter.fill(0);
    for (rank, &cell) in rank.iter_mut().zip(cell) {
        let count = &mut counter[cell as usize];
        *rank = *count;
        *count += 1;
    }
}
