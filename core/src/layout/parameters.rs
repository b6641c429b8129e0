//! The constants of a scene, computed once on the CPU and handed to both backends as bits.
use super::{Planes, f32x4, shared, u32x4};

/// Penalty walls that a scene can have.
pub const PLANES: usize = 6;

shared! {
    /// What every pass reads. SI units, as in 3D; in 2D masses are per metre of depth, and constants of kernels have one
    /// metre less below the line.
    pub struct Parameters {
        /// Cells along x, y, z, and in all: with air one more than these make, for particles that are not there.
        pub cells: u32x4,
        /// One over the edge of a cell along x, y, z, 1/m; w unused.
        pub inverse_cell: f32x4,
        /// Where cells and periods begin along x, y, z, m; w unused.
        pub domain_low: f32x4,
        /// Length of the periodic axes, m; 0 along the others; w unused.
        pub period: f32x4,
        /// Half of it; the largest number along the others; w unused.
        pub half_period: f32x4,
        /// One over it, 1/m; 0 along the others; w unused.
        pub inverse_period: f32x4,
        /// First node of the host's field, m, and one over the distance of nodes, 1/m.
        pub field_low: f32x4,
        /// Nodes along x, y, z, and in all.
        pub field_counts: u32x4,
        /// Penalty walls: inward unit normal, and offset along it in m.
        pub planes: Planes,
        /// Particles in all.
        pub particle_count: u32,
        /// Penalty walls in use.
        pub plane_count: u32,
        /// One over the support radius, 1/m.
        pub inverse_support: f32,
        /// Its square, 1/m2.
        pub inverse_support_squared: f32,
        /// Support radius, m.
        pub support: f32,
        /// `0.01 (H / 2)^2`, m2, which keeps close pairs from dividing by nothing.
        pub softening: f32,
        /// Smallest share of it that a particle's support has.
        pub smallest_support: f32,
        /// Largest share.
        pub largest_support: f32,
        /// Mass of a particle of the first fluid, kg.
        pub particle_mass: f32,
        /// Volume of a particle at rest, m3.
        pub rest_volume: f32,
        /// Density of the first fluid at rest, kg/m3.
        pub rest_density: f32,
        /// What makes a sum over the density kernel a share of the rest density.
        pub density_constant: f32,
        /// What makes a sum over the pressure kernel's slope a rate of the deviation: mass over rest density, times the
        /// slope's constant, times one over the support.
        pub continuity_constant: f32,
        /// Constant of the pressure kernel's slope, 1/m4.
        pub pressure_constant: f32,
        /// Constant of the near kernel's slope, 1/m4.
        pub near_constant: f32,
        /// Constant of the viscosity kernel's slope, 1/m4.
        pub viscosity_slope_constant: f32,
        /// Constant of the viscosity kernel's Laplacian, 1/m5.
        pub viscosity_laplacian_constant: f32,
        /// Constant of the density kernel, 1/m3, as it measures colours.
        pub colour_constant: f32,
        /// Of its slope, 1/m4.
        pub colour_slope_constant: f32,
        /// Of its Laplacian, 1/m5.
        pub colour_laplacian_constant: f32,
        /// That Laplacian at no distance, without the constant.
        pub colour_curvature_at_self: f32,
        /// Length of a normal from which on a particle is at the surface, 1/m.
        pub surface_threshold: f32,
        /// Directions along a surface, d - 1.
        pub surface_directions: f32,
        /// Strain that a spring bears without giving way.
        pub yield_strain: f32,
        /// Share of the strain beyond it that is lost in a second, 1/s.
        pub plastic_rate: f32,
        /// Length of a spring at which it breaks, over its length at rest.
        pub breaking_stretch: f32,
        /// Share of the deviation of density that a step is to mend.
        pub correction_source: f32,
        /// Largest density miss at which iterations end.
        pub tolerance: f32,
        /// Linear coefficient of the artificial viscosity.
        pub alpha: f32,
        /// Quadratic one.
        pub beta: f32,
        /// `2 (d + 2)`.
        pub dotted_factor: f32,
        /// Share of a velocity difference exchanged in a step.
        pub velocity_exchange: f32,
        /// The same of approaching velocities.
        pub radial_exchange: f32,
        /// What makes a sum over the density kernel a velocity: eta, mass over rest density, constant.
        pub xsph_constant: f32,
        /// Share of dissipation that becomes heat.
        pub heat_gain: f32,
        /// Ambient density over rest density.
        pub ambient_ratio: f32,
        /// Share of the normal velocity that a penalty wall gives back.
        pub restitution: f32,
        /// Share of the tangential velocity that it leaves.
        pub slip: f32,
        /// Distance of particles at the start, m.
        pub spacing: f32,
        /// Length of the normal of all that is there from which on a particle of liquid is bare, 1/m.
        pub air_threshold: f32,
        /// Share of its density at rest below which a particle of air vanishes.
        pub air_minimum: f32,
        /// Thermal energy of air that is made, J/kg.
        pub air_heat: f32,
        /// Number of the fluid that the air is.
        pub air_fluid: f32,
        /// First id of the coat's particles, which are the last.
        pub first_air: u32,
        /// How far the fastest particle may come in a step, `C H`, m.
        pub speed_limit_length: f32,
        /// `C^2 H` of the criterion by acceleration, m.
        pub acceleration_reach: f32,
        /// How far sound may come in a step, `C H`, m.
        pub sound_limit_length: f32,
        /// Longest step that viscosity allows, `C H^2 / nu`, s.
        pub viscous_time_step: f32,
        /// Shortest step, s.
        pub smallest_time_step: f32,
        /// Longest step, s.
        pub largest_time_step: f32,
        /// Times that a step may be as long as the last one.
        pub max_time_step_growth: f32,
        /// A step is made again where it lasted more than so many times what it should have; 0: never.
        pub reject_ratio: f32,
    }
}

impl Parameters {
    /// The same scene while time stands still or runs back: no walls to meet, springs that bear everything and keep their lengths.
    pub(crate) fn at_rest(self) -> Parameters {
        Parameters { plane_count: 0, breaking_stretch: f32::MAX, ..self }
    }

    /// The same for a step back in time.
    pub(crate) fn backwards(self) -> Parameters {
        Parameters { plastic_rate: 0.0, ..self.at_rest() }
    }
}
