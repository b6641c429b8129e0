//! 16-bit codes for the slots of neighbours. A slot is a particle's index in the sorted arrays; its code is a window of
//! slots and a place in that window.
use crate::layout::f32x4;

/// Largest number of lanes of any SIMD level.
pub(crate) const MOST_LANES: usize = 16;

/// Number of windows of slots that the codes of neighbours refer to. Where a row of cells along x holds more particles
/// than a window has places, each of the nine rows around a cell in 3D needs a window of its own. Such cells are not
/// listed.
pub(crate) const WINDOWS: usize = 8;

/// Bits of a code that hold the place in its window.
pub(crate) const WINDOW_BITS: u32 = 13;

/// The first slot of each window.
pub(crate) type Windows = [u32; WINDOWS];

/// Largest number of materials that a SIMD level can look up without a memory access for each lane.
pub(crate) const FEW: usize = 16;

/// Byte offset from the first row to the row of each lane. A row holds four numbers of a particle.
#[derive(Clone, Copy)]
#[repr(align(64))]
pub(crate) struct Offsets(pub [u32; MOST_LANES]);

/// Bits by which a slot is shifted to become a byte offset: a row has 16 bytes.
pub(crate) const ROW_BITS: u32 = size_of::<f32x4>().ilog2();

/// Returns the slot that a code stands for.
#[inline(always)]
pub(crate) fn slot(code: u16, windows: &Windows) -> u32 {
    windows[usize::from(code >> WINDOW_BITS)].wrapping_add(u32::from(code) & ((1 << WINDOW_BITS) - 1))
}

// The vectors load and store whole registers of these arrays, so these lengths must fit.
const _: () = assert!(WINDOWS == 8 && WINDOWS << WINDOW_BITS == 1 << u16::BITS && MOST_LANES == 16 && FEW == 16);
