//! The cells of several positions side by side.
use super::{FARTHEST_CELL, floor_of, within_a_period};
use crate::arithmetic::codes::MOST_LANES;
use crate::arithmetic::lanes::Lanes;
use crate::layout::{Parameters, f32x4};

/// The cells of as many positions as there are lanes; nothing where one of them is beyond the range, or more than a period away from
/// the grid. [`cell_of`](super::cell_of) tells of each by itself.
///
/// Whole numbers in loops over arrays, in which the compiler finds vectors: the vocabulary of the terms has none.
#[inline(always)]
#[expect(clippy::needless_bitwise_bool, reason = "a short cut would be a branch in each lane")]
pub(crate) fn cells_of<'r, R: Lanes>(p: &Parameters, row: impl Fn(usize) -> &'r f32x4) -> Option<[u32; MOST_LANES]> {
    let [x, y, z, _] = R::load(row);
    let mut cells = [0; MOST_LANES];
    let mut all = true;
    for (axis, x) in [x, y, z].into_iter().enumerate().rev() {
        let mut scaled = [0.0; MOST_LANES];
        ((x - p.domain_low[axis]) * p.inverse_cell[axis]).write(&mut scaled);
        let count = p.cells[axis] as i32;
        for (cell, scaled) in cells[..R::LANES].iter_mut().zip(&scaled[..R::LANES]) {
            let near = within_a_period(floor_of(*scaled), count);
            all &= (scaled.abs() < FARTHEST_CELL) & (near >= 0) & (near < count);
            // x + nx (y + ny z), from z on
            *cell = (near as u32).wrapping_add(p.cells[axis].wrapping_mul(*cell));
        }
    }
    all.then_some(cells)
}
