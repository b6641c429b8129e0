//! Constants of the kernels: what makes each integrate to one, in two and in three dimensions.
//!
//! A kernel is `W(r) = c / H^d w(q)`, q = r / H, H the support radius; `terms::kernel` holds w and -dw/dq. So the gradient
//! is `-c / H^(d+1) slope(q) x_ab / r`, and a Laplacian carries `1 / H^(d+2)`.
use crate::scene::{Dimension, Kernel};
use core::f64::consts::PI;

impl Kernel {
    /// The constant c that makes the kernel integrate to one.
    #[must_use]
    pub fn normalisation(self, dimension: Dimension) -> f64 {
        match (self, dimension) {
            (Kernel::Poly6, Dimension::Two) => 4.0 / PI,
            (Kernel::Poly6, Dimension::Three) => 315.0 / (64.0 * PI),
            (Kernel::Spiky, Dimension::Two) => 10.0 / PI,
            (Kernel::Spiky, Dimension::Three) => 15.0 / PI,
            // 5 / (14 pi h^2) and 1 / (4 pi h^3) with H = 2 h
            (Kernel::CubicSpline, Dimension::Two) => 10.0 / (7.0 * PI),
            (Kernel::CubicSpline, Dimension::Three) => 2.0 / PI,
        }
    }
}

/// Constant of the near kernel's slope `(1 - q)^3`: Spiky's (S0 section 3.1 per errata).
#[must_use]
pub fn near_slope_constant(dimension: Dimension) -> f64 {
    // Spiky's slope is 3 (1 - q)^2; the near kernel keeps the 3 and raises the power
    3.0 * Kernel::Spiky.normalisation(dimension)
}

/// Constant of the viscosity kernel's Laplacian `1 - q` (S0 eq. 2.46; in 2D per errata): with it the second moment of the
/// Laplacian is 2 d, so that it is exact on a quadratic field.
#[must_use]
pub fn viscosity_laplacian_constant(dimension: Dimension) -> f64 {
    match dimension {
        Dimension::Two => 40.0 / PI,
        Dimension::Three => 45.0 / PI,
    }
}
