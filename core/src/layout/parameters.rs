//! The constants of a scene, computed once on the CPU and passed to both backends bit by bit.
use super::{DrainRows, Planes, SolidRows, f32x4, shared, u32x4};

/// Number of rows of the drains, two for each.
pub const DRAIN_ROWS: usize = 16;

/// Largest number of penalty planes in a scene.
pub const PLANES: usize = 6;

shared! {
    /// Constants that every pass reads. SI units, given for 3D. In 2D masses are per metre of depth, and the constants
    /// of kernels have one power of metre less in the denominator.
    pub struct Parameters {
        /// Cells along x, y, z, and in total. With air the total includes one more cell, which holds the inactive
        /// particles.
        pub cells: u32x4,
        /// Inverse of the cell size along x, y, z, 1/m; w unused.
        pub inverse_cell: f32x4,
        /// Origin of the cells and periods along x, y, z, m; w unused.
        pub domain_low: f32x4,
        /// Length of the period along periodic axes, m; 0 along other axes; w unused.
        pub period: f32x4,
        /// Half of the period, m; `f32::MAX` along other axes; w unused.
        pub half_period: f32x4,
        /// Inverse of the period, 1/m; 0 along other axes; w unused.
        pub inverse_period: f32x4,
        /// First node of the acceleration field supplied by the caller, m; w: inverse of the spacing of its nodes, 1/m.
        pub field_low: f32x4,
        /// Nodes of that field along x, y, z, and in total.
        pub field_counts: u32x4,
        /// Penalty planes: inward unit normal, and offset along the normal in m.
        pub planes: Planes,
        /// Velocities with which the planes slide, m/s; w: dynamic viscosity at the plane in Pa s, negative for that of
        /// the particle.
        pub plane_velocities: Planes,
        /// Two rows per drain: the centre of a ball, m, and its squared radius, m2, or the lowest corner of a box, m,
        /// and 0; the highest corner of a box, m, with w unused.
        pub drains: DrainRows,
        /// The solids: [`SOLID_STRIDE`](super::SOLID_STRIDE) rows of each.
        pub solids: SolidRows,
        /// Number of solids, and number of rows of their poses and of the sides of polygons; z and w unused.
        pub solid_counts: u32x4,
        /// Number of all particles.
        pub particle_count: u32,
        /// Number of penalty planes in use.
        pub plane_count: u32,
        /// Inverse of the support radius H, 1/m.
        pub inverse_support: f32,
        /// Square of `inverse_support`, 1/m2.
        pub inverse_support_squared: f32,
        /// Support radius H, m.
        pub support: f32,
        /// `0.01 (H / 2)^2`, m2. It is added to squared distances, so that close pairs do not divide by zero.
        pub softening: f32,
        /// Smallest support radius of a particle over `support`.
        pub smallest_support: f32,
        /// Largest support radius of a particle over `support`.
        pub largest_support: f32,
        /// Mass of a particle of the first fluid at rest, kg.
        pub particle_mass: f32,
        /// Volume of a particle at rest, m3.
        pub rest_volume: f32,
        /// Rest density of the first fluid, kg/m3.
        pub rest_density: f32,
        /// Factor that turns a sum over the density kernel into a density over the rest density.
        pub density_constant: f32,
        /// Factor that turns a sum over the slope of the pressure kernel into a rate of the density deviation: mass
        /// over rest density, times the constant of the slope, divided by the support radius.
        pub continuity_constant: f32,
        /// Constant of the slope of the pressure kernel, 1/m4.
        pub pressure_constant: f32,
        /// Constant of the slope of the near kernel, 1/m4.
        pub near_constant: f32,
        /// Constant of the slope of the viscosity kernel, 1/m4.
        pub viscosity_slope_constant: f32,
        /// Constant of the Laplacian of the viscosity kernel, 1/m5.
        pub viscosity_laplacian_constant: f32,
        /// Constant of the density kernel in the colour field, 1/m3.
        pub colour_constant: f32,
        /// Constant of the slope of the density kernel in the colour field, 1/m4.
        pub colour_slope_constant: f32,
        /// Constant of the Laplacian of the density kernel in the colour field, 1/m5.
        pub colour_laplacian_constant: f32,
        /// Laplacian of the density kernel at distance zero, without its constant.
        pub colour_curvature_at_self: f32,
        /// Length of a normal above which a particle is at the surface, 1/m.
        pub surface_threshold: f32,
        /// Number of directions along a surface, d - 1.
        pub surface_directions: f32,
        /// Yield strain of springs: the strain up to which they keep their rest length.
        pub yield_strain: f32,
        /// Share of the strain beyond the yield strain that relaxes per second, 1/s.
        pub plastic_rate: f32,
        /// Length at which a spring breaks, over its rest length.
        pub breaking_stretch: f32,
        /// Share of the density deviation that one step of the pressure correction is to remove.
        pub correction_source: f32,
        /// Largest relative density error at which the pressure iteration has converged.
        pub tolerance: f32,
        /// Exponent of Tait's equation.
        pub tait_exponent: f32,
        /// Smallest pressure over the stiffness of Tait's equation whose density is looked for.
        pub least_tait_power: f32,
        /// `2 delta h` of the diffusion of density, m: its coefficient times the support radius.
        pub diffusion: f32,
        /// Linear coefficient of the artificial viscosity.
        pub alpha: f32,
        /// Quadratic coefficient of the artificial viscosity.
        pub beta: f32,
        /// `2 (d + 2)`, the factor of the Monaghan-Gingold viscosity.
        pub monaghan_gingold_factor: f32,
        /// Share of a velocity difference that neighbours at distance zero exchange in a step.
        pub velocity_exchange: f32,
        /// Share of the approach velocity that neighbours at distance zero exchange in a step.
        pub radial_exchange: f32,
        /// Factor that turns a sum over the density kernel into an XSPH velocity: eta, times mass over rest density,
        /// times the constant of the kernel.
        pub xsph_constant: f32,
        /// Coefficient of the shifting: times the support radius, m, for the diffusion of particles; 1 for a background
        /// pressure of `rho0 c0^2`.
        pub shifting: f32,
        /// Speed of the shifting, m/s; unused if it follows from the flow.
        pub shifting_speed: f32,
        /// Largest distance that a particle is shifted in a step, m.
        pub shift_limit_length: f32,
        /// Inverse of the density kernel at the distance of the particle spacing, without its constant; 0 if the kernel
        /// ends before.
        pub inverse_kernel_at_spacing: f32,
        /// Share of the dissipated energy that becomes internal energy.
        pub heat_gain: f32,
        /// Strength with which wall particles repel the fluid, over the square of the speed of sound.
        pub wall_rigidity: f32,
        /// Square of the particle spacing, m2.
        pub spacing2: f32,
        /// Squared distance below which the repulsion of wall particles grows no more, m2.
        pub closest2: f32,
        /// Distance from the surface of a solid at which a path has come to it, m.
        pub touch: f32,
        /// Ambient density over the rest density of the first fluid.
        pub ambient_ratio: f32,
        /// Share of the normal velocity that a penalty plane returns.
        pub restitution: f32,
        /// Share of the tangential velocity that a penalty plane keeps.
        pub slip: f32,
        /// Particle spacing at the start, m.
        pub spacing: f32,
        /// Squared distance from all others that a new particle must have, m2.
        pub clearance2: f32,
        /// Length of the colour gradient of all fluids together above which a particle of liquid is exposed, 1/m.
        pub air_threshold: f32,
        /// Share of its rest density below which an air particle is removed.
        pub air_minimum: f32,
        /// Internal energy of spawned air, J/kg.
        pub air_internal_energy: f32,
        /// Index of the fluid that the air is.
        pub air_fluid: f32,
        /// First id of the particles that can be inactive: those of the layer of air, whose ids are the last, or all.
        pub first_spare: u32,
        /// Number of emitters.
        pub emitter_count: u32,
        /// Number of points of all emitters.
        pub emitter_points: u32,
        /// Number of drains.
        pub drain_count: u32,
        /// `C H` of the criterion by speed: distance that the fastest particle may travel in a step, m.
        pub speed_limit_length: f32,
        /// `C^2 H` of the criterion by acceleration, m.
        pub acceleration_limit_length: f32,
        /// `C H` of the criterion by the speed of sound: distance that sound may travel in a step, m.
        pub sound_limit_length: f32,
        /// Longest step that viscosity allows, `C H^2 / nu`, s.
        pub viscous_time_step: f32,
        /// Shortest step, s.
        pub smallest_time_step: f32,
        /// Longest step, s.
        pub largest_time_step: f32,
        /// Largest ratio of a time step to the one before it.
        pub max_time_step_growth: f32,
        /// A step is rejected and repeated if it was longer than this many times the step that the state at its end
        /// asks for; 0: never.
        pub reject_ratio: f32,
        /// Number of planes that are walls in closed form: all or none.
        pub closed_planes: u32,
    }
}

const _: () = assert!(size_of::<Parameters>().is_multiple_of(16), "a WGSL struct with vectors");

impl Parameters {
    /// The constants for evaluating forces with time at rest or running backwards: no penalty planes, and springs that
    /// never break.
    pub(crate) fn at_rest(self) -> Parameters {
        Parameters { plane_count: 0, breaking_stretch: f32::MAX, ..self }
    }

    /// The constants for a step backwards in time, in which springs also keep their rest lengths.
    pub(crate) fn backwards(self) -> Parameters {
        Parameters { plastic_rate: 0.0, ..self.at_rest() }
    }
}
