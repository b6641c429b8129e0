//! Lattice positions of the particles at the start: in blocks of fluid, and in the layers of walls and solids.
pub(crate) mod lattice;
pub(crate) mod solids;
pub(crate) mod walls;
