//! The lattice on which particles start. Its spacing is the scene's particle spacing.
use crate::derive::frames::Frames;
use crate::scene::{Block, BlockShape, Dimension, Scene};

/// Number of particles of a block along x, y, z. Each number is rounded before they are multiplied.
pub(crate) fn counts(block: &Block, scene: &Scene) -> [u64; 3] {
    let along = |axis: usize| {
        if axis == 2 && scene.dimension == Dimension::Two { 1 } else { whole(block.size[axis], scene) }
    };
    [along(0), along(1), along(2)]
}

/// Largest number of cells of a box whose ball is counted cell by cell. A larger one has too many particles anyway.
const MOST_CELLS: u64 = 1 << 30;

/// Number of particles of a block. It is found quickly for any scene, checked or not.
pub(crate) fn particles(block: &Block, scene: &Scene, frames: Frames<'_>) -> u64 {
    let counts = counts(block, scene);
    let volume = volume(counts);
    if leaves_out(block, scene) && volume <= MOST_AROUND_SOLIDS {
        return cells(block, scene, frames).count() as u64;
    }
    match block.shape {
        BlockShape::Box => volume,
        BlockShape::Ball if volume > MOST_CELLS => volume,
        BlockShape::Ball => {
            // along the longest axis the cells of a row are counted from its ends inwards
            let mut sorted = counts;
            sorted.sort_unstable();
            let [rows, columns, length] = sorted;
            let row = |i: u64, j: u64| {
                let across = offset(i, rows) + offset(j, columns);
                let outside = (0..length / 2).take_while(|&k| across + offset(k, length) > 1.0).count() as u64;
                let middle = u64::from(length % 2 == 1 && across + offset(length / 2, length) > 1.0);
                length - 2 * outside - middle
            };
            (0..rows).map(|i| (0..columns).map(|j| row(i, j)).sum::<u64>()).sum()
        }
    }
}

/// Product of the counts along each axis.
pub(crate) fn volume(counts: [u64; 3]) -> u64 {
    counts.iter().fold(1, |all, &n| all.saturating_mul(n))
}

/// Squared distance of the centre of a cell from the middle of its row, over half of the row's length.
fn offset(index: u64, count: u64) -> f64 {
    let at = (2 * index + 1) as f64 / count as f64 - 1.0;
    at * at
}

/// Returns whether a cell belongs to a block. In 2D there is one layer, whose offset is 0.
fn belongs(block: &Block, index: [u64; 3], counts: [u64; 3]) -> bool {
    let [x, y, z] = [0, 1, 2].map(|axis| offset(index[axis], counts[axis]));
    // in the order in which the rows add them up
    let mut sorted = [(counts[0], 0, x), (counts[1], 1, y), (counts[2], 2, z)];
    sorted.sort_unstable_by_key(|(count, axis, _)| (*count, *axis));
    let [a, b, c] = sorted.map(|(.., offset)| offset);
    block.shape == BlockShape::Box || a + b + c <= 1.0
}

/// Largest number of cells of a block around solids.
pub(crate) const MOST_AROUND_SOLIDS: u64 = 1 << 24;

/// Returns whether a block leaves out the places in solids.
pub(crate) fn leaves_out(block: &Block, scene: &Scene) -> bool {
    block.around_solids && !scene.solids.is_empty()
}

/// Indices of the cells of a block, the first index fastest.
pub(crate) fn cells<'a>(
    block: &'a Block,
    scene: &Scene,
    frames: Frames<'a>,
) -> impl Iterator<Item = [u64; 3]> + use<'a> {
    let counts = counts(block, scene);
    let spacing = f64::from(scene.particle_spacing);
    let d = scene.dimension.count();
    let leaves_out = leaves_out(block, scene);
    let is_free = move |index: &[u64; 3]| {
        let centre = || centre(block, *index, spacing, d).map(|x| x as f32);
        !leaves_out || frames.nearest(centre().into()) >= 0.499 * spacing as f32
    };
    indices(counts).filter(move |index| belongs(block, *index, counts) && is_free(index))
}

/// Centre of a cell of a block, m; 0 along the axes that the scene does not have.
pub(crate) fn centre(block: &Block, index: [u64; 3], spacing: f64, d: usize) -> [f64; 3] {
    let along = |axis: usize| f64::from(block.corner[axis]) + (index[axis] as f64 + 0.5) * spacing;
    [0, 1, 2].map(|axis| if axis < d { along(axis) } else { 0.0 })
}

/// A length as a whole number of spacings.
pub(crate) fn whole(length: f32, scene: &Scene) -> u64 {
    let count = f64::from(length) / f64::from(scene.particle_spacing);
    if count > 0.0 { (count + 0.5) as u64 } else { 0 }
}

/// All index triples below `counts`, the first index fastest.
pub(crate) fn indices(counts: [u64; 3]) -> impl Iterator<Item = [u64; 3]> {
    let [nx, ny, nz] = counts;
    (0..nz).flat_map(move |z| (0..ny).flat_map(move |y| (0..nx).map(move |x| [x, y, z])))
}
