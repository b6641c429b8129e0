//! Which numbers a pass runs on: scalar, lanes in the target's base instructions, or lanes in AVX2.
//!
//! The choice changes speed, never a bit. `core` cannot ask the operating system, so [`Simd::detect`] reads the
//! processor itself; a host that knows better names a level.
use super::lanes::Base;
use super::real::Real;

/// A way to compute, from slowest to fastest.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[non_exhaustive]
pub enum Simd {
    /// One particle at a time: the plain reading of the terms.
    Scalar,
    /// Eight lanes in the instructions that every processor of the target has.
    Base,
    /// Eight lanes in AVX2 registers.
    Avx2,
}

/// Work that can be done in any kind of number: what a pass is to [`Simd`]. `run` must be `#[inline(always)]`, or it is compiled for the base level.
pub(crate) trait Work {
    /// Does it.
    fn run<R: Real>(self);
}

impl Simd {
    /// The fastest level of this processor.
    #[must_use]
    pub fn detect() -> Simd {
        if has_avx2() { Simd::Avx2 } else { Simd::Base }
    }

    /// This level, or the fastest one that the processor has where it lacks this one.
    #[must_use]
    pub fn or_best(self) -> Simd {
        self.min(Simd::detect().max(Simd::Base))
    }

    /// Does `work` at this level.
    #[inline]
    pub(crate) fn run<W: Work>(self, work: W) {
        match self {
            Simd::Scalar => run_by::<f32, W>(work),
            Simd::Base => run_by::<Base, W>(work),
            Simd::Avx2 => run_avx2(work),
        }
    }
}

/// A function of its own for each level: without optimisation the places of all that is compiled into one lie side by side on
/// the stack, and those of two levels are more than a thread has.
#[inline(never)]
fn run_by<R: Real, W: Work>(work: W) {
    work.run::<R>();
}

#[cfg(target_arch = "x86_64")]
#[inline]
#[expect(unsafe_code, reason = "a function for AVX2 can only be called where the processor has it")]
fn run_avx2<W: Work>(work: W) {
    #[target_feature(enable = "avx2")]
    fn vector<W: Work>(work: W) {
        work.run::<super::x86::Avx>();
    }
    // SAFETY: `Solver` takes its level through `or_best`, which grants AVX2 only where cpuid and xgetbv show it.
    unsafe { vector(work) }
}

#[cfg(not(target_arch = "x86_64"))]
#[inline]
fn run_avx2<W: Work>(work: W) {
    work.run::<Base>();
}

/// Intel's manual, volume 1, 14.7.1: AVX2 counts where the processor has it and the system saves its registers.
#[cfg(target_arch = "x86_64")]
#[expect(unsafe_code, reason = "xgetbv faults where the system has not enabled it")]
fn has_avx2() -> bool {
    use core::arch::x86_64::{__cpuid, __cpuid_count, _xgetbv};
    const OSXSAVE_AND_AVX: u32 = 1 << 27 | 1 << 28;
    const AVX2: u32 = 1 << 5;
    const VECTOR_REGISTERS: u64 = 0b110;
    #[target_feature(enable = "xsave")]
    fn saved_registers() -> u64 {
        // SAFETY: called only below, once cpuid has shown xgetbv to be enabled.
        unsafe { _xgetbv(0) }
    }
    if __cpuid(0).eax < 7 || __cpuid(1).ecx & OSXSAVE_AND_AVX != OSXSAVE_AND_AVX {
        return false;
    }
    // SAFETY: bit 27 of leaf 1 says that the system has enabled xgetbv.
    let saved = unsafe { saved_registers() };
    saved & VECTOR_REGISTERS == VECTOR_REGISTERS && __cpuid_count(7, 0).ebx & AVX2 != 0
}

#[cfg(not(target_arch = "x86_64"))]
fn has_avx2() -> bool {
    false
}
