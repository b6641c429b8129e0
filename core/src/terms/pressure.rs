//! Pressure, as the factor of `x_ab / r` in the force density on `a`. With `-dW/dr = constant * slope` it points away
//! from `b` where the pressures are positive.
use crate::arithmetic::real::*;

/// Mueller et al. 2003, eq. 10: `f_a = -sum V_b (P_a + P_b) / 2 grad W` (S0 eq. 2.19).
#[inline(always)]
pub fn pressure_mueller<R: Real>(pressure_a: R, pressure_b: R, volume_b: R, slope: R) -> R {
    return (pressure_a + pressure_b) * 0.5 * volume_b * slope;
}
