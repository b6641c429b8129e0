//! Spiky, `(1 - q)^3`: Mueller et al. 2003, eq. 21 (Pirovano eq. 2.45, corrected). Constants 10 / pi in 2D, 15 / pi in 3D. Its
//! slope does not vanish for close pairs.
use super::inside;
use crate::arithmetic::real::*;

/// The value.
#[inline(always)]
pub fn spiky_w<R: Real>(q: R) -> R {
    let d = inside(q);
    return d * d * d;
}

/// `3 (1 - q)^2`.
#[inline(always)]
pub fn spiky_slope<R: Real>(q: R) -> R {
    let d = inside(q);
    return d * d * 3.0;
}

/// `6 (1 - q)`.
#[inline(always)]
pub fn spiky_curvature<R: Real>(q: R) -> R {
    return inside(q) * 6.0;
}
