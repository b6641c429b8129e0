//! The constants of a scene, computed once on the CPU and handed to both backends as bits.
use super::{Planes, f32x4, shared, u32x4};

/// Walls that a scene can have.
pub const PLANES: usize = 6;

shared! {
    /// What every pass reads. SI units, as in 3D; in 2D masses are per metre of depth, and constants of kernels have one
    /// metre less below the line.
    pub struct Parameters {
        /// Cells along x, y, z, and in all.
        pub cells: u32x4,
        /// Acceleration of gravity, m/s2; w unused.
        pub gravity: f32x4,
        /// Walls: inward unit normal, and offset along it in m.
        pub planes: Planes,
        /// Particles in all.
        pub particle_count: u32,
        /// Walls in use.
        pub plane_count: u32,
        /// One over the edge of a cell, 1/m.
        pub inverse_cell: f32,
        /// One over the support radius, 1/m.
        pub inverse_support: f32,
        /// Its square, 1/m2.
        pub inverse_support_squared: f32,
        /// Time step, s.
        pub time_step: f32,
        /// Half of it, s.
        pub half_time_step: f32,
        /// Mass of a particle, kg.
        pub particle_mass: f32,
        /// Mass times the constant of the density kernel, kg/m3.
        pub density_constant: f32,
        /// Constant of the pressure kernel's slope, 1/m4.
        pub pressure_constant: f32,
        /// Constant of the near kernel's slope, 1/m4.
        pub near_constant: f32,
        /// Constant of the viscosity kernel's Laplacian, 1/m5.
        pub viscosity_constant: f32,
        /// Density at rest, kg/m3.
        pub rest_density: f32,
        /// Tait: `rho0 c0^2 / 7`, Pa. Desbrun: `c0^2`, m2/s2.
        pub state_stiffness: f32,
        /// Near pressure over density, m2/s2.
        pub near_stiffness: f32,
        /// Dynamic viscosity, Pa s.
        pub dynamic_viscosity: f32,
        /// Share of the normal velocity that a wall gives back.
        pub bounce: f32,
        /// Share of the tangential velocity that a wall leaves.
        pub slip: f32,
        /// Unused.
        pub pad0: u32,
        /// Unused.
        pub pad1: u32,
    }
}

impl Parameters {
    /// The same scene with time standing still: a step with these evaluates the forces and moves nothing.
    pub(crate) fn at_rest(mut self) -> Parameters {
        self.time_step = 0.0;
        self.half_time_step = 0.0;
        self.plane_count = 0;
        self
    }
}
