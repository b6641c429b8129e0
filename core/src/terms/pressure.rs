//! Pressure, as the factor of `x_ab / r` in the force density on `a`. With `-dW/dr = constant * slope` it points away
//! from `b` where the pressures are positive.
use crate::arithmetic::real::*;
use crate::layout::Model;

/// Mueller et al. 2003 (S0 eq. 2.19).
pub const MUELLER: u32 = 0;
/// Monaghan 1992 (S0 eq. 2.18).
pub const MONAGHAN: u32 = 1;

/// Mueller et al. 2003, eq. 10: `f_a = -sum V_b (P_a + P_b) / 2 grad W` (S0 eq. 2.19).
///
/// On an even lattice `sum V_b grad W` vanishes, so of `(P_a + P_b) / 2` only half of `P_b` remains: this form gives half
/// of the gradient, and a fluid at rest answers with twice the hydrostatic pressure.
#[inline(always)]
pub fn pressure_mueller<R: Real>(pressure_a: R, pressure_b: R, volume_b: R, slope: R) -> R {
    return (pressure_a + pressure_b) * 0.5 * volume_b * slope;
}

/// Monaghan 1992, eq. 3.1: `f_a = -rho_a sum m_b (P_a / rho_a^2 + P_b / rho_b^2) grad W` (S0 eq. 2.18), for particles of
/// one mass and so with the volumes `V = m / rho`: `f_a = -sum (P_a V_a^2 + P_b V_b^2) / V_a grad W`.
#[inline(always)]
pub fn pressure_monaghan<R: Real>(pressure_a: R, pressure_b: R, volume_a: R, volume_b: R, slope: R) -> R {
    let one: R = real(1.0);
    // the ratio, since the square of a volume is soon too small for f32
    let ratio = volume_b * div(one, volume_a);
    return (pressure_a * volume_a + pressure_b * volume_b * ratio) * slope;
}

/// The chosen form.
#[inline(always)]
pub fn pressure_pair<R: Real>(m: &Model, pressure_a: R, pressure_b: R, volume_a: R, volume_b: R, slope: R) -> R {
    if m.pressure_force == MUELLER {
        return pressure_mueller(pressure_a, pressure_b, volume_b, slope);
    }
    return pressure_monaghan(pressure_a, pressure_b, volume_a, volume_b, slope);
}
