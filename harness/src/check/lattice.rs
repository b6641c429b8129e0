//! Sums of kernels over lattices against a reference table: the errors of density, gradient and Laplacian at the
//! positions where particles start. Part of the study `kernels`.
use super::Metric;
use super::reference::{entry, number, rows};
use crate::failure::Failure;
use crate::outcome::table;
use millpond_core::backend::derive::kernel_constants::{slope, value};
use millpond_core::scene::Kernel;
use std::f64::consts::PI;

/// Limit of the validation catalogue, beyond the rounding of the table's four digits.
const LIMIT: f64 = 2e-6;

/// Lattice cells to each side; the widest support of the table spans four.
const REACH: i32 = 6;

/// Strain at which the response of a lattice to shear is measured. It is small, but its square is well above rounding
/// errors.
const STRAIN: f64 = 0.01;

/// Lattices of the table. A particle has the volume 1.
#[derive(Clone, Copy, Debug)]
enum Lattice {
    Square,
    Hex,
    Cubic,
}

impl Lattice {
    fn called(name: &str) -> Option<Lattice> {
        match name {
            "square" => Some(Lattice::Square),
            "hex" => Some(Lattice::Hex),
            "cubic" => Some(Lattice::Cubic),
            _ => None,
        }
    }

    fn dimension(self) -> usize {
        if matches!(self, Lattice::Cubic) { 3 } else { 2 }
    }

    fn points(self) -> Vec<[f64; 3]> {
        let layers = if matches!(self, Lattice::Cubic) { REACH } else { 0 };
        // side of triangles of area 1/2
        let side = (2.0 / 3f64.sqrt()).sqrt();
        let mut points = Vec::new();
        for z in -layers..=layers {
            for y in -REACH..=REACH {
                for x in -REACH..=REACH {
                    let [x, y, z] = [x, y, z].map(f64::from);
                    points.push(match self {
                        Lattice::Hex => [side * (x + y / 2.0), side * y * 3f64.sqrt() / 2.0, 0.0],
                        _ => [x, y, z],
                    });
                }
            }
        }
        points
    }
}

/// Returns the errors around a point of the lattice with this support: of `sum V W`, of `sum V (x_b - x_a) dW/dx`, and
/// the relative error of the Laplacian of Morris et al. 1997, `sum 2 V (x_ab . grad W) / r^2 (A_a - A_b)`, for
/// `A = x^2`, where it is 2.
fn errors(lattice: Lattice, kernel: Kernel, support: f64) -> [f64; 3] {
    let d = lattice.dimension();
    let c = kernel.normalisation(d) / support.powi(d as i32);
    let mut sums = [0.0; 3];
    for [x, y, z] in lattice.points() {
        let r = (x * x + y * y + z * z).sqrt();
        let q = r / support;
        if q >= 1.0 {
            continue;
        }
        sums[0] += c * value(kernel, q);
        if r > 0.0 {
            let fall = c / support * slope(kernel, d, q);
            sums[1] += x * (x / r) * fall;
            sums[2] += 2.0 * (r * fall) / (r * r) * (x * x) / 2.0;
        }
    }
    sums.map(|sum| sum - 1.0)
}

/// Returns half a unit of the last digit of a number such as `1.234e-5`.
fn rounding(word: &str) -> Result<f64, Failure> {
    let (digits, power) = word.split_once('e').unwrap_or((word, "0"));
    let places = digits.split_once('.').map_or(0, |(_, places)| places.len());
    Ok(0.5 * 10f64.powf(number(power)? - places as f64))
}

/// Returns the figures of the three sums over the whole reference table, and a table of the sums.
///
/// # Errors
/// The reference table cannot be read.
pub(super) fn figures() -> Result<(Vec<Metric>, String), Failure> {
    let mut worst = [0.0f64; 3];
    let mut lines = Vec::new();
    for row in rows(include_str!("../../data/lattice.csv")) {
        let (name, kernel_name) = (entry(&row, 0)?, entry(&row, 1)?);
        let (Some(lattice), Some(kernel)) = (Lattice::called(name), kernel_called(kernel_name)) else { continue };
        let h = number(entry(&row, 2)?)?;
        let found = errors(lattice, kernel, 2.0 * h);
        for (i, worst) in worst.iter_mut().enumerate() {
            let word = entry(&row, 3 + i)?;
            let miss = ((found[i] - number(word)?).abs() - rounding(word)?).max(0.0);
            *worst = worst.max(if miss.is_nan() { f64::INFINITY } else { miss });
        }
        lines.push([name.into(), kernel.name().into(), h.to_string(), number_of(found[0]), number_of(found[1])]);
    }
    let rows = lines.len();
    let names = ["density sums", "gradient sums", "Morris' Laplacian sums"];
    let figure = |(name, worst): (&str, f64)| {
        Metric::below(format!("{name} on lattices against the reference table, {rows} rows"), worst, LIMIT)
    };
    let figures = names.into_iter().zip(worst).map(figure).collect();
    Ok((figures, table(["lattice", "kernel", "h over spacing", "density error", "gradient error"], lines)))
}

/// Returns the density sum over a square or cubic lattice that is stretched by this factor along x and compressed by it
/// along y.
fn stretched_sum(kernel: Kernel, d: usize, support: f64, stretch: f64) -> f64 {
    let lattice = if d == 3 { Lattice::Cubic } else { Lattice::Square };
    let distance = |[x, y, z]: [f64; 3]| (x * x * stretch * stretch + y * y / (stretch * stretch) + z * z).sqrt();
    let shares = lattice.points().into_iter().map(|point| distance(point) / support).filter(|q| *q < 1.0);
    kernel.normalisation(d) / support.powi(d as i32) * shares.map(|q| value(kernel, q)).sum::<f64>()
}

/// Returns the response to shear of a lattice under a pressure P. The density sum rises by this share of the square of
/// the strain, and at constant volume the lattice gains as much energy over P. A lattice with a positive response
/// resists shear like a solid. With a negative response it gives way.
fn shear(kernel: Kernel, d: usize, neighbours: f64) -> f64 {
    let support = match d {
        2 => (neighbours / PI).sqrt(),
        _ => (neighbours * 3.0 / (4.0 * PI)).cbrt(),
    };
    let sum = |stretch: f64| stretched_sum(kernel, d, support, stretch);
    let even = f64::midpoint(sum(1.0 + STRAIN), sum(1.0 / (1.0 + STRAIN)));
    (even / sum(1.0) - 1.0) / (STRAIN * STRAIN)
}

/// Returns a table of the response to shear by number of neighbours, for the kernels that are used under pressure.
pub(super) fn shear_table() -> String {
    let kernels = [Kernel::CubicSpline, Kernel::WendlandC2, Kernel::WendlandC4, Kernel::Poly6];
    let mut lines = Vec::new();
    for d in [2, 3] {
        for neighbours in [20.0, 27.0, 32.0, 40.0, 50.0, 64.0, 80.0] {
            let [spline, c2, c4, poly6] = kernels.map(|kernel| format!("{:+.4}", shear(kernel, d, neighbours)));
            lines.push([format!("{d}"), format!("{neighbours}"), spline, c2, c4, poly6]);
        }
    }
    let titles = ["dimension", "neighbours", "cubic spline", "Wendland C2", "Wendland C4", "Poly6"];
    "Response of a lattice to shear: the energy that it gains, over its pressure and the square of the strain. This is \
     twice its shear modulus over its pressure. Where it is negative, flow that grows from a lattice grows too fast. \
     Where it is large, the flow grows too slowly.\n\n"
        .to_owned()
        + &table(titles, lines)
}

fn number_of(x: f64) -> String {
    format!("{x:+.2e}")
}

/// Returns the kernel that has this name in the reference tables.
pub(super) fn kernel_called(name: &str) -> Option<Kernel> {
    match name {
        "cubic spline" => Some(Kernel::CubicSpline),
        "Wendland C2" => Some(Kernel::WendlandC2),
        "Wendland C4" => Some(Kernel::WendlandC4),
        "poly6" => Some(Kernel::Poly6),
        "spiky" => Some(Kernel::Spiky),
        _ => None,
    }
}
