//! Kernels from tables (Pirovano, section 4.2.3), with linear interpolation between the entries. The tables are indexed
//! by q, or by q^2, which saves a square root where nothing else needs the distance.
use super::kernel::*;
use crate::arithmetic::real::*;
use crate::layout::{Model, Tables};

/// Kernels are evaluated by their formulas.
pub const DIRECT: u32 = 0;
/// Kernels are read from tables over q.
pub const TABLE: u32 = 1;
/// Kernels are read from tables over q^2.
pub const SQUARED_TABLE: u32 = 2;

/// Viscosity by the Laplacian of its kernel: see [`viscosity`](super::viscosity).
pub const LAPLACIAN_VISCOSITY: u32 = 1;
/// Viscosity by the Laplacian of its kernel, adapted to density contrasts.
pub const ADAPTED_LAPLACIAN_VISCOSITY: u32 = 6;

/// Returns whether the viscosity uses the Laplacian of its kernel instead of the slope.
#[inline(always)]
pub fn takes_laplacian(m: &Model) -> bool {
    return m.viscosity == LAPLACIAN_VISCOSITY || m.viscosity == ADAPTED_LAPLACIAN_VISCOSITY;
}

/// Table of the density kernel's value.
pub const DENSITY_TABLE: u32 = 0;
/// Table of the pressure kernel's slope.
pub const PRESSURE_TABLE: u32 = 1;
/// Table of the viscosity kernel's Laplacian or slope, whichever the viscosity uses.
pub const VISCOSITY_TABLE: u32 = 2;

/// Returns the value of a table at `x`, which is at least 0. From x = 1 on it is the last entry, 0.
#[inline(always)]
pub fn interpolated<R: Real>(t: &Tables, table: u32, x: R) -> R {
    let place = smaller(x, real(1.0)) * 1024.0;
    // The last entry has no successor. The entry before it reaches it with a fraction of 1.
    let entry = smaller(floor(place), real(1023.0));
    let low = lookup(t, table, entry);
    let high = lookup(t, table, entry + 1.0);
    return low + (high - low) * (place - entry);
}

/// Returns the value of the density kernel.
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

/// Returns the slope of the pressure kernel.
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

/// Returns the Laplacian or the slope of the viscosity kernel, whichever the viscosity uses, by its formula.
#[inline(always)]
pub fn viscous_direct<R: Real>(m: &Model, q: R) -> R {
    if takes_laplacian(m) {
        return kernel_laplacian(m, m.viscosity_kernel, q);
    }
    return kernel_slope(m, m.viscosity_kernel, q);
}

/// Returns the Laplacian or the slope of the viscosity kernel, whichever the viscosity uses, by formula or from a
/// table.
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
