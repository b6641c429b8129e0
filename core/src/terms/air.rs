//! A layer of air around the liquid (Pirovano, section 3.4.2). Where the gradient of the colour of all particles is
//! long, the liquid is exposed, and an air particle is placed beside it. An air particle that has lost the liquid has a
//! low density and is removed. Pirovano leaves open where and when air is made: place, clearance and thresholds are our
//! choice.
use super::geometry::*;
use super::integrate::*;
use super::pair::*;
use super::tension::*;
use crate::arithmetic::real::*;
use crate::layout::{Model, Parameters};

/// Returns the contribution of a neighbour of any material to `grad C = sum V_b grad W` (Pirovano, eq. 3.9), 1/m. The
/// sum points away from empty space.
#[inline(always)]
pub fn total_gradient<R: Real>(m: &Model, p: &Parameters, a: Local<R>, b: Local<R>) -> vec3<R> {
    let x_ab = separation(m, p, a.position, b.position);
    return x_ab * -(b.volume * colour_slope(m, p, x_ab, pair_scale(m, a.support, b.support)));
}

/// Returns 1 for an exposed liquid particle, whose gradient is longer than the threshold, and 0 for all other
/// particles.
#[inline(always)]
pub fn is_exposed<R: Real>(p: &Parameters, normal: vec3<R>, wall: R, fluid: R) -> R {
    let nothing: R = real(0.0);
    let long = select(nothing, real(1.0), less(real(p.air_threshold), root(length2(normal))));
    // Fluid numbers are integers.
    let of_liquid = select(long, nothing, less(abs(fluid - p.air_fluid), real(0.5)));
    return select(of_liquid, nothing, less(nothing, wall));
}

/// Returns the position at which an exposed particle requests an air particle, m: one particle spacing outwards along
/// the normal.
#[inline(always)]
pub fn spawn_position<R: Real>(m: &Model, p: &Parameters, position: vec3<R>, normal: vec3<R>) -> vec3<R> {
    let away = div(real(p.spacing), root(length2(normal)));
    return wrap(m, p, flush3(position - normal * away));
}

/// Returns 1 where `x` is nearer to `place` than a new particle may be to others, else 0. A new particle that close to
/// another one would be pushed away at once.
#[inline(always)]
pub fn is_taken<R: Real>(m: &Model, p: &Parameters, place: vec3<R>, x: vec3<R>) -> R {
    return select(real(0.0), real(1.0), less(length2(separation(m, p, place, x)), real(p.clearance2)));
}

/// Returns 1 for an air particle whose density is below the minimum, so that it is removed, else 0.
#[inline(always)]
pub fn is_thin<R: Real>(p: &Parameters, deviation: R) -> R {
    return select(real(0.0), real(1.0), less(deviation + 1.0, real(p.air_minimum)));
}
