//! The largest arithmetic rate of a processor, with which benchmarks compare the passes.
use super::lanes::Lanes;
use super::level::{Simd, Work};
use core::hint::black_box;

/// Number of independent sums. Each one waits only for itself. Twelve keep all units busy of a processor that starts
/// two multiplications and two additions per cycle and needs six cycles for one of each; with two constants they fit
/// into sixteen registers.
const CHAINS: usize = 12;

/// Multiplies and adds `rounds` times in all lanes of a SIMD level, without memory accesses, and returns the number of
/// operations. A processor without that level uses its best one. At the scalar level the compiler may work on several
/// sums at once, as it may in a pass.
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
        // The compiler does not know these numbers, and the sums keep their value with them.
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
