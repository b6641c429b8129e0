//! The Gaussian (Gingold and Monaghan 1977; Pirovano, eq. 2.42; Gourlay, table 1), `exp(-9 q^2)`. It is cut off at
//! q = 1, where its value is e^-9, and normalised with that cutoff.
use super::if_inside;
use crate::arithmetic::real::*;

/// Returns `exp(-y)` for y from 0 to 9, with a relative error of about 2e-6: the series of `exp(y / 32)`, to the power
/// of -32. The built-in exponentials of Rust and WGSL do not agree bit for bit.
#[inline(always)]
pub fn exp_of_minus<R: Real>(y: R) -> R {
    let one: R = real(1.0);
    let x = y * 0.03125;
    let tail = x * 0.0013888889 + 0.008333334;
    let series = ((((tail * x + 0.041666668) * x + 0.16666667) * x + 0.5) * x + 1.0) * x + 1.0;
    let e2 = series * series;
    let e4 = e2 * e2;
    let e8 = e4 * e4;
    let e16 = e8 * e8;
    return div(one, e16 * e16);
}

/// Kernel value, from q^2.
#[inline(always)]
pub fn gaussian_w<R: Real>(q2: R) -> R {
    return if_inside(q2, exp_of_minus(q2 * 9.0));
}

/// Slope `18 q exp(-9 q^2)`.
#[inline(always)]
pub fn gaussian_slope<R: Real>(q: R) -> R {
    return gaussian_w(q * q) * q * 18.0;
}

/// Curvature `(324 q^2 - 18) exp(-9 q^2)`.
#[inline(always)]
pub fn gaussian_curvature<R: Real>(q: R) -> R {
    let q2 = q * q;
    return gaussian_w(q2) * (q2 * 324.0 - 18.0);
}
