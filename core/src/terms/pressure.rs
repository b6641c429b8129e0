//! Pressure, as the factor of `x_ab / r` in the force density on `a`: the forms of the gradient (Pirovano eqs. 2.4, 2.6, 2.7; Gourlay
//! table 2). With `-dW/dr = constant * slope` it points away from `b` where the pressures are positive.
use super::pair::*;
use crate::arithmetic::real::*;
use crate::layout::Model;

/// Mueller et al. 2003 (Pirovano eq. 2.19).
pub const MUELLER: u32 = 0;
/// Monaghan 1992 (Pirovano eq. 2.18), symmetric.
pub const MONAGHAN: u32 = 1;
/// Canonical (Pirovano eqs. 2.4, 2.17).
pub const CANONICAL: u32 = 2;
/// Difference (Pirovano eq. 2.6).
pub const DIFFERENCE: u32 = 3;
/// Symmetric on the number density (Gourlay).
pub const NUMBER_DENSITY_FORCE: u32 = 4;
/// Solenthaler and Pajarola 2008 (Pirovano eq. 3.6, corrected): Mueller's, where volumes are `1 / delta`.
pub const MUELLER_ADAPTED: u32 = 5;
/// Pirovano, section 4.1.2, corrected: symmetric, where volumes are `1 / delta`.
pub const MONAGHAN_ADAPTED: u32 = 6;
/// Hu and Adams 2007, where volumes are `1 / delta`.
pub const DENSITY_WEIGHTED: u32 = 7;

/// Mueller et al. 2003, eq. 10: `f_a = -sum V_b (P_a + P_b) / 2 grad W` (Pirovano eq. 2.19).
///
/// On an even lattice `sum V_b grad W` vanishes, so of `(P_a + P_b) / 2` only half of `P_b` remains: this form gives half
/// of the gradient, and a fluid at rest answers with twice the hydrostatic pressure.
///
/// Adapted to contrasts of density (Pirovano eq. 3.6, corrected), `F_a = -sum (P_a + P_b) / 2 / (delta_a delta_b) grad W` in newtons: over
/// the particle's own volume `1 / delta_a` that is the same formula, with other volumes.
#[inline(always)]
pub fn pressure_mueller<R: Real>(pressure_a: R, pressure_b: R, volume_b: R, slope: R) -> R {
    return (pressure_a + pressure_b) * 0.5 * volume_b * slope;
}

/// `f_a = -sum V_b P_b grad W` (Pirovano eq. 2.17).
#[inline(always)]
pub fn pressure_canonical<R: Real>(pressure_b: R, volume_b: R, slope: R) -> R {
    return pressure_b * volume_b * slope;
}

/// `f_a = -1 / rho_a sum m_b (P_b - P_a) grad W` (Pirovano eq. 2.6), with `m_b / rho_a = V_a m_b / m_a`.
#[inline(always)]
pub fn pressure_difference<R: Real>(m: &Model, a: Local<R>, pressure_b: R, masses: R, slope: R) -> R {
    let push = (pressure_b - a.pressure) * a.volume * slope;
    if weighs(m) {
        return push * masses;
    }
    return push;
}

/// `f_a = -n_a sum (P_a / n_a^2 + P_b / n_b^2) grad W` (Gourlay table 2), n = 1 / V. In newtons,
/// `F_a = -sum (P_a / delta_a^2 + P_b / delta_b^2) grad W` (Pirovano, section 4.1.2, corrected), it is Monaghan's form adapted to contrasts of density.
#[inline(always)]
pub fn pressure_number_density<R: Real>(a: Local<R>, pressure_b: R, volume_b: R, slope: R) -> R {
    let one: R = real(1.0);
    // the ratio, since the square of a volume is soon too small for f32
    let ratio = volume_b * div(one, a.volume);
    return (a.pressure * a.volume + pressure_b * volume_b * ratio) * slope;
}

/// Monaghan 1992, eq. 3.1: `f_a = -rho_a sum m_b (P_a / rho_a^2 + P_b / rho_b^2) grad W` (Pirovano eq. 2.18), with `V = m / rho`:
/// `f_a = -sum (P_a V_a^2 m_b / m_a + P_b V_b^2 m_a / m_b) / V_a grad W`.
#[inline(always)]
pub fn pressure_monaghan<R: Real>(m: &Model, a: Local<R>, pressure_b: R, volume_b: R, masses: R, slope: R) -> R {
    if weighs(m) {
        let one: R = real(1.0);
        let ratio = volume_b * div(one, a.volume * masses);
        return (a.pressure * a.volume * masses + pressure_b * volume_b * ratio) * slope;
    }
    return pressure_number_density(a, pressure_b, volume_b, slope);
}

/// Hu and Adams 2007, eq. 12: `F_a = -sum (V_a^2 + V_b^2) (rho_b P_a + rho_a P_b) / (rho_a + rho_b) grad W`. Across an interface pressure
/// goes on and has a kink, while `grad P / rho` goes on without one: a pressure between two particles that is weighted by the
/// other's density makes this acceleration, and not the gradient, even.
#[inline(always)]
pub fn pressure_density_weighted<R: Real>(a: Local<R>, pressure_b: R, volume_b: R, masses: R, slope: R) -> R {
    let one: R = real(1.0);
    let inverse: R = div(one, a.volume);
    // rho_b / rho_a
    let densities = masses * div(a.volume, volume_b);
    let pressure = div(densities * a.pressure + pressure_b, densities + 1.0);
    return (a.volume + volume_b * (volume_b * inverse)) * pressure * slope;
}

/// The chosen form, between `a` and what stands for `b`; `masses` is `m_b / m_a`.
#[inline(always)]
pub fn pressure_pair<R: Real>(m: &Model, a: Local<R>, pressure_b: R, volume_b: R, masses: R, slope: R) -> R {
    if m.pressure_force == MUELLER || m.pressure_force == MUELLER_ADAPTED {
        return pressure_mueller(a.pressure, pressure_b, volume_b, slope);
    }
    if m.pressure_force == MONAGHAN {
        return pressure_monaghan(m, a, pressure_b, volume_b, masses, slope);
    }
    if m.pressure_force == CANONICAL {
        return pressure_canonical(pressure_b, volume_b, slope);
    }
    if m.pressure_force == DIFFERENCE {
        return pressure_difference(m, a, pressure_b, masses, slope);
    }
    if m.pressure_force == DENSITY_WEIGHTED {
        return pressure_density_weighted(a, pressure_b, volume_b, masses, slope);
    }
    return pressure_number_density(a, pressure_b, volume_b, slope);
}
