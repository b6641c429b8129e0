//! SIMD levels: a pass computes with scalar numbers, or with lanes in the base instructions of the target, in AVX2 or
//! in AVX-512.
//!
//! The level changes the speed and never a bit. `core` cannot ask the operating system, so [`Simd::detect`] reads the
//! processor itself. A caller that has better information sets a level.
use super::lanes::Lanes;

/// The vector of the target's base instructions.
#[cfg(not(target_arch = "x86_64"))]
use super::portable::Four as Base;
#[cfg(target_arch = "x86_64")]
use super::x86::Sse as Base;

/// A SIMD level, from slowest to fastest.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[non_exhaustive]
pub enum Simd {
    /// One particle at a time, in scalar numbers.
    Scalar,
    /// Four lanes in the instructions that every processor of the target has.
    Base,
    /// Eight lanes in AVX2 registers.
    Avx2,
    /// Sixteen lanes in AVX-512 registers.
    Avx512,
}

/// Work that can be done at any SIMD level, such as a pass. `run` must be `#[inline(always)]`, because otherwise it is
/// compiled for the base level.
pub(crate) trait Work {
    /// Does the work with numbers of type `R`.
    fn run<R: Lanes>(self);
}

impl Simd {
    /// All levels, from slowest to fastest.
    pub const ALL: [Simd; 4] = [Simd::Scalar, Simd::Base, Simd::Avx2, Simd::Avx512];

    /// Returns the fastest level of this processor.
    #[must_use]
    pub fn detect() -> Simd {
        let [avx2, avx512] = extensions();
        match (avx2, avx512) {
            (true, true) => Simd::Avx512,
            (true, false) => Simd::Avx2,
            (false, _) => Simd::Base,
        }
    }

    /// Returns the level of a new solver: the fastest level of this processor, but AVX2 at most in builds with debug
    /// assertions. Without optimisation every temporary vector has a place of its own on the stack, and one pass in
    /// AVX-512 would need more than the 1 MiB that the main thread has on Windows.
    pub(crate) fn of_new_solver() -> Simd {
        if cfg!(debug_assertions) { Simd::Avx2.or_best() } else { Simd::detect() }
    }

    /// Returns the levels that this processor has, from slowest to fastest.
    pub fn available() -> impl Iterator<Item = Simd> {
        let best = Simd::detect();
        Simd::ALL.into_iter().filter(move |level| *level <= best)
    }

    /// Returns this level, or the fastest level of the processor if it lacks this one.
    #[must_use]
    pub fn or_best(self) -> Simd {
        self.min(Simd::detect())
    }

    /// Does `work` at this level.
    #[inline]
    pub(crate) fn run<W: Work>(self, work: W) {
        match self {
            Simd::Scalar => run_by::<f32, W>(work),
            Simd::Base => run_by::<Base, W>(work),
            Simd::Avx2 => run_avx2(work),
            Simd::Avx512 => run_avx512(work),
        }
    }
}

/// Runs the work in a function of its own for each level. Without optimisation, the locals of all code compiled into
/// one function lie side by side on the stack, and those of two levels need more stack than a thread has.
#[inline(never)]
fn run_by<R: Lanes, W: Work>(work: W) {
    work.run::<R>();
}

#[cfg(target_arch = "x86_64")]
#[inline]
#[expect(unsafe_code, reason = "a function for AVX2 can only be called where the processor has it")]
fn run_avx2<W: Work>(work: W) {
    #[target_feature(enable = "avx2,popcnt,bmi1,bmi2,lzcnt")]
    fn vector<W: Work>(work: W) {
        work.run::<super::x86::Avx>();
    }
    // SAFETY: the level of a solver comes from `detect` or `or_best`, and these give AVX2 only where cpuid and xgetbv
    // show all features that are enabled here.
    unsafe { vector(work) }
}

#[cfg(target_arch = "x86_64")]
#[inline]
#[expect(unsafe_code, reason = "a function for AVX-512 can only be called where the processor has it")]
fn run_avx512<W: Work>(work: W) {
    #[target_feature(enable = "avx512f,avx512dq,avx512bw,avx512vl,avx2,popcnt,bmi1,bmi2,lzcnt")]
    fn vector<W: Work>(work: W) {
        work.run::<super::x86::Avx512>();
    }
    // SAFETY: the level of a solver comes from `detect` or `or_best`, and these give AVX-512 only where cpuid and
    // xgetbv show all features that are enabled here and those that they imply.
    unsafe { vector(work) }
}

#[cfg(not(target_arch = "x86_64"))]
#[inline]
fn run_avx2<W: Work>(work: W) {
    run_by::<Base, W>(work);
}

#[cfg(not(target_arch = "x86_64"))]
#[inline]
fn run_avx512<W: Work>(work: W) {
    run_by::<Base, W>(work);
}

/// Returns whether AVX2 and AVX-512 are available: the processor has them, and the operating system saves their
/// registers (Intel's manual, volume 1, sections 14.7.1 and 15.2).
#[cfg(target_arch = "x86_64")]
#[expect(unsafe_code, reason = "xgetbv faults where the system has not enabled it")]
fn extensions() -> [bool; 2] {
    use core::arch::x86_64::{__cpuid, __cpuid_count, _xgetbv};
    /// Returns whether all of these bits are set.
    const fn all(word: u32, bits: &[u32]) -> bool {
        let mut i = 0;
        while i < bits.len() {
            if word >> bits[i] & 1 == 0 {
                return false;
            }
            i += 1;
        }
        true
    }
    #[target_feature(enable = "xsave")]
    fn saved_registers() -> u32 {
        // SAFETY: this function is called only below, after cpuid has shown that xgetbv is enabled.
        unsafe { _xgetbv(0) as u32 }
    }
    // These are bit numbers in the cpuid leaves 1, 7 and 0x80000001.
    let [fma, popcnt, osxsave, avx, f16c] = [12, 23, 27, 28, 29];
    let [bmi1, avx2, bmi2, f, dq, bw, vl] = [3, 5, 8, 16, 17, 30, 31];
    let lzcnt = 5;
    let (basic, highest) = (__cpuid(1).ecx, __cpuid(0).eax);
    if highest < 7 || !all(basic, &[osxsave, avx]) {
        return [false; 2];
    }
    // SAFETY: cpuid has shown that the operating system has enabled xgetbv.
    let saved = unsafe { saved_registers() };
    let more = __cpuid_count(7, 0).ebx;
    // Bits of `saved`: 1 SSE, 2 AVX; 5 masks, 6 upper halves, 7 registers from 16 on.
    let has_avx2 = all(saved, &[1, 2])
        && all(basic, &[popcnt])
        && all(more, &[avx2, bmi1, bmi2])
        && all(__cpuid(0x8000_0001).ecx, &[lzcnt]);
    // To the compiler, avx512f implies fused operations and half floats, though nothing here uses them.
    [has_avx2, has_avx2 && all(basic, &[fma, f16c]) && all(saved, &[5, 6, 7]) && all(more, &[f, dq, bw, vl])]
}

#[cfg(not(target_arch = "x86_64"))]
fn extensions() -> [bool; 2] {
    [false; 2]
}
