//! Quantities of a pair of particles: the separation to the nearest image, and the common support radius.
use super::geometry::*;
use crate::arithmetic::real::*;
use crate::layout::{Model, Parameters};

/// The properties of a particle that the pair terms use.
#[derive(Clone, Copy)]
pub struct Local<R> {
    /// Position, m.
    pub position: vec3<R>,
    /// Velocity, m/s.
    pub velocity: vec3<R>,
    /// Support radius over that of the scene.
    pub support: R,
    /// Mass over that of a particle of the same fluid at rest.
    pub mass: R,
    /// Density deviation `rho / rho0 - 1`.
    pub deviation: R,
    /// Pressure, Pa.
    pub pressure: R,
    /// Near pressure, Pa.
    pub near_pressure: R,
    /// Volume, m3 (m2 in 2D).
    pub volume: R,
    /// Dynamic viscosity, Pa s.
    pub viscosity: R,
    /// Greater than 0 for a wall particle or an inactive air particle, 0 for a fluid particle.
    pub wall: R,
    /// Rest density of its fluid over that of the scene's first fluid.
    pub rest_ratio: R,
    /// Number of its fluid.
    pub fluid: R,
    /// Speed of sound of its fluid at rest, m/s.
    pub speed_of_sound: R,
    /// Number of its fluid's equation of state.
    pub state_equation: R,
    /// Surface tension of its fluid, in the unit of the chosen form.
    pub tension: R,
}

/// Further constants of the receiving particle's fluid, for density and the pressure correction.
#[derive(Clone, Copy)]
pub struct Stiffness<R> {
    /// Constant of the equation of state, Pa.
    pub state: R,
    /// Near pressure at rest (density-proportional) or over the near density sum (double density), Pa.
    pub near: R,
    /// Relative decrease of density that 1 Pa causes around a particle in a step, over the squared time step,
    /// 1/(Pa s2).
    pub pressure_response: R,
    /// Offset added to that decrease in an iteration of the pressure, 1/Pa.
    pub response_offset: R,
    /// `1 / (rho0 c0^2)`, 1/Pa.
    pub compressibility: R,
}

/// Returns whether masses differ between particles or between fluids.
#[inline(always)]
pub fn weighs(m: &Model) -> bool {
    return m.has_variable_mass + m.is_multi_fluid > 0;
}

/// Returns the density over the rest density of the scene's first fluid.
#[inline(always)]
pub fn density_ratio<R: Real>(m: &Model, deviation: R, rest_ratio: R) -> R {
    if m.is_multi_fluid == 0 {
        return deviation + 1.0;
    }
    return (deviation + 1.0) * rest_ratio;
}

/// Returns the density, mass over volume, kg/m3.
#[inline(always)]
pub fn local_density<R: Real>(m: &Model, p: &Parameters, a: Local<R>) -> R {
    if m.has_number_density_volume == 1 {
        return div(a.mass * a.rest_ratio * p.particle_mass, a.volume);
    }
    return density_ratio(m, a.deviation, a.rest_ratio) * p.rest_density;
}

/// Returns the inverse density, m3/kg. It converts a force density to an acceleration, `F_a / m_a = f_a V_a / m_a`.
#[inline(always)]
pub fn inverse_density<R: Real>(m: &Model, p: &Parameters, a: Local<R>) -> R {
    if m.has_number_density_volume == 1 {
        return div(a.volume, a.mass * a.rest_ratio * p.particle_mass);
    }
    let one: R = real(1.0);
    return div(one, density_ratio(m, a.deviation, a.rest_ratio) * p.rest_density);
}

/// Returns a difference of coordinates, taken the shorter way round where the axis is periodic.
#[inline(always)]
pub fn nearest<R: Real>(x: R, period: f32, half_period: f32) -> R {
    let half: R = real(half_period);
    let down = select(x, x - period, less(half, x));
    return select(down, down + period, less(down, -half));
}

/// Returns `x_ab = x_a - x_b`, taken to the nearest image of b in a periodic domain.
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

/// Returns the support radius of the scene over that of a pair. The pair has one symmetric `H_ab = (H_a + H_b) / 2`, so
/// that its forces are equal and opposite.
#[inline(always)]
pub fn pair_scale<R: Real>(m: &Model, support_a: R, support_b: R) -> R {
    if m.has_variable_support == 0 {
        return real(1.0);
    }
    return div(real(2.0), support_a + support_b);
}

/// Returns `q^2 = (r / H_ab)^2`.
#[inline(always)]
pub fn squared_ratio<R: Real>(m: &Model, p: &Parameters, x_ab: vec3<R>, scale: R) -> R {
    let q2 = length2(x_ab) * p.inverse_support_squared;
    if m.has_variable_support == 0 {
        return q2;
    }
    return q2 * scale * scale;
}

/// Scales a kernel value to the pair's support radius, `1 / H^d`.
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

/// Scales a kernel slope to the pair's support radius, `1 / H^(d + 1)`.
#[inline(always)]
pub fn slope_scaled<R: Real>(m: &Model, x: R, scale: R) -> R {
    if m.has_variable_support == 0 {
        return x;
    }
    return value_scaled(m, x, scale) * scale;
}

/// Scales a kernel Laplacian to the pair's support radius, `1 / H^(d + 2)`.
#[inline(always)]
pub fn laplacian_scaled<R: Real>(m: &Model, x: R, scale: R) -> R {
    if m.has_variable_support == 0 {
        return x;
    }
    return value_scaled(m, x, scale) * scale * scale;
}

/// Returns `x / q`, or 0 where two particles coincide: the pair has no direction, so they exert no force on each other.
#[inline(always)]
pub fn over_distance<R: Real>(x: R, q: R) -> R {
    return select(real(0.0), div(x, q), less(real(0.0), q));
}
