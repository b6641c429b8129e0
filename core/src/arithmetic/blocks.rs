//! Operations that a vector of four-lane blocks needs beyond arithmetic.
use super::codes::{FEW, Offsets, Windows};
use super::real::Real;
use crate::layout::f32x4;

/// A vector whose lanes form blocks of four.
pub(crate) trait Blocks: Real {
    /// Loads a row into each block.
    fn of_rows<'r>(row: impl Fn(usize) -> &'r f32x4) -> Self;
    /// Transposes the 4 x 4 matrix of each block.
    fn transpose(rows: [Self; 4]) -> [Self; 4];
    /// Copies the first lane of each block to all lanes of the block.
    fn first(self) -> Self;
    /// Copies the second lane of each block to all lanes of the block.
    fn second(self) -> Self;
    /// Copies the third lane of each block to all lanes of the block.
    fn third(self) -> Self;
    /// Copies the fourth lane of each block to all lanes of the block.
    fn fourth(self) -> Self;
    /// Returns the lanes of a block.
    fn block(self, block: usize) -> f32x4;
    /// See [`Lanes::read`](super::lanes::Lanes::read).
    fn read_lanes(from: &[f32]) -> Self;
    /// See [`Lanes::write`](super::lanes::Lanes::write).
    fn write_lanes(self, to: &mut [f32]);
    /// See [`Lanes::decode`](super::lanes::Lanes::decode).
    fn decode_lanes(codes: &[u16], windows: &Windows, offsets: &mut Offsets, limit: u32) -> bool;
    /// See [`Lanes::append`](super::lanes::Lanes::append).
    fn compress(to: (&mut [u32], &mut [f32]), used: usize, codes: &[u32], numbers: Self, mask: Self::Mask) -> usize;
    /// See [`Lanes::pick`](super::lanes::Lanes::pick).
    fn permute(column: &[f32; FEW], index: Self) -> Self;
}
