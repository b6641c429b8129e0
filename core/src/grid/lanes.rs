//! The cells of several positions, one per lane.
use super::{FARTHEST_CELL, floor_of, within_a_period};
use crate::arithmetic::codes::MOST_LANES;
use crate::arithmetic::lanes::Lanes;
use crate::layout::{Parameters, f32x4};

/// Returns the cells of as many positions as there are lanes. Returns `None` if one of them is out of range or more
/// than one period away from the grid; [`cell_of`](super::cell_of) then handles each position separately.
///
/// The integers are computed in loops over arrays, which the compiler vectorises, because the intrinsics of the terms
/// include no integers.
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
            // x + nx (y + ny z), starting with z
            *cell = (near as u32).wrapping_add(p.cells[axis].wrapping_mul(*cell));
        }
    }
    all.then_some(cells)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::arithmetic::level::{Simd, Work};
    use crate::grid::cell_of;

    /// Asserts that the cell of a position in the last lane is that of [`cell_of`], if cells are returned.
    struct Last<'a>(&'a Parameters, f32x4, &'a mut u32);

    impl Work for Last<'_> {
        #[inline(always)]
        fn run<R: Lanes>(self) {
            let near = [0.5, 0.5, 0.5, 1.0];
            let cells = cells_of::<R>(self.0, |lane| if lane + 1 == R::LANES { &self.1 } else { &near });
            if let Some(cells) = cells {
                assert_eq!(Ok(cells[R::LANES - 1]), cell_of(self.0, self.1), "{:?}", self.1);
                *self.2 += 1;
            }
        }
    }

    #[test]
    fn cells_side_by_side_are_those_of_each() {
        let mut parameters: Parameters = bytemuck::Zeroable::zeroed();
        (parameters.cells, parameters.inverse_cell) = ([5, 7, 9, 315], [1.0, 1.0, 1.0, 0.0]);
        let edge = FARTHEST_CELL;
        let numbers =
            [0.0, -0.0, 0.99, 1.0, 4.999, 5.0, -0.001, -4.5, -5.0, 9.5, 14.0, 1e6, edge, -edge, 1e30, f32::NAN];
        for simd in Simd::available() {
            let mut told = 0;
            for x in numbers {
                for [y, z] in [[0.5, 0.5], [x, 8.5], [-3.0, x]] {
                    simd.run(Last(&parameters, [x, y, z, 1.0], &mut told));
                }
            }
            // most positions are within a period of the grid
            assert!((20..48).contains(&told), "{simd:?}: {told}");
        }
    }
}
