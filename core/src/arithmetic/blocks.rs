//! What a vector of blocks of four lanes can do, beside arithmetic.
use super::codes::{FEW, Offsets, Windows};
use super::real::Real;
use crate::layout::f32x4;

/// A vector whose lanes are blocks of four.
pub(crate) trait Blocks: Real {
    /// A row in each block.
    fn of_rows<'r>(row: impl Fn(usize) -> &'r f32x4) -> Self;
    /// Rows for columns, in each block.
    fn transpose(rows: [Self; 4]) -> [Self; 4];
    /// The first lane of each block, in all of its lanes.
    fn first(self) -> Self;
    /// The second.
    fn second(self) -> Self;
    /// The third.
    fn third(self) -> Self;
    /// The fourth.
    fn fourth(self) -> Self;
    /// The lanes of a block.
    fn block(self, block: usize) -> f32x4;
    /// As [`Lanes::read`](super::lanes::Lanes::read).
    fn read_lanes(from: &[f32]) -> Self;
    /// As [`Lanes::write`](super::lanes::Lanes::write).
    fn write_lanes(self, to: &mut [f32]);
    /// As [`Lanes::decode`](super::lanes::Lanes::decode).
    fn decode_lanes(codes: &[u16], windows: &Windows, offsets: &mut Offsets, limit: u32) -> bool;
    /// As [`Lanes::append`](super::lanes::Lanes::append).
    fn compress(to: (&mut [u32], &mut [f32]), used: usize, codes: &[u32], numbers: Self, mask: Self::Mask) -> usize;
    /// As [`Lanes::pick`](super::lanes::Lanes::pick).
    fn permute(column: &[f32; FEW], index: Self) -> Self;
}
