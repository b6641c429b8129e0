//! The lighting: computes the colours of pixels from samples.
//!
//! A sphere is lit from above, which makes the single particle visible. The relief makes the shape of the water
//! visible: the depths on rings around a particle give the slope of the water surface there and whether nearer water
//! shades it.

use super::SUPERSAMPLING;
use super::camera::Camera;
use super::canvas::Canvas;
use super::colour::{Encoder, from_srgb};
use super::discs::{Disc, Layer, Sample};
use super::solids::Seen;
use super::tank::Floor;
use glam::{Vec2, Vec3};
use rayon::prelude::*;

/// Direction towards the light: right, up and towards the eye.
const SUN: Vec3 = Vec3::new(-0.45, 0.70, 0.555);

/// Radii of the rings on which the relief is sampled, in particle radii.
const RINGS: [f32; 2] = [2.6, 4.4];

/// Directions to the samples on a ring.
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

/// Computes the colours of the samples of `layer` and averages them into pixels.
pub(super) fn expose(
    layer: &Layer,
    discs: &[Disc],
    camera: &Camera,
    floor: Option<&Floor>,
    solids: Option<&[Seen]>,
) -> Canvas {
    let side = SUPERSAMPLING as usize;
    let (width, height) = (layer.width() / side, layer.height() / side);
    let mut bytes = vec![0; width * height * 3];
    let (encoder, studio) = (Encoder::new(), Studio { solids, ..Studio::new(layer, discs, camera, floor) });
    bytes.par_chunks_mut(width * 3).enumerate().for_each(|(y, row)| {
        for (x, pixel) in row.chunks_exact_mut(3).enumerate() {
            let samples = (0..side * side).map(|i| studio.light(x * side + i % side, y * side + i / side));
            let mean = samples.sum::<Vec3>() / (side * side) as f32;
            pixel.copy_from_slice(&encoder.bytes(mean));
        }
    });
    Canvas::new(width as u32, height as u32, bytes)
}

/// Everything that the colour of a sample depends on.
struct Studio<'a> {
    layer: &'a Layer,
    discs: &'a [Disc],
    reliefs: Vec<Relief>,
    camera: &'a Camera,
    floor: Option<&'a Floor>,
    /// What each sample shows of the solids.
    solids: Option<&'a [Seen]>,
    sky: [Vec3; 2],
    ground: [Vec3; 2],
    edge: [Vec3; 2],
    haze: Vec3,
    gleam: Vec3,
}

impl<'a> Studio<'a> {
    fn new(layer: &'a Layer, discs: &'a [Disc], camera: &'a Camera, floor: Option<&'a Floor>) -> Self {
        Self {
            layer,
            discs,
            reliefs: discs.par_iter().map(|disc| Relief::new(layer, disc, camera)).collect(),
            camera,
            floor,
            solids: None,
            sky: [0xfa_fcfd, 0xe9_eff4].map(from_srgb),
            ground: [0xdf_e6ec, 0x86_9db0].map(from_srgb),
            edge: [0x5b_6975, 0xae_bac5].map(from_srgb),
            haze: from_srgb(0x8a_c6f0),
            gleam: from_srgb(0xa8_e4ff),
        }
    }

    /// Returns the colour of one sample.
    fn light(&self, x: usize, y: usize) -> Vec3 {
        let sample = self.layer.sample(x as isize, y as isize);
        let at = Vec2::new(x as f32, y as f32) + 0.5;
        let solid = self.solids.and_then(|solids| solids.get(y * self.layer.width() + x));
        if let Some(solid) = solid.filter(|solid| solid.depth < sample.depth) {
            return solid.colour;
        }
        let seen = sample.disc as usize;
        match (sample.disc, self.discs.get(seen).zip(self.reliefs.get(seen))) {
            (_, Some((disc, relief))) => self.water(disc, relief, at),
            (Sample::EDGE, None) => self.edge[0].lerp(self.edge[1], self.camera.recession(sample.depth)),
            _ => self.behind(at),
        }
    }

    /// Returns the colour of the background: the floor, or a sky that is lighter at the top.
    fn behind(&self, at: Vec2) -> Vec3 {
        match self.floor.and_then(|floor| floor.shadow(self.camera, at)) {
            Some(shadow) => self.ground[0].lerp(self.ground[1], shadow),
            None => self.sky[0].lerp(self.sky[1], at.y / self.layer.height() as f32),
        }
    }

    /// Returns the colour of a particle at a sample.
    fn water(&self, disc: &Disc, relief: &Relief, at: Vec2) -> Vec3 {
        let bead = disc.normal(at);
        let normal = (bead * 0.55 + relief.lean).normalize_or_zero();
        let lambert = normal.dot(SUN).max(0.0);
        let sky = 0.5 + 0.5 * normal.y;
        let rim = 1.0 - bead.z;
        let open = 1.0 - relief.shade;
        let strength = (0.30 + 0.26 * sky + 0.74 * lambert) * (1.0 - 0.35 * rim * rim) * (0.4 + 0.6 * open);
        let shine = 0.20 * normal.dot((SUN + Vec3::Z).normalize_or_zero()).max(0.0).powi(24) * open;
        (disc.colour * strength + self.gleam * shine).lerp(self.haze, 0.16 * self.camera.recession(disc.depth))
    }
}

/// The shape of the water surface around a particle.
///
/// It is computed once per particle and not once per sample, since a sphere that is partly in shadow would look like
/// two.
struct Relief {
    /// Normal of the water surface: right, up and towards the eye.
    lean: Vec3,
    /// Share of the light that nearer water blocks, 0 to 1.
    shade: f32,
}

impl Relief {
    /// Samples the depths on the rings around a particle. Background counts as a steep fall, which rounds the water
    /// towards its outline; an edge of the container counts as level.
    fn new(layer: &Layer, disc: &Disc, camera: &Camera) -> Self {
        let surface = disc.depth - 0.7 * disc.bulge; // mean over the disc, comparable with the ring samples
        let (mut lean, mut shade) = (Vec2::ZERO, 0.0);
        for (direction, radii) in RINGS.into_iter().flat_map(|radii| AROUND.map(|direction| (direction, radii))) {
            let reach = (radii * disc.radius).max(2.0);
            let place = disc.at + direction * reach;
            let sample = layer.sample(place.x as isize, place.y as isize);
            let metres = reach / camera.scale_at(disc.depth);
            let fall = if sample.disc == Sample::EDGE { 0.0 } else { (sample.depth - surface) / metres };
            lean += direction * fall.clamp(-1.0, 1.0);
            shade += (-fall).clamp(0.0, 1.5);
        }
        let count = (RINGS.len() * AROUND.len()) as f32;
        Self { lean: Vec3::new(lean.x, -lean.y, count * 0.5).normalize_or_zero(), shade: shade / (1.5 * count) }
    }
}
