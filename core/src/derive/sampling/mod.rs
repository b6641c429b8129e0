//! Lattice positions of the particles at the start: in blocks of fluid, and in the layers of walls.
pub(crate) mod lattice;
pub(crate) mod walls;
