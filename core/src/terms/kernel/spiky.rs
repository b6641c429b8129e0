//! Spiky (Mueller et al. 2003, eq. 21; Pirovano, eq. 2.45, corrected), `(1 - q)^3`. The constants are 10 / pi in 2D and
//! 15 / pi in 3D. The slope does not vanish for close pairs.
use super::inside;
use crate::arithmetic::real::*;

/// Kernel value.
#[inline(always)]
pub fn spiky_w<R: Real>(q: R) -> R {
    let d = inside(q);
    return d * d * d;
}

/// Slope `3 (1 - q)^2`.
#[inline(always)]
pub fn spiky_slope<R: Real>(q: R) -> R {
    let d = inside(q);
    return d * d * 3.0;
}

/// Curvature `6 (1 - q)`.
#[inline(always)]
pub fn spiky_curvature<R: Real>(q: R) -> R {
    return inside(q) * 6.0;
}
