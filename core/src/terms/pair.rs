//! What two particles are to each other: the shortest way between them, and their common support.
use super::geometry::*;
use crate::arithmetic::real::*;
use crate::layout::{Model, Parameters};

/// What the pair terms know of a particle.
#[derive(Clone, Copy)]
pub struct Local<R> {
    /// Where it is, m.
    pub position: vec3<R>,
    /// How fast it is, m/s.
    pub velocity: vec3<R>,
    /// Its support radius over the scene's.
    pub support: R,
    /// Its mass over that of a particle of its fluid at rest.
    pub mass: R,
    /// `rho / rho0 - 1`.
    pub deviation: R,
    /// Pressure, Pa.
    pub pressure: R,
    /// Near pressure, Pa.
    pub near_pressure: R,
    /// Volume it stands for, m3 (m2 in 2D).
    pub volume: R,
    /// Dynamic viscosity, Pa s.
    pub viscosity: R,
    /// Larger than 0 for a particle of a wall, or of air that is not there; 0 for a fluid's.
    pub wall: R,
    /// Rest density of its fluid over that of the scene's first.
    pub rest_ratio: R,
    /// Number of its fluid.
    pub fluid: R,
    /// Speed of sound of its fluid at rest, m/s.
    pub speed_of_sound: R,
    /// Number of its equation of state.
    pub state_equation: R,
    /// Surface tension of its fluid.
    pub tension: R,
}

/// What the density pass knows of the receiving particle's fluid beside that.
#[derive(Clone, Copy)]
pub struct Stiffness<R> {
    /// Constant of the equation of state, Pa.
    pub state: R,
    /// Near pressure at rest (thesis), or over the near sum (article), Pa.
    pub near: R,
    /// How much a pressure thins the density around it in a step, over the step's square, 1/(Pa s2).
    pub pressure_response: R,
    /// What an iteration of pressure adds to that, 1/Pa.
    pub response_offset: R,
    /// `1 / (rho0 c0^2)`, 1/Pa.
    pub compressibility: R,
}

/// Do masses differ, by particle or by fluid?
#[inline(always)]
pub fn weighs(m: &Model) -> bool {
    return m.has_variable_mass + m.is_multi_fluid > 0;
}

/// Density over the rest density of the scene's first fluid.
#[inline(always)]
pub fn density_ratio<R: Real>(m: &Model, deviation: R, rest_ratio: R) -> R {
    if m.is_multi_fluid == 0 {
        return deviation + 1.0;
    }
    return (deviation + 1.0) * rest_ratio;
}

/// Density as mass over volume, kg/m3.
#[inline(always)]
pub fn local_density<R: Real>(m: &Model, p: &Parameters, a: Local<R>) -> R {
    if m.has_number_density_volume == 1 {
        return div(a.mass * a.rest_ratio * p.particle_mass, a.volume);
    }
    return density_ratio(m, a.deviation, a.rest_ratio) * p.rest_density;
}

/// One over it: what makes of a force density an acceleration, `F_a / m_a = f_a V_a / m_a`, m3/kg.
#[inline(always)]
pub fn inverse_density<R: Real>(m: &Model, p: &Parameters, a: Local<R>) -> R {
    if m.has_number_density_volume == 1 {
        return div(a.volume, a.mass * a.rest_ratio * p.particle_mass);
    }
    let one: R = real(1.0);
    return div(one, density_ratio(m, a.deviation, a.rest_ratio) * p.rest_density);
}

/// A difference of coordinates, the shorter way round where the axis is periodic.
#[inline(always)]
pub fn nearest<R: Real>(x: R, period: f32, half_period: f32) -> R {
    let half: R = real(half_period);
    let down = select(x, x - period, less(half, x));
    return select(down, down + period, less(down, -half));
}

/// `x_ab = x_a - x_b`, to the nearest image of b in a periodic domain.
#[inline(always)]
pub fn separation<R: Real>(m: &Model, p: &Parameters, x_a: vec3<R>, x_b: vec3<R>) -> vec3<R> {
    let x_ab = x_a - x_b;
    if m.is_periodic == 0 {
        return x_ab;
    }
    let x = nearest(x_ab.x, p.period[0], p.half_period[0]);
    let y = nearest(x_ab.y, p.period[1], p.half_period[1]);
    let z = nearest(x_ab.z, p.period[2], p.half_period[2]);
    return vec3(x, y, z);
}

/// Support of the scene over that of a pair: one symmetric `H_ab = (H_a + H_b) / 2`, so that action is reaction.
#[inline(always)]
pub fn pair_scale<R: Real>(m: &Model, support_a: R, support_b: R) -> R {
    if m.has_variable_support == 0 {
        return real(1.0);
    }
    return div(real(2.0), support_a + support_b);
}

/// `q^2 = (r / H_ab)^2`.
#[inline(always)]
pub fn squared_ratio<R: Real>(m: &Model, p: &Parameters, x_ab: vec3<R>, scale: R) -> R {
    let q2 = length2(x_ab) * p.inverse_support_squared;
    if m.has_variable_support == 0 {
        return q2;
    }
    return q2 * scale * scale;
}

/// A kernel's value on a pair's own support, `1 / H^d`.
#[inline(always)]
pub fn value_scaled<R: Real>(m: &Model, x: R, scale: R) -> R {
    if m.has_variable_support == 0 {
        return x;
    }
    if m.is_3d == 0 {
        return x * scale * scale;
    }
    return x * scale * scale * scale;
}

/// A kernel's slope on a pair's own support, `1 / H^(d + 1)`.
#[inline(always)]
pub fn slope_scaled<R: Real>(m: &Model, x: R, scale: R) -> R {
    if m.has_variable_support == 0 {
        return x;
    }
    return value_scaled(m, x, scale) * scale;
}

/// A kernel's Laplacian on a pair's own support, `1 / H^(d + 2)`.
#[inline(always)]
pub fn laplacian_scaled<R: Real>(m: &Model, x: R, scale: R) -> R {
    if m.has_variable_support == 0 {
        return x;
    }
    return value_scaled(m, x, scale) * scale * scale;
}

/// `x / q`, and 0 where two particles are at one place: they have no direction, so they do not push each other.
#[inline(always)]
pub fn over_distance<R: Real>(x: R, q: R) -> R {
    return select(real(0.0), div(x, q), less(real(0.0), q));
}
