//! What a surface does to itself: it pulls itself together. By its curvature, which comes from the colour of a fluid, 1 where its
//! particles are and 0 elsewhere (Morris 1999, 2000; Mueller et al. 2003; Pirovano eqs. 3.8 to 3.11); or by what draws particles of one
//! fluid to each other (Becker and Teschner 2007; Hinsch 2024, section 6.4). A particle sees the colour of its own fluid only, so of an
//! interface of two fluids each has one half of the profile.
use super::geometry::*;
use super::kernel::*;
use super::pair::*;
use super::wall::*;
use crate::arithmetic::real::*;
use crate::layout::{Model, Parameters};

/// None.
pub const NO_TENSION: u32 = 0;
/// Pirovano eqs. 3.8 to 3.11.
pub const CURVATURE: u32 = 1;
/// Morris 2000.
pub const NORMAL_CURVATURE: u32 = 2;
/// Pirovano eq. 3.12, corrected.
pub const ATTRACTION: u32 = 3;
/// Hinsch 2024, section 6.4.
pub const GRADIENT_SUM: u32 = 4;

/// `x` between two particles of one fluid, 0 between others and walls'.
#[inline(always)]
pub fn if_same_fluid<R: Real>(a: Local<R>, b: Local<R>, x: R) -> R {
    // the numbers of fluids are whole, and a wall's 1 or more
    let apart = abs(a.fluid - b.fluid) + b.wall;
    return select(real(0.0), x, less(apart, real(0.5)));
}

/// Slope of the density kernel on a pair as the factor of `x_ab` in `-grad W`, 1/m5 (1/m4 in 2D); exactly 0 for who is no
/// neighbour.
#[inline(always)]
pub fn colour_slope<R: Real>(m: &Model, p: &Parameters, x_ab: vec3<R>, scale: R) -> R {
    let q = root(squared_ratio(m, p, x_ab, scale));
    let slope = slope_scaled(m, kernel_slope(m, m.density_kernel, q), scale) * p.colour_slope_constant;
    return if_inside(q, over_distance(slope * scale * p.inverse_support, q));
}

/// What a neighbour adds to the inward normal `n_a = grad C = sum V_b grad W` (Pirovano eq. 3.9), 1/m.
#[inline(always)]
pub fn colour_gradient<R: Real>(m: &Model, p: &Parameters, a: Local<R>, b: Local<R>) -> vec3<R> {
    let x_ab = separation(m, p, a.position, b.position);
    let slope = colour_slope(m, p, x_ab, pair_scale(m, a.support, b.support));
    return x_ab * -(if_same_fluid(a, b, b.volume * slope));
}

/// What a neighbour adds to the Laplacian of the colour, `sum V_b laplacian W`, 1/m2.
#[inline(always)]
pub fn colour_laplacian<R: Real>(m: &Model, p: &Parameters, a: Local<R>, b: Local<R>) -> R {
    let x_ab = separation(m, p, a.position, b.position);
    let scale = pair_scale(m, a.support, b.support);
    let q = root(squared_ratio(m, p, x_ab, scale));
    // what the kernel has at no distance the particle itself adds once
    let whole = select(real(p.colour_curvature_at_self), kernel_laplacian(m, m.density_kernel, q), less(real(0.0), q));
    let laplacian = laplacian_scaled(m, whole, scale) * p.colour_laplacian_constant;
    return if_same_fluid(a, b, b.volume * if_inside(q, laplacian));
}

/// `y` for a particle whose normal is longer than the threshold, and so is at the surface; else `x`.
#[inline(always)]
pub fn if_at_surface<R: Real>(p: &Parameters, normal: vec3<R>, x: R, y: R) -> R {
    return select(x, y, less(real(p.surface_threshold), root(length2(normal))));
}

/// `n / |n|`, and nothing off the surface.
#[inline(always)]
pub fn unit_normal<R: Real>(p: &Parameters, normal: vec3<R>) -> vec3<R> {
    let nothing: R = real(0.0);
    let one: R = real(1.0);
    let length = root(length2(normal));
    return normal * if_at_surface(p, normal, nothing, div(one, larger(length, real(p.surface_threshold))));
}

/// `kappa = -laplacian C / |n|` (Pirovano eq. 3.10), 1/m: positive where the fluid is convex, 0 off the surface.
#[inline(always)]
pub fn curvature_of_colour<R: Real>(p: &Parameters, normal: vec3<R>, laplacian: R) -> R {
    let nothing: R = real(0.0);
    let length = larger(root(length2(normal)), real(p.surface_threshold));
    return if_at_surface(p, normal, nothing, -(div(laplacian, length)));
}

/// What a neighbour adds to a measure of how unit normals turn along the surface: in `x` the turn
/// `-(n_a - n_b) . t V_b |grad W| / r` along the part t of `x_ab` that lies in the surface, in `y` what it is to be measured by,
/// `t . t V_b |grad W| / r`. Beyond an interface normals point the other way.
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
    // of two particles at the surface, neither of a wall
    let weight = select(nothing, slope, less(b.wall, real(0.5))) * dot3(own_b, own_b);
    return vec3(-(dot3(unit_a - unit_b, along) * weight), dot3(along, along) * weight, nothing);
}

/// `kappa = -div (n / |n|)`, 1/m (Morris 2000). The sums reach as far as there are normals, so their ratio is taken, which of a
/// sphere is exact however far that is; along each of the d - 1 directions in the surface.
#[inline(always)]
pub fn curvature_of_normals<R: Real>(p: &Parameters, normal: vec3<R>, sums: vec3<R>) -> R {
    let nothing: R = real(0.0);
    let turn = select(nothing, div(sums.x, sums.y), less(nothing, sums.y));
    return if_at_surface(p, normal, nothing, turn * p.surface_directions);
}

/// `a = sigma kappa n / rho` (Pirovano eq. 3.11), m/s2.
#[inline(always)]
pub fn tension_close<R: Real>(m: &Model, p: &Parameters, a: Local<R>, normal: vec3<R>, curvature: R) -> vec3<R> {
    let pull = a.tension * curvature * inverse_density(m, p, a);
    return normal * if_at_surface(p, normal, real(0.0), pull);
}

/// `a_a = -(sigma / m_a) sum m_b x_ab W` (Becker and Teschner 2007; Pirovano eq. 3.12, corrected), as a force density, N/m3. Of particles
/// whose masses differ, as with a hydrostatic start, it does not keep momentum.
#[inline(always)]
pub fn attraction<R: Real>(m: &Model, p: &Parameters, a: Local<R>, b: Local<R>) -> vec3<R> {
    let x_ab = separation(m, p, a.position, b.position);
    let scale = pair_scale(m, a.support, b.support);
    let q2 = squared_ratio(m, p, x_ab, scale);
    let w = value_scaled(m, if_inside(q2, kernel_w(m.density_kernel, q2)), scale) * p.colour_constant;
    let pull = a.tension * mass_ratio(m, a, b) * w * local_density(m, p, a);
    return x_ab * -(if_same_fluid(a, b, pull));
}

/// `a_a = sigma V0 sum grad W` (Hinsch 2024, section 6.4, algorithm 2), as a force density, N/m3.
#[inline(always)]
pub fn gradient_sum<R: Real>(m: &Model, p: &Parameters, a: Local<R>, b: Local<R>) -> vec3<R> {
    let x_ab = separation(m, p, a.position, b.position);
    let slope = colour_slope(m, p, x_ab, pair_scale(m, a.support, b.support));
    let pull = a.tension * p.rest_volume * slope * local_density(m, p, a);
    return x_ab * -(if_same_fluid(a, b, pull));
}
