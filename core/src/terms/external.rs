//! External accelerations (Pirovano, section 2.2.5): gravity, the buoyancy of a surrounding medium, wind, and an
//! acceleration field supplied by the caller.
use super::geometry::*;
use crate::arithmetic::real::*;
use crate::layout::{Model, Parameters, StepUniform};

/// Returns `g (1 - rho_ambient / rho_a)` (Gourlay's body force), m/s2, or g where no medium surrounds the fluid.
/// `density` is relative to the rest density of the first fluid.
#[inline(always)]
pub fn weight<R: Real>(m: &Model, p: &Parameters, u: &StepUniform, density: R) -> vec3<R> {
    let g = vec3(real(u.gravity[0]), real(u.gravity[1]), real(u.gravity[2]));
    if m.has_buoyancy == 0 {
        return g;
    }
    let one: R = real(1.0);
    return g * (one - div(real(p.ambient_ratio), density));
}

/// Returns `drag (wind - v)`, m/s2.
#[inline(always)]
pub fn wind_drag<R: Real>(u: &StepUniform, velocity: vec3<R>) -> vec3<R> {
    let wind = vec3(real(u.wind[0]), real(u.wind[1]), real(u.wind[2]));
    return (wind - velocity) * real(u.wind[3]);
}

/// Returns a position in the lattice of the acceleration field supplied by the caller, in node spacings from the first
/// node.
#[inline(always)]
pub fn field_place<R: Real>(p: &Parameters, position: vec3<R>) -> vec3<R> {
    let low = vec3(real(p.field_low[0]), real(p.field_low[1]), real(p.field_low[2]));
    return (position - low) * real(p.field_low[3]);
}

/// Returns the interpolation weight of a node: `1 - |distance|` along each axis, in node spacings, and 0 from the next
/// node on. In 2D there is one layer of nodes.
#[inline(always)]
pub fn field_share<R: Real>(m: &Model, place: vec3<R>, node: vec3<R>) -> R {
    let one: R = real(1.0);
    let x = larger(one - abs(place.x - node.x), real(0.0));
    let y = larger(one - abs(place.y - node.y), real(0.0));
    if m.is_3d == 0 {
        return x * y;
    }
    return x * y * larger(one - abs(place.z - node.z), real(0.0));
}

/// Returns the acceleration by neighbours, `internal`, plus gravity and wind, m/s2. The acceleration field supplied by
/// the caller is not included.
#[inline(always)]
pub fn external_close<R: Real>(
    m: &Model,
    p: &Parameters,
    u: &StepUniform,
    internal: vec3<R>,
    velocity: vec3<R>,
    density: R,
) -> vec3<R> {
    if m.has_gravity == 0 {
        if m.has_wind == 0 {
            return flush3(internal);
        }
        return flush3(internal + wind_drag(u, velocity));
    }
    let weighed = internal + weight(m, p, u, density);
    if m.has_wind == 0 {
        return flush3(weighed);
    }
    return flush3(weighed + wind_drag(u, velocity));
}
