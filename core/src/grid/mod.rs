//! Where neighbours are found: particles sorted by cell, and the cells around a cell.
//!
//! The cells wrap around, so far particles may share one; the distance test sorts them out. The stencil runs z, then y,
//! then x ascending in unwrapped coordinates, and members of a cell stand in the order of their ids: this order of
//! summation is part of the specification, and no structure, grid size or history changes it. The half stencil has an order of its
//! own (`half.rs`), which the number of cells decides too.
pub(crate) mod half;
pub(crate) mod lanes;

use crate::executor::share_of;
use crate::layout::{Model, Parameters, f32x4};
use core::ops::Range;

/// A coordinate past this many cells from the origin cannot tell its cell any more.
pub const FARTHEST_CELL: f32 = 4_194_304.0;

/// The cell of a coordinate along an axis before wrapping, or `None` beyond the range (or for NaN).
#[inline]
#[must_use]
pub fn cell_coordinate(p: &Parameters, axis: usize, x: f32) -> Option<i32> {
    let scaled = (x - p.domain_low[axis]) * p.inverse_cell[axis];
    (scaled.abs() < FARTHEST_CELL).then(|| floor_of(scaled))
}

/// The largest whole number that is not larger.
#[inline(always)]
fn floor_of(scaled: f32) -> i32 {
    let towards_zero = scaled as i32;
    // wraps for numbers beyond the range, which callers refuse
    towards_zero.wrapping_sub(i32::from(towards_zero as f32 > scaled))
}

/// Index of the wrapped cell at unwrapped coordinates: floor and Euclidean remainder (Pirovano source 4.2, corrected).
#[inline]
#[must_use]
pub fn cell_index(p: &Parameters, c: [i32; 3]) -> u32 {
    let [x, y, z] = [0, 1, 2].map(|axis| wrapped(c[axis], p.cells[axis] as i32) as u32);
    x + p.cells[0] * (y + p.cells[1] * z)
}

/// Euclidean remainder. Nearly all coordinates are less than a period off, and a division costs as much as trying a few neighbours.
#[inline(always)]
fn wrapped(c: i32, count: i32) -> i32 {
    let near = within_a_period(c, count);
    if (0..count).contains(&near) { near } else { c.rem_euclid(count) }
}

/// The remainder of a coordinate that is less than a period off, else some other number beyond the grid.
#[inline(always)]
fn within_a_period(c: i32, count: i32) -> i32 {
    c.wrapping_add(if c < 0 { count } else { 0 }).wrapping_sub(if c >= count { count } else { 0 })
}

/// Cell of a position.
///
/// # Errors
/// The first axis along which it lies beyond the range.
#[inline]
pub fn cell_of(p: &Parameters, position: f32x4) -> Result<u32, u32> {
    let mut c = [0; 3];
    for (axis, c) in c.iter_mut().enumerate() {
        *c = cell_coordinate(p, axis, position[axis]).ok_or(axis as u32)?;
    }
    Ok(cell_index(p, c))
}

/// Is this the cell of air that is not there? It is the last one, and no stencil reaches it.
#[inline(always)]
pub(crate) fn is_limbo(m: &Model, p: &Parameters, cell: usize) -> bool {
    m.has_air == 1 && cell + 1 == p.cells[3] as usize
}

/// The sorted particles: those of cell `c` stand at slots `start[c] ..`, `counter[c]` of them.
#[derive(Clone, Copy)]
pub struct Cells<'a> {
    /// First slot of each cell.
    pub start: &'a [u32],
    /// Particles of each cell.
    pub counter: &'a [u32],
}

impl Cells<'_> {
    /// Slots of a cell.
    #[inline(always)]
    #[must_use]
    pub fn members(&self, cell: usize) -> Range<usize> {
        let start = self.start[cell] as usize;
        start..start + self.counter[cell] as usize
    }

    /// First slot of a cell, or the number of particles for the one after the last.
    fn first_slot(&self, cell: usize, particles: usize) -> usize {
        self.start.get(cell).map_or(particles, |&slot| slot as usize)
    }

    /// Cuts the cells into `parts` runs of about equally many particles: (cells, slots) of each.
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

/// Runs of slots around a cell, in the order of the stencil.
pub struct Stencil {
    runs: [(u32, u32); 27],
    count: usize,
}

impl Stencil {
    /// The runs around `cell`. Cells that follow each other along x without wrapping share one.
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

    /// The runs.
    #[inline(always)]
    pub fn runs(&self) -> impl Iterator<Item = Range<usize>> {
        self.runs[..self.count].iter().map(|&(start, end)| start as usize..end as usize)
    }
}
