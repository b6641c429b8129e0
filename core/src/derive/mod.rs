//! Quantities derived from a scene: all numbers that are not set but computed. Each is computed once, in f64, and
//! rounded once (Pirovano, section 4.1).
//!
//! Dependencies between the files of this folder point one way, from [`Derived`] down to the lengths and the lattice
//! sums. Code that runs before the scene has been checked (lengths, counts) never panics and always finishes quickly,
//! whatever the scene contains.
pub(crate) mod bonds;
pub(crate) mod counts;
mod derived;
pub(crate) mod domain;
pub(crate) mod emission;
mod fluid;
pub(crate) mod frames;
mod hydrostatic;
pub(crate) mod initial_particles;
pub mod kernel_constants;
pub(crate) mod kernel_tables;
pub(crate) mod lattice_sums;
pub(crate) mod material;
mod materials;
mod parameters;
pub mod plane_integrals;
pub(crate) mod recommended_step;
pub(crate) mod sampling;
pub(crate) mod scales;
pub(crate) mod solids;
mod step_limits;

pub use derived::Derived;
pub use fluid::FluidConstants;
pub use material::{Material, material_of};
pub use scales::{average_neighbours, speed_of_sound, support_radius};
pub use solids::reach as solid_reach;
