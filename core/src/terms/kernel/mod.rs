//! Smoothing kernels without their constants, as functions of `q = r / support_radius`, zero from q = 1 on. Each kernel
//! has a value w, a slope `-dw/dq`, which is positive where the kernel falls, and a curvature `d2w/dq2`. The constants
//! depend on the dimension and are computed by quadrature (`derive/kernel_constants.rs`).
use crate::arithmetic::real::*;
use crate::layout::Model;

pub mod clavet;
pub mod cubic_spline;
pub mod gaussian;
pub mod lucy;
pub mod poly6;
pub mod spiky;
pub mod viscosity;
pub mod wendland_c2;
pub mod wendland_c4;
texts!(clavet cubic_spline gaussian lucy poly6 spiky viscosity wendland_c2 wendland_c4);

use clavet::*;
use cubic_spline::*;
use gaussian::*;
use lucy::*;
use poly6::*;
use spiky::*;
use viscosity::*;
use wendland_c2::*;
use wendland_c4::*;

/// The [`poly6`] kernel.
pub const POLY6: u32 = 0;
/// The [`spiky`] kernel.
pub const SPIKY: u32 = 1;
/// The [`cubic_spline`] kernel.
pub const CUBIC_SPLINE: u32 = 2;
/// The [`gaussian`] kernel.
pub const GAUSSIAN: u32 = 3;
/// The [`lucy`] kernel.
pub const LUCY: u32 = 4;
/// The [`viscosity`] kernel.
pub const VISCOSITY: u32 = 5;
/// The [`clavet`] kernel.
pub const CLAVET: u32 = 6;
/// The [`wendland_c2`] kernel.
pub const WENDLAND_C2: u32 = 7;
/// The [`wendland_c4`] kernel.
pub const WENDLAND_C4: u32 = 8;

/// Returns `1 - q`, or 0 where that is negative.
#[inline(always)]
pub fn inside<R: Real>(q: R) -> R {
    let one: R = real(1.0);
    return larger(one - q, real(0.0));
}

/// Returns `x` inside the support, 0 from its edge on.
#[inline(always)]
pub fn if_inside<R: Real>(q: R, x: R) -> R {
    return select(real(0.0), x, less(q, real(1.0)));
}

/// Returns the value of the chosen kernel from q^2, so that some kernels need no square root. The viscosity kernel,
/// whose value is infinite at q = 0, is not available.
#[inline(always)]
pub fn kernel_w<R: Real>(kernel: u32, q2: R) -> R {
    if kernel == POLY6 {
        return poly6_w(q2);
    }
    if kernel == GAUSSIAN {
        return gaussian_w(q2);
    }
    let q = root(q2);
    if kernel == SPIKY {
        return spiky_w(q);
    }
    if kernel == CUBIC_SPLINE {
        return cubic_spline_w(q);
    }
    if kernel == LUCY {
        return lucy_w(q);
    }
    if kernel == CLAVET {
        return clavet_w(q);
    }
    if kernel == WENDLAND_C2 {
        return wendland_c2_w(q);
    }
    return wendland_c4_w(q);
}

/// Returns the slope `-dw/dq` of the chosen kernel.
#[inline(always)]
pub fn kernel_slope<R: Real>(m: &Model, kernel: u32, q: R) -> R {
    if kernel == POLY6 {
        return poly6_slope(q);
    }
    if kernel == SPIKY {
        return spiky_slope(q);
    }
    if kernel == CUBIC_SPLINE {
        return cubic_spline_slope(q);
    }
    if kernel == GAUSSIAN {
        return gaussian_slope(q);
    }
    if kernel == LUCY {
        return lucy_slope(q);
    }
    if kernel == VISCOSITY {
        return viscosity_slope(m, q);
    }
    if kernel == CLAVET {
        return clavet_slope(q);
    }
    if kernel == WENDLAND_C2 {
        return wendland_c2_slope(q);
    }
    return wendland_c4_slope(q);
}

/// Returns the curvature `d2w/dq2` of the chosen kernel.
#[inline(always)]
pub fn kernel_curvature<R: Real>(kernel: u32, q: R) -> R {
    if kernel == POLY6 {
        return poly6_curvature(q);
    }
    if kernel == SPIKY {
        return spiky_curvature(q);
    }
    if kernel == CUBIC_SPLINE {
        return cubic_spline_curvature(q);
    }
    if kernel == GAUSSIAN {
        return gaussian_curvature(q);
    }
    if kernel == LUCY {
        return lucy_curvature(q);
    }
    if kernel == CLAVET {
        return clavet_curvature(q);
    }
    if kernel == WENDLAND_C2 {
        return wendland_c2_curvature(q);
    }
    return wendland_c4_curvature(q);
}

/// Returns the Laplacian of the chosen kernel in d dimensions, `w'' + (d - 1) w' / q`, in units of 1 / H^2; 0 at q = 0.
#[inline(always)]
pub fn kernel_laplacian<R: Real>(m: &Model, kernel: u32, q: R) -> R {
    if kernel == VISCOSITY {
        return viscosity_laplacian(m, q);
    }
    let fall = div(kernel_slope(m, kernel, q), q);
    let curvature = kernel_curvature(kernel, q);
    let plane = curvature - fall;
    if m.is_3d == 0 {
        return select(real(0.0), plane, less(real(0.0), q));
    }
    return select(real(0.0), plane - fall, less(real(0.0), q));
}
