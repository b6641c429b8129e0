//! Constants of each material. A particle stores the index of its material.
use super::{f32x4, shared};

/// Number of materials that there is room for: fluids, blocks with their own viscosity, walls, solids, and, as the last one,
/// inactive air particles.
pub const MATERIALS: usize = 64;

/// One row per material.
pub type MaterialRows = [f32x4; MATERIALS];

shared! {
    /// The constants of the materials.
    pub struct Materials {
        /// Dynamic viscosity in Pa s (negative for a wall that takes the viscosity of the particle); 0 for fluids, 1
        /// for walls and 2 for inactive particles; rest density over that of the first fluid; index of the fluid.
        pub properties: MaterialRows,
        /// Constant of the equation of state, Pa; near pressure at rest (density-proportional) or over the near density
        /// sum (double density), Pa; speed of sound, m/s; number of the equation of state.
        pub states: MaterialRows,
        /// For the pressure correction: relative decrease of density around a particle per pascal and step, divided by
        /// the square of the time step, 1/(Pa s2); a term added to it, 1/Pa; `1 / (rho0 c0^2)`, 1/Pa. Last, the
        /// coefficient of surface tension.
        pub corrections: MaterialRows,
    }
}
