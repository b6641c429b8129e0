//! Where the lattice has particles: in blocks of fluid, and in the layers of walls.
pub(crate) mod lattice;
pub(crate) mod walls;
