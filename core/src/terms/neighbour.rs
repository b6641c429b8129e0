//! The force of one neighbour on a particle, and the acceleration that follows from the sum of these forces.
use super::correction::*;
use super::geometry::*;
use super::kernel::*;
use super::near::*;
use super::pair::*;
use super::pressure::*;
use super::table::*;
use super::tension::*;
use super::viscosity::*;
use super::wall::*;
use crate::arithmetic::real::*;
use crate::layout::{Model, Parameters, Tables};

/// Returns the pressure force, as the factor of `x_ab / r` in the force density on `a`, N/m3.
#[inline(always)]
pub fn push_of_pressure<R: Real>(m: &Model, p: &Parameters, t: &Tables, a: Local<R>, b: Local<R>, q: R, scale: R) -> R {
    let slope = slope_scaled(m, pressure_slope(m, t, q), scale) * p.pressure_constant;
    let pressure_b = wall_mirrored(m, a.pressure, b.pressure, b.wall);
    return pressure_pair(m, a, pressure_b, neighbour_volume(m, a, b), mass_ratio(m, a, b), slope);
}

/// Returns the near pressure force, as the factor of `x_ab / r` in the force density on `a`, N/m3.
#[inline(always)]
pub fn push_of_near_pressure<R: Real>(m: &Model, p: &Parameters, a: Local<R>, b: Local<R>, q: R, scale: R) -> R {
    if m.near_pressure == NEAR_OFF {
        return real(0.0);
    }
    let slope = slope_scaled(m, near_slope(m, q), scale) * p.near_constant;
    let pressure_b = wall_following(m, a.near_pressure, b.near_pressure, b.wall);
    return pressure_mueller(a.near_pressure, pressure_b, neighbour_volume(m, a, b), slope);
}

/// Returns the sum of both pressure forces, as the factor of `x_ab / r` in the force density on `a`, N/m3. With the
/// pressure correction it is the near pressure force only, because later passes add the corrected pressure.
#[inline(always)]
pub fn push_neighbour<R: Real>(m: &Model, p: &Parameters, t: &Tables, a: Local<R>, b: Local<R>, q: R, scale: R) -> R {
    if m.pressure_solver == PRESSURE_CORRECTION {
        return push_of_near_pressure(m, p, a, b, q, scale);
    }
    let push = push_of_pressure(m, p, t, a, b, q, scale);
    if m.near_pressure == NEAR_OFF {
        return push;
    }
    return push + push_of_near_pressure(m, p, a, b, q, scale);
}

/// Converts a factor of `x_ab / r` to a factor of `x_ab`. The result is exactly 0 where the particles are not
/// neighbours: for an infinite pressure a slope of zero alone would not achieve this.
#[inline(always)]
pub fn along_pair<R: Real>(p: &Parameters, push: R, q: R, scale: R) -> R {
    return if_inside(q, over_distance(push * scale * p.inverse_support, q));
}

/// Returns `V |grad W| / r` of the pressure kernel for a pair, 1/m2 with a volume in m3 (m2 in 2D): then `-x_ab` times
/// it is `V grad W`.
#[inline(always)]
pub fn volume_gradient<R: Real>(
    m: &Model,
    p: &Parameters,
    t: &Tables,
    a: Local<R>,
    b: Local<R>,
    x_ab: vec3<R>,
    volume: R,
) -> R {
    let scale = pair_scale(m, a.support, b.support);
    let q = root(squared_ratio(m, p, x_ab, scale));
    let slope = slope_scaled(m, pressure_slope(m, t, q), scale) * p.pressure_constant;
    return along_pair(p, volume * slope, q, scale);
}

/// Returns the force density of pressure alone on `a`, N/m3.
#[inline(always)]
pub fn pressure_neighbour<R: Real>(m: &Model, p: &Parameters, t: &Tables, a: Local<R>, b: Local<R>) -> vec3<R> {
    let x_ab = separation(m, p, a.position, b.position);
    let scale = pair_scale(m, a.support, b.support);
    let q = root(squared_ratio(m, p, x_ab, scale));
    return x_ab * along_pair(p, push_of_pressure(m, p, t, a, b, q, scale), q, scale);
}

/// Returns the force density of viscosity on `a`, N/m3; exactly 0 where the particles are not neighbours.
#[inline(always)]
pub fn drag_of_pair<R: Real>(
    m: &Model,
    p: &Parameters,
    t: &Tables,
    a: Local<R>,
    b: Local<R>,
    x_ab: vec3<R>,
    q: R,
    scale: R,
) -> vec3<R> {
    let drag = viscosity_pair(m, p, t, a, b, x_ab, q, scale);
    return vec3(if_inside(q, drag.x), if_inside(q, drag.y), if_inside(q, drag.z));
}

/// Returns `push`, or for a wall particle that repels the factor of `x_ab` in the force density of its repulsion.
#[inline(always)]
pub fn push_or_repulsion<R: Real>(
    m: &Model,
    p: &Parameters,
    t: &Tables,
    a: Local<R>,
    b: Local<R>,
    x_ab: vec3<R>,
    push: R,
    q: R,
    scale: R,
) -> R {
    if !repels_directly(m) {
        return push;
    }
    let one: R = real(1.0);
    let density = div(one, inverse_density(m, p, a));
    let strength = density * a.speed_of_sound * a.speed_of_sound * p.wall_rigidity;
    let of_wall = less(real(0.0), b.wall);
    if m.wall_particles == LENNARD_JONES {
        return select(push, if_inside(q, lennard_jones(p, length2(x_ab)) * strength), of_wall);
    }
    // Ten times the strength, so that both forms need about the same rigidity (our choice).
    let value = value_scaled(m, density_kernel(m, t, q * q), scale) * (p.density_constant * 10.0);
    return select(push, along_pair(p, value * strength * p.inverse_support, q, scale), of_wall);
}

/// Returns the force density of pressure and viscosity on `a`, N/m3.
#[inline(always)]
pub fn push_and_drag<R: Real>(m: &Model, p: &Parameters, t: &Tables, a: Local<R>, b: Local<R>) -> vec3<R> {
    let x_ab = separation(m, p, a.position, b.position);
    let scale = pair_scale(m, a.support, b.support);
    // The loops select neighbours by the same q^2, so particles that are not neighbours add exact zeros.
    let q = root(squared_ratio(m, p, x_ab, scale));
    let push = along_pair(p, push_neighbour(m, p, t, a, b, q, scale), q, scale);
    let pushed = x_ab * push_or_repulsion(m, p, t, a, b, x_ab, push, q, scale);
    if m.viscosity == NO_VISCOSITY {
        return pushed;
    }
    if m.viscosity == VELOCITY_EXCHANGE {
        return pushed;
    }
    return pushed + drag_of_pair(m, p, t, a, b, x_ab, q, scale);
}

/// Returns the force density that `b` exerts on `a`, N/m3: pressure, then viscosity, then the attraction between
/// particles of one fluid.
#[inline(always)]
pub fn force_neighbour<R: Real>(m: &Model, p: &Parameters, t: &Tables, a: Local<R>, b: Local<R>) -> vec3<R> {
    let force = push_and_drag(m, p, t, a, b);
    if m.tension == ATTRACTION {
        return force + attraction(m, p, a, b);
    }
    if m.tension == GRADIENT_SUM {
        return force + gradient_sum(m, p, a, b);
    }
    return force;
}

/// Returns the acceleration of `a`, m/s2: the summed force density divided by the density of `a` (Pirovano, eq. 2.8).
#[inline(always)]
pub fn acceleration_close<R: Real>(m: &Model, p: &Parameters, force: vec3<R>, a: Local<R>) -> vec3<R> {
    return force * inverse_density(m, p, a);
}
