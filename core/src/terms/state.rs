//! Equations of state: pressure from the density deviation.
use crate::arithmetic::real::*;
use crate::layout::Model;

/// Tait equation with exponent 7 (Monaghan 1994; Pirovano, eq. 2.15).
pub const TAIT: u32 = 0;
/// Linear equation (Desbrun and Cani 1996; Pirovano, eq. 2.14).
pub const LINEAR: u32 = 1;
/// Ideal gas (Pirovano, eq. 2.13).
pub const IDEAL_GAS: u32 = 2;

/// Returns `P = B ((1 + e)^7 - 1)`, Pa, expanded so that a small e loses no digits. B is `rho0 c0^2 / 7` (the corrected
/// constant of Roy), or Hinsch's k.
#[inline(always)]
pub fn pressure_tait<R: Real>(deviation: R, stiffness: R) -> R {
    let e = deviation;
    let tail = (e + 7.0) * e + 21.0;
    return ((((tail * e + 35.0) * e + 35.0) * e + 21.0) * e + 7.0) * e * stiffness;
}

/// Returns `P = c0^2 (rho - rho0)`, Pa; `stiffness` is `rho0 c0^2`.
#[inline(always)]
pub fn pressure_linear<R: Real>(deviation: R, stiffness: R) -> R {
    return deviation * stiffness;
}

/// Returns `P = c0^2 rho`, Pa; `stiffness` is `rho0 c0^2`.
#[inline(always)]
pub fn pressure_ideal_gas<R: Real>(deviation: R, stiffness: R) -> R {
    return (deviation + 1.0) * stiffness;
}

/// Returns the pressure by the equation of state, Pa. Each fluid may have its own equation.
#[inline(always)]
pub fn pressure_of_state<R: Real>(m: &Model, deviation: R, stiffness: R, equation: R) -> R {
    if m.has_mixed_state_equations == 1 {
        // The equations have the numbers 0 (Tait), 1 (linear) and 2 (ideal gas).
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

/// Returns the density deviation at a pressure by Tait's equation, the inverse of [`pressure_tait`]: `e` improved by a
/// step of Newton's method, where `x` is the pressure over the stiffness.
#[inline(always)]
pub fn tait_refined<R: Real>(e: R, x: R) -> R {
    let one: R = real(1.0);
    let s = e + 1.0;
    let cubed = s * s * s;
    return e - div(pressure_tait(e, one) - x, cubed * cubed * 7.0);
}

/// Returns the density deviation at a pressure by Tait's equation, to the last bits of an f32. It is at least -1/2, so
/// that a volume stays finite where the pressure is below that of any density.
#[inline(always)]
pub fn deviation_tait<R: Real>(pressure: R, stiffness: R) -> R {
    // the seventh root is found from the eighth one, which is close to it
    let x = larger(div(pressure, stiffness), real(-0.9921875));
    let close = root(root(root(x + 1.0))) - 1.0;
    return tait_refined(tait_refined(tait_refined(tait_refined(tait_refined(close, x), x), x), x), x);
}

/// Returns the density deviation at a pressure by the equation of state, the inverse of [`pressure_of_state`]; at least
/// -1/2.
#[inline(always)]
pub fn deviation_of_state<R: Real>(m: &Model, pressure: R, stiffness: R, equation: R) -> R {
    let least: R = real(-0.5);
    let linear = larger(div(pressure, stiffness), least);
    let gas = larger(div(pressure, stiffness) - 1.0, least);
    if m.has_mixed_state_equations == 1 {
        let other = select(gas, linear, less(equation, real(1.5)));
        return select(other, deviation_tait(pressure, stiffness), less(equation, real(0.5)));
    }
    if m.equation_of_state == TAIT {
        return deviation_tait(pressure, stiffness);
    }
    if m.equation_of_state == LINEAR {
        return linear;
    }
    return gas;
}

/// Limits the pressure to at least 0 where the scene does not allow negative pressure. A fluid below its rest density
/// then does not pull.
#[inline(always)]
pub fn pressure_close<R: Real>(m: &Model, pressure: R) -> R {
    if m.allows_negative_pressure == 0 {
        return larger(pressure, real(0.0));
    }
    return pressure;
}

/// Returns the speed of sound of a particle, m/s: `c = c0 (rho / rho0)^3` with the Tait equation (Roy), else c0.
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
