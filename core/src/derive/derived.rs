//! All quantities derived from a scene.
use super::counts::{Counts, field_counts, spring_ends, springs_of_particle};
use super::fluid::FluidConstants;
use super::frames::{Poses, poses_at_start};
use super::materials::materials;
use super::parameters::{parameters, step_uniform};
use super::scales::{Scales, average_neighbours, particle_mass};
use super::solids::pose_rows;
use super::step_limits::kinematic_viscosity;
use crate::layout::{Materials, Parameters, StepUniform};
use crate::scene::{FLUIDS, Scene};
use heapless::Vec;

/// Quantities derived from a scene, computed once when it is checked: [`Checked::derived`](crate::Checked::derived).
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Derived {
    /// Distance at which every kernel vanishes, m ([`support_radius`](super::support_radius)).
    pub support_radius: f64,
    /// Particles inside the support radius ([`average_neighbours`](super::average_neighbours)).
    pub average_neighbours: f32,
    /// Cells along x, y, z; in 2D there is one along z.
    pub cells: [u32; 3],
    /// Mass of a particle of the first fluid at rest, kg (per metre of depth in 2D).
    pub particle_mass: f64,
    /// Constants of the fluids, by index; at least one.
    pub fluids: Vec<FluidConstants, FLUIDS>,
    /// Largest kinematic viscosity, m2/s.
    pub kinematic_viscosity: f64,
    /// Number of fluid particles, whose ids come first.
    pub fluid_particles: usize,
    /// Number of particles of walls and of solids, whose ids come next.
    pub wall_particles: usize,
    /// Number of particles that are inactive at the start, whose ids come last: for the layer of air, and for emitters.
    pub inactive_particles: usize,
    /// Number of points of all emitters.
    pub emitter_points: usize,
    /// Number of rows of the poses of solids and of the sides of polygons.
    pub pose_rows: usize,
    /// The poses of solids at the start, and the sides of polygons.
    pub(crate) poses: Poses,
    /// Layers of particles in a wall: two with mirrored pressure (Hinsch 2024, section 6.3), three as dynamic boundary
    /// particles (Pirovano, section 3.5.3); more if the support radius reaches further.
    pub wall_layers: u32,
    /// Number of spring ends that there is room for, two per spring; 0 if no fluid is elastic and no capacity is set.
    pub spring_ends: usize,
    /// Number of springs at a particle inside an elastic lattice.
    pub springs_of_particle: usize,
    /// Nodes of the acceleration field supplied by the caller along x, y, z, and in total; 0 if there is no such field.
    pub field_counts: [u32; 4],
    /// The constants that every pass reads, rounded once.
    pub parameters: Parameters,
    /// The constants of each material.
    pub materials: Materials,
    /// The numbers of the first step.
    pub step: StepUniform,
}

impl Derived {
    /// Derives the quantities of a scene whose numbers and counts are within their bounds.
    pub(crate) fn of(scene: &Scene, scales: &Scales, counts: &Counts, cells: [u32; 3]) -> Derived {
        let particle_mass = particle_mass(scene, scales);
        let fluids = FluidConstants::of_all(scene, particle_mass);
        let kinematic_viscosity = kinematic_viscosity(scene, scales, &fluids);
        let parameters = parameters(scene, scales, (counts, cells), particle_mass, kinematic_viscosity);
        Derived {
            support_radius: scales.support_radius,
            average_neighbours: average_neighbours(scene),
            cells,
            particle_mass,
            poses: poses_at_start(scene, &parameters),
            parameters,
            materials: materials(scene, &fluids, particle_mass, scales.support_radius),
            step: step_uniform(scene),
            fluids,
            kinematic_viscosity,
            fluid_particles: counts.fluid as usize,
            wall_particles: (counts.walls + counts.solids) as usize,
            pose_rows: pose_rows(scene),
            inactive_particles: counts.inactive as usize,
            emitter_points: counts.emitter_points as usize,
            wall_layers: counts.wall_layers,
            spring_ends: spring_ends(scene, scales),
            springs_of_particle: springs_of_particle(scene, scales, 0.0),
            field_counts: field_counts(scene),
        }
    }

    /// Number of all particles: of fluids, of walls, and those that are inactive at the start.
    #[must_use]
    pub fn particles(&self) -> usize {
        self.fluid_particles + self.wall_particles + self.inactive_particles
    }

    /// Constants of a fluid by index; those of the first fluid if there is none with this index.
    #[must_use]
    pub fn fluid(&self, number: u32) -> &FluidConstants {
        self.fluids.get(number as usize).unwrap_or(&self.fluids[0])
    }
}
