//! Normalisation constants of the kernels, which make each kernel integrate to one. They are computed from the terms by
//! quadrature, so that each kernel is written only once.
//!
//! A kernel is `W(r) = c / H^d w(q)`, with q = r / H and H the support radius. Its gradient is
//! `-c / H^(d+1) slope(q) x_ab / r`, and its Laplacian has the factor `1 / H^(d+2)`.
use crate::arithmetic::double::Double;
use crate::layout::Model;
use crate::scene::Kernel;
use crate::terms::kernel::{VISCOSITY, kernel_laplacian, kernel_slope, kernel_w};
use bytemuck::Zeroable;
use core::f64::consts::PI;

/// A model with what kernels need of it: the dimension, 2 or 3. (In 1D the functions that depend on it are undefined.)
fn of_dimension(d: usize) -> Model {
    Model { is_3d: u32::from(d == 3), ..Model::zeroed() }
}

/// `x^n` by multiplication: the last bit of a library's `pow` may differ between platforms.
pub(super) fn power(x: f64, n: usize) -> f64 {
    core::iter::repeat_n(x, n).product()
}

/// w(q), without the normalisation constant.
#[must_use]
pub fn value(kernel: Kernel, q: f64) -> f64 {
    kernel_w(kernel as u32, Double(q * q)).0
}

/// `-dw/dq` in `d` dimensions, without the normalisation constant.
#[must_use]
pub fn slope(kernel: Kernel, d: usize, q: f64) -> f64 {
    kernel_slope(&of_dimension(d), kernel as u32, Double(q)).0
}

/// The Laplacian of w with respect to q in `d` = 2 or 3 dimensions, without the normalisation constant.
#[must_use]
pub fn laplacian(kernel: Kernel, d: usize, q: f64) -> f64 {
    kernel_laplacian(&of_dimension(d), kernel as u32, Double(q)).0
}

/// Surface area of the unit sphere in `d` dimensions.
fn sphere(d: usize) -> f64 {
    match d {
        1 => 2.0,
        2 => 2.0 * PI,
        _ => 4.0 * PI,
    }
}

impl Kernel {
    /// Returns whether the kernel is finite at distance zero.
    #[must_use]
    pub fn has_value(self) -> bool {
        self as u32 != VISCOSITY
    }

    /// Returns whether the kernel has a cusp at distance zero, where its slope does not vanish.
    #[must_use]
    pub fn is_cusped(self) -> bool {
        slope(self, 3, 1e-9) > 1e-3
    }

    /// The constant c that makes the kernel integrate to one in `d` = 1, 2 or 3 dimensions.
    #[must_use]
    pub fn normalisation(self, d: usize) -> f64 {
        let whole = if self.has_value() {
            integral(&|q| value(self, q) * power(q, d - 1))
        } else {
            // by parts, since the value is infinite at distance zero, and a logarithm in 2D; the slope is neither
            integral(&|q| slope(self, d, q) * power(q, d)) / d as f64
        };
        1.0 / (sphere(d) * whole)
    }
}

/// Integral from 0 to 1 by Gauss-Legendre quadrature with 8 points on each of 8 parts. It is exact for piecewise
/// polynomials of degree 15 with breaks at multiples of 1/8.
#[must_use]
pub fn integral(f: &dyn Fn(f64) -> f64) -> f64 {
    const PARTS: usize = 8;
    const RULE: [(f64, f64); 4] = [
        (0.183_434_642_495_649_8, 0.362_683_783_378_362),
        (0.525_532_409_916_329, 0.313_706_645_877_887_3),
        (0.796_666_477_413_626_7, 0.222_381_034_453_374_5),
        (0.960_289_856_497_536_2, 0.101_228_536_290_376_3),
    ];
    let half = 0.5 / PARTS as f64;
    let part = |i: usize| {
        let middle = (2 * i + 1) as f64 * half;
        RULE.iter().map(|(x, w)| w * (f(middle - half * x) + f(middle + half * x))).sum::<f64>() * half
    };
    (0..PARTS).map(part).sum()
}

/// Constant of the slope `(1 - q)^3` of the density-proportional near pressure. It is the constant of Spiky's slope,
/// `3 (1 - q)^2` (Pirovano, section 3.1, corrected).
#[must_use]
pub fn near_slope_constant(d: usize) -> f64 {
    3.0 * Kernel::Spiky.normalisation(d)
}
