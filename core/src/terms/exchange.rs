//! Gourlay's viscosity: neighbours exchange the whole velocity difference ("shear"), the part with which they approach
//! each other ("shock"), or both. Gourlay changes velocities in place, so that the result depends on the order of
//! pairs; here each particle sums its changes from the old velocities. Where the shares of all neighbours add up to
//! more than 1, they are scaled down to 1: the particle then takes the mean of its neighbours' velocities, and no
//! velocity is reversed. Where this limit applies to only one particle of a pair, the two changes are not equal and
//! opposite, and momentum is not conserved.
use super::geometry::*;
use super::kernel::*;
use super::pair::*;
use super::wall::*;
use crate::arithmetic::real::*;
use crate::layout::{Model, Parameters, StepUniform};

/// Returns the share of the velocity difference to a neighbour that a particle takes: half of the gain, falling
/// linearly with distance, and 0 for the particle itself. The lighter particle takes more, `m_b / ((m_a + m_b) / 2)`,
/// so that the exchange conserves momentum.
#[inline(always)]
pub fn exchange_weight<R: Real>(m: &Model, p: &Parameters, a: Local<R>, b: Local<R>) -> R {
    let x_ab = separation(m, p, a.position, b.position);
    let q = root(squared_ratio(m, p, x_ab, pair_scale(m, a.support, b.support)));
    let share = select(real(0.0), inside(q) * 0.5, less(real(0.0), q));
    if weighs(m) {
        let masses = mass_ratio(m, a, b);
        return share * div(masses * 2.0, masses + 1.0);
    }
    return share;
}

/// Returns `v_ab . x_ab` for two particles that approach each other, and 0 for particles that separate.
#[inline(always)]
pub fn closing_speed<R: Real>(m: &Model, p: &Parameters, a: Local<R>, b: Local<R>) -> R {
    let x_ab = separation(m, p, a.position, b.position);
    return smaller(dot3(a.velocity - b.velocity, x_ab), real(0.0));
}

/// Returns the contribution of a neighbour to the sum of shares.
#[inline(always)]
pub fn exchange_share<R: Real>(m: &Model, p: &Parameters, a: Local<R>, b: Local<R>) -> R {
    let shock: R = real(p.radial_exchange);
    let closing = select(real(0.0), shock, less(closing_speed(m, p, a, b), real(0.0)));
    return exchange_weight(m, p, a, b) * (closing + p.velocity_exchange);
}

/// Returns the contribution of a neighbour to the change of velocity in a step, m/s.
#[inline(always)]
pub fn exchange_neighbour<R: Real>(m: &Model, p: &Parameters, a: Local<R>, b: Local<R>) -> vec3<R> {
    let x_ab = separation(m, p, a.position, b.position);
    let one: R = real(1.0);
    let r2 = length2(x_ab);
    let inverse_r2 = select(real(0.0), div(one, r2), less(real(0.0), r2));
    let shock = closing_speed(m, p, a, b) * inverse_r2 * p.radial_exchange;
    let difference = (b.velocity - a.velocity) * real(p.velocity_exchange) - x_ab * shock;
    return difference * exchange_weight(m, p, a, b);
}

/// Returns the factor that converts the change of velocity in a step to an acceleration, 1/s. `shares` is the sum of
/// shares; where it exceeds 1, the factor scales the change down.
#[inline(always)]
pub fn exchange_close<R: Real>(u: &StepUniform, shares: R) -> R {
    return div(real(u.inverse_time_step), larger(shares, real(1.0)));
}
