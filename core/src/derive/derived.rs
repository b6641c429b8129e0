//! All that follows from a scene, in one place.
use super::counts::{Counts, field_counts, spring_ends, springs_of_particle};
use super::fluid::FluidConstants;
use super::materials::materials;
use super::parameters::{parameters, step_uniform};
use super::scales::{Scales, average_neighbours, particle_mass};
use super::step_limits::kinematic_viscosity;
use crate::layout::{Materials, Parameters, StepUniform};
use crate::scene::{FLUIDS, Scene};
use heapless::Vec;

/// What follows from a scene, computed once when it is checked: [`Checked::derived`](crate::Checked::derived).
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Derived {
    /// Distance at which every kernel vanishes, m ([`support_radius`](super::support_radius)).
    pub support_radius: f64,
    /// Particles inside the support radius ([`average_neighbours`](super::average_neighbours)).
    pub average_neighbours: f32,
    /// Cells along x, y, z; in 2D one along z.
    pub cells: [u32; 3],
    /// Mass of a particle of the first fluid at rest, kg (per metre of depth in 2D).
    pub particle_mass: f64,
    /// Constants of the fluids, by number; at least one.
    pub fluids: Vec<FluidConstants, FLUIDS>,
    /// Largest kinematic viscosity, m2/s.
    pub kinematic_viscosity: f64,
    /// Particles of the fluids: their ids come first.
    pub fluid_particles: usize,
    /// Particles of the walls: their ids come next.
    pub wall_particles: usize,
    /// Particles that the coat of air can have: their ids come last.
    pub air_particles: usize,
    /// Layers of a wall: Hinsch's two with mirrored pressure, Pirovano's three as quasi-fluid; more where the support reaches further.
    pub wall_layers: u32,
    /// Ends of springs that there is room for, two a spring; 0 where no fluid is elastic and no capacity is named.
    pub spring_ends: usize,
    /// Springs at a particle inside of an elastic lattice.
    pub springs_of_particle: usize,
    /// Nodes of the host's field along x, y, z, and in all; 0 where the scene has none.
    pub field_counts: [u32; 4],
    /// The constants that every pass reads, rounded once.
    pub parameters: Parameters,
    /// Those of each material.
    pub materials: Materials,
    /// The numbers of the first step.
    pub step: StepUniform,
}

impl Derived {
    /// Of a scene whose numbers and counts are within their bounds.
    pub(crate) fn of(scene: &Scene, scales: &Scales, counts: &Counts, cells: [u32; 3]) -> Derived {
        let particle_mass = particle_mass(scene, scales);
        let fluids = FluidConstants::of_all(scene, particle_mass);
        let kinematic_viscosity = kinematic_viscosity(scene, scales, &fluids);
        Derived {
            support_radius: scales.support_radius,
            average_neighbours: average_neighbours(scene),
            cells,
            particle_mass,
            parameters: parameters(scene, scales, (counts, cells), particle_mass, kinematic_viscosity),
            materials: materials(scene, &fluids, particle_mass, scales.support_radius),
            step: step_uniform(scene),
            fluids,
            kinematic_viscosity,
            fluid_particles: counts.fluid as usize,
            wall_particles: counts.walls as usize,
            air_particles: counts.air as usize,
            wall_layers: counts.wall_layers,
            spring_ends: spring_ends(scene, scales),
            springs_of_particle: springs_of_particle(scene, scales, 0.0),
            field_counts: field_counts(scene),
        }
    }

    /// Particles in all: of fluids, of walls, and air that is not there yet.
    #[must_use]
    pub fn particles(&self) -> usize {
        self.fluid_particles + self.wall_particles + self.air_particles
    }

    /// Constants of a fluid by number; of the first where there is none of that number.
    #[must_use]
    pub fn fluid(&self, number: u32) -> &FluidConstants {
        self.fluids.get(number as usize).unwrap_or(&self.fluids[0])
    }
}
