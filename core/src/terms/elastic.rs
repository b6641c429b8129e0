//! Springs between the particles of an elastic fluid (Pirovano, section 2.2.6; Clavet et al. 2005).
use super::geometry::*;
use super::pair::*;
use crate::arithmetic::real::*;
use crate::layout::{Parameters, StepUniform};

/// Returns the contribution of a spring to the acceleration of a particle, `-1/2 (k / m_a) (r - L0) x_ab / r`
/// (Pirovano, eq. 2.26, corrected), m/s2. The particle is at one end of the spring. `pull` is `k / (2 m_a)`, 1/s2. A
/// broken spring has a negative rest length and exerts no force.
#[inline(always)]
pub fn spring_pull<R: Real>(x_ab: vec3<R>, rest_length: R, pull: R) -> vec3<R> {
    let nothing: R = real(0.0);
    let r = root(length2(x_ab));
    let along = over_distance((r - rest_length) * pull, r);
    return x_ab * -(select(along, nothing, less(rest_length, nothing)));
}

/// Returns the rest length of a spring after a step, m. It changes where the strain exceeds the yield strain (Clavet
/// et al. 2005, section 5.2), and is -1 from the step in which the spring breaks.
#[inline(always)]
pub fn plastic_rest_length<R: Real>(p: &Parameters, u: &StepUniform, x_ab: vec3<R>, rest_length: R) -> R {
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
