//! Positions of wall particles: layers that continue the lattice of the fluid beyond its boundary.
use super::lattice::{indices, volume, whole};
use crate::derive::material::FIRST_WALL;
use crate::derive::scales::Scales;
use crate::scene::{Face, InitialParticle, Scene, Wall, WallPressure, WallShape};
use glam::Vec3;

/// Layers of particles in a wall: two with a mirrored pressure (Hinsch 2024, section 6.3) or an
/// extrapolated one, three as dynamic boundary
/// particles (Pirovano, section 3.5.3); more if the support radius reaches further.
pub(crate) fn wall_layers(scene: &Scene, scales: &Scales) -> u32 {
    let least = match scene.model.wall_pressure {
        WallPressure::Mirrored
        | WallPressure::Extrapolated
        | WallPressure::LennardJones
        | WallPressure::KernelForce => 2,
        WallPressure::Dynamic => 3,
    };
    let largest = scene.model.variable_support.map_or(1.0, |range| f64::from(range.largest));
    let reach = scales.support_radius * largest / f64::from(scene.particle_spacing);
    least.max((reach.min(64.0) + 0.5) as u32)
}

/// A wall as a box of lattice positions: its low corner and its counts.
struct Layers {
    low: [f64; 3],
    counts: [u64; 3],
    /// The hollow part of the box: offset and counts along each axis.
    hollow: Option<([u64; 3], [u64; 3])>,
}

/// The box of a wall with this number of layers.
fn layers_of(wall: &Wall, scene: &Scene, layers: u32) -> Layers {
    let d = scene.dimension.count();
    let spacing = f64::from(scene.particle_spacing);
    let layers = u64::from(layers);
    let count = |low: &Vec3, high: &Vec3, axis: usize| {
        if axis < d { whole(high[axis] - low[axis], scene) } else { 1 }
    };
    match &wall.shape {
        WallShape::Plane { face, low, high } => {
            let mut corner = low.to_array().map(f64::from);
            let mut counts = [0, 1, 2].map(|axis| count(low, high, axis));
            counts[face.axis()] = layers;
            if !face.is_high() {
                corner[face.axis()] -= layers as f64 * spacing;
            }
            Layers { low: corner, counts, hollow: None }
        }
        WallShape::Box { low, high, open } => {
            let inside = [0, 1, 2].map(|axis| count(low, high, axis));
            let mut corner = low.to_array().map(f64::from);
            let (mut offset, mut counts) = ([0; 3], inside);
            for face in Face::ALL.iter().filter(|face| face.axis() < d) {
                let axis = face.axis();
                let round = scene.periodic.is_some_and(|periodic| periodic.axes[axis]);
                if !open.contains(face) && !round {
                    counts[axis] = counts[axis].saturating_add(layers);
                    if !face.is_high() {
                        corner[axis] -= layers as f64 * spacing;
                        offset[axis] = layers;
                    }
                }
            }
            Layers { low: corner, counts, hollow: Some((offset, inside)) }
        }
    }
}

impl Layers {
    fn particles(&self) -> u64 {
        volume(self.counts).saturating_sub(self.hollow.map_or(0, |(_, counts)| volume(counts)))
    }
}

/// Number of particles of a wall.
pub(crate) fn wall_count(wall: &Wall, scene: &Scene, layers: u32) -> u64 {
    layers_of(wall, scene, layers).particles()
}

/// All wall particles.
pub(crate) fn wall_particles(scene: &Scene, layers: u32) -> impl Iterator<Item = InitialParticle> {
    let spacing = f64::from(scene.particle_spacing);
    scene.walls.iter().enumerate().flat_map(move |(i, wall)| {
        let Layers { low, counts, hollow } = layers_of(wall, scene, layers);
        let is_hollow = move |index: &[u64; 3]| {
            hollow
                .is_some_and(|(offset, inside)| (0..3).all(|a| (offset[a]..offset[a] + inside[a]).contains(&index[a])))
        };
        indices(counts).filter(move |index| !is_hollow(index)).map(move |index| {
            let mut position = [0.0; 3];
            for axis in 0..scene.dimension.count() {
                position[axis] = (low[axis] + (index[axis] as f64 + 0.5) * spacing) as f32;
            }
            InitialParticle::of_fluid(FIRST_WALL + i as u32, position, wall.velocity)
        })
    })
}
