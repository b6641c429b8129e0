//! Surface tension. It is computed either from the curvature of the surface, which follows from the colour of a fluid,
//! 1 at its particles and 0 elsewhere (Morris 2000; Mueller et al. 2003; Pirovano, eqs. 3.8 to 3.11), or from
//! pairwise forces between particles of one fluid (Becker and Teschner 2007; Hinsch 2024, section 6.4). A particle sees
//! only the colour of its own fluid, so at the interface of two fluids each fluid has one half of the profile.
use super::geometry::*;
use super::kernel::*;
use super::pair::*;
use super::wall::*;
use crate::arithmetic::real::*;
use crate::layout::{Model, Parameters};

/// No surface tension.
pub const NO_TENSION: u32 = 0;
/// Curvature from the Laplacian of the colour (Pirovano, eqs. 3.8 to 3.11).
pub const CURVATURE: u32 = 1;
/// Curvature from the divergence of unit normals (Morris 2000).
pub const NORMAL_CURVATURE: u32 = 2;
/// Attraction between particles of one fluid (Becker and Teschner 2007; Pirovano, eq. 3.12, corrected).
pub const ATTRACTION: u32 = 3;
/// Sum of kernel gradients (Hinsch 2024, section 6.4).
pub const GRADIENT_SUM: u32 = 4;

/// Returns `x` where both particles are of one fluid, and 0 for other pairs and for pairs with a wall particle.
#[inline(always)]
pub fn if_same_fluid<R: Real>(a: Local<R>, b: Local<R>, x: R) -> R {
    // Fluid numbers are integers, and `wall` is at least 1 for a wall particle.
    let apart = abs(a.fluid - b.fluid) + b.wall;
    return select(real(0.0), x, less(apart, real(0.5)));
}

/// Returns the slope of the density kernel for a pair, as the factor of `x_ab` in `-grad W`, 1/m5 (1/m4 in 2D); exactly
/// 0 where the particles are not neighbours.
#[inline(always)]
pub fn colour_slope<R: Real>(m: &Model, p: &Parameters, x_ab: vec3<R>, scale: R) -> R {
    let q = root(squared_ratio(m, p, x_ab, scale));
    let slope = slope_scaled(m, kernel_slope(m, m.density_kernel, q), scale) * p.colour_slope_constant;
    return if_inside(q, over_distance(slope * scale * p.inverse_support, q));
}

/// Returns the contribution of a neighbour to the inward normal `n_a = grad C = sum V_b grad W` (Pirovano, eq. 3.9),
/// 1/m.
#[inline(always)]
pub fn colour_gradient<R: Real>(m: &Model, p: &Parameters, a: Local<R>, b: Local<R>) -> vec3<R> {
    let x_ab = separation(m, p, a.position, b.position);
    let slope = colour_slope(m, p, x_ab, pair_scale(m, a.support, b.support));
    return x_ab * -(if_same_fluid(a, b, b.volume * slope));
}

/// Returns the contribution of a neighbour to the Laplacian of the colour, `sum V_b laplacian W`, 1/m2.
#[inline(always)]
pub fn colour_laplacian<R: Real>(m: &Model, p: &Parameters, a: Local<R>, b: Local<R>) -> R {
    let x_ab = separation(m, p, a.position, b.position);
    let scale = pair_scale(m, a.support, b.support);
    let q = root(squared_ratio(m, p, x_ab, scale));
    // At q = 0 the particle itself adds the Laplacian of the kernel at its centre.
    let whole = select(real(p.colour_curvature_at_self), kernel_laplacian(m, m.density_kernel, q), less(real(0.0), q));
    let laplacian = laplacian_scaled(m, whole, scale) * p.colour_laplacian_constant;
    return if_same_fluid(a, b, b.volume * if_inside(q, laplacian));
}

/// Returns `y` for a particle at the surface, whose normal is longer than the threshold, else `x`.
#[inline(always)]
pub fn if_at_surface<R: Real>(p: &Parameters, normal: vec3<R>, x: R, y: R) -> R {
    return select(x, y, less(real(p.surface_threshold), root(length2(normal))));
}

/// Returns the unit normal `n / |n|`, or 0 for a particle that is not at the surface.
#[inline(always)]
pub fn unit_normal<R: Real>(p: &Parameters, normal: vec3<R>) -> vec3<R> {
    let nothing: R = real(0.0);
    let one: R = real(1.0);
    let length = root(length2(normal));
    return normal * if_at_surface(p, normal, nothing, div(one, larger(length, real(p.surface_threshold))));
}

/// Returns `kappa = -laplacian C / |n|` (Pirovano, eq. 3.10), 1/m: positive where the fluid is convex, and 0 for a
/// particle that is not at the surface.
#[inline(always)]
pub fn curvature_of_colour<R: Real>(p: &Parameters, normal: vec3<R>, laplacian: R) -> R {
    let nothing: R = real(0.0);
    let length = larger(root(length2(normal)), real(p.surface_threshold));
    return if_at_surface(p, normal, nothing, -(div(laplacian, length)));
}

/// Returns the contribution of a neighbour to two sums that measure how unit normals turn along the surface. Let t be
/// the part of `x_ab` in the surface. The x component is the turn, `-(n_a - n_b) . t V_b |grad W| / r`, and the y
/// component is its reference, `t . t V_b |grad W| / r`. The normal of a neighbour in another fluid is reversed,
/// because beyond an interface normals point the other way.
#[inline(always)]
pub fn normal_divergence<R: Real>(
    m: &Model,
    p: &Parameters,
    a: Local<R>,
    b: Local<R>,
    normal_a: vec3<R>,
    normal_b: vec3<R>,
) -> vec3<R> {
    let nothing: R = real(0.0);
    let unit_a = unit_normal(p, normal_a);
    let own_b = unit_normal(p, normal_b);
    let unit_b = own_b * (if_same_fluid(a, b, real(2.0)) - 1.0);
    let x_ab = separation(m, p, a.position, b.position);
    let along = x_ab - unit_a * dot3(x_ab, unit_a);
    let slope = colour_slope(m, p, x_ab, pair_scale(m, a.support, b.support)) * b.volume;
    // Only pairs of particles at the surface count, and wall particles do not.
    let weight = select(nothing, slope, less(b.wall, real(0.5))) * dot3(own_b, own_b);
    return vec3(-(dot3(unit_a - unit_b, along) * weight), dot3(along, along) * weight, nothing);
}

/// Returns `kappa = -div (n / |n|)`, 1/m (Morris 2000): the ratio of the two sums, times the d - 1 directions in the
/// surface. The sums extend only as far as there are normals; whatever that distance is, their ratio is exact for a
/// sphere.
#[inline(always)]
pub fn curvature_of_normals<R: Real>(p: &Parameters, normal: vec3<R>, sums: vec3<R>) -> R {
    let nothing: R = real(0.0);
    let turn = select(nothing, div(sums.x, sums.y), less(nothing, sums.y));
    return if_at_surface(p, normal, nothing, turn * p.surface_directions);
}

/// Returns the acceleration `a = sigma kappa n / rho` (Pirovano, eq. 3.11), m/s2.
#[inline(always)]
pub fn tension_close<R: Real>(m: &Model, p: &Parameters, a: Local<R>, normal: vec3<R>, curvature: R) -> vec3<R> {
    let pull = a.tension * curvature * inverse_density(m, p, a);
    return normal * if_at_surface(p, normal, real(0.0), pull);
}

/// Returns the contribution of a neighbour to `a_a = -(sigma / m_a) sum m_b x_ab W` (Becker and Teschner 2007;
/// Pirovano, eq. 3.12, corrected), as a force density, N/m3. Between particles of different masses, as with a
/// hydrostatic start, it does not conserve momentum.
#[inline(always)]
pub fn attraction<R: Real>(m: &Model, p: &Parameters, a: Local<R>, b: Local<R>) -> vec3<R> {
    let x_ab = separation(m, p, a.position, b.position);
    let scale = pair_scale(m, a.support, b.support);
    let q2 = squared_ratio(m, p, x_ab, scale);
    let w = value_scaled(m, if_inside(q2, kernel_w(m.density_kernel, q2)), scale) * p.colour_constant;
    let pull = a.tension * mass_ratio(m, a, b) * w * local_density(m, p, a);
    return x_ab * -(if_same_fluid(a, b, pull));
}

/// Returns the contribution of a neighbour to `a_a = sigma V0 sum grad W` (Hinsch 2024, section 6.4, algorithm 2), as a
/// force density, N/m3.
#[inline(always)]
pub fn gradient_sum<R: Real>(m: &Model, p: &Parameters, a: Local<R>, b: Local<R>) -> vec3<R> {
    let x_ab = separation(m, p, a.position, b.position);
    let slope = colour_slope(m, p, x_ab, pair_scale(m, a.support, b.support));
    let pull = a.tension * p.rest_volume * slope * local_density(m, p, a);
    return x_ab * -(if_same_fluid(a, b, pull));
}
