//! Near pressure, which only repels, and only at short distances, so that particles do not pair (Pirovano, section 3.1;
//! Gourlay).
use super::density::*;
use super::kernel::*;
use super::pair::*;
use crate::arithmetic::real::*;
use crate::layout::Model;

/// No near pressure.
pub const NEAR_OFF: u32 = 0;
/// Density-proportional near pressure (Pirovano, section 3.1, corrected).
pub const DENSITY_PROPORTIONAL: u32 = 1;
/// Double density (Clavet et al. 2005; Gourlay).
pub const DOUBLE_DENSITY: u32 = 2;

/// Returns the contribution of a neighbour to the near density, `(1 - q)^3` (Gourlay, after Clavet et al. 2005).
#[inline(always)]
pub fn near_density_neighbour<R: Real>(m: &Model, mass_b: R, q2: R, scale: R) -> R {
    let w = value_scaled(m, kernel_w(SPIKY, q2), scale);
    if counts_masses(m) {
        return w * mass_b;
    }
    return w;
}

/// Returns `P_near = k_near rho`, Pa, where near pressure has a stiffness `k_near` of its own, m2/s2 (Pirovano,
/// section 3.1, corrected). `stiffness` is `k_near rho0`.
#[inline(always)]
pub fn near_pressure_proportional<R: Real>(deviation: R, stiffness: R) -> R {
    return (deviation + 1.0) * stiffness;
}

/// Returns `P_near = k_near rho_near` (Gourlay), Pa. `stiffness` also converts the kernel sum to a density.
#[inline(always)]
pub fn near_pressure_double_density<R: Real>(near_sum: R, stiffness: R) -> R {
    return near_sum * stiffness;
}

/// Returns the near pressure of the chosen form, Pa.
#[inline(always)]
pub fn near_pressure_close<R: Real>(m: &Model, deviation: R, near_sum: R, stiffness: R) -> R {
    if m.near_pressure == DENSITY_PROPORTIONAL {
        return near_pressure_proportional(deviation, stiffness);
    }
    if m.near_pressure == DOUBLE_DENSITY {
        return near_pressure_double_density(near_sum, stiffness);
    }
    return real(0.0);
}

/// Slope of the density-proportional near pressure, `(1 - q)^3`: Spiky's slope with the next power (Pirovano,
/// section 3.1, corrected).
#[inline(always)]
pub fn near_slope_proportional<R: Real>(q: R) -> R {
    let d = inside(q);
    return d * d * d;
}

/// Slope of the double density, `3 (1 - q)^2`: that of the near density's kernel (Gourlay).
#[inline(always)]
pub fn near_slope_double_density<R: Real>(q: R) -> R {
    let d = inside(q);
    return d * d * 3.0;
}

/// Returns the slope of the chosen near pressure.
#[inline(always)]
pub fn near_slope<R: Real>(m: &Model, q: R) -> R {
    if m.near_pressure == DENSITY_PROPORTIONAL {
        return near_slope_proportional(q);
    }
    return near_slope_double_density(q);
}
