//! Viscosity, as the factor of `v_ab` in the force density on `a`.
use crate::arithmetic::real::*;

/// Mueller et al. 2003, eq. 14: `f_a = mu sum V_b (v_b - v_a) laplacian W` (S0 eq. 2.24). The sign is in `v_ab`'s.
#[inline(always)]
pub fn viscosity_mueller<R: Real>(dynamic_viscosity: R, volume_b: R, laplacian: R) -> R {
    return -(dynamic_viscosity * volume_b * laplacian);
}
