//! Kernels as tables, where a scene reads them from there.

/// Entries of a table: 1024 intervals.
pub const TABLE_ENTRIES: usize = 1025;

/// Tables: the density kernel, the pressure kernel's slope, what viscosity takes of its kernel.
pub const TABLES: usize = 3;

/// All of them, in whole fours, as a device wants them.
pub const TABLE_WORDS: usize = (TABLES * TABLE_ENTRIES).next_multiple_of(4);

/// The tables of a scene one after the other; empty where it reads none.
pub type Tables = [f32];
