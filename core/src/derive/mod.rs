//! What follows from a scene: every number that is not asked for but computed, in f64, once, and rounded once (guided creation,
//! Pirovano, section 4.1).
//!
//! Arrows between the files of this folder point one way, from [`Derived`] down to the lengths and the sums over the lattice.
//! Whatever runs before the scene has been checked (lengths, counts) never panics and never takes long, whatever the scene says.
pub(crate) mod bonds;
pub(crate) mod counts;
mod derived;
pub(crate) mod domain;
mod fluid;
mod hydrostatic;
pub(crate) mod initial_particles;
pub mod kernel_constants;
pub(crate) mod kernel_tables;
pub(crate) mod lattice_sums;
pub(crate) mod material;
mod materials;
mod parameters;
pub(crate) mod sampling;
pub(crate) mod scales;
mod step_limits;

pub use derived::Derived;
pub use fluid::FluidConstants;
pub use material::{Material, material_of};
pub use scales::{average_neighbours, speed_of_sound, support_radius};
