//! How the slot of a neighbour is written in 16 bits: as a window of slots, and a place in it.
use crate::layout::f32x4;

/// Most lanes of any level.
pub(crate) const MOST_LANES: usize = 16;

/// Windows of slots that the codes of neighbours refer to. Where a row of cells along x holds more particles than a
/// window has places, each of the nine rows around a cell in space needs a window of its own: such cells are not listed.
pub(crate) const WINDOWS: usize = 8;

/// Bits of a code that say where in its window a slot is.
pub(crate) const WINDOW_BITS: u32 = 13;

/// The first slot of each window.
pub(crate) type Windows = [u32; WINDOWS];

/// Materials that a level can look up without asking memory for each lane.
pub(crate) const FEW: usize = 16;

/// Bytes from the first row to that of each lane.
#[derive(Clone, Copy)]
#[repr(align(64))]
pub(crate) struct Offsets(pub [u32; MOST_LANES]);

/// Bits that a slot is moved by to make an offset of it: a row has 16 bytes.
pub(crate) const ROW_BITS: u32 = size_of::<f32x4>().ilog2();

/// Decodes one code.
#[inline(always)]
pub(crate) fn slot(code: u16, windows: &Windows) -> u32 {
    windows[usize::from(code >> WINDOW_BITS)].wrapping_add(u32::from(code) & ((1 << WINDOW_BITS) - 1))
}

// What the vectors load and store is as long as their registers need.
const _: () = assert!(WINDOWS == 8 && WINDOWS << WINDOW_BITS == 1 << u16::BITS && MOST_LANES == 16 && FEW == 16);
