//! The density kernel of Clavet et al. 2005 (the near pair of Gourlay), `(1 - q)^2`.
use super::{if_inside, inside};
use crate::arithmetic::real::*;

/// Kernel value.
#[inline(always)]
pub fn clavet_w<R: Real>(q: R) -> R {
    let d = inside(q);
    return d * d;
}

/// Slope `2 (1 - q)`.
#[inline(always)]
pub fn clavet_slope<R: Real>(q: R) -> R {
    return inside(q) * 2.0;
}

/// Curvature, 2 inside the support.
#[inline(always)]
pub fn clavet_curvature<R: Real>(q: R) -> R {
    return if_inside(q, real(2.0));
}
