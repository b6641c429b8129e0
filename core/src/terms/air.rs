//! A coat of air around the liquid (Pirovano, section 3.4.2): where the gradient of the colour of all that is there is long, a surface is
//! bare, and gets a particle of air beside it; one that has lost the liquid is thin, and goes. The thesis leaves open where air is
//! made and when: place, clearance and thresholds are ours.
use super::geometry::*;
use super::integrate::*;
use super::pair::*;
use super::tension::*;
use crate::arithmetic::real::*;
use crate::layout::{Model, Parameters};

/// What a neighbour, whatever it is of, adds to `grad C = sum V_b grad W` (Pirovano eq. 3.9), 1/m: it points away from where nothing is.
#[inline(always)]
pub fn total_gradient<R: Real>(m: &Model, p: &Parameters, a: Local<R>, b: Local<R>) -> vec3<R> {
    let x_ab = separation(m, p, a.position, b.position);
    return x_ab * -(b.volume * colour_slope(m, p, x_ab, pair_scale(m, a.support, b.support)));
}

/// 1 for a particle of liquid with nothing on one of its sides, 0 for all others.
#[inline(always)]
pub fn is_exposed<R: Real>(p: &Parameters, normal: vec3<R>, wall: R, fluid: R) -> R {
    let nothing: R = real(0.0);
    let long = select(nothing, real(1.0), less(real(p.air_threshold), root(length2(normal))));
    // the numbers of fluids are whole
    let of_liquid = select(long, nothing, less(abs(fluid - p.air_fluid), real(0.5)));
    return select(of_liquid, nothing, less(nothing, wall));
}

/// Where a bare particle has air made: a spacing away, outwards, m.
#[inline(always)]
pub fn place_of_birth<R: Real>(m: &Model, p: &Parameters, position: vec3<R>, normal: vec3<R>) -> vec3<R> {
    let away = div(real(p.spacing), root(length2(normal)));
    return wrap(m, p, flush3(position - normal * away));
}

/// 1 where `x` is within 3/4 of a spacing of the place, else 0: as near as that a new particle would be pushed away at once.
#[inline(always)]
pub fn is_taken<R: Real>(m: &Model, p: &Parameters, place: vec3<R>, x: vec3<R>) -> R {
    let clearance: R = real(p.spacing * p.spacing * 0.5625);
    return select(real(0.0), real(1.0), less(length2(separation(m, p, place, x)), clearance));
}

/// 1 for a particle of air so thin that it goes, else 0.
#[inline(always)]
pub fn is_thin<R: Real>(p: &Parameters, deviation: R) -> R {
    return select(real(0.0), real(1.0), less(deviation + 1.0, real(p.air_minimum)));
}
