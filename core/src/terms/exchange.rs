//! Gourlay's viscosity: neighbours exchange velocity, all of it ("shear") or the part with which they approach each other
//! ("shock"). The source changes velocities in place, so that its result depends on the order of pairs; here each particle
//! sums its changes from the old velocities. Where the shares of all neighbours come to more than 1, they are scaled
//! down to 1: a particle then takes the mean of its neighbours' velocities, and none is ever reversed. Where
//! that happens to one of a pair and not to the other, they do not act on each other alike, and momentum is not kept.
use super::geometry::*;
use super::kernel::*;
use super::pair::*;
use super::wall::*;
use crate::arithmetic::real::*;
use crate::layout::{Model, Parameters, StepUniform};

/// Share of the difference to a neighbour that a particle takes: half of the gain, falling with distance, 0 for itself. Of
/// two masses the lighter takes more, `m_b / ((m_a + m_b) / 2)`, so that what one gains in momentum the other loses.
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

/// Of the velocity with which two particles approach each other: `v_ab . x_ab`, 0 where they part.
#[inline(always)]
pub fn closing_speed<R: Real>(m: &Model, p: &Parameters, a: Local<R>, b: Local<R>) -> R {
    let x_ab = separation(m, p, a.position, b.position);
    return smaller(dot3(a.velocity - b.velocity, x_ab), real(0.0));
}

/// What a neighbour adds to the sum of shares.
#[inline(always)]
pub fn exchange_share<R: Real>(m: &Model, p: &Parameters, a: Local<R>, b: Local<R>) -> R {
    let shock: R = real(p.radial_exchange);
    let closing = select(real(0.0), shock, less(closing_speed(m, p, a, b), real(0.0)));
    return exchange_weight(m, p, a, b) * (closing + p.velocity_exchange);
}

/// What a neighbour adds to the change of velocity, m/s.
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

/// What makes of a change in a step an acceleration, 1/s, `shares` being their sum.
#[inline(always)]
pub fn exchange_close<R: Real>(u: &StepUniform, shares: R) -> R {
    return div(real(u.inverse_time_step), larger(shares, real(1.0)));
}
