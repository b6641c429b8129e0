//! Variable smoothing length (Pirovano, eq. 4.2, corrected): the support radius follows the density, so that the number
//! of neighbours stays the same.
use crate::arithmetic::real::*;
use crate::layout::{Model, Parameters};

/// Returns the next iterate of Newton's method for `y^3 = x`.
#[inline(always)]
pub fn cube_root_step<R: Real>(y: R, x: R) -> R {
    return (y * 2.0 + div(x, y * y)) * 0.33333334;
}

/// Returns `x^(1/3)` for x between 0.1 and 10, accurate to the last bits of f32. The built-in functions of Rust and
/// WGSL do not agree bit for bit.
#[inline(always)]
pub fn cube_root<R: Real>(x: R) -> R {
    let y = x * 0.33333334 + 0.6666667;
    let y2 = cube_root_step(cube_root_step(y, x), x);
    let y4 = cube_root_step(cube_root_step(y2, x), x);
    return cube_root_step(cube_root_step(y4, x), x);
}

/// Returns `H_a / H = (rho0 / rho_a)^(1/d)`, limited to the bounds of the scene.
#[inline(always)]
pub fn support_close<R: Real>(m: &Model, p: &Parameters, deviation: R) -> R {
    let one: R = real(1.0);
    // With an empty neighbourhood the support radius would exceed every bound.
    let ratio = div(one, larger(deviation + 1.0, real(0.1)));
    if m.is_3d == 0 {
        return smaller(larger(root(ratio), real(p.smallest_support)), real(p.largest_support));
    }
    return smaller(larger(cube_root(smaller(ratio, real(10.0))), real(p.smallest_support)), real(p.largest_support));
}
