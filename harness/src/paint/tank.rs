//! The container: its edges, drawn with depth so that water hides those behind it, and its floor, with the soft shadow
//! of the water straight above.

use super::Frame;
use super::camera::{Camera, corner};
use super::discs::Layer;
use glam::{Vec2, Vec3};

/// Width of an edge, as a share of the picture height.
const WIDTH: f32 = 0.0028;

/// Largest number of dots per edge, enough to cross the largest picture without gaps.
const MOST_DOTS: f32 = 40_000.0;

/// Number of cells along each side of the shadow map.
const CELLS: usize = 96;

/// Number of passes of the blur that softens the shadow.
const BLURS: usize = 6;

/// Draws the twelve edges of the box between two corners.
pub(super) fn outline(layer: &mut Layer, camera: &Camera, corners: [Vec3; 2]) {
    for from in 0..8 {
        for to in [1, 2, 4].map(|axis| from | axis).into_iter().filter(|&to| to != from) {
            edge(layer, camera, corner(corners, from), corner(corners, to));
        }
    }
}

/// Draws one edge as a row of dots that are projected one by one. This is slower than drawing a projected line, but
/// needs no special case for perspective.
fn edge(layer: &mut Layer, camera: &Camera, a: Vec3, b: Vec3) {
    // The width is a whole number of samples, since any other width would vary along a slanted edge.
    let half = 0.5 * (WIDTH * layer.height() as f32).round().max(2.0);
    let scale = [a, b].into_iter().filter_map(|end| camera.spot(end)).map(|spot| spot.scale).fold(0.0, f32::max);
    let dots = (a.distance(b) * scale).clamp(1.0, MOST_DOTS).ceil();
    for i in 0..=dots as u32 {
        if let Some(spot) = camera.spot(a.lerp(b, i as f32 / dots)) {
            layer.draw_dot(spot.at, half, spot.depth);
        }
    }
}

/// The floor and its shadow map.
pub(super) struct Floor {
    low: Vec3,
    size: Vec2,
    shadow: Vec<f32>,
}

impl Floor {
    /// Returns the floor of a container; `None` if it is not visible from above.
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
        // Each layer of spheres blocks a share of the light that the layers above it let through.
        floor.shadow.iter_mut().for_each(|cover| *cover = 1.0 - (-cover.max(0.0)).exp());
        Some(floor)
    }

    /// Returns how dark the floor is where the line of sight through a sample meets it, 0 to 1; `None` outside of the
    /// floor.
    pub(super) fn shadow(&self, camera: &Camera, at: Vec2) -> Option<f32> {
        let (eye, sight) = camera.sight(at)?;
        let reach = (self.low.y - eye.y) / sight.y;
        let cell = (reach > 0.0).then(|| self.cell(eye + sight * reach))??;
        self.shadow.get(cell).copied()
    }

    /// Returns the cell below `point`; `None` for a point that is not above the floor.
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
