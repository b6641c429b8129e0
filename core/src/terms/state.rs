//! Equations of state: density to pressure.
use crate::arithmetic::real::*;
use crate::layout::{Model, Parameters};

/// Tait with exponent 7 (Monaghan 1994; S0 eq. 2.15).
pub const TAIT: u32 = 0;
/// Desbrun and Cani 1996 (S0 eq. 2.14).
pub const DESBRUN: u32 = 1;

/// `P = rho0 c0^2 / 7 ((rho / rho0)^7 - 1)`, Pa; `stiffness` is `rho0 c0^2 / 7`.
#[inline(always)]
pub fn pressure_tait<R: Real>(density: R, rest_density: R, stiffness: R) -> R {
    let s = div(density, rest_density);
    let s2 = s * s;
    let s4 = s2 * s2;
    return (s4 * s2 * s - 1.0) * stiffness;
}

/// `P = c0^2 (rho - rho0)`, Pa; `stiffness` is `c0^2`.
#[inline(always)]
pub fn pressure_desbrun<R: Real>(density: R, rest_density: R, stiffness: R) -> R {
    return (density - rest_density) * stiffness;
}

/// Pressure of the chosen equation of state.
#[inline(always)]
pub fn pressure_of_state<R: Real>(m: &Model, p: &Parameters, density: R) -> R {
    if m.equation_of_state == TAIT {
        return pressure_tait(density, real(p.rest_density), real(p.state_stiffness));
    }
    return pressure_desbrun(density, real(p.rest_density), real(p.state_stiffness));
}

/// The same, cut off at zero where the scene allows no suction: a fluid below its rest density then does not pull.
#[inline(always)]
pub fn pressure_close<R: Real>(m: &Model, p: &Parameters, density: R) -> R {
    if m.suction == 0 {
        return larger(pressure_of_state(m, p, density), real(0.0));
    }
    return pressure_of_state(m, p, density);
}

/// Near pressure, `P_near = k_near rho` (S0 section 3.1 per errata: its own stiffness `k_near`, m2/s2), Pa.
#[inline(always)]
pub fn near_pressure_close<R: Real>(m: &Model, p: &Parameters, density: R) -> R {
    if m.near_pressure == 0 {
        return real(0.0);
    }
    return density * p.near_stiffness;
}
