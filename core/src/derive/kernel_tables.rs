//! Fills the tables of kernels (Pirovano, section 4.2.3) from the terms themselves.
use crate::arithmetic::double::Double;
use crate::layout::{Model, TABLE_ENTRIES, Tables};
use crate::scene::{Evaluation, Formulation, Viscosity};
use crate::terms::kernel::{kernel_curvature, kernel_laplacian, kernel_slope, kernel_w};
use crate::terms::table::{DENSITY_TABLE, PRESSURE_TABLE, VISCOSITY_TABLE};
use bytemuck::Zeroable;

/// Fills `tables`, which may be empty, for `d` dimensions.
pub(crate) fn fill_tables(choice: &Formulation, d: usize, tables: &mut Tables) {
    let m = Model { is_3d: u32::from(d == 3), ..Model::zeroed() };
    let squared = choice.evaluation == Evaluation::SquaredTable;
    let of_viscosity = |q: Double| match choice.viscosity {
        // at distance zero: the limit for smooth kernels, where w' / q tends to w''
        Viscosity::Mueller if q.0 == 0.0 && !choice.viscosity_kernel.is_cusped() => {
            kernel_curvature(choice.viscosity_kernel as u32, q) * d as f32
        }
        Viscosity::Mueller => kernel_laplacian(&m, choice.viscosity_kernel as u32, q),
        _ => kernel_slope(&m, choice.viscosity_kernel as u32, q),
    };
    for (i, out) in tables.iter_mut().enumerate() {
        let share = (i % TABLE_ENTRIES) as f64 / (TABLE_ENTRIES - 1) as f64;
        let q = Double(if squared { libm::sqrt(share) } else { share });
        let value = match (i / TABLE_ENTRIES) as u32 {
            DENSITY_TABLE => kernel_w(choice.density_kernel as u32, Double(q.0 * q.0)),
            PRESSURE_TABLE => kernel_slope(&m, choice.pressure_kernel as u32, q),
            VISCOSITY_TABLE => of_viscosity(q),
            _ => Double(0.0),
        };
        *out = value.0 as f32;
    }
}
