//! The state hash, and sums over a whole fluid. Both go in order of ids, so that slots do not change them.
use crate::layout::{f32x4, u32x2};

/// The FNV-1a hash with 64 bits, over little-endian bytes.
#[derive(Clone, Copy, Debug)]
pub struct Fnv(pub u64);

impl Default for Fnv {
    fn default() -> Self {
        Fnv(0xcbf2_9ce4_8422_2325)
    }
}

impl Fnv {
    /// Adds a word.
    #[must_use]
    pub fn word(self, word: u32) -> Fnv {
        Fnv(word
            .to_le_bytes()
            .iter()
            .fold(self.0, |hash, &byte| (hash ^ u64::from(byte)).wrapping_mul(0x100_0000_01b3)))
    }
}

/// Hash of the positions and velocities, xyz each, particle after particle in order of ids; `slot` is the slot of each
/// id.
#[must_use]
pub fn state_hash(slot: &[u32], position: &[f32x4], velocity: &[f32x4]) -> u64 {
    let words = slot.iter().flat_map(|&s| {
        let [x, y, z, _] = position[s as usize];
        let [u, v, w, _] = velocity[s as usize];
        [x, y, z, u, v, w].map(f32::to_bits)
    });
    words.fold(Fnv::default(), Fnv::word).0
}

/// Hash of every array of a state, all four numbers of each entry: array after array, the entries of particles in order
/// of ids, then the spring ends and the other arrays. Unused arrays add nothing.
#[must_use]
pub fn full_state_hash(slot: &[u32], arrays: &[&[f32x4]], spring_ends: &[u32x2], others: &[&[f32x4]]) -> u64 {
    let of_particles = arrays.iter().flat_map(|array| slot.iter().filter_map(|&s| array.get(s as usize)).flatten());
    let words = of_particles.map(|x| x.to_bits()).chain(spring_ends.iter().flatten().copied());
    let words = words.chain(others.iter().flat_map(|other| other.iter().flatten()).map(|x| x.to_bits()));
    words.fold(Fnv::default(), Fnv::word).0
}

/// Sum of `term(0) .. term(count - 1)` by recursive halving. The tree of additions is fixed, so the sum is the same
/// wherever it is computed, and the rounding error is small.
pub fn tree_sum(count: usize, term: &impl Fn(usize) -> f64) -> f64 {
    fn of(from: usize, to: usize, term: &impl Fn(usize) -> f64) -> f64 {
        match to - from {
            0 => 0.0,
            1 => term(from),
            n => of(from, from + n / 2, term) + of(from + n / 2, to, term),
        }
    }
    of(0, count, term)
}
