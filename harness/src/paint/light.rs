//! The lighting: from samples to the colours of pixels.
//!
//! A sphere is lit from above, which shows the particle. What shows the wave is the relief: the depths on a ring
//! around a sample say which way the water's surface leans there and whether something nearer shades it.

use super::SUPERSAMPLING;
use super::camera::Camera;
use super::canvas::Canvas;
use super::colour::{Encoder, from_srgb};
use super::discs::{Disc, Layer, Sample};
use super::floor::Floor;
use glam::{Vec2, Vec3};
use rayon::prelude::*;

/// Where the light comes from: right, up and towards the eye.
const SUN: Vec3 = Vec3::new(-0.45, 0.70, 0.555);

/// Radius of the ring that the relief is read from, in radii of the particle.
const RING: f32 = 3.5;

/// Directions of the ring.
const AROUND: [Vec2; 8] = {
    const D: f32 = std::f32::consts::FRAC_1_SQRT_2;
    [
        Vec2::new(1.0, 0.0),
        Vec2::new(D, D),
        Vec2::new(0.0, 1.0),
        Vec2::new(-D, D),
        Vec2::new(-1.0, 0.0),
        Vec2::new(-D, -D),
        Vec2::new(0.0, -1.0),
        Vec2::new(D, -D),
    ]
};

/// Lights the samples of `layer` and averages them into the pixels of a picture.
pub(super) fn expose(layer: &Layer, discs: &[Disc], camera: &Camera, floor: Option<&Floor>) -> Canvas {
    let side = SUPERSAMPLING as usize;
    let (width, height) = (layer.width() / side, layer.height() / side);
    let mut bytes = vec![0; width * height * 3];
    let (encoder, studio) = (Encoder::new(), Studio::new(layer, discs, camera, floor));
    bytes.par_chunks_mut(width * 3).enumerate().for_each(|(y, row)| {
        for (x, pixel) in row.chunks_exact_mut(3).enumerate() {
            let samples = (0..side * side).map(|i| studio.light(x * side + i % side, y * side + i / side));
            let mean = samples.sum::<Vec3>() / (side * side) as f32;
            pixel.copy_from_slice(&encoder.bytes(mean));
        }
    });
    Canvas::new(width as u32, height as u32, bytes)
}

/// All that the colour of a sample depends on.
struct Studio<'a> {
    layer: &'a Layer,
    discs: &'a [Disc],
    camera: &'a Camera,
    floor: Option<&'a Floor>,
    sky: [Vec3; 2],
    ground: [Vec3; 2],
    edge: [Vec3; 2],
}

impl<'a> Studio<'a> {
    fn new(layer: &'a Layer, discs: &'a [Disc], camera: &'a Camera, floor: Option<&'a Floor>) -> Self {
        Self {
            layer,
            discs,
            camera,
            floor,
            sky: [0xfa_fcfd, 0xe9_eff4].map(from_srgb),
            ground: [0xdf_e6ec, 0x86_9db0].map(from_srgb),
            edge: [0x4d_5b68, 0xa3_b0bc].map(from_srgb),
        }
    }

    /// Colour of one sample.
    fn light(&self, x: usize, y: usize) -> Vec3 {
        let sample = self.layer.sample(x as isize, y as isize);
        let at = Vec2::new(x as f32, y as f32) + 0.5;
        match (sample.disc, self.discs.get(sample.disc as usize)) {
            (_, Some(disc)) => self.water(disc, at),
            (Sample::EDGE, None) => self.edge[0].lerp(self.edge[1], self.camera.recession(sample.depth)),
            _ => self.behind(at),
        }
    }

    /// Colour where no particle is: the floor, or a sky that is lighter above.
    fn behind(&self, at: Vec2) -> Vec3 {
        match self.floor.and_then(|floor| floor.shadow(self.camera, at)) {
            Some(shadow) => self.ground[0].lerp(self.ground[1], shadow),
            None => self.sky[0].lerp(self.sky[1], at.y / self.layer.height() as f32),
        }
    }

    /// Colour of a particle.
    fn water(&self, disc: &Disc, at: Vec2) -> Vec3 {
        let (lean, shade) = self.relief(disc, at);
        let bead = disc.normal(at);
        let normal = (bead * 0.55 + lean).normalize_or_zero();
        let lambert = normal.dot(SUN).max(0.0);
        let sky = 0.5 + 0.5 * normal.y;
        let rim = 1.0 - bead.z;
        let strength = (0.34 + 0.22 * sky + 0.62 * lambert) * (1.0 - 0.35 * rim * rim) * (1.0 - 0.55 * shade);
        let shine = 0.22 * normal.dot((SUN + Vec3::Z).normalize_or_zero()).max(0.0).powi(24);
        let lit = disc.colour * strength + shine * (1.0 - shade);
        lit.lerp(self.sky[1], 0.22 * self.camera.recession(disc.depth))
    }

    /// Which way the water's surface leans around a sample, and how much of its light is taken by nearer water.
    fn relief(&self, disc: &Disc, at: Vec2) -> (Vec3, f32) {
        let reach = (RING * disc.radius).max(3.0);
        let metres = reach / self.camera.scale_at(disc.depth);
        let surface = disc.depth - 0.7 * disc.bulge; // of a sphere as a whole, so that its own roundness leaves no mark
        let (mut lean, mut shade) = (Vec2::ZERO, 0.0);
        for direction in AROUND {
            let there = at + direction * reach;
            let sample = self.layer.sample(there.x as isize, there.y as isize);
            let fall = if sample.disc == Sample::EDGE { 0.0 } else { (sample.depth - surface) / metres };
            lean += direction * fall.clamp(-1.0, 1.0);
            shade += (-fall).clamp(0.0, 1.5);
        }
        (Vec3::new(lean.x, -lean.y, 4.0).normalize_or_zero(), shade / 12.0)
    }
}
