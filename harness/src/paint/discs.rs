//! The rasteriser: finds the nearest sphere at every sample.
//!
//! A sphere is drawn as a disc, with the depth of the sphere's surface at each sample, so that two overlapping spheres
//! intersect in a clean line.

use super::Frame;
use super::camera::Camera;
use super::colour::wall;
use glam::{Vec2, Vec3};
use rayon::prelude::*;

/// Smallest radius of a disc, samples. Smaller discs would miss all samples at times and flicker.
const LEAST_RADIUS: f32 = 1.2;

/// Number of rows per parallel task.
const BAND: usize = 32;

/// A projected particle.
pub(super) struct Disc {
    /// Centre of the disc, samples.
    pub at: Vec2,
    /// Radius of the disc, samples.
    pub radius: f32,
    /// Depth of the sphere's centre, metres.
    pub depth: f32,
    /// Radius of the sphere, metres.
    pub bulge: f32,
    /// Colour without lighting.
    pub colour: Vec3,
}

impl Disc {
    /// Projects the visible particles of `frame`, wall particles included, and sorts them, nearest first.
    ///
    /// In this order most samples of a hidden sphere are rejected by one comparison.
    pub(super) fn project(frame: &Frame, camera: &Camera) -> Vec<Self> {
        let bulge = if frame.radius.is_finite() { frame.radius.max(0.0) } else { 0.0 };
        let disc = |(&[x, y, z, _], colour): (&[f32; 4], Vec3)| {
            let spot = camera.spot(Vec3::new(x, y, z))?;
            let radius = (bulge * spot.scale).max(LEAST_RADIUS);
            Some(Self { at: spot.at, radius, depth: spot.depth, bulge, colour })
        };
        let coloured = frame.positions.iter().zip(frame.colouring.lights(frame.positions.len()));
        let all = coloured.chain(frame.walls.iter().zip(std::iter::repeat(wall())));
        let mut discs: Vec<_> = all.take(Sample::EDGE as usize).filter_map(disc).collect();
        discs.sort_by(|a, b| a.depth.total_cmp(&b.depth)); // stable: particles of equal depth keep their order
        discs
    }

    /// Returns the surface normal of the sphere at a sample: right, up and towards the eye.
    pub(super) fn normal(&self, at: Vec2) -> Vec3 {
        let offset = (at - self.at) / self.radius;
        Vec3::new(offset.x, -offset.y, (1.0 - offset.length_squared()).max(0.0).sqrt())
    }
}

/// The contents of one sample.
#[derive(Clone, Copy)]
pub(super) struct Sample {
    /// Depth of the surface, metres; infinite if there is no surface.
    pub depth: f32,
    /// Index of the disc, [`Sample::EDGE`] or [`Sample::NOTHING`].
    pub disc: u32,
}

impl Sample {
    /// The sample shows an edge of the container.
    pub(super) const EDGE: u32 = u32::MAX - 1;
    /// The sample shows the background.
    pub(super) const NOTHING: u32 = u32::MAX;
}

/// The samples of a picture, row by row from the top.
pub(super) struct Layer {
    width: usize,
    height: usize,
    samples: Vec<Sample>,
}

impl Layer {
    /// Returns a layer without any surface.
    pub(super) fn new(width: usize, height: usize) -> Self {
        Self { width, height, samples: vec![Sample { depth: f32::INFINITY, disc: Sample::NOTHING }; width * height] }
    }

    /// Width, samples.
    pub(super) fn width(&self) -> usize {
        self.width
    }

    /// Height, samples.
    pub(super) fn height(&self) -> usize {
        self.height
    }

    /// Returns the sample at a position, which is clamped to the picture.
    pub(super) fn sample(&self, x: isize, y: isize) -> Sample {
        let (x, y) = (x.clamp(0, self.width as isize - 1), y.clamp(0, self.height as isize - 1));
        self.samples[y as usize * self.width + x as usize]
    }

    /// Draws spheres. Of several spheres that cover a sample the nearest is kept, and of equally near ones the first.
    pub(super) fn draw_discs(&mut self, discs: &[Disc]) {
        let width = self.width;
        self.samples.par_chunks_mut(BAND * width).enumerate().for_each(|(band, samples)| {
            let top = (band * BAND) as f32;
            let bottom = top + (samples.len() / width) as f32;
            for (disc, index) in discs.iter().zip(0..) {
                if disc.at.y + disc.radius > top && disc.at.y - disc.radius < bottom {
                    draw_disc(samples, width, top, disc, index);
                }
            }
        });
    }

    /// Draws one dot of an edge, a small flat square around `at`, wherever nothing is nearer.
    pub(super) fn draw_dot(&mut self, at: Vec2, half: f32, depth: f32) {
        // A horizontal edge may lie just between two rows, where rounding errors would turn it into a dotted line.
        let steady = (at * 64.0).round() / 64.0;
        let [columns, rows] = [(steady.x, self.width), (steady.y, self.height)].map(|(at, n)| covered(at, half, n));
        for row in rows {
            for sample in &mut self.samples[row * self.width..][columns.clone()] {
                if depth < sample.depth {
                    *sample = Sample { depth, disc: Sample::EDGE };
                }
            }
        }
    }
}

/// Draws one sphere into a band of rows, the first of which is row `top` of the picture.
fn draw_disc(samples: &mut [Sample], width: usize, top: f32, disc: &Disc, index: u32) {
    let front = disc.depth - disc.bulge;
    let steepness = disc.radius.recip();
    for row in covered(disc.at.y - top, disc.radius, samples.len() / width) {
        let dy = (row as f32 + 0.5 + top - disc.at.y) * steepness;
        let left = (1.0 - dy * dy).max(0.0);
        let columns = covered(disc.at.x, disc.radius * left.sqrt(), width);
        let first = columns.start as f32 + 0.5 - disc.at.x;
        for (sample, step) in samples[row * width..][columns].iter_mut().zip(0u16..) {
            if front < sample.depth {
                let dx = (first + f32::from(step)) * steepness;
                let depth = disc.depth - disc.bulge * (left - dx * dx).max(0.0).sqrt();
                if depth < sample.depth {
                    *sample = Sample { depth, disc: index };
                }
            }
        }
    }
}

/// Returns the samples of a row or column of `size` samples whose centres lie within `reach` of `at`.
fn covered(at: f32, reach: f32, size: usize) -> std::ops::Range<usize> {
    let end = ((at + reach + 0.5).max(0.0) as usize).min(size); // casts saturate, so far positions are safe
    let start = ((at - reach + 0.5).max(0.0) as usize).min(end);
    start..end
}
