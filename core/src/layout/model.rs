//! Which formula each term uses: the plan's choices as numbers that both languages compare.
use super::shared;

shared! {
    /// The choices of a scene. On the GPU this is a constant, so that what is not chosen is compiled away.
    pub struct Model {
        /// [`terms::kernel`](crate::terms::kernel) of the density.
        pub density_kernel: u32,
        /// [`terms::kernel`](crate::terms::kernel) of the pressure gradient.
        pub pressure_kernel: u32,
        /// [`terms::pressure`](crate::terms::pressure).
        pub pressure_force: u32,
        /// [`terms::state`](crate::terms::state).
        pub equation_of_state: u32,
        /// 1: pressure may be negative.
        pub suction: u32,
        /// 1: near pressure acts.
        pub near_pressure: u32,
        /// 1: viscosity acts.
        pub viscosity: u32,
        /// 1: gravity acts.
        pub gravity: u32,
        /// 1: there are walls.
        pub walls: u32,
        /// 1: walls give back no more than the share of the path that lay behind them.
        pub reflection: u32,
        /// Cells around a particle's own along z, 0 or 1: in 2D there is one layer.
        pub layers: u32,
        /// Places of a cell in the cell lists; 0 with the index sort.
        pub cell_places: u32,
    }
}
