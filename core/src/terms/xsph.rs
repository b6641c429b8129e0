//! XSPH (Monaghan 1989; Pirovano, eq. 2.16, corrected; Roy): a particle moves with a velocity closer to that of its
//! neighbours.
use super::geometry::*;
use super::kernel::*;
use super::pair::*;
use super::table::*;
use super::wall::*;
use crate::arithmetic::real::*;
use crate::layout::{Model, Parameters, Tables};

/// Returns the contribution of a neighbour to `eta sum m_b / rho_mean_ab (v_b - v_a) W_ab`, m/s. Eta and the constants
/// are applied to the whole sum.
#[inline(always)]
pub fn xsph_neighbour<R: Real>(m: &Model, p: &Parameters, t: &Tables, a: Local<R>, b: Local<R>) -> vec3<R> {
    let x_ab = separation(m, p, a.position, b.position);
    let scale = pair_scale(m, a.support, b.support);
    let q2 = squared_ratio(m, p, x_ab, scale);
    let w = value_scaled(m, density_kernel(m, t, q2), scale);
    let both = density_ratio(m, a.deviation, a.rest_ratio) + density_seen(m, a, b);
    let mass = mass_seen(m, a.rest_ratio, b.mass, b.rest_ratio, b.wall);
    return (b.velocity - a.velocity) * if_inside(q2, div(w * mass * 2.0, both));
}

/// Returns the velocity with which a particle moves in addition to its own, m/s.
#[inline(always)]
pub fn xsph_close<R: Real>(p: &Parameters, sum: vec3<R>) -> vec3<R> {
    return flush3(sum * real(p.xsph_constant));
}
