//! Pictures of a run: which states are drawn, and how a scene looks.
use crate::failure::Failure;
use crate::fluid::Snapshot;
use crate::paint::{Frame, View, paint};
use crate::scenes::{Camera, Named, Shade};
use glam::Vec3;
use millpond_core::scene::{Dimension, Scene};
use std::path::{Path, PathBuf};

/// Size of a picture, pixels.
const SIZE: [u32; 2] = [960, 540];

/// Drawn radius over spacing: spheres that just overlap show a surface and not its grains.
const RADIUS: f32 = 0.55;

/// A row of pictures, evenly over a run.
#[derive(Debug)]
pub struct Film<'a> {
    scene: Option<(&'a Named, PathBuf)>,
    steps: std::collections::VecDeque<u64>,
    pictures: Vec<PathBuf>,
}

impl<'a> Film<'a> {
    /// No pictures.
    #[must_use]
    pub fn none() -> Film<'a> {
        Film { scene: None, steps: std::collections::VecDeque::new(), pictures: Vec::new() }
    }

    /// `count` pictures in `folder`, but no more than there are states: the last of them after the last of `steps` steps,
    /// the first, where there is more than one, of the start.
    #[must_use]
    pub fn new(named: &'a Named, folder: &Path, count: u64, steps: u64) -> Film<'a> {
        let count = count.min(steps.saturating_add(1));
        let parts = u128::from(count.saturating_sub(1).max(1));
        let before_end = |i: u64| (u128::from(steps) * u128::from(i) / parts) as u64;
        let at: Vec<u64> = (0..count).rev().map(|i| steps - before_end(i)).collect();
        Film { scene: Some((named, folder.to_owned())), steps: at.into(), pictures: Vec::new() }
    }

    /// The step whose state is to be drawn next.
    #[must_use]
    pub fn next_step(&self) -> Option<u64> {
        self.steps.front().copied()
    }

    /// Draws the state after `step` steps, if it is one of the film's.
    ///
    /// # Errors
    /// The picture cannot be written.
    pub fn shoot(&mut self, step: u64, state: &Snapshot) -> Result<(), Failure> {
        let Some((named, folder)) = &self.scene else { return Ok(()) };
        if self.next_step() != Some(step) {
            return Ok(());
        }
        self.steps.pop_front();
        let path = folder.join(format!("{}-{:04}.png", named.name, self.pictures.len()));
        draw(named, step, state, &path)?;
        self.pictures.push(path);
        Ok(())
    }

    /// The pictures drawn.
    #[must_use]
    pub fn finish(self) -> Vec<PathBuf> {
        self.pictures
    }
}

/// Draws one state.
fn draw(named: &Named, step: u64, state: &Snapshot, path: &Path) -> Result<(), Failure> {
    let scene = &named.file.scene;
    let bounds = bounds(scene, state);
    let speed = |v: &[f32; 4]| Vec3::new(v[0], v[1], v[2]).length();
    let (shade, range, legend): (Vec<f32>, _, _) = match named.file.shade {
        Shade::Speed(low, high) => (state.velocity.iter().map(speed).collect(), [low, high], "speed, m/s"),
        Shade::Density(low, high) => {
            let rest = scene.fluid.rest_density;
            (state.density_pressure.iter().map(|d| (d[0] + 1.0) * rest).collect(), [low, high], "density, kg/m3")
        }
    };
    let time = step as f64 * f64::from(scene.time_step);
    let caption = format!("{}   t = {time:.2} s   {} particles", named.name, state.position.len());
    let frame = Frame {
        positions: &state.position,
        shade: &shade,
        range,
        radius: RADIUS * scene.particle_spacing,
        container: scene.container.as_ref().map(|_| bounds),
        caption: &caption,
        legend,
    };
    let view = match named.file.camera {
        Camera::Flat => View::Flat,
        Camera::Orbit { yaw_degrees, pitch_degrees } => View::Orbit { yaw_degrees, pitch_degrees },
    };
    paint(&frame, &view, bounds, SIZE[0], SIZE[1]).write_png(path).map_err(Failure::file(path))
}

/// The box that a picture frames: the container, or a little more than the blocks at the start.
fn bounds(scene: &Scene, state: &Snapshot) -> [Vec3; 2] {
    let flat = |v: [f32; 3]| if scene.dimension == Dimension::Two { Vec3::new(v[0], v[1], 0.0) } else { Vec3::from(v) };
    if let Some(container) = &scene.container {
        return [flat(container.low), flat(container.high)];
    }
    let corners = scene.blocks.iter().map(|b| (Vec3::from(b.corner), Vec3::from(b.corner) + Vec3::from(b.size)));
    let joined = corners.reduce(|(low, high), (a, b)| (low.min(a), high.max(b)));
    let (low, high) = joined.unwrap_or_else(|| {
        let at = state.position.first().map_or(Vec3::ZERO, |x| Vec3::new(x[0], x[1], x[2]));
        (at - 1.0, at + 1.0)
    });
    let margin = (high - low) * 0.25;
    [low - margin, high + margin]
}
