//! The half stencil: the half of the cells around a cell that lies ahead of it, so that each pair of cells is visited
//! once.
use super::{Cells, wrapped};
use crate::layout::Parameters;
use core::ops::Range;

/// Number of cells ahead of a cell in 3D: its neighbour along x, three in the next row, nine in the next plane.
const AHEAD: usize = 13;

/// Planes of cells, in 3D across the z axis; in 2D rows, across the y axis. Pairs reach from one plane to the next.
#[derive(Clone, Copy)]
pub(crate) struct Planes {
    /// Number of planes.
    pub count: usize,
    /// Number of cells in each plane.
    pub cells: usize,
}

impl Planes {
    /// Returns the planes of a grid. `layers` is 1 in 3D and 0 in 2D.
    pub(crate) fn of(p: &Parameters, layers: u32) -> Planes {
        let [x, y, z, _] = p.cells.map(|count| count as usize);
        if layers == 0 { Planes { count: y, cells: x } } else { Planes { count: z, cells: x * y } }
    }

    /// Returns the slots of the particles in a range of planes, which must not be empty.
    pub(crate) fn slots(&self, cells: Cells<'_>, planes: Range<usize>) -> Range<usize> {
        cells.members(planes.start * self.cells).start..cells.members(planes.end * self.cells - 1).end
    }
}

/// Returns the slots of the cells ahead of `cell`, in this order: along x, the next row, the next plane. `layers` is 1
/// in 3D and 0 in 2D.
pub(crate) fn ahead(p: &Parameters, layers: u32, cells: Cells<'_>, cell: usize) -> impl Iterator<Item = Range<usize>> {
    let [nx, ny, nz, _] = p.cells.map(|count| count as i32);
    let (row, x) = (cell as i32 / nx, cell as i32 % nx);
    let (y, z) = (row % ny, row / ny);
    let in_plane = (0..4).map(|i| if i == 0 { [1, 0, 0] } else { [i - 2, 1, 0] });
    let next_plane = (0..9).map(|i| [i % 3 - 1, i / 3 - 1, 1]);
    let of_layers = if layers == 0 { 4 } else { AHEAD };
    in_plane.chain(next_plane).take(of_layers).map(move |[dx, dy, dz]| {
        let [x, y, z] = [wrapped(x + dx, nx), wrapped(y + dy, ny), wrapped(z + dz, nz)];
        cells.members((x + nx * (y + ny * z)) as usize)
    })
}
