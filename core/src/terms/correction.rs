//! Pressure correction (Bao et al. 2009; Pirovano, section 3.2.2, corrected). The pressure does not follow from an
//! equation of state: it is iterated until the predicted density of the next step reaches its target.
use super::integrate::*;
use super::state::*;
use crate::arithmetic::real::*;
use crate::layout::{Model, Parameters, StepUniform};

/// Pressure follows from density by an equation of state: see [`state`](super::state).
pub const EQUATION_OF_STATE: u32 = 0;
/// Pressure is iterated (Pirovano, section 3.2.2, corrected).
pub const PRESSURE_CORRECTION: u32 = 1;
/// Iterates towards the density that corresponds to the pressure at the fluid's speed of sound.
pub const RELAXED: u32 = 0;
/// Iterates with the full stiffness, as printed (Pirovano, eqs. 3.3 and 3.4, corrected).
pub const LITERAL: u32 = 1;

/// Returns the pressure with which the iterations of a step begin, Pa: that of the previous step, or 0 in the literal
/// form.
#[inline(always)]
pub fn pressure_carried<R: Real>(m: &Model, before: R) -> R {
    if m.iteration == LITERAL {
        return real(0.0);
    }
    return before;
}

/// Returns the velocity with which a particle would drift in the next step, m/s.
#[inline(always)]
pub fn predicted_velocity<R: Real>(u: &StepUniform, velocity: vec3<R>, acceleration: vec3<R>) -> vec3<R> {
    return kick(velocity, acceleration, real(u.time_step));
}

/// Returns the predicted density error of the next step, over the rest density. `rate` is the rate of the density
/// deviation at the predicted velocities.
///
/// In the relaxed form the target is the compression that belongs to the pressure, `P / (rho0 c0^2)`, so that the fluid
/// keeps its real speed of sound. An error that the density already has is removed over several steps, because removing
/// it in one step would shake the particles. In the literal form (Pirovano, eq. 3.3, corrected) the target is an
/// unchanged density.
#[inline(always)]
pub fn predicted_density_error<R: Real>(
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

/// Returns the inverse stiffness of an iteration, 1/Pa: the density error, over the rest density, divided by the
/// pressure that one iteration adds for it. It contains the relative decrease of density that 1 Pa causes around a
/// particle in a step, `dt^2 V^2 / rho0 sum |grad W|^2`, and an offset that keeps the stiffness finite. The factor 2
/// halves the correction, so that the Jacobi iteration does not overshoot although all particles change at once.
#[inline(always)]
pub fn inverse_correction<R: Real>(u: &StepUniform, pressure_response: R, response_offset: R) -> R {
    return (pressure_response * (u.time_step * u.time_step) + response_offset) * 2.0;
}

/// Returns the pressure after an iteration, Pa: `P + k miss`. The stiffness k is `rho0 c0^2` in the literal form, and
/// limited by the response of the lattice in the relaxed form.
#[inline(always)]
pub fn pressure_corrected<R: Real>(m: &Model, pressure: R, miss: R, inverse_stiffness: R) -> R {
    return flush(pressure_close(m, pressure + div(miss, inverse_stiffness)));
}

/// Returns the density error that the iteration corrected, over the rest density. It is 0 where the pressure stays at 0
/// because negative pressure is not allowed.
#[inline(always)]
pub fn residual<R: Real>(before: R, after: R, inverse_stiffness: R) -> R {
    return abs(after - before) * inverse_stiffness;
}
