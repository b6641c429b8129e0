//! Wendland 1995, C2 in three dimensions: `(1 - q)^4 (1 + 4 q)`. Its Fourier transform is positive everywhere, so
//! particles do not pair for any number of neighbours (Dehnen and Aly 2012). The constants are 7 / pi in 2D and 21 / (2
//! pi) in 3D.
use super::inside;
use crate::arithmetic::real::*;

/// Kernel value.
#[inline(always)]
pub fn wendland_c2_w<R: Real>(q: R) -> R {
    let d = inside(q);
    let d2 = d * d;
    return d2 * d2 * (q * 4.0 + 1.0);
}

/// Slope `20 q (1 - q)^3`.
#[inline(always)]
pub fn wendland_c2_slope<R: Real>(q: R) -> R {
    let d = inside(q);
    return d * d * d * q * 20.0;
}

/// Curvature `20 (1 - q)^2 (4 q - 1)`.
#[inline(always)]
pub fn wendland_c2_curvature<R: Real>(q: R) -> R {
    let d = inside(q);
    return d * d * (q * 4.0 - 1.0) * 20.0;
}
