//! Wendland 1995, C4 in three dimensions: 3 times `(1 - q)^6 (1 + 6 q + 35/3 q^2)`. The constants are divided by this
//! factor 3: they are 3 / pi in 2D and 165 / (32 pi) in 3D.
use super::inside;
use crate::arithmetic::real::*;

/// Kernel value.
#[inline(always)]
pub fn wendland_c4_w<R: Real>(q: R) -> R {
    let d = inside(q);
    let d2 = d * d;
    return d2 * d2 * d2 * ((q * 35.0 + 18.0) * q + 3.0);
}

/// Slope `56 q (1 + 5 q) (1 - q)^5`.
#[inline(always)]
pub fn wendland_c4_slope<R: Real>(q: R) -> R {
    let d = inside(q);
    let d2 = d * d;
    return d2 * d2 * d * (q * 5.0 + 1.0) * q * 56.0;
}

/// Curvature `56 (1 - q)^4 (35 q^2 - 4 q - 1)`.
#[inline(always)]
pub fn wendland_c4_curvature<R: Real>(q: R) -> R {
    let d = inside(q);
    let d2 = d * d;
    return d2 * d2 * ((q * 35.0 - 4.0) * q - 1.0) * 56.0;
}
