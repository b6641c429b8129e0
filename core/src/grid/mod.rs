//! The uniform grid: particles sorted by cell, and the stencil of cells around a cell, in which neighbours are
//! searched.
//!
//! The cells wrap around, so distant particles may share a cell; the distance test excludes them. The stencil visits
//! cells by z, then y, then x, each ascending in unwrapped coordinates, and the particles of a cell are in the order of
//! their ids. This order of summation is part of the specification: it does not depend on the grid structure, the grid
//! size or earlier steps. The half stencil has a different order (`half.rs`), which also depends on the number of
//! cells.
pub(crate) mod half;
pub(crate) mod lanes;

use crate::executor::share_of;
use crate::layout::{Model, Parameters, f32x4};
use core::ops::Range;

/// Largest distance of a coordinate from the origin, in cells. Beyond it single precision is too coarse to determine
/// the cell.
pub const FARTHEST_CELL: f32 = 4_194_304.0;

/// Returns the cell of a coordinate along an axis before wrapping, or `None` if it is out of range or NaN.
#[inline]
#[must_use]
pub fn cell_coordinate(p: &Parameters, axis: usize, x: f32) -> Option<i32> {
    let scaled = (x - p.domain_low[axis]) * p.inverse_cell[axis];
    (scaled.abs() < FARTHEST_CELL).then(|| floor_of(scaled))
}

/// Returns the largest integer that is not larger than the argument.
#[inline(always)]
fn floor_of(scaled: f32) -> i32 {
    let towards_zero = scaled as i32;
    // wraps for numbers out of range, which callers reject
    towards_zero.wrapping_sub(i32::from(towards_zero as f32 > scaled))
}

/// Returns the index of the cell at unwrapped coordinates, which are wrapped by floor and Euclidean remainder
/// (Pirovano, source 4.2, corrected).
#[inline]
#[must_use]
pub fn cell_index(p: &Parameters, c: [i32; 3]) -> u32 {
    let [x, y, z] = [0, 1, 2].map(|axis| wrapped(c[axis], p.cells[axis] as i32) as u32);
    x + p.cells[0] * (y + p.cells[1] * z)
}

/// Returns the Euclidean remainder. Nearly all coordinates are less than a period off, and a division costs as much as
/// the distance test of a few neighbours.
#[inline(always)]
fn wrapped(c: i32, count: i32) -> i32 {
    let near = within_a_period(c, count);
    if (0..count).contains(&near) { near } else { c.rem_euclid(count) }
}

/// Returns the remainder of a coordinate that is less than a period off, else some number outside the grid.
#[inline(always)]
fn within_a_period(c: i32, count: i32) -> i32 {
    c.wrapping_add(if c < 0 { count } else { 0 }).wrapping_sub(if c >= count { count } else { 0 })
}

/// Returns the cell of a position.
///
/// # Errors
/// The first axis along which the position is out of range, if there is one.
#[inline]
pub fn cell_of(p: &Parameters, position: f32x4) -> Result<u32, u32> {
    let mut c = [0; 3];
    for (axis, c) in c.iter_mut().enumerate() {
        *c = cell_coordinate(p, axis, position[axis]).ok_or(axis as u32)?;
    }
    Ok(cell_index(p, c))
}

/// Returns whether this is the cell of inactive particles. It is the last cell, and no stencil includes it.
#[inline(always)]
pub(crate) fn is_inactive_cell(m: &Model, p: &Parameters, cell: usize) -> bool {
    m.has_inactive == 1 && cell + 1 == p.cells[3] as usize
}

/// The particles sorted by cell: those of cell `c` lie in `counter[c]` slots from `start[c]` on.
#[derive(Clone, Copy)]
pub struct Cells<'a> {
    /// First slot of each cell.
    pub start: &'a [u32],
    /// Number of particles in each cell.
    pub counter: &'a [u32],
}

impl Cells<'_> {
    /// Returns the slots of a cell.
    #[inline(always)]
    #[must_use]
    pub fn members(&self, cell: usize) -> Range<usize> {
        let start = self.start[cell] as usize;
        start..start + self.counter[cell] as usize
    }

    /// Returns the first slot of a cell, or the number of particles for the cell after the last.
    fn first_slot(&self, cell: usize, particles: usize) -> usize {
        self.start.get(cell).map_or(particles, |&slot| slot as usize)
    }

    /// Divides the cells into `parts` ranges with about the same number of particles. Each item is a range of cells and
    /// its range of slots.
    pub fn shares(self, parts: usize, particles: usize) -> impl Iterator<Item = (Range<usize>, Range<usize>)> {
        let mut from = 0;
        (1..=parts).map(move |part| {
            let target = share_of(particles, part, parts);
            let to = if part == parts {
                self.start.len()
            } else {
                self.start.partition_point(|&slot| (slot as usize) < target).max(from)
            };
            let share = (from..to, self.first_slot(from, particles)..self.first_slot(to, particles));
            from = to;
            share
        })
    }
}

/// The cells around a cell, as runs of consecutive slots, in the order of summation.
pub struct Stencil {
    runs: [(u32, u32); 27],
    count: usize,
}

impl Stencil {
    /// Returns the stencil around `cell`. `layers` is 1 in 3D and 0 in 2D. Adjacent cells along x share a run unless
    /// they wrap around.
    #[inline]
    #[must_use]
    pub fn around(p: &Parameters, layers: i32, cells: Cells<'_>, cell: usize) -> Stencil {
        let [nx, ny, nz, _] = p.cells.map(|count| count as i32);
        let (row, x) = (cell as u32 / p.cells[0], (cell as u32 % p.cells[0]) as i32);
        let [y, z] = [row % p.cells[1], row / p.cells[1]].map(|c| c as i32);
        let mut stencil = Stencil { runs: [(0, 0); 27], count: 0 };
        for dz in -layers..=layers {
            let plane = ny * wrapped(z + dz, nz);
            for dy in -1..=1 {
                let first = (nx * (plane + wrapped(y + dy, ny))) as usize;
                if x > 0 && x + 1 < nx {
                    let own = first + x as usize;
                    stencil.push(cells.start[own - 1] as usize, cells.members(own + 1).end);
                } else {
                    for dx in -1..=1 {
                        let run = cells.members(first + wrapped(x + dx, nx) as usize);
                        stencil.push(run.start, run.end);
                    }
                }
            }
        }
        stencil
    }

    #[inline(always)]
    fn push(&mut self, start: usize, end: usize) {
        if start < end {
            self.runs[self.count] = (start as u32, end as u32);
            self.count += 1;
        }
    }

    /// Returns the runs of slots.
    #[inline(always)]
    pub fn runs(&self) -> impl Iterator<Item = Range<usize>> {
        self.runs[..self.count].iter().map(|&(start, end)| start as usize..end as usize)
    }
}
