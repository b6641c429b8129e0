//! Equations of state: pressure from the density deviation.
use crate::arithmetic::real::*;
use crate::layout::{Model, Parameters};

/// Tait's equation (Monaghan 1994; Pirovano, eq. 2.15).
pub const TAIT: u32 = 0;
/// Linear equation (Desbrun and Cani 1996; Pirovano, eq. 2.14).
pub const LINEAR: u32 = 1;
/// Ideal gas (Pirovano, eq. 2.13).
pub const IDEAL_GAS: u32 = 2;

/// Returns `(1 + e)^gamma - 1` with the exponent of Tait's equation, in a form that loses no digits of a small e.
#[inline(always)]
pub fn tait_power<R: Real>(m: &Model, e: R) -> R {
    if m.tait_exponent == 7 {
        let tail = (e + 7.0) * e + 21.0;
        return ((((tail * e + 35.0) * e + 35.0) * e + 21.0) * e + 7.0) * e;
    }
    // (1 + e)^(k + 1) - 1 = ((1 + e)^k - 1) (1 + e) + e
    let s = e + 1.0;
    let second = e * s + e;
    let third = second * s + e;
    let fourth = third * s + e;
    let fifth = fourth * s + e;
    if m.tait_exponent == 1 {
        return e;
    }
    if m.tait_exponent == 2 {
        return second;
    }
    if m.tait_exponent == 3 {
        return third;
    }
    if m.tait_exponent == 4 {
        return fourth;
    }
    if m.tait_exponent == 5 {
        return fifth;
    }
    return fifth * s + e;
}

/// Returns `P = B ((1 + e)^gamma - 1)`, Pa. B is `rho0 c0^2 / gamma` (the corrected constant of Roy), or Hinsch's k.
#[inline(always)]
pub fn pressure_tait<R: Real>(m: &Model, deviation: R, stiffness: R) -> R {
    return tait_power(m, deviation) * stiffness;
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
        return select(linear, pressure_tait(m, deviation, stiffness), less(equation, real(0.5)));
    }
    if m.equation_of_state == TAIT {
        return pressure_tait(m, deviation, stiffness);
    }
    if m.equation_of_state == LINEAR {
        return pressure_linear(deviation, stiffness);
    }
    return pressure_ideal_gas(deviation, stiffness);
}

/// Returns the density deviation at a pressure by Tait's equation, the inverse of [`pressure_tait`]: `e` improved by a
/// step of Newton's method, where `x` is the pressure over the stiffness.
#[inline(always)]
pub fn tait_refined<R: Real>(m: &Model, p: &Parameters, e: R, x: R) -> R {
    let power = tait_power(m, e);
    // the derivative of (1 + e)^gamma
    let slope = div((power + 1.0) * p.tait_exponent, e + 1.0);
    return e - div(power - x, slope);
}

/// Returns the root that is closest to that of the exponent of Tait's equation.
#[inline(always)]
pub fn tait_start<R: Real>(m: &Model, second: R, fourth: R, eighth: R) -> R {
    if m.tait_exponent < 3 {
        return second;
    }
    if m.tait_exponent < 5 {
        return fourth;
    }
    return eighth;
}

/// Returns the density deviation at a pressure by Tait's equation, to the last bits of an f32. It is at least about
/// -1/2, so that a volume stays finite where the pressure is below that of any density.
#[inline(always)]
pub fn deviation_tait<R: Real>(m: &Model, p: &Parameters, pressure: R, stiffness: R) -> R {
    // a root with a power of two as its exponent is close to the wanted one
    let x = larger(div(pressure, stiffness), real(p.least_tait_power));
    let second = root(x + 1.0);
    let fourth = root(second);
    let e = tait_start(m, second, fourth, root(fourth)) - 1.0;
    let better = tait_refined(m, p, tait_refined(m, p, tait_refined(m, p, e, x), x), x);
    return tait_refined(m, p, tait_refined(m, p, tait_refined(m, p, better, x), x), x);
}

/// Returns the density deviation at a pressure by the equation of state, the inverse of [`pressure_of_state`]; at least
/// -1/2.
#[inline(always)]
pub fn deviation_of_state<R: Real>(m: &Model, p: &Parameters, pressure: R, stiffness: R, equation: R) -> R {
    let least: R = real(-0.5);
    let linear = larger(div(pressure, stiffness), least);
    let gas = larger(div(pressure, stiffness) - 1.0, least);
    if m.has_mixed_state_equations == 1 {
        let other = select(gas, linear, less(equation, real(1.5)));
        return select(other, deviation_tait(m, p, pressure, stiffness), less(equation, real(0.5)));
    }
    if m.equation_of_state == TAIT {
        return deviation_tait(m, p, pressure, stiffness);
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

/// Returns the speed of sound of a particle, m/s: `c = c0 (rho / rho0)^((gamma - 1) / 2)` with Tait's equation (Roy),
/// else c0.
#[inline(always)]
pub fn sound_of_state<R: Real>(m: &Model, deviation: R, sound: R, equation: R) -> R {
    let tait = sound_tait(m, deviation, sound);
    if m.has_mixed_state_equations == 1 {
        return select(sound, tait, less(equation, real(0.5)));
    }
    if m.equation_of_state == TAIT {
        return tait;
    }
    return sound;
}

/// Returns the speed of sound with Tait's equation, m/s.
#[inline(always)]
pub fn sound_tait<R: Real>(m: &Model, deviation: R, sound: R) -> R {
    let s = deviation + 1.0;
    if m.tait_exponent == 7 {
        return s * s * s * sound;
    }
    return root(div(tait_power(m, deviation) + 1.0, s)) * sound;
}
