//! Equations of state: density, as its deviation from rest, to pressure.
use crate::arithmetic::real::*;
use crate::layout::Model;

/// Tait with exponent 7 (Monaghan 1994; Pirovano eq. 2.15).
pub const TAIT: u32 = 0;
/// Desbrun and Cani 1996 (Pirovano eq. 2.14).
pub const LINEAR: u32 = 1;
/// Pirovano eq. 2.13.
pub const IDEAL_GAS: u32 = 2;

/// `P = B ((1 + e)^7 - 1)`, Pa, multiplied out so that no digits of a small e are lost. `B = rho0 c0^2 / 7` (Roy's corrected
/// constant), or Hinsch's k.
#[inline(always)]
pub fn pressure_tait<R: Real>(deviation: R, stiffness: R) -> R {
    let e = deviation;
    let tail = (e + 7.0) * e + 21.0;
    return ((((tail * e + 35.0) * e + 35.0) * e + 21.0) * e + 7.0) * e * stiffness;
}

/// `P = c0^2 (rho - rho0)`, Pa; `stiffness` is `rho0 c0^2`.
#[inline(always)]
pub fn pressure_linear<R: Real>(deviation: R, stiffness: R) -> R {
    return deviation * stiffness;
}

/// `P = c0^2 rho`, Pa; `stiffness` is `rho0 c0^2`.
#[inline(always)]
pub fn pressure_ideal_gas<R: Real>(deviation: R, stiffness: R) -> R {
    return (deviation + 1.0) * stiffness;
}

/// Pressure of the chosen equation of state, which may be the fluid's own.
#[inline(always)]
pub fn pressure_of_state<R: Real>(m: &Model, deviation: R, stiffness: R, equation: R) -> R {
    if m.has_mixed_state_equations == 1 {
        // by their numbers: Tait 0, Desbrun 1, a gas 2
        let gas = pressure_ideal_gas(deviation, stiffness);
        let linear = select(gas, pressure_linear(deviation, stiffness), less(equation, real(1.5)));
        return select(linear, pressure_tait(deviation, stiffness), less(equation, real(0.5)));
    }
    if m.equation_of_state == TAIT {
        return pressure_tait(deviation, stiffness);
    }
    if m.equation_of_state == LINEAR {
        return pressure_linear(deviation, stiffness);
    }
    return pressure_ideal_gas(deviation, stiffness);
}

/// No less than zero where the scene allows no suction: a fluid below its rest density then does not pull.
#[inline(always)]
pub fn pressure_close<R: Real>(m: &Model, pressure: R) -> R {
    if m.allows_negative_pressure == 0 {
        return larger(pressure, real(0.0));
    }
    return pressure;
}

/// Speed of sound of a particle, m/s: `c = c0 (rho / rho0)^3` with Tait's equation (Roy), else c0.
#[inline(always)]
pub fn sound_of_state<R: Real>(m: &Model, deviation: R, sound: R, equation: R) -> R {
    let s = deviation + 1.0;
    let cubed = s * s * s * sound;
    if m.has_mixed_state_equations == 1 {
        return select(sound, cubed, less(equation, real(0.5)));
    }
    if m.equation_of_state == TAIT {
        return cubed;
    }
    return sound;
}
