//! Which formula each term uses: the plan's choices as numbers that both languages compare.
use super::shared;

shared! {
    /// The choices of a scene. On the GPU this is a constant, so that what is not chosen is compiled away.
    pub struct Model {
        /// [`terms::kernel`](crate::terms::kernel) of the density.
        pub density_kernel: u32,
        /// [`terms::kernel`](crate::terms::kernel) of the pressure gradient.
        pub pressure_kernel: u32,
        /// [`terms::kernel`](crate::terms::kernel) of the viscosity.
        pub viscosity_kernel: u32,
        /// [`terms::table`](crate::terms::table): how kernels are evaluated.
        pub evaluation: u32,
        /// [`terms::density`](crate::terms::density).
        pub density: u32,
        /// [`terms::correction`](crate::terms::correction): where pressure comes from.
        pub pressure_solver: u32,
        /// [`terms::state`](crate::terms::state).
        pub equation_of_state: u32,
        /// [`terms::correction`](crate::terms::correction).
        pub iteration: u32,
        /// 1: pressure may be negative.
        pub allows_negative_pressure: u32,
        /// [`terms::pressure`](crate::terms::pressure).
        pub pressure_force: u32,
        /// [`terms::near`](crate::terms::near); 0: none.
        pub near_pressure: u32,
        /// [`terms::viscosity`](crate::terms::viscosity); 0: none.
        pub viscosity: u32,
        /// 1: velocities are exchanged ([`terms::exchange`](crate::terms::exchange)).
        pub has_velocity_exchange: u32,
        /// 1: gravity acts.
        pub has_gravity: u32,
        /// 1: against the buoyancy of what surrounds the fluid.
        pub has_buoyancy: u32,
        /// 1: wind acts.
        pub has_wind: u32,
        /// 1: a field of the host's acts.
        pub has_acceleration_field: u32,
        /// 1: there are penalty walls.
        pub has_container: u32,
        /// 1: they give back no more than the share of the path that lay behind them.
        pub has_conserving_reflection: u32,
        /// [`terms::wall`](crate::terms::wall): walls of particles; 0: none.
        pub wall_particles: u32,
        /// 1: some axis is periodic.
        pub is_periodic: u32,
        /// 1: supports follow the density.
        pub has_variable_support: u32,
        /// 1: particles differ in mass.
        pub has_variable_mass: u32,
        /// 1: particles differ in kind: walls, or fluids of several viscosities.
        pub has_materials: u32,
        /// 1: there are several fluids.
        pub is_multi_fluid: u32,
        /// 1: their equations of state differ.
        pub has_mixed_state_equations: u32,
        /// 1: volumes come from the number density, where the density does not.
        pub has_number_density_volume: u32,
        /// [`terms::tension`](crate::terms::tension); 0: none.
        pub tension: u32,
        /// 1: normals are found.
        pub has_normals: u32,
        /// 1: springs join particles.
        pub has_springs: u32,
        /// 1: their lengths at rest change.
        pub is_plastic: u32,
        /// 1: there is a coat of air.
        pub has_air: u32,
        /// 1: thermal energy is kept account of.
        pub has_internal_energy: u32,
        /// 1: particles move with their neighbours.
        pub has_xsph: u32,
        /// [`terms::integrate`](crate::terms::integrate).
        pub integrator: u32,
        /// 1: forces are evaluated once more, with the velocities at the end of the step.
        pub is_reevaluated: u32,
        /// 1: the time step follows from the state.
        pub is_adaptive: u32,
        /// Cells around a particle's own along z, 0 or 1: in 2D there is one layer.
        pub is_3d: u32,
        /// Places of a cell in the cell lists; 0 with the index sort.
        pub cell_places: u32,
        /// 1: each pair is computed once, by the half of the stencil. Never on a device.
        pub is_half_stencil: u32,
    }
}
