//! `kernels`: checks of every kernel. Its integral and the moment of its Laplacian are computed by quadrature, its
//! derivatives are compared with finite differences, its sums over lattices with a reference table, and its tabulated
//! forms with the formula.
use super::flow::larger;
use super::lattice::kernel_called;
use super::reference::{entry, number, rows};
use super::{Context, Metric, Outcome, evaluation, lattice};
use crate::failure::Failure;
use crate::outcome::table;
use millpond_core::backend::derive::kernel_constants::{laplacian, slope, value};
use millpond_core::backend::terms::kernel::kernel_w;
use millpond_core::scene::Kernel;
use std::f64::consts::PI;

const NAME: &str = "kernels";

/// Required limit of the error of the integral, which is 1; also used for the moment of the Laplacian.
const NORMALISED: f64 = 1e-5;

/// Limit of the validation catalogue for the relative error of W(0), whose table has eight digits.
const AT_ZERO: f64 = 1e-6;

/// Limit of the validation catalogue for derivatives, over the largest slope or Laplacian.
const DIFFERENCES: f64 = 1e-4;

/// Points of a midpoint quadrature. For a kernel with a kink the error is their squared distance, 1e-9.
const POINTS: u32 = 20_000;

/// Half of the width of a central difference, and its least distance from the ends of the support, where some kernels
/// have edges. Both are in support radii.
const STEP: f64 = 1e-5;
const AWAY: f64 = 0.02;

pub(super) fn run(context: &Context) -> Result<Outcome, Failure> {
    let mut figures = Vec::new();
    let mut lines = Vec::new();
    let (mut slopes, mut laplacians, mut moments) = (0.0, 0.0, 0.0);
    for kernel in Kernel::ALL.iter().copied() {
        let off = dimensions(kernel).map(|d| (integral_of(kernel, d) - 1.0).abs()).fold(0.0, larger);
        figures.push(Metric::below(format!("error of the integral, {}", kernel.name()), off, NORMALISED));
        for d in [2, 3] {
            slopes = larger(slopes, slope_error(kernel, d));
            laplacians = larger(laplacians, laplacian_error(kernel, d));
            moments = larger(moments, (laplacian_moment(kernel, d) / (2.0 * d as f64) - 1.0).abs());
        }
        let spread = |d| if kernel.has_value() { format!("{:.5}", second_moment(kernel, d)) } else { "-".into() };
        let constant = |d| format!("{:.6}", kernel.normalisation(d));
        lines.push([kernel.name().into(), constant(2), constant(3), format!("{off:.1e}"), spread(2), spread(3)]);
    }
    figures.push(Metric::below("slopes against finite differences, all kernels", slopes, DIFFERENCES));
    figures.push(Metric::below("Laplacians against finite differences, all kernels", laplacians, DIFFERENCES));
    figures.push(Metric::below("second moment of the Laplacian against 2 d, all kernels", moments, NORMALISED));
    figures.push(Metric::below("W(0) against the reference table", at_zero()?, AT_ZERO));
    let mut notes =
        vec![table(["kernel", "c in 2D", "c in 3D", "integral error", "second moment of W over H^2, 2D", "3D"], lines)];
    let (more, note) = lattice::figures()?;
    figures.extend(more);
    notes.push(note);
    let (more, note) = evaluation::figures(context)?;
    figures.extend(more);
    notes.push(note);
    notes.push(lattice::shear_table());
    Ok(Outcome::new(NAME, figures, notes))
}

/// Returns the dimensions in which a kernel is defined. The viscosity kernel has a different form in each, and none in
/// 1D.
fn dimensions(kernel: Kernel) -> impl Iterator<Item = usize> {
    let least = if kernel.has_value() { 1 } else { 2 };
    least..=3
}

/// Integrates from 0 to 1 by the midpoint rule, which is not the rule by which core finds the constants.
fn integral(f: impl Fn(f64) -> f64) -> f64 {
    let width = 1.0 / f64::from(POINTS);
    (0..POINTS).map(|i| f((f64::from(i) + 0.5) * width)).sum::<f64>() * width
}

/// Returns the surface of the unit sphere in `d` dimensions.
fn sphere(d: usize) -> f64 {
    match d {
        1 => 2.0,
        2 => 2.0 * PI,
        _ => 4.0 * PI,
    }
}

/// Returns the kernel value in f32, as the solver computes it.
fn stepped_value(kernel: Kernel, q: f64) -> f64 {
    f64::from(kernel_w::<f32>(kernel as u32, (q * q) as f32))
}

/// Returns the integral of W over space. For a kernel that is infinite at zero distance it is computed from the slope,
/// as `-1/d` of the integral of `r W'`.
fn integral_of(kernel: Kernel, d: usize) -> f64 {
    let power = |q: f64, n: usize| q.powi(n as i32);
    let whole = if kernel.has_value() {
        integral(|q| stepped_value(kernel, q) * power(q, d - 1))
    } else {
        integral(|q| slope(kernel, d, q) * power(q, d)) / d as f64
    };
    kernel.normalisation(d) * sphere(d) * whole
}

/// Returns the second moment of W over H^2 (H is the support radius). It measures how far a kernel spreads, by which
/// kernels can be compared (Dehnen and Aly 2012).
fn second_moment(kernel: Kernel, d: usize) -> f64 {
    let whole = integral(|q| stepped_value(kernel, q) * q.powi(d as i32 + 1));
    kernel.normalisation(d) * sphere(d) * whole
}

/// Returns the integral of `r^2` times the Laplacian. It is 2 d if the Laplacian is exact on a quadratic field. For a
/// kernel that does not vanish at the edge of its support, such as the Gaussian, the jump there contributes to it.
fn laplacian_moment(kernel: Kernel, d: usize) -> f64 {
    let inside = 1.0 - 1e-12;
    let edge = if kernel.has_value() { slope(kernel, d, inside) + 2.0 * value(kernel, inside) } else { 0.0 };
    let whole = integral(|q| laplacian(kernel, d, q) * q.powi(d as i32 + 1)) + edge;
    kernel.normalisation(d) * sphere(d) * whole
}

/// Returns points of the support away from its ends.
fn points() -> impl Iterator<Item = f64> {
    let count = 500u32;
    (0..=count).map(move |i| AWAY + (1.0 - 2.0 * AWAY) * f64::from(i) / f64::from(count))
}

/// Returns the largest error of the slope against central differences of the value, over the largest slope.
fn slope_error(kernel: Kernel, d: usize) -> f64 {
    if !kernel.has_value() {
        return 0.0;
    }
    let difference = |q: f64| (value(kernel, q - STEP) - value(kernel, q + STEP)) / (2.0 * STEP);
    relative(points().map(|q| [slope(kernel, d, q), difference(q)]))
}

/// Returns the largest error of the Laplacian against central differences of the slope, `-(s' + (d - 1) s / q)`, over
/// the largest Laplacian.
fn laplacian_error(kernel: Kernel, d: usize) -> f64 {
    let difference = |q: f64| {
        // in proportion to q, since the slope of the viscosity kernel is infinite at zero distance
        let step = STEP * q;
        let bend = (slope(kernel, d, q + step) - slope(kernel, d, q - step)) / (2.0 * step);
        -(bend + (d - 1) as f64 * slope(kernel, d, q) / q)
    };
    relative(points().map(|q| [laplacian(kernel, d, q), difference(q)]))
}

/// Returns the largest difference within a pair, over the largest first number.
fn relative(pairs: impl Iterator<Item = [f64; 2]>) -> f64 {
    let (miss, largest) =
        pairs.fold((0.0, 0.0), |(miss, largest), [a, b]| (larger(miss, (a - b).abs()), larger(largest, a.abs())));
    miss / largest
}

/// Returns the largest relative error of W(0) against the reference table.
fn at_zero() -> Result<f64, Failure> {
    let mut worst = 0.0;
    for row in rows(include_str!("../../data/kernels.csv")) {
        let Some(kernel) = kernel_called(entry(&row, 0)?) else { continue };
        let support = number(entry(&row, 1)?)?;
        for d in [2, 3] {
            let expected = number(entry(&row, d)?)?;
            let found = kernel.normalisation(d) * value(kernel, 0.0) / support.powi(d as i32);
            worst = larger(worst, (found / expected - 1.0).abs());
        }
    }
    Ok(worst)
}
