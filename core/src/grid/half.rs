//! Half of the cells around a cell: those that lie ahead of it, so that each pair of cells is met once.
use super::{Cells, wrapped};
use crate::layout::Parameters;
use core::ops::Range;

/// Cells ahead of one in space: its neighbour along x, three of the next row, nine of the next plane.
const AHEAD: usize = 13;

/// Planes of cells. Pairs reach from one to the next: along z, in 2D rows along y.
#[derive(Clone, Copy)]
pub(crate) struct Planes {
    /// How many there are.
    pub count: usize,
    /// Cells of each.
    pub cells: usize,
}

impl Planes {
    /// Those of a grid.
    pub(crate) fn of(p: &Parameters, layers: u32) -> Planes {
        let [x, y, z, _] = p.cells.map(|count| count as usize);
        if layers == 0 { Planes { count: y, cells: x } } else { Planes { count: z, cells: x * y } }
    }

    /// Slots of the particles in these planes, of which there is one at least.
    pub(crate) fn slots(&self, cells: Cells<'_>, planes: Range<usize>) -> Range<usize> {
        cells.members(planes.start * self.cells).start..cells.members(planes.end * self.cells - 1).end
    }
}

/// The members of the cells ahead of `cell`, in order: along x, the next row, the next plane.
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
