//! What each material has of its own: particles name theirs by number.
use super::{f32x4, shared};

/// Materials that there is room for: fluids, blocks with a viscosity of their own, walls, and the last one for inactive particles.
pub const MATERIALS: usize = 256;

/// A row for each material.
pub type MaterialRows = [f32x4; MATERIALS];

shared! {
    /// The constants of the materials.
    pub struct Materials {
        /// Dynamic viscosity in Pa s (negative for a wall that takes the particle's), 1 for a wall and 2 for inactive particles,
        /// rest density over the first fluid's, number of the fluid.
        pub properties: MaterialRows,
        /// Constant of the equation of state, near pressure at rest (thesis) or over the near sum (article), both in Pa, speed
        /// of sound in m/s, number of the equation.
        pub states: MaterialRows,
        /// Of an iteration of pressure: how much a pressure thins the density around it in a step, over the step's square, in
        /// 1/(Pa s2), what is added to that, in 1/Pa; `1 / (rho0 c0^2)` in 1/Pa; surface tension.
        pub corrections: MaterialRows,
    }
}
