//! Renormalised gradients: sums over kernel gradients, multiplied by a matrix that makes them exact for linear fields
//! however the neighbours are arranged (Randles and Libersky 1996; Bonet and Lok 1999). The smallest eigenvalue lambda
//! of the inverse of this matrix shows how close a particle is to a free surface: it is 1 inside the fluid, and 0 for a
//! particle without neighbours (Marrone et al. 2010).
//!
//! The inverse is `sum V_b |grad W| / r x_ab x_ab`. It is symmetric, and given by its diagonal (xx, yy, zz) and the
//! rest (xy, xz, yz).
use super::density::*;
use super::geometry::*;
use super::neighbour::*;
use super::pair::*;
use crate::arithmetic::real::*;
use crate::layout::{Model, Parameters, Tables};

/// Returns `V_b |grad W| / r` of a neighbour, 1/m2. It is 0 for a neighbour in another fluid, whose particles end this
/// one as a free surface does, unless particles are to be shifted across interfaces. `a` and `b` have the densities of
/// the previous step.
#[inline(always)]
pub fn gradient_weight<R: Real>(m: &Model, p: &Parameters, t: &Tables, a: Local<R>, b: Local<R>, x_ab: vec3<R>) -> R {
    let volume = volume_close(p, b.mass, b.deviation);
    return if_same_body(m, a, b, volume_gradient(m, p, t, a, b, x_ab, volume));
}

/// Returns a number above 0 for a neighbour in another fluid, and 0 for one in the same fluid and for a wall particle.
#[inline(always)]
pub fn apart_by_fluid<R: Real>(a: Local<R>, b: Local<R>) -> R {
    let nothing: R = real(0.0);
    return select(abs(a.fluid - b.fluid), nothing, less(nothing, b.wall));
}

/// Returns `x` for a neighbour in the same fluid and for a wall particle. For a neighbour in another fluid it returns
/// 0, unless particles are to be shifted across interfaces.
#[inline(always)]
pub fn if_same_body<R: Real>(m: &Model, a: Local<R>, b: Local<R>, x: R) -> R {
    if m.is_multi_fluid == 0 || m.shifts_interfaces == 1 {
        return x;
    }
    let nothing: R = real(0.0);
    return select(x, nothing, less(nothing, apart_by_fluid(a, b)));
}

/// Returns the diagonal of a neighbour's contribution to the inverse of the matrix; `weight` is the
/// [`gradient_weight`].
#[inline(always)]
pub fn inverse_diagonal<R: Real>(x_ab: vec3<R>, weight: R) -> vec3<R> {
    return vec3(x_ab.x * x_ab.x * weight, x_ab.y * x_ab.y * weight, x_ab.z * x_ab.z * weight);
}

/// Returns the rest of a neighbour's contribution to the inverse of the matrix.
#[inline(always)]
pub fn inverse_mixed<R: Real>(x_ab: vec3<R>, weight: R) -> vec3<R> {
    return vec3(x_ab.x * x_ab.y * weight, x_ab.x * x_ab.z * weight, x_ab.y * x_ab.z * weight);
}

/// Returns the contribution of a neighbour to `sum V_b (e_b - e_a) grad W`, the gradient of the density deviation
/// before it is renormalised, 1/m. Only neighbours of the same fluid and wall particles count.
#[inline(always)]
pub fn deviation_gradient<R: Real>(m: &Model, a: Local<R>, b: Local<R>, x_ab: vec3<R>, weight: R) -> vec3<R> {
    let nothing: R = real(0.0);
    let difference = (a.deviation - b.deviation) * weight;
    if m.is_multi_fluid == 0 {
        return x_ab * difference;
    }
    return x_ab * select(difference, nothing, less(nothing, apart_by_fluid(a, b)));
}

/// Returns a step of Newton's method towards the smallest root of `x^3 - 3 x = 2 r`, from its left.
#[inline(always)]
pub fn root_step<R: Real>(x: R, r: R) -> R {
    let x2 = x * x;
    let miss = (x2 - 3.0) * x - r * 2.0;
    // the slope vanishes where two roots coincide
    return x - div(miss, larger((x2 - 1.0) * 3.0, real(0.001)));
}

/// Returns the determinant of a symmetric matrix.
#[inline(always)]
pub fn symmetric_determinant<R: Real>(d: vec3<R>, o: vec3<R>) -> R {
    let first = d.x * (d.y * d.z - o.z * o.z);
    let second = o.x * (o.x * d.z - o.z * o.y);
    let third = o.y * (o.x * o.z - d.y * o.y);
    return first - second + third;
}

/// Returns the smallest eigenvalue of a symmetric matrix, exact in 2D. In 3D it is `mean + spread x`, where x is the
/// smallest root of a cubic equation (Smith 1961), which Newton's method finds without the functions sine and arc
/// cosine; the error is at most 0.04 of the spread, and that only where the two smallest eigenvalues coincide.
#[inline(always)]
pub fn smallest_eigenvalue<R: Real>(m: &Model, d: vec3<R>, o: vec3<R>) -> R {
    if m.is_3d == 0 {
        let half = (d.x - d.y) * 0.5;
        return (d.x + d.y) * 0.5 - root(half * half + o.x * o.x);
    }
    let mean = (d.x + d.y + d.z) * 0.33333334;
    let e = vec3(d.x - mean, d.y - mean, d.z - mean);
    let spread = root((length2(e) + length2(o) * 2.0) * 0.16666667);
    let cube = larger(spread * spread * spread, real(0.000000000001));
    let one: R = real(1.0);
    let r = smaller(larger(div(symmetric_determinant(e, o) * 0.5, cube), -one), one);
    let x2 = root_step(root_step(real(-2.0), r), r);
    let x4 = root_step(root_step(x2, r), r);
    return mean + spread * root_step(x4, r);
}

/// Returns a gradient multiplied by the matrix. Where lambda is below 0.1 the matrix would magnify errors too much, and
/// the gradient is returned as it is.
#[inline(always)]
pub fn renormalised<R: Real>(m: &Model, d: vec3<R>, o: vec3<R>, lambda: R, gradient: vec3<R>) -> vec3<R> {
    let least: R = real(0.1);
    let one: R = real(1.0);
    // with a 1 for the missing direction the formulas of 3D hold in 2D
    let flat = vec3(d.x, d.y, d.z + one);
    let full = select_in_3d(m, d, flat);
    let inverse = div(one, larger(symmetric_determinant(full, o), real(0.0001)));
    let xx = full.y * full.z - o.z * o.z;
    let yy = full.x * full.z - o.y * o.y;
    let zz = full.x * full.y - o.x * o.x;
    let xy = o.y * o.z - o.x * full.z;
    let xz = o.x * o.z - o.y * full.y;
    let yz = o.x * o.y - o.z * full.x;
    let x = dot3(vec3(xx, xy, xz), gradient) * inverse;
    let y = dot3(vec3(xy, yy, yz), gradient) * inverse;
    let z = dot3(vec3(xz, yz, zz), gradient) * inverse;
    let is_poor = less(lambda, least);
    return flush3(vec3(
        select(x, gradient.x, is_poor),
        select(y, gradient.y, is_poor),
        select(z, gradient.z, is_poor),
    ));
}

/// Returns `in_3d` in 3D, else `in_2d`.
#[inline(always)]
pub fn select_in_3d<R: Real>(m: &Model, in_3d: vec3<R>, in_2d: vec3<R>) -> vec3<R> {
    if m.is_3d == 1 {
        return in_3d;
    }
    return in_2d;
}

/// Returns how far inside the fluid a particle is: 0 at a free surface and in the rows beside it, 1 further inside. On
/// a lattice lambda is 0.5 in the first row and 0.8 in the second (with 32 neighbours in 2D), and above 0.95 inside.
#[inline(always)]
pub fn inside_share<R: Real>(lambda: R) -> R {
    return smaller(larger((lambda - 0.8) * 6.6666665, real(0.0)), real(1.0));
}
