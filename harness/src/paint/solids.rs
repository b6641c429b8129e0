//! Solids, drawn by following the line of sight through each sample to their surface (sphere tracing, Hart 1996).

use super::camera::Camera;
use super::colour::from_srgb;
use glam::{Vec2, Vec3};
use rayon::prelude::*;

/// Distances of a point from the solids, m: from the nearest obstacle, and from the nearest wall around the fluid. They
/// are negative in an obstacle, and outside of such a wall.
pub type Distances<'a> = dyn Fn(Vec3) -> [f32; 2] + Sync + 'a;

/// Largest number of points that are tried along a line of sight.
const MOST_TRACED: usize = 160;

/// Width of the outline of a solid in a flat view, samples.
const OUTLINE: f32 = 3.0;

/// The light on obstacles comes from up here: right, up and towards the eye of an upright camera.
const SUN: Vec3 = Vec3::new(-0.4, 0.8, 0.45);

/// What a sample shows of the solids.
#[derive(Clone, Copy)]
pub(super) struct Seen {
    /// Depth of the surface, metres; infinite if there is none.
    pub depth: f32,
    /// Its colour.
    pub colour: Vec3,
}

const NOTHING: Seen = Seen { depth: f32::INFINITY, colour: Vec3::ZERO };

/// Returns what each sample of a picture shows of the solids.
pub(super) fn look(camera: &Camera, distances: &Distances<'_>, width: usize, height: usize) -> Vec<Seen> {
    let [stone, line, wall] = [0x9a_a1a8, 0x4a_525a, 0xd4_dae0].map(from_srgb);
    let at = |i: usize| Vec2::new((i % width) as f32 + 0.5, (i / width) as f32 + 0.5);
    let shaded = |normal: Vec3| 0.45 + 0.4 * normal.dot(SUN.normalize()).max(0.0) + 0.15 * normal.y;
    (0..width * height)
        .into_par_iter()
        .map(|i| match camera.sight(at(i)) {
            None => {
                let (point, metres) = camera.flat(at(i));
                let [obstacle, around] = distances(point);
                let is_rim = |distance: f32| distance < 0.0 && distance > -OUTLINE * metres;
                let seen = if is_rim(obstacle) || is_rim(around) { Some(line) } else { None };
                let seen = seen.or((obstacle < 0.0).then_some(stone));
                seen.map_or(NOTHING, |colour| Seen { depth: 0.0, colour })
            }
            Some((eye, sight)) => {
                let length = sight.length();
                let ray = sight / length;
                let [near, far] = camera.reach().map(|depth| depth * length);
                let obstacle = follow(near, far, &|along| distances(eye + ray * along)[0]);
                // the wall around the fluid is seen from inside: where the line of sight leaves it
                let enters = follow(near, far, &|along| -distances(eye + ray * along)[1]);
                let leaves = enters.and_then(|from| {
                    let step = (far - near) * 1e-3;
                    follow(from + step, far, &|along| distances(eye + ray * along)[1])
                });
                let normal = |along: f32, which: usize| {
                    let (point, step) = (eye + ray * along, (far - near) * 1e-3);
                    let slope =
                        |axis: Vec3| distances(point + axis * step)[which] - distances(point - axis * step)[which];
                    Vec3::new(slope(Vec3::X), slope(Vec3::Y), slope(Vec3::Z)).normalize_or_zero()
                };
                let of = |along: f32, which, colour: Vec3| Seen {
                    depth: along / length,
                    colour: colour * shaded(normal(along, which)),
                };
                match (obstacle, leaves) {
                    (Some(along), leaves) if leaves.is_none_or(|wall| along < wall) => of(along, 0, stone * 1.2),
                    (_, Some(along)) => of(along, 1, wall * 1.15),
                    _ => NOTHING,
                }
            }
        })
        .collect()
}

/// Returns how far along a line of sight the distance first comes to 0.
fn follow(near: f32, far: f32, distance: &dyn Fn(f32) -> f32) -> Option<f32> {
    let mut along = near;
    let close = (far - near) * 2e-4;
    for _ in 0..MOST_TRACED {
        let here = distance(along);
        if here < close {
            return Some(along);
        }
        along += here;
        if along > far {
            return None;
        }
    }
    None
}
