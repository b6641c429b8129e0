//! Promise: every kernel integrates to one in 1D, 2D and 3D, its slope is minus its derivative, its Laplacian agrees
//! with its slope, and the kernel vanishes at the support radius.
//!
//! Quadrature and differences are computed in f64 from the f32 terms themselves. `millpond check kernels` reports more.
use approx::assert_relative_eq;
use millpond_core::backend::derive::kernel_constants::{laplacian, near_slope_constant, slope, value};
use millpond_core::backend::layout::Model;
use millpond_core::backend::terms::kernel::{kernel_slope, kernel_w};
use millpond_core::scene::Kernel;
use std::f64::consts::PI;

/// Returns the integral of `f(q)` over the unit ball, by the midpoint rule on 20 000 shells. The error of the rule is
/// of second order in the width of a shell, 1e-9 here; single precision contributes about 1e-7.
fn ball(d: usize, f: impl Fn(f32) -> f32) -> f64 {
    let shells = 20_000;
    let width = 1.0 / f64::from(shells);
    let surface = |q: f64| [2.0, 2.0 * PI * q, 4.0 * PI * q * q][d - 1];
    let shell = |i: i32| {
        let q = (f64::from(i) + 0.5) * width;
        surface(q) * f64::from(f(q as f32))
    };
    (0..shells).map(shell).sum::<f64>() * width
}

fn model(d: usize) -> Model {
    Model { is_3d: u32::from(d == 3), ..bytemuck::Zeroable::zeroed() }
}

#[test]
fn every_kernel_integrates_to_one() {
    for &kernel in Kernel::ALL {
        for d in if kernel.has_value() { 1..=3 } else { 2..=3 } {
            let whole = if kernel.has_value() {
                ball(d, |q| kernel_w(kernel as u32, q * q))
            } else {
                // by parts, since the kernel is infinite at distance zero
                ball(d, |q| kernel_slope(&model(d), kernel as u32, q) * q) / d as f64
            };
            // the exponential of the Gaussian is accurate to 2e-6
            assert_relative_eq!(whole * kernel.normalisation(d), 1.0, epsilon = 4e-6);
        }
    }
}

#[test]
fn constants_are_the_literatures() {
    // the constant c of W = c / H^d w(q) in 1D, 2D and 3D, with w as in the terms; for the cubic spline see Hinsch
    // 2024, section 4.1, where H is 2 h
    let known = [
        (Kernel::CubicSpline, [1.0 / 6.0 * 2.0, 5.0 / (14.0 * PI) * 4.0, 1.0 / (4.0 * PI) * 8.0]),
        (Kernel::Poly6, [35.0 / 32.0, 4.0 / PI, 315.0 / (64.0 * PI)]),
        (Kernel::Spiky, [2.0, 10.0 / PI, 15.0 / PI]),
        (Kernel::Lucy, [5.0 / 4.0, 5.0 / PI, 105.0 / (16.0 * PI)]),
        (Kernel::Clavet, [3.0 / 2.0, 6.0 / PI, 15.0 / (2.0 * PI)]),
    ];
    for (kernel, constants) in known {
        for (i, constant) in constants.into_iter().enumerate() {
            assert_relative_eq!(kernel.normalisation(i + 1), constant, max_relative = 1e-13);
        }
    }
    // the usual 7 / (4 pi), 21 / (16 pi), 9 / (4 pi) and 495 / (256 pi) are for the support 2 h; w of C4 is 3 times
    // theirs here
    assert_relative_eq!(Kernel::WendlandC2.normalisation(2), 7.0 / PI, max_relative = 1e-13);
    assert_relative_eq!(Kernel::WendlandC2.normalisation(3), 21.0 / (2.0 * PI), max_relative = 1e-13);
    assert_relative_eq!(Kernel::WendlandC4.normalisation(2), 9.0 / PI / 3.0, max_relative = 1e-13);
    assert_relative_eq!(Kernel::WendlandC4.normalisation(3), 495.0 / (32.0 * PI) / 3.0, max_relative = 1e-13);
    // its 1/6 is a single-precision literal
    assert_relative_eq!(Kernel::Viscosity.normalisation(2), 40.0 / PI, max_relative = 1e-7);
    assert_relative_eq!(Kernel::Viscosity.normalisation(3), 15.0 / (2.0 * PI), max_relative = 1e-13);
    let cut = 1.0 - (-9f64).exp();
    assert_relative_eq!(Kernel::Gaussian.normalisation(2), 9.0 / (PI * cut), max_relative = 1e-6);
}

#[test]
fn every_slope_is_minus_the_derivative_and_the_laplacian_that_of_the_slope() {
    for &kernel in Kernel::ALL {
        for d in [2, 3] {
            // central differences over 2 s in f64: their error is s^2 w''' / 6, and the Gaussian's series adds 2e-6
            let s = 1e-4;
            let steepest = (5..100).map(|i| slope(kernel, d, f64::from(i) / 100.0)).fold(0.0, f64::max);
            for i in 5..100 {
                let q = f64::from(i) / 100.0 + 0.0013;
                if kernel.has_value() {
                    let difference = (value(kernel, q - s) - value(kernel, q + s)) / (2.0 * s);
                    let error = (difference - slope(kernel, d, q)).abs();
                    assert!(error < 1e-5 * steepest, "{kernel:?} in {d}D at {q}: {difference}");
                }
                let curvature = (slope(kernel, d, q - s) - slope(kernel, d, q + s)) / (2.0 * s);
                let want = curvature - (d - 1) as f64 * slope(kernel, d, q) / q;
                let error = (want - laplacian(kernel, d, q)).abs();
                assert!(error < 1e-4 * steepest / q, "{kernel:?} in {d}D at {q}: {want}");
            }
        }
    }
}

#[test]
fn every_kernel_falls_to_zero_at_the_support() {
    for &kernel in Kernel::ALL {
        let w = |i: u16| kernel_w(kernel as u32, (f32::from(i) / 500.0).powi(2));
        if kernel.has_value() {
            // the Gaussian ends with a step of e^-9
            assert!((1..=500).all(|i| w(i) <= w(i - 1) && w(i) >= 0.0), "{kernel:?} falls");
        }
        // up to the range of the grid, 2^22 cells along each axis
        for q in [1.0, 1.0 + f32::EPSILON, 1.5, 3.0, 1e8] {
            let slope = kernel_slope(&model(3), kernel as u32, q);
            let value = if kernel.has_value() { kernel_w(kernel as u32, q * q) } else { 0.0 };
            assert_eq!((value, slope), (0.0, 0.0), "{kernel:?} at {q}");
        }
    }
}

#[test]
fn the_near_kernel_is_spikys_with_the_next_power() {
    // Pirovano, section 3.1, corrected: 45 / (pi H^4) in 3D and 30 / (pi H^3) in 2D, for the slope (1 - q)^3
    assert_relative_eq!(near_slope_constant(3), 45.0 / PI, max_relative = 1e-13);
    assert_relative_eq!(near_slope_constant(2), 30.0 / PI, max_relative = 1e-13);
    assert_relative_eq!(millpond_core::backend::terms::near::near_slope_proportional(0.5f32), 0.125);
}

#[test]
fn the_viscosity_laplacian_is_exact_on_a_quadratic_field() {
    // the sum of V r^2 times the Laplacian of W is 2 d, the Laplacian of x^2 + y^2 (+ z^2), which determines the
    // constant
    for d in [2, 3] {
        let moment = ball(d, |q| q * q * laplacian(Kernel::Viscosity, d, f64::from(q)) as f32);
        assert_relative_eq!(moment * Kernel::Viscosity.normalisation(d), 2.0 * d as f64, epsilon = 1e-6);
    }
}
