//! The cells of a scene, and the constants of each axis.
use super::scales::Scales;
use crate::layout::f32x4;
use crate::scene::{Dimension, Scene};

/// Cells along x, y, z: those of `grid`; along a periodic axis as many as fit; in 2D one along z.
pub(crate) fn cells(scene: &Scene, scales: &Scales) -> [u32; 3] {
    let mut cells = scene.grid.cells;
    for axis in scene.periodic_axes() {
        if let Some(periodic) = &scene.periodic {
            let length = f64::from(periodic.high[axis]) - f64::from(periodic.low[axis]);
            let fitting = length / scales.least_cell;
            // a number of cells that is too large is rejected later, where the three numbers are multiplied
            cells[axis] = fitting.min(f64::from(u32::MAX)) as u32;
        }
    }
    if scene.dimension == Dimension::Two {
        cells[2] = 1;
    }
    cells
}

/// The constants of each axis.
pub(super) struct Axes {
    pub(super) cells: [u32; 4],
    pub(super) inverse_cell: f32x4,
    pub(super) domain_low: f32x4,
    pub(super) period: f32x4,
    pub(super) half_period: f32x4,
    pub(super) inverse_period: f32x4,
}

impl Axes {
    pub(super) fn of(scene: &Scene, scales: &Scales, [x, y, z]: [u32; 3]) -> Axes {
        // inactive particles lie in an additional cell, the last one, which no stencil reaches
        let inactive_cells = u32::from(scene.has_inactive());
        let inverse = (1.0 / scales.least_cell) as f32;
        let mut axes = Axes {
            cells: [x, y, z, x.wrapping_mul(y).wrapping_mul(z).wrapping_add(inactive_cells)],
            inverse_cell: [inverse, inverse, inverse, 0.0],
            domain_low: [0.0; 4],
            period: [0.0; 4],
            half_period: [f32::MAX; 4],
            inverse_period: [0.0; 4],
        };
        for axis in scene.periodic_axes() {
            if let Some(periodic) = &scene.periodic {
                let length = f64::from(periodic.high[axis]) - f64::from(periodic.low[axis]);
                axes.inverse_cell[axis] = (f64::from(axes.cells[axis]) / length) as f32;
                axes.domain_low[axis] = periodic.low[axis];
                axes.period[axis] = length as f32;
                axes.half_period[axis] = (length * 0.5) as f32;
                axes.inverse_period[axis] = (1.0 / length) as f32;
            }
        }
        axes
    }
}
