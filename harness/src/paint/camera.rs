//! The camera: projection of points onto the picture.

use super::View;
use glam::{Mat3, Vec2, Vec3};

/// Distance between the eye and the picture plane, in picture heights. This is a field of view of about 19 degrees,
/// narrow enough that a box still looks like one.
const FOCAL_HEIGHTS: f32 = 3.0;

/// Points nearer to the eye than this share of the distance to the target are not drawn.
const NEAR: f32 = 0.05;

/// A camera. It converts metres to samples.
pub(super) struct Camera {
    /// Columns are the directions right, up and towards the eye.
    axes: Mat3,
    target: Vec3,
    /// Distance from the eye to the target, metres.
    distance: f32,
    /// Samples per metre: at a depth of one metre in perspective, at every depth without.
    focal: f32,
    perspective: bool,
    /// Middle of the picture, samples.
    centre: Vec2,
    /// Depths of the nearest and the farthest corner of the bounds, metres.
    span: [f32; 2],
}

/// A projected point.
#[derive(Clone, Copy)]
pub(super) struct Spot {
    /// Position in samples, from the left and from the top.
    pub at: Vec2,
    /// Distance from the eye along the line of sight, metres.
    pub depth: f32,
    /// Samples per metre at this depth.
    pub scale: f32,
}

impl Camera {
    /// Returns a camera for a picture of `width` x `height` samples that shows all of `bounds`, with a margin of
    /// `margin` samples.
    pub(super) fn new(view: &View, bounds: [Vec3; 2], width: f32, height: f32, margin: f32) -> Self {
        // Bounds come from a scene file or from particles that may have flown apart, so invalid bounds become a unit
        // box.
        let sound = bounds.iter().all(|corner| corner.is_finite()) && bounds[0] != bounds[1];
        let bounds = if sound { bounds } else { [Vec3::ZERO, Vec3::ONE] };
        let (target, half) = (bounds[0].midpoint(bounds[1]), (bounds[1] - bounds[0]).abs() * 0.5);
        let (yaw, pitch) = match *view {
            View::Flat => (0.0, 0.0),
            View::Orbit { yaw_degrees, pitch_degrees } => (angle(yaw_degrees), angle(pitch_degrees)),
        };
        let perspective = *view != View::Flat;
        let toward = Vec3::new(yaw.sin() * pitch.cos(), pitch.sin(), yaw.cos() * pitch.cos());
        let right = Vec3::new(yaw.cos(), 0.0, -yaw.sin());
        let axes = Mat3::from_cols(right, toward.cross(right), toward);

        let room = Vec2::new(width * 0.5 - margin, height * 0.5 - margin).max(Vec2::splat(1.0));
        let corners = [0, 1, 2, 3, 4, 5, 6, 7].map(|i| axes.transpose() * corner([-half, half], i));
        // A corner (x, y, z) is visible if focal * |x| / (distance - z) is at most half of the width inside the margin,
        // and the same for y and the height.
        let long = height * FOCAL_HEIGHTS;
        let fits = |c: Vec3| (Vec2::new(c.x, c.y).abs() / room).max_element();
        let radius = half.length();
        let (distance, focal) = if perspective {
            let distance = corners.iter().map(|&c| c.z + long * fits(c)).fold(0.0, f32::max);
            (distance.max(1.5 * radius), long)
        } else {
            let tightest = corners.iter().map(|&c| fits(c)).fold(f32::MIN_POSITIVE, f32::max);
            (4.0 * radius, tightest.recip())
        };
        let depth = |pick: fn(f32, f32) -> f32| corners.iter().map(|c| distance - c.z).reduce(pick).unwrap_or(distance);
        let span = [depth(f32::min), depth(f32::max)];
        Self { axes, target, distance, focal, perspective, centre: Vec2::new(width, height) * 0.5, span }
    }

    /// Projects a point; `None` if it is not finite, behind the eye or very close to the eye.
    pub(super) fn spot(&self, point: Vec3) -> Option<Spot> {
        let seen = self.axes.transpose() * (point - self.target);
        let depth = self.distance - seen.z;
        if !(seen.is_finite() && depth > NEAR * self.distance) {
            return None;
        }
        let scale = self.scale_at(depth);
        Some(Spot { at: self.centre + Vec2::new(seen.x, -seen.y) * scale, depth, scale })
    }

    /// Returns the samples per metre at `depth`.
    pub(super) fn scale_at(&self, depth: f32) -> f32 {
        if self.perspective { self.focal / depth } else { self.focal }
    }

    /// Returns the line of sight through a sample: its origin and its direction. Returns `None` without perspective,
    /// where all lines of sight are parallel and the floor is not visible.
    pub(super) fn sight(&self, at: Vec2) -> Option<(Vec3, Vec3)> {
        let offset = (at - self.centre) / self.focal;
        let eye = self.target + self.axes.z_axis * self.distance;
        self.perspective.then(|| (eye, self.axes * Vec3::new(offset.x, -offset.y, -1.0)))
    }

    /// Returns the point of the plane through the target that a sample shows without perspective, and the metres per
    /// sample there.
    pub(super) fn flat(&self, at: Vec2) -> (Vec3, f32) {
        let offset = (at - self.centre) / self.focal;
        (self.target + self.axes * Vec3::new(offset.x, -offset.y, 0.0), self.focal.recip())
    }

    /// Returns the smallest and the largest depth at which solids are looked for, metres.
    pub(super) fn reach(&self) -> [f32; 2] {
        [NEAR * self.distance, self.span[1] + 0.5 * self.distance]
    }

    /// Returns how far back in the bounds `depth` lies: 0 at the nearest corner, 1 at the farthest.
    pub(super) fn recession(&self, depth: f32) -> f32 {
        let [near, far] = self.span;
        ((depth - near) / (far - near).max(f32::MIN_POSITIVE)).clamp(0.0, 1.0)
    }
}

/// Returns corner number `i`, 0 to 7, of the box between two points: bit k of `i` selects the point that gives
/// coordinate k.
pub(super) fn corner(ends: [Vec3; 2], i: usize) -> Vec3 {
    Vec3::new(ends[i & 1].x, ends[i >> 1 & 1].y, ends[i >> 2 & 1].z)
}

/// Converts degrees to radians. An angle that is not finite becomes 0.
fn angle(degrees: f32) -> f32 {
    if degrees.is_finite() { degrees.to_radians() } else { 0.0 }
}
