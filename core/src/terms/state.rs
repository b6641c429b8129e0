//! Equations of state: density, as its deviation from rest, to pressure.
use crate::arithmetic::real::*;
use crate::layout::{Model, Parameters};

/// Tait with exponent 7 (Monaghan 1994; S0 eq. 2.15).
pub const TAIT: u32 = 0;
/// Desbrun and Cani 1996 (S0 eq. 2.14).
pub const DESBRUN: u32 = 1;
/// S0 eq. 2.13.
pub const IDEAL_GAS: u32 = 2;
/// S0 section 3.2.2: see [`correction`](super::correction).
pub const PRESSURE_CORRECTION: u32 = 3;

/// `P = B ((1 + e)^7 - 1)`, Pa, multiplied out so that no digits of a small e are lost. `B = rho0 c0^2 / 7` (S3's corrected
/// constant), or S1's k.
#[inline(always)]
pub fn pressure_tait<R: Real>(deviation: R, stiffness: R) -> R {
    let e = deviation;
    let tail = (e + 7.0) * e + 21.0;
    return ((((tail * e + 35.0) * e + 35.0) * e + 21.0) * e + 7.0) * e * stiffness;
}

/// `P = c0^2 (rho - rho0)`, Pa; `stiffness` is `rho0 c0^2`.
#[inline(always)]
pub fn pressure_desbrun<R: Real>(deviation: R, stiffness: R) -> R {
    return deviation * stiffness;
}

/// `P = c0^2 rho`, Pa; `stiffness` is `rho0 c0^2`.
#[inline(always)]
pub fn pressure_ideal_gas<R: Real>(deviation: R, stiffness: R) -> R {
    return (deviation + 1.0) * stiffness;
}

/// Pressure of the chosen equation of state.
#[inline(always)]
pub fn pressure_of_state<R: Real>(m: &Model, p: &Parameters, deviation: R) -> R {
    if m.equation_of_state == TAIT {
        return pressure_tait(deviation, real(p.state_stiffness));
    }
    if m.equation_of_state == DESBRUN {
        return pressure_desbrun(deviation, real(p.state_stiffness));
    }
    return pressure_ideal_gas(deviation, real(p.state_stiffness));
}

/// No less than zero where the scene allows no suction: a fluid below its rest density then does not pull.
#[inline(always)]
pub fn pressure_close<R: Real>(m: &Model, pressure: R) -> R {
    if m.suction == 0 {
        return larger(pressure, real(0.0));
    }
    return pressure;
}

/// Speed of sound of a particle, m/s: `c = c0 (rho / rho0)^3` with Tait's equation (S3), else c0.
#[inline(always)]
pub fn sound_of_state<R: Real>(m: &Model, p: &Parameters, deviation: R) -> R {
    if m.equation_of_state == TAIT {
        let s = deviation + 1.0;
        return s * s * s * p.speed_of_sound;
    }
    return real(p.speed_of_sound);
}
