//! What one neighbour adds to the force on a particle, and what closes that sum.
use super::geometry::*;
use super::kernel::*;
use super::pressure::*;
use super::viscosity::*;
use crate::arithmetic::real::*;
use crate::layout::{Model, Parameters};

/// What the pair terms know of a particle.
#[derive(Clone, Copy)]
pub struct Local<R> {
    /// Where it is, m.
    pub position: vec3<R>,
    /// How fast it is, m/s.
    pub velocity: vec3<R>,
    /// Pressure, Pa.
    pub pressure: R,
    /// Near pressure, Pa.
    pub near_pressure: R,
    /// Volume it stands for, m3 (m2 in 2D).
    pub volume: R,
}

/// Pressure and near pressure as the factor of `x_ab / r` in the force density on `a`, N/m3.
#[inline(always)]
pub fn pressure_neighbour<R: Real>(m: &Model, p: &Parameters, a: Local<R>, b: Local<R>, q: R) -> R {
    let slope = kernel_slope(m.pressure_kernel, q) * p.pressure_constant;
    let push = pressure_pair(m, a.pressure, b.pressure, a.volume, b.volume, slope);
    if m.near_pressure == 0 {
        return push;
    }
    let near = near_slope(q) * p.near_constant;
    return push + pressure_mueller(a.near_pressure, b.near_pressure, b.volume, near);
}

/// Force density that `b` exerts on `a`, N/m3: pressure, then viscosity.
#[inline(always)]
pub fn force_neighbour<R: Real>(m: &Model, p: &Parameters, a: Local<R>, b: Local<R>) -> vec3<R> {
    let x_ab = a.position - b.position;
    // from the same q^2 by which the loops tell neighbours, so that who is not one adds exact zeros
    let q = root(length2(x_ab) * p.inverse_support_squared);
    let one: R = real(1.0);
    // two particles at one place have no direction: they do not push each other
    let inverse_r = select(real(0.0), div(real(p.inverse_support), q), less(real(0.0), q));
    let push = pressure_neighbour(m, p, a, b, q) * inverse_r;
    // where a pressure is infinite, a zero slope alone would not keep it out
    let pushed = x_ab * select(real(0.0), push, less(q, one));
    if m.viscosity == 0 {
        return pushed;
    }
    let laplacian = viscosity_laplacian(q) * p.viscosity_constant;
    let drag = viscosity_mueller(real(p.dynamic_viscosity), b.volume, laplacian);
    return pushed + (a.velocity - b.velocity) * select(real(0.0), drag, less(q, one));
}

/// Acceleration of `a` (S0 eq. 2.8): the summed force density over its density, and gravity, m/s2.
#[inline(always)]
pub fn acceleration_close<R: Real>(m: &Model, force: vec3<R>, density: R, gravity: vec3<R>) -> vec3<R> {
    let one: R = real(1.0);
    let driven = force * div(one, density);
    if m.gravity == 0 {
        return flush3(driven);
    }
    return flush3(driven + gravity);
}
