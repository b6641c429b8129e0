//! Tables of kernels, for scenes that interpolate kernels instead of evaluating their formulas.

/// Number of entries in a table: 1024 intervals.
pub const TABLE_ENTRIES: usize = 1025;

/// Number of tables: value of the density kernel, slope of the pressure kernel, and slope or Laplacian of the viscosity
/// kernel.
pub const TABLES: usize = 3;

/// Number of words in all tables, rounded up to a multiple of four for the GPU.
pub const TABLE_WORDS: usize = (TABLES * TABLE_ENTRIES).next_multiple_of(4);

/// The tables of a scene, one after the other; empty if the scene reads none.
pub type Tables = [f32];
