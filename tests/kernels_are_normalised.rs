//! Promise: every kernel integrates to one in 2D and 3D, its slope is its derivative, and it vanishes at the support.
//!
//! Quadrature and differences are in f64 over the f32 terms themselves.
use approx::assert_relative_eq;
use millpond_core::kernel::{near_slope_constant, viscosity_laplacian_constant};
use millpond_core::scene::{Dimension, Kernel};
use millpond_core::terms::kernel::{kernel_slope, kernel_w, near_slope, viscosity_laplacian};
use std::f64::consts::PI;

const DIMENSIONS: [Dimension; 2] = [Dimension::Two, Dimension::Three];

/// Integral over the unit ball of `f(q)`, by the midpoint rule on 20 000 shells: its error is of second order in the
/// shell's width, 1e-9 here, and single precision leaves about 1e-7.
fn ball(dimension: Dimension, f: impl Fn(f32) -> f32) -> f64 {
    let shells = 20_000;
    let width = 1.0 / f64::from(shells);
    let sum: f64 = (0..shells)
        .map(|i| {
            let q = (f64::from(i) + 0.5) * width;
            let surface = if dimension == Dimension::Two { 2.0 * PI * q } else { 4.0 * PI * q * q };
            surface * f64::from(f(q as f32))
        })
        .sum();
    sum * width
}

#[test]
fn every_kernel_integrates_to_one() {
    for dimension in DIMENSIONS {
        for kernel in Kernel::ALL {
            let integral = ball(dimension, |q| kernel_w(kernel as u32, q * q)) * kernel.normalisation(dimension);
            assert_relative_eq!(integral, 1.0, epsilon = 1e-6);
        }
    }
}

#[test]
fn every_slope_is_minus_the_derivative() {
    for kernel in Kernel::ALL {
        let w = |q: f64| f64::from(kernel_w(kernel as u32, (q * q) as f32));
        let steepest = (1..1000).map(|i| kernel_slope(kernel as u32, i as f32 / 1000.0)).fold(0.0, f32::max);
        for i in 1..100 {
            // a central difference over 2 d errs by d^2 w''' / 6 and by rounding / d: both under 1e-4 of the steepest here
            let (q, d) = (f64::from(i) / 100.0, 2e-3);
            let difference = (w(q - d) - w(q + d)) / (2.0 * d);
            let slope = f64::from(kernel_slope(kernel as u32, q as f32));
            assert!((difference - slope).abs() < 2e-4 * f64::from(steepest), "{kernel:?} at {q}: {difference} {slope}");
        }
    }
}

#[test]
fn every_kernel_falls_to_zero_at_the_support() {
    for kernel in Kernel::ALL {
        let w = |i: u16| kernel_w(kernel as u32, (f32::from(i) / 500.0).powi(2));
        assert!((1..=500).all(|i| w(i) <= w(i - 1) && w(i) >= 0.0), "{kernel:?} falls");
        for q in [1.0, 1.0 + f32::EPSILON, 1.5, 3.0, 1e30] {
            assert_eq!(
                (kernel_w(kernel as u32, q * q), kernel_slope(kernel as u32, q)),
                (0.0, 0.0),
                "{kernel:?} at {q}"
            );
        }
    }
    assert_eq!((near_slope(1.0f32), viscosity_laplacian(1.0f32)), (0.0, 0.0));
}

#[test]
fn the_near_kernel_is_spikys_with_the_next_power() {
    // errata of S0 section 3.1: 45 / (pi H^4) in 3D and 30 / (pi H^3) in 2D, for the slope (1 - q)^3
    assert_relative_eq!(near_slope_constant(Dimension::Three), 45.0 / PI, max_relative = 1e-15);
    assert_relative_eq!(near_slope_constant(Dimension::Two), 30.0 / PI, max_relative = 1e-15);
    assert_relative_eq!(near_slope(0.5f32), 0.125);
}

#[test]
fn the_viscosity_laplacian_is_exact_on_a_quadratic_field() {
    // sum V (r^2) laplacian W = 2 d: the Laplacian of x^2 + y^2 (+ z^2), which fixes the constant
    for dimension in DIMENSIONS {
        let moment = ball(dimension, |q| q * q * viscosity_laplacian(q)) * viscosity_laplacian_constant(dimension);
        assert_relative_eq!(moment, 2.0 * dimension.count() as f64, epsilon = 1e-6);
    }
}
