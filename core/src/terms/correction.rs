//! Pressure correction (Bao et al. 2009; Pirovano, section 3.2.2, corrected): instead of an equation of state, pressure is changed
//! until the density that the next step would have is the one aimed at.
use super::integrate::*;
use super::state::*;
use crate::arithmetic::real::*;
use crate::layout::{Model, Parameters, StepUniform};

/// Pressure follows from density: see [`state`](super::state).
pub const EQUATION_OF_STATE: u32 = 0;
/// Pirovano, section 3.2.2.
pub const PRESSURE_CORRECTION: u32 = 1;
/// Towards the density that the speed of sound allows.
pub const RELAXED: u32 = 0;
/// As printed.
pub const LITERAL: u32 = 1;

/// Where the iterations of a step begin, Pa: at the pressure of the step before; by the letter, at none.
#[inline(always)]
pub fn pressure_carried<R: Real>(m: &Model, before: R) -> R {
    if m.iteration == LITERAL {
        return real(0.0);
    }
    return before;
}

/// Velocity that a particle would drift with in the next step, m/s.
#[inline(always)]
pub fn predicted_velocity<R: Real>(u: &StepUniform, velocity: vec3<R>, acceleration: vec3<R>) -> vec3<R> {
    return kick(velocity, acceleration, real(u.time_step));
}

/// How far the next density would be off, over the rest density. `rate` is that of the deviation at the predicted velocities.
///
/// Relaxed: from `P / (rho0 c0^2)`, the compression that the pressure stands for, so that the fluid has its real speed of
/// sound; what density is off by already is mended in a few steps, since in one it would shake the particles. Literal (Pirovano
/// eq. 3.3): from no change at all.
#[inline(always)]
pub fn density_miss<R: Real>(
    m: &Model,
    p: &Parameters,
    u: &StepUniform,
    pressure: R,
    deviation: R,
    rate: R,
    compressibility: R,
) -> R {
    let change = rate * u.time_step;
    if m.iteration == LITERAL {
        return change;
    }
    return (deviation - pressure * compressibility) * p.correction_source + change;
}

/// One over what an iteration adds for a density that is off by all of itself, 1/Pa: how much a pressure thins the density
/// around it in a step, `dt^2 V^2 / rho0 sum |grad W|^2`, with what keeps it finite, and the half by which Jacobi's iteration is
/// kept from overshooting where all particles change at once.
#[inline(always)]
pub fn inverse_correction<R: Real>(u: &StepUniform, pressure_response: R, response_offset: R) -> R {
    return (pressure_response * (u.time_step * u.time_step) + response_offset) * 2.0;
}

/// Pressure after an iteration, Pa: `P + k miss`, where k is `rho0 c0^2`, or what the lattice can bear.
#[inline(always)]
pub fn pressure_corrected<R: Real>(m: &Model, pressure: R, miss: R, inverse_stiffness: R) -> R {
    return flush(pressure_close(m, pressure + div(miss, inverse_stiffness)));
}

/// What the iteration still had to mend, over the rest density; nothing where a pressure stays at 0 for want of suction.
#[inline(always)]
pub fn residual<R: Real>(before: R, after: R, inverse_stiffness: R) -> R {
    return abs(after - before) * inverse_stiffness;
}
