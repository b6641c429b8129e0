//! What a scene is: a fluid, where it starts, what holds it, and which formulas move it.
//!
//! A scene is plain data in SI units; [`Scene::check`] refuses what cannot run before anything is touched.
mod check;
mod choice;
mod lattice;

pub(crate) use check::check_count;
pub use choice::{Dimension, EquationOfState, Face, GridStructure, Kernel, PressureForce, Reflection};
pub use lattice::{Place, places};

use crate::layout::PLANES;
use heapless::Vec;

/// Blocks of fluid that a scene can have.
pub const BLOCKS: usize = 16;

/// A fluid and all that decides how it moves.
///
/// Lists have a fixed capacity ([`heapless::Vec`], re-exported as [`millpond_core::heapless`](crate::heapless)).
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(deny_unknown_fields))]
pub struct Scene {
    /// Two or three dimensions. In 2D every z is 0 and masses are per metre of depth.
    pub dimension: Dimension,
    /// Distance between particles at the start, m. Smaller: finer, and at the same time step stiffer.
    pub particle_spacing: f32,
    /// Particles inside a support radius, itself counted (S0 section 4.1.5; default 32). More: smoother and slower.
    #[cfg_attr(feature = "serde", serde(default = "default_average_neighbours"))]
    pub average_neighbours: f32,
    /// Time step, s. Too large against `spacing / speed_of_sound`, and the fluid explodes.
    pub time_step: f32,
    /// Acceleration that acts everywhere, m/s2 (default none).
    #[cfg_attr(feature = "serde", serde(default))]
    pub gravity: [f32; 3],
    /// What flows.
    pub fluid: Fluid,
    /// Where it is at the start.
    pub blocks: Vec<Block, BLOCKS>,
    /// The box that holds it, if any.
    #[cfg_attr(feature = "serde", serde(default))]
    pub container: Option<Container>,
    /// Which formulas are used.
    #[cfg_attr(feature = "serde", serde(default))]
    pub model: ModelChoice,
    /// How neighbours are found.
    #[cfg_attr(feature = "serde", serde(default))]
    pub grid: Grid,
}

#[cfg(feature = "serde")]
fn default_average_neighbours() -> f32 {
    32.0
}

/// Properties of a fluid (S0 section 4.1.4).
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(deny_unknown_fields))]
pub struct Fluid {
    /// Density at rest, kg/m3.
    pub rest_density: f32,
    /// Speed of sound, m/s; about ten times the fastest flow keeps the density within 1 %.
    pub speed_of_sound: f32,
    /// Dynamic viscosity, Pa s (default 0: none).
    #[cfg_attr(feature = "serde", serde(default))]
    pub dynamic_viscosity: f32,
    /// Near pressure over density, m2/s2 (default 0.1 c0^2, our choice: with c0^2 a liquid becomes a gas). Acts where
    /// [`ModelChoice::near_pressure`] is on.
    #[cfg_attr(feature = "serde", serde(default))]
    pub near_stiffness: Option<f32>,
}

/// A box of fluid on a lattice of cell centres (S0's instant cube).
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(deny_unknown_fields))]
pub struct Block {
    /// Lowest corner, m.
    pub corner: [f32; 3],
    /// Extent, m; rounded to whole particles along each axis. In 2D its z is ignored.
    pub size: [f32; 3],
    /// Velocity at the start, m/s (default at rest).
    #[cfg_attr(feature = "serde", serde(default))]
    pub velocity: [f32; 3],
    /// Random displacement at the start, in spacings (default 0; the seed is fixed, so it is always the same one).
    #[cfg_attr(feature = "serde", serde(default))]
    pub jitter: f32,
}

/// A box with penalty walls (S0 section 3.5.1).
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(deny_unknown_fields))]
pub struct Container {
    /// Lowest corner, m.
    pub low: [f32; 3],
    /// Highest corner, m.
    pub high: [f32; 3],
    /// Share of the normal velocity that a wall gives back, 0 to 1 (default 0).
    #[cfg_attr(feature = "serde", serde(default))]
    pub bounce: f32,
    /// Share of the tangential velocity that a wall leaves, 0 (no slip) to 1 (default 1).
    #[cfg_attr(feature = "serde", serde(default = "default_slip"))]
    pub slip: f32,
    /// How much of a bounce is given back (default energy conserving).
    #[cfg_attr(feature = "serde", serde(default))]
    pub reflection: Reflection,
    /// Faces that are not there, such as a lid (S0's direction control; default none missing).
    #[cfg_attr(feature = "serde", serde(default))]
    pub open: Vec<Face, PLANES>,
}

#[cfg(feature = "serde")]
fn default_slip() -> f32 {
    1.0
}

/// Which formula each term uses. The defaults are S0's (section 4.1.2).
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(deny_unknown_fields, default))]
pub struct ModelChoice {
    /// Kernel of the density sum.
    pub density_kernel: Kernel,
    /// Kernel of the pressure gradient.
    pub pressure_kernel: Kernel,
    /// Pressure to force.
    pub pressure_force: PressureForce,
    /// Density to pressure.
    pub equation_of_state: EquationOfState,
    /// May pressure be negative? Suction holds a free cloud together, and lets particles pair without near pressure.
    pub suction: bool,
    /// Near pressure, which keeps particles from pairing (S0 section 3.1).
    pub near_pressure: bool,
}

impl Default for ModelChoice {
    fn default() -> Self {
        ModelChoice {
            density_kernel: Kernel::Poly6,
            pressure_kernel: Kernel::Spiky,
            pressure_force: PressureForce::Mueller,
            equation_of_state: EquationOfState::Tait,
            suction: true,
            near_pressure: true,
        }
    }
}

/// The cells that neighbours are looked up in. They wrap, so the simulated volume is unbounded.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(deny_unknown_fields, default))]
pub struct Grid {
    /// Cells along x, y, z (default 32 each, S0 section 4.2.2). At least 3; in 2D the one along z is ignored. Too few and far
    /// particles share cells, which costs time and never a bit.
    pub cells: [u32; 3],
    /// How particles get into cells.
    pub structure: GridStructure,
}

impl Default for Grid {
    fn default() -> Self {
        Grid { cells: [32, 32, 32], structure: GridStructure::IndexSort }
    }
}
