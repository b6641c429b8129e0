//! Lucy 1977 (Gourlay, table 1), `(1 + 3 q) (1 - q)^3`. The constants are 5 / pi in 2D and 105 / (16 pi) in 3D.
use super::inside;
use crate::arithmetic::real::*;

/// Kernel value.
#[inline(always)]
pub fn lucy_w<R: Real>(q: R) -> R {
    let d = inside(q);
    return d * d * d * (q * 3.0 + 1.0);
}

/// Slope `12 q (1 - q)^2`.
#[inline(always)]
pub fn lucy_slope<R: Real>(q: R) -> R {
    let d = inside(q);
    return d * d * q * 12.0;
}

/// Curvature `12 (1 - q) (3 q - 1)`.
#[inline(always)]
pub fn lucy_curvature<R: Real>(q: R) -> R {
    return inside(q) * (q * 3.0 - 1.0) * 12.0;
}
