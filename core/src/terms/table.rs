//! Kernels from tables (Pirovano, section 4.2.3), between whose entries they are straight lines: addressed by q, or by q^2, which
//! spares a root where nothing else needs the distance.
use super::kernel::*;
use crate::arithmetic::real::*;
use crate::layout::{Model, Tables};

/// By the formulas.
pub const DIRECT: u32 = 0;
/// Tables over q.
pub const TABLE: u32 = 1;
/// Tables over q^2.
pub const SQUARED_TABLE: u32 = 2;

/// The one viscosity that takes the Laplacian of its kernel: see [`viscosity`](super::viscosity).
pub const LAPLACIAN_VISCOSITY: u32 = 1;
/// The same, adapted to contrasts of density.
pub const ADAPTED_LAPLACIAN_VISCOSITY: u32 = 6;

/// Does viscosity take the Laplacian of its kernel, and not the slope?
#[inline(always)]
pub fn takes_laplacian(m: &Model) -> bool {
    return m.viscosity == LAPLACIAN_VISCOSITY || m.viscosity == ADAPTED_LAPLACIAN_VISCOSITY;
}

/// Table of the density kernel's value.
pub const DENSITY_TABLE: u32 = 0;
/// Table of the pressure kernel's slope.
pub const PRESSURE_TABLE: u32 = 1;
/// Table of what the viscosity takes of its kernel.
pub const VISCOSITY_TABLE: u32 = 2;

/// A table at `x` from 0 to 1, beyond which it is 0.
#[inline(always)]
pub fn interpolated<R: Real>(t: &Tables, table: u32, x: R) -> R {
    let place = smaller(x, real(1.0)) * 1024.0;
    // the last entry has no other side: the one before it reaches it with a fraction of 1
    let entry = smaller(floor(place), real(1023.0));
    let low = lookup(t, table, entry);
    let high = lookup(t, table, entry + 1.0);
    return low + (high - low) * (place - entry);
}

/// Value of the density kernel.
#[inline(always)]
pub fn density_kernel<R: Real>(m: &Model, t: &Tables, q2: R) -> R {
    if m.evaluation == TABLE {
        return interpolated(t, DENSITY_TABLE, root(q2));
    }
    if m.evaluation == SQUARED_TABLE {
        return interpolated(t, DENSITY_TABLE, q2);
    }
    return kernel_w(m.density_kernel, q2);
}

/// Slope of the pressure kernel.
#[inline(always)]
pub fn pressure_slope<R: Real>(m: &Model, t: &Tables, q: R) -> R {
    if m.evaluation == TABLE {
        return interpolated(t, PRESSURE_TABLE, q);
    }
    if m.evaluation == SQUARED_TABLE {
        return interpolated(t, PRESSURE_TABLE, q * q);
    }
    return kernel_slope(m, m.pressure_kernel, q);
}

/// What viscosity takes of its kernel, by formula: the Laplacian, or the slope.
#[inline(always)]
pub fn viscous_direct<R: Real>(m: &Model, q: R) -> R {
    if takes_laplacian(m) {
        return kernel_laplacian(m, m.viscosity_kernel, q);
    }
    return kernel_slope(m, m.viscosity_kernel, q);
}

/// The same, or from a table.
#[inline(always)]
pub fn viscous_kernel<R: Real>(m: &Model, t: &Tables, q: R) -> R {
    if m.evaluation == TABLE {
        return interpolated(t, VISCOSITY_TABLE, q);
    }
    if m.evaluation == SQUARED_TABLE {
        return interpolated(t, VISCOSITY_TABLE, q * q);
    }
    return viscous_direct(m, q);
}
