//! The edges of the container, drawn with depth so that water stands in front of the back ones.

use super::camera::{Camera, corner};
use super::discs::Layer;
use glam::Vec3;

/// Half the width of an edge, as a share of the picture's height.
const HALF_WIDTH: f32 = 0.0011;

/// Most dots to an edge: enough to cross the largest picture without gaps.
const MOST_DOTS: f32 = 40_000.0;

/// Draws the twelve edges of the box between two corners.
pub(super) fn draw(layer: &mut Layer, camera: &Camera, corners: [Vec3; 2]) {
    for from in 0..8 {
        for to in [1, 2, 4].map(|axis| from | axis).into_iter().filter(|&to| to != from) {
            edge(layer, camera, corner(corners, from), corner(corners, to));
        }
    }
}

/// Draws one edge as a row of dots, each put into the picture by itself: slower than stepping along the drawn line,
/// and right in every view without a word about perspective.
fn edge(layer: &mut Layer, camera: &Camera, a: Vec3, b: Vec3) {
    let half = (HALF_WIDTH * layer.height() as f32).max(0.8);
    let scale = [a, b].into_iter().filter_map(|end| camera.spot(end)).map(|spot| spot.scale).fold(0.0, f32::max);
    let dots = (a.distance(b) * scale).clamp(1.0, MOST_DOTS).ceil();
    for i in 0..=dots as u32 {
        if let Some(spot) = camera.spot(a.lerp(b, i as f32 / dots)) {
            layer.draw_dot(spot.at, half, spot.depth);
        }
    }
}
