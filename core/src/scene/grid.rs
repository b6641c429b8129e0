//! The grid of the neighbour search.

/// The grid of the neighbour search. A cell is a little longer than the support radius. Cell indices wrap around, so
/// the simulated volume is unbounded.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(deny_unknown_fields, default))]
pub struct Grid {
    /// Number of cells along x, y, z, at least 3 each (default 32 each, Pirovano, section 4.2.2). In 2D the number
    /// along z is ignored, and along a periodic axis as many cells are used as fit. The product, times the places per
    /// cell of [`GridStructure::CellLists`], must be less than 2^31. If there are too few cells, particles that are
    /// far apart share cells, which costs time. The number of cells never changes a bit with the full stencil; with
    /// the half stencil it does, because the order of summation follows the cells.
    pub cells: [u32; 3],
    /// How particles are sorted into cells (default index sort).
    pub structure: GridStructure,
    /// How the neighbours of a particle are visited (default full stencil).
    pub traversal: Traversal,
}

impl Default for Grid {
    fn default() -> Self {
        Grid { cells: [32, 32, 32], structure: GridStructure::IndexSort, traversal: Traversal::FullStencil }
    }
}

/// How the neighbours of a particle are visited.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[repr(u32)]
pub enum Traversal {
    /// All cells around a particle's cell are searched, so each pair is computed twice, once for each of its
    /// particles. It runs on CPU and GPU, and is the faster choice with SIMD (default).
    #[default]
    FullStencil = 0,
    /// Only the cells ahead are searched, half of those around, so each pair is computed once and added to both of its
    /// particles (Gourlay). Planes of cells are processed in two rounds, the even planes first. The order of summation
    /// differs from that of `FullStencil` and depends on the number of cells; therefore the bits of the results do
    /// too. They are the same at every SIMD level, on any number of threads and with either grid structure. It runs on
    /// the CPU only, and is faster only without SIMD. Scenes are rejected where the contributions of a pair to its two
    /// particles differ, or where another pass needs all neighbours of a particle.
    HalfStencil = 1,
}

/// How particles are sorted into cells. Both structures give the same bits, because the particles of a cell are always
/// in the order of their ids.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum GridStructure {
    /// Counting sort: count, prefix sum, scatter (Hinsch 2024, section 6.2). A cell can hold any number of particles.
    IndexSort,
    /// A fixed number of places per cell (the CUDA design of Pirovano, section 4.4.2). It needs one pass less, but a
    /// step fails with [`StepError::CellFull`](crate::StepError::CellFull) if a cell gets more particles than it has
    /// places.
    CellLists {
        /// Places per cell, at least 1. Cells times places must be less than 2^31.
        places: u32,
    },
}
