//! Pressure, as the factor of `x_ab / r` in the force density on `a`: the forms of the gradient (Pirovano, eqs. 2.4,
//! 2.6 and 2.7; Gourlay, table 2). The slope is defined by `-dW/dr = constant * slope`, so the force points away from
//! `b` where the pressures are positive.
use super::pair::*;
use crate::arithmetic::real::*;
use crate::layout::Model;

/// Mueller et al. 2003 (Pirovano, eq. 2.19).
pub const MUELLER: u32 = 0;
/// Monaghan 1992, symmetric (Pirovano, eq. 2.18).
pub const MONAGHAN: u32 = 1;
/// Canonical form (Pirovano, eqs. 2.4 and 2.17).
pub const CANONICAL: u32 = 2;
/// Difference form (Pirovano, eq. 2.6).
pub const DIFFERENCE: u32 = 3;
/// Symmetric form with the number density (Gourlay).
pub const NUMBER_DENSITY_FORCE: u32 = 4;
/// Solenthaler and Pajarola 2008 (Pirovano, eq. 3.6, corrected): Mueller's form with volumes `1 / delta`.
pub const MUELLER_ADAPTED: u32 = 5;
/// Symmetric form with volumes `1 / delta` (Pirovano, section 4.1.2, corrected).
pub const MONAGHAN_ADAPTED: u32 = 6;
/// Hu and Adams 2007, with volumes `1 / delta`.
pub const DENSITY_WEIGHTED: u32 = 7;

/// Mueller et al. 2003, eq. 10 (Pirovano, eq. 2.19): `f_a = -sum V_b (P_a + P_b) / 2 grad W`.
///
/// On a regular lattice `sum V_b grad W` vanishes, so of `(P_a + P_b) / 2` only half of `P_b` remains. This form
/// therefore gives half of the gradient, and a fluid at rest has twice the hydrostatic pressure.
///
/// Adapted to density contrasts, it is `F_a = -sum (P_a + P_b) / 2 / (delta_a delta_b) grad W` in newtons (Pirovano,
/// eq. 3.6, corrected). Divided by the particle's own volume `1 / delta_a`, that is the same formula with different
/// volumes.
#[inline(always)]
pub fn pressure_mueller<R: Real>(pressure_a: R, pressure_b: R, volume_b: R, slope: R) -> R {
    return (pressure_a + pressure_b) * 0.5 * volume_b * slope;
}

/// Canonical form (Pirovano, eq. 2.17): `f_a = -sum V_b P_b grad W`.
#[inline(always)]
pub fn pressure_canonical<R: Real>(pressure_b: R, volume_b: R, slope: R) -> R {
    return pressure_b * volume_b * slope;
}

/// Difference form: `f_a = -1 / rho_a sum m_b (P_b - P_a) grad W` (Pirovano, eq. 2.6). Its `m_b / rho_a` is
/// `V_a m_b / m_a`.
#[inline(always)]
pub fn pressure_difference<R: Real>(m: &Model, a: Local<R>, pressure_b: R, masses: R, slope: R) -> R {
    let push = (pressure_b - a.pressure) * a.volume * slope;
    if weighs(m) {
        return push * masses;
    }
    return push;
}

/// Symmetric form with the number density (Gourlay, table 2): `f_a = -n_a sum (P_a / n_a^2 + P_b / n_b^2) grad W`, with
/// n = 1 / V. In newtons it is `F_a = -sum (P_a / delta_a^2 + P_b / delta_b^2) grad W`, Monaghan's form adapted to
/// density contrasts (Pirovano, section 4.1.2, corrected).
#[inline(always)]
pub fn pressure_number_density<R: Real>(a: Local<R>, pressure_b: R, volume_b: R, slope: R) -> R {
    let one: R = real(1.0);
    // The formula uses the ratio of volumes, because the square of a volume can be too small for f32.
    let ratio = volume_b * div(one, a.volume);
    return (a.pressure * a.volume + pressure_b * volume_b * ratio) * slope;
}

/// Monaghan 1992, eq. 3.1 (Pirovano, eq. 2.18): `f_a = -rho_a sum m_b (P_a / rho_a^2 + P_b / rho_b^2) grad W`. With
/// `V = m / rho` it is `f_a = -sum (P_a V_a^2 m_b / m_a + P_b V_b^2 m_a / m_b) / V_a grad W`.
#[inline(always)]
pub fn pressure_monaghan<R: Real>(m: &Model, a: Local<R>, pressure_b: R, volume_b: R, masses: R, slope: R) -> R {
    if weighs(m) {
        let one: R = real(1.0);
        let ratio = volume_b * div(one, a.volume * masses);
        return (a.pressure * a.volume * masses + pressure_b * volume_b * ratio) * slope;
    }
    return pressure_number_density(a, pressure_b, volume_b, slope);
}

/// Hu and Adams 2007, eq. 12: `F_a = -sum (V_a^2 + V_b^2) (rho_b P_a + rho_a P_b) / (rho_a + rho_b) grad W`. Across an
/// interface the pressure is continuous with a kink, while `grad P / rho` is continuous without one. Each pressure of a
/// pair is therefore weighted by the density of the other particle: this makes the acceleration, and not the gradient,
/// vary smoothly.
#[inline(always)]
pub fn pressure_density_weighted<R: Real>(a: Local<R>, pressure_b: R, volume_b: R, masses: R, slope: R) -> R {
    let one: R = real(1.0);
    let inverse: R = div(one, a.volume);
    // rho_b / rho_a
    let densities = masses * div(a.volume, volume_b);
    let pressure = div(densities * a.pressure + pressure_b, densities + 1.0);
    return (a.volume + volume_b * (volume_b * inverse)) * pressure * slope;
}

/// Returns the pressure force of the chosen form. `pressure_b` and `volume_b` are the values that `a` sees of `b`, and
/// `masses` is `m_b / m_a`.
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
