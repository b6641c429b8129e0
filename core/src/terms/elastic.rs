//! Springs between the particles of an elastic fluid (Pirovano, section 2.2.6 after Clavet et al. 2005).
use super::geometry::*;
use super::pair::*;
use crate::arithmetic::real::*;
use crate::layout::{Parameters, StepUniform};

/// What a spring adds to the acceleration of the particle at one of its ends, `-1/2 (k / m_a) (r - L0) x_ab / r` (Pirovano eq. 2.26 per
/// errata), m/s2; `pull` is `k / (2 m_a)`, 1/s2. A broken spring has a negative length at rest, and pulls nobody.
#[inline(always)]
pub fn spring_pull<R: Real>(x_ab: vec3<R>, rest_length: R, pull: R) -> vec3<R> {
    let nothing: R = real(0.0);
    let r = root(length2(x_ab));
    let along = over_distance((r - rest_length) * pull, r);
    return x_ab * -(select(along, nothing, less(rest_length, nothing)));
}

/// Length at rest after a step, m: it gives way to what strain is beyond the yield (Clavet et al. 2005, section 5.2), and is -1
/// from where the spring breaks.
#[inline(always)]
pub fn spring_given_way<R: Real>(p: &Parameters, u: &StepUniform, x_ab: vec3<R>, rest_length: R) -> R {
    let nothing: R = real(0.0);
    let r = root(length2(x_ab));
    let borne = rest_length * p.yield_strain;
    let longer = larger(r - rest_length - borne, nothing);
    let shorter = larger(rest_length - r - borne, nothing);
    let given = rest_length + (longer - shorter) * (p.plastic_rate * u.time_step);
    let broken: R = real(-1.0);
    let held = select(given, broken, less(rest_length * p.breaking_stretch, r));
    return select(held, rest_length, less(rest_length, nothing));
}
