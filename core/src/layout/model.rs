//! Which formula each term uses: the choices of the plan as numbers that Rust and WGSL compare.
use super::shared;

shared! {
    /// The choices of a scene. On the GPU this struct is a constant, so that unused formulas are compiled away.
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
        /// [`terms::diffusion`](crate::terms::diffusion); 0: none.
        pub density_diffusion: u32,
        /// [`terms::correction`](crate::terms::correction): how pressure is computed.
        pub pressure_solver: u32,
        /// [`terms::state`](crate::terms::state).
        pub equation_of_state: u32,
        /// Exponent of Tait's equation, 1 to 7.
        pub tait_exponent: u32,
        /// [`terms::correction`](crate::terms::correction): how pressure is iterated.
        pub iteration: u32,
        /// 1: pressure may be negative.
        pub allows_negative_pressure: u32,
        /// [`terms::pressure`](crate::terms::pressure).
        pub pressure_force: u32,
        /// [`terms::near`](crate::terms::near); 0: none.
        pub near_pressure: u32,
        /// [`terms::viscosity`](crate::terms::viscosity); 0: none.
        pub viscosity: u32,
        /// 1: neighbours exchange velocities ([`terms::exchange`](crate::terms::exchange)).
        pub has_velocity_exchange: u32,
        /// 1: there is gravity.
        pub has_gravity: u32,
        /// 1: the buoyancy of the ambient medium reduces gravity.
        pub has_buoyancy: u32,
        /// 1: there is wind.
        pub has_wind: u32,
        /// 1: there is an acceleration field supplied by the caller.
        pub has_acceleration_field: u32,
        /// 1: there are penalty planes.
        pub has_container: u32,
        /// 1: penalty planes return only the share of the normal velocity that corresponds to the part of the path
        /// behind the plane (energy conserving, Kelager 2006).
        pub has_conserving_reflection: u32,
        /// 1: the penalty planes, or some solids, are walls in closed form ([`terms::beyond`](crate::terms::beyond)).
        pub has_closed_walls: u32,
        /// 1: there are solids.
        pub has_solids: u32,
        /// 1: there is a solid that repels.
        pub has_repulsion: u32,
        /// 1: there is a solid with particles that moves.
        pub has_carried: u32,
        /// [`terms::wall`](crate::terms::wall): wall particles; 0: none.
        pub wall_particles: u32,
        /// 1: wall particles repel, and have no part in density and pressure.
        pub has_repelling_walls: u32,
        /// 1: at least one axis is periodic.
        pub is_periodic: u32,
        /// 1: support radii follow the density.
        pub has_variable_support: u32,
        /// 1: particles of one fluid may differ in mass.
        pub has_variable_mass: u32,
        /// 1: there are several materials: walls, several fluids, or blocks with their own viscosity.
        pub has_materials: u32,
        /// 1: there are several fluids.
        pub is_multi_fluid: u32,
        /// 1: the equations of state of the fluids differ.
        pub has_mixed_state_equations: u32,
        /// 1: volumes are computed from the number density although the density is not.
        pub has_number_density_volume: u32,
        /// [`terms::tension`](crate::terms::tension); 0: none.
        pub tension: u32,
        /// 1: normals are computed.
        pub has_normals: u32,
        /// 1: springs join particles.
        pub has_springs: u32,
        /// 1: rest lengths of springs change.
        pub is_plastic: u32,
        /// 1: there is a layer of air.
        pub has_air: u32,
        /// 1: particles come and go by emitters, drains or the host.
        pub has_turnover: u32,
        /// 1: there are emitters.
        pub has_emitters: u32,
        /// 1: particles can be inactive: with air, or if they come and go.
        pub has_inactive: u32,
        /// 1: internal energy is tracked.
        pub has_internal_energy: u32,
        /// 1: XSPH: particles move with a velocity nearer to that of their neighbours.
        pub has_xsph: u32,
        /// [`terms::shifting`](crate::terms::shifting); 0: none.
        pub shifting: u32,
        /// 1: the scene gives the speed of the shifting.
        pub has_shifting_speed: u32,
        /// 1: particles are shifted across the interfaces of fluids.
        pub shifts_interfaces: u32,
        /// 1: particles with a negative pressure do not attract their neighbours.
        pub has_tensile_control: u32,
        /// [`terms::integrate`](crate::terms::integrate).
        pub integrator: u32,
        /// 1: forces are evaluated a second time, with the predicted velocities at the end of the step.
        pub is_reevaluated: u32,
        /// 1: the time step can change, because it is adaptive or because a step that cannot be made is shortened.
        pub has_changing_step: u32,
        /// How many times a step that cannot be made is halved before it is refused.
        pub most_halvings: u32,
        /// 1 in 3D, 0 in 2D: how many layers of cells the stencil spans on either side along z.
        pub is_3d: u32,
        /// Number of places per cell in the cell lists; 0 with the index sort.
        pub cell_places: u32,
        /// 1: each pair is computed once, by the half stencil. Always 0 on a GPU.
        pub is_half_stencil: u32,
    }
}
