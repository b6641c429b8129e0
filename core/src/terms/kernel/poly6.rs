//! Poly6 (Mueller et al. 2003, eq. 20; Pirovano, eq. 2.44, corrected), `(1 - q^2)^3`. The constants are 4 / pi in 2D
//! and 315 / (64 pi) in 3D.
use super::inside;
use crate::arithmetic::real::*;

/// Kernel value, from q^2.
#[inline(always)]
pub fn poly6_w<R: Real>(q2: R) -> R {
    let d = inside(q2);
    return d * d * d;
}

/// Slope `6 q (1 - q^2)^2`.
#[inline(always)]
pub fn poly6_slope<R: Real>(q: R) -> R {
    let d = inside(q * q);
    return q * d * d * 6.0;
}

/// Curvature `6 (1 - q^2) (5 q^2 - 1)`.
#[inline(always)]
pub fn poly6_curvature<R: Real>(q: R) -> R {
    let q2 = q * q;
    return inside(q2) * (q2 * 5.0 - 1.0) * 6.0;
}
