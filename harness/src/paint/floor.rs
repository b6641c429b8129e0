//! The floor of the container, with the soft shadow that the water throws straight down on it.

use super::Frame;
use super::camera::Camera;
use glam::{Vec2, Vec3};

/// Cells along each side of the shadow.
const CELLS: usize = 96;

/// Passes of the blur that softens the shadow.
const BLURS: usize = 3;

/// The floor, and how much of the sky each part of it sees.
pub(super) struct Floor {
    low: Vec3,
    size: Vec2,
    shadow: Vec<f32>,
}

impl Floor {
    /// The floor of a container; none where it would not be seen from above.
    pub(super) fn new(camera: &Camera, corners: [Vec3; 2], frame: &Frame) -> Option<Self> {
        let (low, high) = (corners[0].min(corners[1]), corners[0].max(corners[1]));
        let size = Vec2::new(high.x - low.x, high.z - low.z);
        let (eye, _) = camera.sight(Vec2::ZERO)?;
        if !(eye.y > low.y && size.min_element() > 0.0) {
            return None;
        }
        let mut floor = Self { low, size, shadow: vec![0.0; CELLS * CELLS] };
        let cell = size / CELLS as f32;
        let cover = std::f32::consts::PI * frame.radius * frame.radius / cell.element_product();
        for &[x, y, z, _] in frame.positions {
            if let Some(cell) = floor.cell(Vec3::new(x, y, z)) {
                floor.shadow[cell] += cover;
            }
        }
        (0..BLURS).for_each(|_| floor.blur());
        // What one layer of spheres lets through, the next dims again.
        floor.shadow.iter_mut().for_each(|cover| *cover = 1.0 - (-cover.max(0.0)).exp());
        Some(floor)
    }

    /// How dark the floor is in the line of sight through a sample, 0 to 1; none past its edge.
    pub(super) fn shadow(&self, camera: &Camera, at: Vec2) -> Option<f32> {
        let (eye, sight) = camera.sight(at)?;
        let reach = (self.low.y - eye.y) / sight.y;
        let point = eye + sight * reach;
        if !(reach > 0.0) {
            return None;
        }
        let cell = self.cell(point)?;
        self.shadow.get(cell).copied()
    }

    /// The cell under `point`; none for a point that is not above the floor.
    fn cell(&self, point: Vec3) -> Option<usize> {
        let place = Vec2::new(point.x - self.low.x, point.z - self.low.z) / self.size;
        let inside = place.cmpge(Vec2::ZERO).all() && place.cmple(Vec2::ONE).all();
        let [x, z] = (place * CELLS as f32).to_array().map(|at| (at as usize).min(CELLS - 1));
        inside.then_some(z * CELLS + x)
    }

    /// Averages each cell with its neighbours.
    fn blur(&mut self) {
        let old = self.shadow.clone();
        for (i, cover) in self.shadow.iter_mut().enumerate() {
            let (x, z) = (i % CELLS, i / CELLS);
            let [xs, zs] = [x, z].map(|c| c.saturating_sub(1)..=(c + 1).min(CELLS - 1));
            let sum: f32 = zs.flat_map(|z| xs.clone().map(move |x| z * CELLS + x)).map(|j| old[j]).sum();
            *cover = sum / 9.0;
        }
    }
}
