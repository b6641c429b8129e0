//! Smoothing kernels without their constants, as functions of `q = r / support_radius`, zero from q = 1 on.
//! The constants, which depend on the dimension, are computed once (`kernel.rs`, one level up).
use crate::arithmetic::real::*;

/// Poly6: Mueller et al. 2003, eq. 20 (S0 eq. 2.44).
pub const POLY6: u32 = 0;
/// Spiky: Mueller et al. 2003, eq. 21 (S0 eq. 2.45).
pub const SPIKY: u32 = 1;
/// Cubic spline: Monaghan and Lattanzio 1985 (S0 eq. 2.43 per errata; S1 section 6.1.1).
pub const CUBIC_SPLINE: u32 = 2;

/// `1 - q`, cut off at zero.
#[inline(always)]
pub fn inside<R: Real>(q: R) -> R {
    let one: R = real(1.0);
    return larger(one - q, real(0.0));
}

/// Poly6, `(1 - q^2)^3`, from q^2.
#[inline(always)]
pub fn poly6_w<R: Real>(q2: R) -> R {
    let d = inside(q2);
    return d * d * d;
}

/// Its falling slope `-dw/dq = 6 q (1 - q^2)^2`.
#[inline(always)]
pub fn poly6_slope<R: Real>(q: R) -> R {
    let d = inside(q * q);
    return q * d * d * 6.0;
}

/// Spiky, `(1 - q)^3`.
#[inline(always)]
pub fn spiky_w<R: Real>(q: R) -> R {
    let d = inside(q);
    return d * d * d;
}

/// Its falling slope `-dw/dq = 3 (1 - q)^2`.
#[inline(always)]
pub fn spiky_slope<R: Real>(q: R) -> R {
    let d = inside(q);
    return d * d * 3.0;
}

/// Cubic spline, `(2 - s)^3 - 4 (1 - s)^3` with s = 2 q: the textbook's r / h, its support being 2 h.
#[inline(always)]
pub fn cubic_spline_w<R: Real>(q: R) -> R {
    let outer = inside(q) * 2.0;
    let inner = inside(q * 2.0);
    return outer * outer * outer - inner * inner * inner * 4.0;
}

/// Its falling slope `-dw/dq = 6 (2 - s)^2 - 24 (1 - s)^2`.
#[inline(always)]
pub fn cubic_spline_slope<R: Real>(q: R) -> R {
    let outer = inside(q) * 2.0;
    let inner = inside(q * 2.0);
    return outer * outer * 6.0 - inner * inner * 24.0;
}

/// Slope of the near kernel, `(1 - q)^3`: Spiky's with the next power (S0 section 3.1 per errata).
#[inline(always)]
pub fn near_slope<R: Real>(q: R) -> R {
    return spiky_w(q);
}

/// Laplacian of the viscosity kernel, `1 - q`: Mueller et al. 2003, eq. 22 (S0 eq. 2.46).
#[inline(always)]
pub fn viscosity_laplacian<R: Real>(q: R) -> R {
    return inside(q);
}

/// The chosen kernel, from q^2: Poly6 then needs no root.
#[inline(always)]
pub fn kernel_w<R: Real>(kernel: u32, q2: R) -> R {
    if kernel == POLY6 {
        return poly6_w(q2);
    }
    if kernel == SPIKY {
        return spiky_w(root(q2));
    }
    return cubic_spline_w(root(q2));
}

/// Falling slope `-dw/dq` of the chosen kernel.
#[inline(always)]
pub fn kernel_slope<R: Real>(kernel: u32, q: R) -> R {
    if kernel == POLY6 {
        return poly6_slope(q);
    }
    if kernel == SPIKY {
        return spiky_slope(q);
    }
    return cubic_spline_slope(q);
}
