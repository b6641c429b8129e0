//! Pictures of a run: selection of the states to draw, and conversion of a state to a picture.
use crate::failure::Failure;
use crate::paint::{Colouring, Frame, Swatch, View, paint};
use crate::run_length::RunLength;
use crate::scene_file::{Camera, SceneFile, Shade};
use crate::scenes::LoadedScene;
use crate::snapshot::Snapshot;
use glam::Vec3;
use millpond_core::backend::derive::{Material, material_of, solid_reach};
use millpond_core::backend::layout::{Model, Parameters, f32x4};
use millpond_core::backend::solids::distance_from;
use millpond_core::scene::{Dimension, Fluid, Scene, Solid, WallShape};
use millpond_core::{Array, Plan};
use std::path::{Path, PathBuf};

/// Size of a picture, pixels.
const SIZE: [u32; 2] = [960, 540];

/// Drawn radius of a particle over the particle spacing. Spheres that just overlap look like a surface instead of
/// grains.
const RADIUS: f32 = 0.55;

/// Draws pictures at equal intervals of a run.
#[derive(Debug)]
pub struct FrameRecorder<'a> {
    scene: Option<(&'a LoadedScene, PathBuf)>,
    span: RunLength,
    /// Number of pictures, and index of the next one.
    count: u64,
    next: u64,
    pictures: Vec<PathBuf>,
}

impl<'a> FrameRecorder<'a> {
    /// Returns a recorder that draws nothing.
    #[must_use]
    pub fn none() -> FrameRecorder<'a> {
        FrameRecorder { scene: None, span: RunLength::Steps(0), count: 0, next: 0, pictures: Vec::new() }
    }

    /// Returns a recorder of `count` pictures in `folder`, or fewer if the run has fewer states. The last picture shows
    /// the end of the run; if there are several, the first one shows the start.
    #[must_use]
    pub fn new(named: &'a LoadedScene, folder: &Path, count: u64, span: RunLength) -> FrameRecorder<'a> {
        let count = match span {
            RunLength::Steps(steps) => count.min(steps.saturating_add(1)),
            // if several pictures are due in one step, one is drawn
            RunLength::Seconds(_) => count,
        };
        FrameRecorder { scene: Some((named, folder.to_owned())), span, count, next: 0, pictures: Vec::new() }
    }

    /// Returns when the next picture is due, in steps or seconds as in the run length; `None` after the last one.
    #[must_use]
    pub fn next(&self) -> Option<f64> {
        if self.next >= self.count {
            return None;
        }
        let (left, parts) = (self.count - 1 - self.next, self.count.saturating_sub(1).max(1));
        Some(match self.span {
            RunLength::Steps(steps) => {
                (steps - (u128::from(steps) * u128::from(left) / u128::from(parts)) as u64) as f64
            }
            RunLength::Seconds(seconds) => seconds * (1.0 - left as f64 / parts as f64),
        })
    }

    /// Draws the state after `passed` steps or seconds of the run, at the simulated time `time` (s), if a picture is
    /// due.
    ///
    /// # Errors
    /// A picture that cannot be written.
    pub fn capture(&mut self, passed: f64, time: f64, state: &Snapshot) -> Result<(), Failure> {
        let Some((named, folder)) = &self.scene else { return Ok(()) };
        if self.next().is_none_or(|due| passed < due) {
            return Ok(());
        }
        let path = folder.join(format!("{}-{:04}.png", named.name, self.pictures.len()));
        draw(named, time, state, &path)?;
        self.pictures.push(path);
        // skip pictures that were due before this state
        self.next += match self.span {
            RunLength::Steps(_) => 1,
            RunLength::Seconds(seconds) => {
                let parts = self.count.saturating_sub(1).max(1) as f64;
                ((passed / seconds * parts) as u64).saturating_sub(self.next).saturating_add(1)
            }
        };
        Ok(())
    }

    /// Returns the paths of the pictures.
    #[must_use]
    pub fn finish(self) -> Vec<PathBuf> {
        self.pictures
    }
}

/// Draws one state to a file.
fn draw(named: &LoadedScene, time: f64, state: &Snapshot, path: &Path) -> Result<(), Failure> {
    let scene = &named.file.scene;
    let bounds = bounds(scene, state);
    let cast = FrameContent::of(&named.file, state);
    let positions: Vec<f32x4> = cast.beads.iter().map(|bead| bead.position).collect();
    let caption = format!("{}   t = {time:.2} s   {} particles", named.name, cast.present);
    let distances = Distances::of(named, state);
    let distances = |point: Vec3| distances.from(point);
    let frame = Frame {
        positions: &positions,
        colouring: &colouring(&named.file, &cast.beads),
        walls: &cast.walls,
        radius: RADIUS * scene.particle_spacing,
        container: scene.container.as_ref().map(|_| bounds),
        solids: (!scene.solids.is_empty()).then_some(&distances),
        caption: &caption,
    };
    let view = match named.file.camera {
        Camera::Flat => View::Flat,
        Camera::Orbit { yaw_degrees, pitch_degrees } => View::Orbit { yaw_degrees, pitch_degrees },
    };
    paint(&frame, &view, bounds, SIZE[0], SIZE[1]).write_png(path).map_err(Failure::unwritten(path))
}

/// A fluid particle as it is drawn.
#[derive(Clone, Copy, Debug)]
struct DrawParticle {
    position: f32x4,
    /// Speed, m/s.
    speed: f32,
    /// Density, kg/m3.
    density: f32,
    /// Index of the fluid.
    fluid: u32,
}

/// The particles of a picture.
#[derive(Debug, Default)]
struct FrameContent {
    /// Fluid particles.
    beads: Vec<DrawParticle>,
    /// Positions of the wall particles that are drawn.
    walls: Vec<f32x4>,
    /// Number of particles without inactive air, drawn or not.
    present: usize,
}

impl FrameContent {
    fn of(file: &SceneFile, state: &Snapshot) -> FrameContent {
        let scene = &file.scene;
        let mut cast = FrameContent::default();
        for ((x, v), d) in state.position().iter().zip(state.velocity()).zip(state.density_pressure()) {
            let [vx, vy, vz, material] = *v;
            match material_of(material as u32, scene) {
                Some(Material::Fluid(fluid)) => cast.beads.push(DrawParticle {
                    position: *x,
                    speed: Vec3::new(vx, vy, vz).length(),
                    density: (d[0] + 1.0) * scene.fluid_of(fluid).rest_density,
                    fluid,
                }),
                Some(Material::Wall(wall)) if is_in_sight(file, wall, x[1]) => cast.walls.push(*x),
                Some(Material::Wall(_) | Material::Solid(_)) => {}
                Some(Material::Inactive) | None => continue,
            }
            cast.present += 1;
        }
        cast
    }
}

/// Returns whether a wall particle at height `y` is drawn. In 2D all of them are, since they cover nothing. In 3D only
/// those below the inside of their wall are drawn, as of a floor, and only if the camera does not look from below.
fn is_in_sight(file: &SceneFile, wall: u32, y: f32) -> bool {
    let from_below = matches!(file.camera, Camera::Orbit { pitch_degrees, .. } if pitch_degrees < 0.0);
    let is_floor = file.scene.walls.get(wall as usize).is_some_and(|wall| {
        let (WallShape::Plane { low, .. } | WallShape::Box { low, .. }) = &wall.shape;
        y < low[1]
    });
    file.scene.dimension == Dimension::Two || (is_floor && !from_below)
}

/// The solids of a state.
struct Distances<'a> {
    scene: &'a Scene,
    constants: Option<(Model, Parameters)>,
    poses: &'a [f32x4],
}

impl<'a> Distances<'a> {
    fn of(named: &'a LoadedScene, state: &'a Snapshot) -> Self {
        let scene = &named.file.scene;
        let has_solids = !scene.solids.is_empty();
        let checked = has_solids.then(|| scene.check().ok()).flatten();
        let constants = checked.map(|checked| (Plan::of(&checked).model, checked.derived().parameters));
        Distances { scene, constants, poses: state.vectors(Array::pose) }
    }

    /// Returns the distances from the nearest obstacle and from the nearest wall around the fluid, m.
    fn from(&self, point: Vec3) -> [f32; 2] {
        let Some((model, parameters)) = &self.constants else { return [f32::MAX; 2] };
        let mut nearest = [f32::MAX; 2];
        for (number, solid) in self.scene.solids.iter().enumerate() {
            let distance = distance_from(model, parameters, self.poses, number, point).unwrap_or(f32::MAX);
            let which = usize::from(solid.hollow);
            nearest[which] = nearest[which].min(distance);
        }
        nearest
    }
}

/// Returns the colours of the particles.
fn colouring(file: &SceneFile, beads: &[DrawParticle]) -> Colouring {
    let numbers = |of: fn(&DrawParticle) -> f32, range, label| Colouring::Numbers {
        of: beads.iter().map(of).collect(),
        range,
        label,
    };
    match file.shade {
        Shade::Speed(low, high) => numbers(|bead| bead.speed, [low, high], "speed, m/s"),
        Shade::Density(low, high) => numbers(|bead| bead.density, [low, high], "density, kg/m3"),
        Shade::Fluid => {
            let swatch =
                |(number, fluid): (usize, &Fluid)| Swatch::new(format!("fluid {number}"), number, fluid.colour);
            Colouring::Kinds {
                of: beads.iter().map(|bead| bead.fluid).collect(),
                key: file.scene.fluids.iter().enumerate().map(swatch).collect(),
            }
        }
    }
}

/// Returns the box that the picture shows: the container, or else the blocks at the start with a margin, and the walls.
fn bounds(scene: &Scene, state: &Snapshot) -> [Vec3; 2] {
    let flat = |v: Vec3| if scene.dimension == Dimension::Two { v.with_z(0.0) } else { v };
    if let Some(container) = &scene.container {
        return [flat(container.low), flat(container.high)];
    }
    let joined =
        |boxes: &mut dyn Iterator<Item = (Vec3, Vec3)>| boxes.reduce(|(low, high), (a, b)| (low.min(a), high.max(b)));
    let mut blocks = scene.blocks.iter().map(|b| (b.corner, b.corner + b.size));
    let (low, high) = joined(&mut blocks).unwrap_or_else(|| {
        let at = state.position().first().map_or(Vec3::ZERO, |x| Vec3::new(x[0], x[1], x[2]));
        (at - 1.0, at + 1.0)
    });
    // the fluid needs room to move, and walls do not
    let margin = (high - low) * 0.25;
    let walls = scene.walls.iter().map(|w| {
        let (WallShape::Plane { low, high, .. } | WallShape::Box { low, high, .. }) = &w.shape;
        (flat(*low), flat(*high))
    });
    let reach = |s: &Solid| solid_reach(s, scene.dimension);
    let solids = scene.solids.iter().filter(|s| reach(s).is_finite());
    let solids = solids.map(|s| (flat(s.position - reach(s)), flat(s.position + reach(s))));
    let walls = walls.chain(solids);
    let emitters = scene.emitters.iter().map(|e| {
        let reach = 0.75 * e.opening.width();
        (flat(e.position - reach), flat(e.position + reach))
    });
    let walls = walls.chain(emitters);
    let room = [(low - margin, high + margin)];
    let (low, high) = joined(&mut room.into_iter().chain(walls)).unwrap_or(room[0]);
    [low, high]
}
