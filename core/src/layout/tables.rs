//! Tables of kernels, for scenes that interpolate kernels instead of evaluating their formulas, and for walls in closed
//! form.

/// Number of entries in a table: 1024 intervals.
pub const TABLE_ENTRIES: usize = 1025;

/// Number of tables: value of the density kernel, slope of the pressure kernel, and slope or Laplacian of the viscosity
/// kernel; then, for the density kernel and for the pressure kernel, what of it lies beyond a plane, and its integral
/// over the plane; then, for both, the correction of the former for curved surfaces.
pub const TABLES: usize = 9;

/// Number of words in all tables, rounded up to a multiple of four for the GPU.
pub const TABLE_WORDS: usize = (TABLES * TABLE_ENTRIES).next_multiple_of(4);

/// The tables of a scene, one after the other; empty if the scene reads none.
pub type Tables = [f32];
