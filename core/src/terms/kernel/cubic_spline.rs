//! Cubic spline (Monaghan and Lattanzio 1985; Pirovano, eq. 2.43, corrected; Hinsch 2024, section 4.1):
//! `(2 - s)^3 - 4 (1 - s)^3` with s = 2 q. This s is the r / h of textbooks, whose support radius is 2 h. Hinsch's
//! constants are 1 / (6 h), 5 / (14 pi h^2) and 1 / (4 pi h^3).
use super::inside;
use crate::arithmetic::real::*;

/// Kernel value.
#[inline(always)]
pub fn cubic_spline_w<R: Real>(q: R) -> R {
    let outer = inside(q) * 2.0;
    let inner = inside(q * 2.0);
    return outer * outer * outer - inner * inner * inner * 4.0;
}

/// Slope `6 (2 - s)^2 - 24 (1 - s)^2`.
#[inline(always)]
pub fn cubic_spline_slope<R: Real>(q: R) -> R {
    let outer = inside(q) * 2.0;
    let inner = inside(q * 2.0);
    return outer * outer * 6.0 - inner * inner * 24.0;
}

/// Curvature `24 (2 - s) - 96 (1 - s)`.
#[inline(always)]
pub fn cubic_spline_curvature<R: Real>(q: R) -> R {
    let outer = inside(q) * 2.0;
    let inner = inside(q * 2.0);
    return outer * 24.0 - inner * 96.0;
}
