//! What one neighbour adds to the force on a particle, and what closes that sum.
use super::correction::*;
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

/// Pressure as the factor of `x_ab / r` in the force density on `a`, N/m3.
#[inline(always)]
pub fn push_of_pressure<R: Real>(m: &Model, p: &Parameters, t: &Tables, a: Local<R>, b: Local<R>, q: R, scale: R) -> R {
    let slope = slope_scaled(m, pressure_slope(m, t, q), scale) * p.pressure_constant;
    let pressure_b = wall_mirrored(m, a.pressure, b.pressure, b.wall);
    return pressure_pair(m, a, pressure_b, neighbour_volume(m, a, b), mass_ratio(m, a, b), slope);
}

/// Near pressure, likewise, N/m3.
#[inline(always)]
pub fn push_of_near_pressure<R: Real>(m: &Model, p: &Parameters, a: Local<R>, b: Local<R>, q: R, scale: R) -> R {
    if m.near_pressure == NEAR_OFF {
        return real(0.0);
    }
    let slope = slope_scaled(m, near_slope(m, q), scale) * p.near_constant;
    let pressure_b = wall_mirrored(m, a.near_pressure, b.near_pressure, b.wall);
    return pressure_mueller(a.near_pressure, pressure_b, neighbour_volume(m, a, b), slope);
}

/// Both, likewise; a correction of pressure comes later, in passes of its own.
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

/// From the factor of `x_ab / r` to that of `x_ab`, exactly 0 for who is no neighbour: where a pressure is infinite, a zero
/// slope alone would not keep it out.
#[inline(always)]
pub fn along_pair<R: Real>(p: &Parameters, push: R, q: R, scale: R) -> R {
    return if_inside(q, over_distance(push * scale * p.inverse_support, q));
}

/// Force density by which pressure alone acts on `a`, N/m3.
#[inline(always)]
pub fn pressure_neighbour<R: Real>(m: &Model, p: &Parameters, t: &Tables, a: Local<R>, b: Local<R>) -> vec3<R> {
    let x_ab = separation(m, p, a.position, b.position);
    let scale = pair_scale(m, a.support, b.support);
    let q = root(squared_ratio(m, p, x_ab, scale));
    return x_ab * along_pair(p, push_of_pressure(m, p, t, a, b, q, scale), q, scale);
}

/// Force density by which viscosity acts on `a`, N/m3, exactly 0 for who is no neighbour.
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

/// Pressure and viscosity, N/m3.
#[inline(always)]
pub fn push_and_drag<R: Real>(m: &Model, p: &Parameters, t: &Tables, a: Local<R>, b: Local<R>) -> vec3<R> {
    let x_ab = separation(m, p, a.position, b.position);
    let scale = pair_scale(m, a.support, b.support);
    // from the same q^2 by which the loops tell neighbours, so that who is not one adds exact zeros
    let q = root(squared_ratio(m, p, x_ab, scale));
    let pushed = x_ab * along_pair(p, push_neighbour(m, p, t, a, b, q, scale), q, scale);
    if m.viscosity == NO_VISCOSITY {
        return pushed;
    }
    if m.viscosity == VELOCITY_EXCHANGE {
        return pushed;
    }
    return pushed + drag_of_pair(m, p, t, a, b, x_ab, q, scale);
}

/// Force density that `b` exerts on `a`, N/m3: pressure, then viscosity, then what draws particles of one fluid together.
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

/// Acceleration of `a` (Pirovano eq. 2.8): the summed force density over its density, m/s2.
#[inline(always)]
pub fn acceleration_close<R: Real>(m: &Model, p: &Parameters, force: vec3<R>, a: Local<R>) -> vec3<R> {
    return force * inverse_density(m, p, a);
}
