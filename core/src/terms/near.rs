//! Near pressure, which only ever pushes and only close by, so that particles do not pair (Pirovano, section 3.1; Gourlay).
use super::density::*;
use super::kernel::*;
use super::pair::*;
use crate::arithmetic::real::*;
use crate::layout::Model;

/// None.
pub const NEAR_OFF: u32 = 0;
/// Pirovano, section 3.1.
pub const DENSITY_PROPORTIONAL: u32 = 1;
/// Gourlay.
pub const DOUBLE_DENSITY: u32 = 2;

/// What a neighbour adds to the near density, `(1 - q)^3` (Gourlay after Clavet et al. 2005).
#[inline(always)]
pub fn near_density_neighbour<R: Real>(m: &Model, mass_b: R, q2: R, scale: R) -> R {
    let w = value_scaled(m, kernel_w(SPIKY, q2), scale);
    if counts_masses(m) {
        return w * mass_b;
    }
    return w;
}

/// `P_near = k_near rho` (Pirovano, section 3.1, corrected: its own stiffness `k_near`, m2/s2), Pa.
#[inline(always)]
pub fn near_pressure_proportional<R: Real>(deviation: R, stiffness: R) -> R {
    return (deviation + 1.0) * stiffness;
}

/// `P_near = k_near rho_near` (Gourlay), Pa.
#[inline(always)]
pub fn near_pressure_double_density<R: Real>(near_sum: R, stiffness: R) -> R {
    return near_sum * stiffness;
}

/// The chosen near pressure.
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

/// `(1 - q)^3`: Spiky's slope with the next power (Pirovano, section 3.1, corrected).
#[inline(always)]
pub fn near_slope_proportional<R: Real>(q: R) -> R {
    let d = inside(q);
    return d * d * d;
}

/// `3 (1 - q)^2`: the slope of the near density's own kernel (Gourlay).
#[inline(always)]
pub fn near_slope_double_density<R: Real>(q: R) -> R {
    let d = inside(q);
    return d * d * 3.0;
}

/// The chosen slope.
#[inline(always)]
pub fn near_slope<R: Real>(m: &Model, q: R) -> R {
    if m.near_pressure == DENSITY_PROPORTIONAL {
        return near_slope_proportional(q);
    }
    return near_slope_double_density(q);
}
