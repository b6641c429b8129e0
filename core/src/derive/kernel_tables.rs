//! Fills the tables of kernels (Pirovano, section 4.2.3), and those of what of them lies beyond a plane, from the terms
//! themselves.
use super::lattice_sums::MOST_SPACINGS;
use super::plane_integrals::{bending, gamma, gamma_of_rows, surface};
use super::scales::support_radius;
use crate::arithmetic::double::Double;
use crate::layout::{Model, TABLE_ENTRIES, Tables};
use crate::scene::{Evaluation, Scene, Viscosity};
use crate::terms::beyond::{
    DENSITY_BENDING, DENSITY_GAMMA, DENSITY_SURFACE, PRESSURE_BENDING, PRESSURE_GAMMA, PRESSURE_SURFACE,
};
use crate::terms::kernel::{kernel_curvature, kernel_laplacian, kernel_slope, kernel_w};
use crate::terms::table::{DENSITY_TABLE, PRESSURE_TABLE, VISCOSITY_TABLE};
use bytemuck::Zeroable;

/// Fills `tables`, which may be empty.
pub(crate) fn fill_tables(scene: &Scene, tables: &mut Tables) {
    let (choice, d, is_closed) = (&scene.model, scene.dimension.count(), scene.has_closed_walls());
    // the largest number of rows is that of the largest lattice sum
    let row = (f64::from(scene.particle_spacing) / support_radius(scene)).max(1.0 / MOST_SPACINGS);

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
    let reads = choice.evaluation != Evaluation::Direct;
    for (i, out) in tables.iter_mut().enumerate() {
        let share = (i % TABLE_ENTRIES) as f64 / (TABLE_ENTRIES - 1) as f64;
        let q = Double(if squared { libm::sqrt(share) } else { share });
        let value = match (i / TABLE_ENTRIES) as u32 {
            DENSITY_TABLE if reads => kernel_w(choice.density_kernel as u32, Double(q.0 * q.0)),
            PRESSURE_TABLE if reads => kernel_slope(&m, choice.pressure_kernel as u32, q),
            VISCOSITY_TABLE if reads => of_viscosity(q),
            DENSITY_GAMMA if is_closed => Double(gamma_of_rows(choice.density_kernel, d, share, row)),
            DENSITY_SURFACE if is_closed => Double(surface(choice.density_kernel, d, share)),
            PRESSURE_GAMMA if is_closed => Double(gamma(choice.pressure_kernel, d, share)),
            PRESSURE_SURFACE if is_closed => Double(surface(choice.pressure_kernel, d, share)),
            DENSITY_BENDING if is_closed => Double(bending(choice.density_kernel, d, share)),
            PRESSURE_BENDING if is_closed => Double(bending(choice.pressure_kernel, d, share)),
            _ => Double(0.0),
        };
        *out = value.0 as f32;
    }
}
