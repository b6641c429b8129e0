//! What of a kernel lies beyond a plane at a distance from its centre, and the integral of the kernel over that plane,
//! by quadrature of the terms.
use super::kernel_constants::{integral, value};
use crate::scene::Kernel;
use core::f64::consts::PI;

/// The integral of the kernel over the space beyond a plane at the distance `s` H, for a kernel with a value.
#[must_use]
pub fn gamma(kernel: Kernel, d: usize, s: f64) -> f64 {
    // shells of radius q: the share of their surface that lies beyond
    let beyond = |q: f64| if d == 2 { 2.0 * q * libm::acos((s / q).min(1.0)) } else { 2.0 * PI * q * (q - s) };
    // q = s + (1 - s) x^2 takes away the root at q = s
    let shell = |x: f64| {
        let q = s + (1.0 - s) * x * x;
        if q > 0.0 { value(kernel, q) * beyond(q) * 2.0 * x * (1.0 - s) } else { 0.0 }
    };
    kernel.normalisation(d) * integral(&shell)
}

/// The integral of the kernel over a plane at the distance `s` H, times H, for a kernel with a value.
#[must_use]
pub fn surface(kernel: Kernel, d: usize, s: f64) -> f64 {
    let radius = libm::sqrt((1.0 - s * s).max(0.0));
    let ring = |x: f64| {
        let t = radius * x;
        let q = libm::sqrt(s * s + t * t);
        value(kernel, q) * if d == 2 { 2.0 } else { 2.0 * PI * t }
    };
    kernel.normalisation(d) * radius * integral(&ring)
}

/// The integral of the distance times [`surface`] from the plane at the distance `s` H on, over H: half of the sum of
/// the principal curvatures times this is what a curved surface takes away from [`gamma`], to first order.
#[must_use]
pub fn bending(kernel: Kernel, d: usize, s: f64) -> f64 {
    let beyond = |q: f64| {
        let rest = (q * q - s * s).max(0.0);
        if d == 2 { 2.0 * q * libm::sqrt(rest) } else { PI * q * rest }
    };
    // q = s + (1 - s) x^2 takes away the root at q = s
    let shell = |x: f64| {
        let q = s + (1.0 - s) * x * x;
        if q > 0.0 { value(kernel, q) * beyond(q) * 2.0 * x * (1.0 - s) } else { 0.0 }
    };
    kernel.normalisation(d) * integral(&shell)
}

/// The sum of the kernel over rows of particles beyond a plane at the distance `s` H: the first lies half a row from
/// the plane, and rows are `row` H apart. It tends to [`gamma`] as rows come closer. A density sum needs it instead:
/// beside a wall the sum over the rows in front of it differs from the integral by up to 2 % with 32 neighbours in 2D,
/// and as much with the opposite sign beyond.
#[must_use]
pub fn gamma_of_rows(kernel: Kernel, d: usize, s: f64, row: f64) -> f64 {
    let mut sum = 0.0;
    let mut place = s + 0.5 * row;
    while place < 1.0 && row > 0.0 {
        sum += surface(kernel, d, place) * row;
        place += row;
    }
    sum
}
