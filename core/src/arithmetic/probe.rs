//! What a processor can do at most: benchmarks hold the passes against it.
use super::lanes::Lanes;
use super::level::{Simd, Work};
use core::hint::black_box;

/// Sums that grow side by side. Each waits for itself alone, and so many keep all units of a processor busy that can start two
/// products and two sums in a cycle, and needs six for one of each; with two constants they fit into sixteen registers.
const CHAINS: usize = 12;

/// Multiplies and adds `rounds` times over in all lanes of a level, without any memory, and returns how many operations
/// that was. A processor without the level uses its best. A compiler may work on several sums of the scalar level at once, as it may in
/// a pass.
#[must_use]
pub fn multiply_and_add(simd: Simd, rounds: u32) -> u64 {
    let mut operations = 0;
    simd.or_best().run(Rounds { rounds, operations: &mut operations });
    operations
}

struct Rounds<'a> {
    rounds: u32,
    operations: &'a mut u64,
}

impl Work for Rounds<'_> {
    #[inline(always)]
    fn run<R: Lanes>(self) {
        // numbers that the compiler does not know, and that stay as they are
        let (factor, term) = (R::splat(black_box(0.5)), R::splat(black_box(0.5)));
        let mut sums = [R::splat(black_box(1.0)); CHAINS];
        for _ in 0..self.rounds {
            for sum in &mut sums {
                *sum = *sum * factor + term;
            }
        }
        black_box(sums);
        *self.operations = u64::from(self.rounds) * (2 * CHAINS * R::LANES) as u64;
    }
}
