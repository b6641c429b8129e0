//! Theory of an oscillating drop, and the fit of a damped oscillation to samples.
use super::drop::{Around, Calm, REST_DENSITY, SIDE};
use std::f64::consts::PI;

/// Values on either side of the best one that a round of the search tries, and number of rounds. Each round searches a
/// third of the range of the round before.
const GRID: i32 = 10;
const ROUNDS: u32 = 10;

/// Iterations for the frequency with boundary layers. Each one reduces the error to a tenth.
const ITERATIONS: u32 = 12;

/// A damped oscillation.
#[derive(Clone, Copy, Debug)]
pub(super) struct Swing {
    /// Period, s.
    pub(super) period: f64,
    /// Decay rate of the amplitude, 1/s.
    pub(super) decay: f64,
}

/// Returns the angular frequency of mode n without viscosity, 1/s, from
/// `omega^2 = n (n^2 - 1) sigma / ((rho_in + rho_out) R^3)`, which is the two-dimensional form of Rayleigh 1879 and
/// Lamb 1932, art. 275.
pub(super) fn natural(n: f64, sigma: f64, densities: f64, radius: f64) -> f64 {
    (n * (n * n - 1.0) * sigma / (densities * radius.powi(3))).sqrt()
}

/// Returns the oscillation of a drop with this kinematic viscosity, m2/s. The period is not finite if the tension is
/// not positive.
pub(super) fn theory(around: Around, sigma: f64, calm: &Calm, viscosity: f32) -> Swing {
    let (radius, density) = (calm.radius, calm.density);
    // dynamic viscosity of the scene, Pa s, over the density of the packing
    let nu = f64::from(viscosity) * f64::from(REST_DENSITY) / density;
    let [decay, omega] = match around {
        Around::Nothing => {
            // 2 n (n - 1) nu / R^2, for weak viscosity (case S2)
            let (decay, omega) = (4.0 * nu / radius.powi(2), natural(2.0, sigma, density, radius));
            [decay, (omega.powi(2) - decay.powi(2)).sqrt()]
        }
        Around::Like => between_like_fluids(natural(2.0, sigma, density * (1.0 + images()), radius), nu, radius),
    };
    Swing { period: 2.0 * PI / omega, decay }
}

/// Returns the density of the fluid outside that acts on the second mode with all periodic images of the drop, over
/// that without images.
///
/// Outside of the drop the complex potential is the Weierstrass function of the square, `1 / z^2 + 3 G z^2` near the
/// drop, with `G = 3.1512 / L^4`, the sum of `w^-4` over the images. The ratio is `(1 + e) / (1 - e)`, where
/// `e = 3 G R^4`.
fn images() -> f64 {
    let share = 3.0 * 3.151_212 / f64::from(SIDE).powi(4);
    (1.0 + share) / (1.0 - share)
}

/// Returns the decay rate and the angular frequency of the second mode between two identical fluids, 1/s.
///
/// The two are one fluid, driven by a tension along a line. The linear Stokes equations with a force on the circle have
/// modes `e^(s t)`. By the Green's functions of `laplacian` and `laplacian - s / nu`, they satisfy
/// `s^2 = -omega^2 (1 - 2 n I_n(z) K_n(z))`, `z^2 = s R^2 / nu`. The modified Bessel functions represent the boundary
/// layers.
fn between_like_fluids(omega: f64, nu: f64, radius: f64) -> [f64; 2] {
    let mut s = [0.0, omega];
    for _ in 0..ITERATIONS {
        let layers = bessel_product(s.map(|part| part * radius.powi(2) / nu));
        let root = root([1.0 - 4.0 * layers[0], -4.0 * layers[1]]);
        s = times([0.0, omega], root);
    }
    [-s[0], s[1]]
}

/// Returns `I_2(z) K_2(z)` for a `z^2` far from zero (Abramowitz and Stegun 1964, 9.7.5): with `u = 1 / (2 z)^2`, it is
/// `(1 - 15 u / 2 + 315 u^2 / 8 + 4725 u^3 / 16) / (2 z)`.
fn bessel_product(z2: [f64; 2]) -> [f64; 2] {
    let u = inverse(z2.map(|part| 4.0 * part));
    let terms = [4725.0 / 16.0, 315.0 / 8.0, -7.5, 1.0];
    let series = terms.into_iter().fold([0.0; 2], |sum, term| {
        let [re, im] = times(sum, u);
        [re + term, im]
    });
    times(series, root(u))
}

/// Returns the product of two complex numbers.
fn times([a, b]: [f64; 2], [c, d]: [f64; 2]) -> [f64; 2] {
    [a * c - b * d, a * d + b * c]
}

/// Returns the inverse of a complex number.
fn inverse([a, b]: [f64; 2]) -> [f64; 2] {
    let square = a * a + b * b;
    [a / square, -b / square]
}

/// Returns the square root of a complex number, the one whose real part is not negative.
fn root([a, b]: [f64; 2]) -> [f64; 2] {
    let length = a.hypot(b);
    [f64::midpoint(length, a).max(0.0).sqrt(), f64::midpoint(length, -a).max(0.0).sqrt().copysign(b)]
}

/// Returns the damped oscillation about some mean that fits samples of time and value best, near a frequency, and the
/// share of the sum of squares that it leaves. Frequency and decay are searched on a grid that shrinks around its best
/// point.
pub(super) fn fit(samples: &[[f64; 2]], guess: f64) -> (Swing, f64) {
    let (mut best, mut left) = ([guess, 0.2 * guess], f64::INFINITY);
    let mut reach = [0.6 * guess, 0.3 * guess];
    for _ in 0..ROUNDS {
        let middle = best;
        for i in -GRID..=GRID {
            for j in -GRID..=GRID {
                let share = [i, j].map(|k| f64::from(k) / f64::from(GRID));
                let [omega, decay] = [0, 1].map(|k| middle[k] + share[k] * reach[k]);
                let leaves = leaves(samples, omega, decay);
                if leaves < left {
                    (best, left) = ([omega, decay], leaves);
                }
            }
        }
        reach = reach.map(|reach| reach / 3.0);
    }
    // if nothing fits, the result is NaN
    let found = if left.is_finite() { best } else { [f64::NAN; 2] };
    (Swing { period: 2.0 * PI / found[0], decay: found[1] }, left)
}

/// Returns the share of the sum of squares that is left by the best `e^(-decay t) (a cos omega t + b sin omega t) + c`,
/// by Cramer's rule.
fn leaves(samples: &[[f64; 2]], omega: f64, decay: f64) -> f64 {
    let (mut products, mut targets, mut squares) = ([[0.0; 3]; 3], [0.0; 3], 0.0);
    for [time, value] in samples {
        let (fall, (sin, cos)) = ((-decay * time).exp(), (omega * time).sin_cos());
        let base = [fall * cos, fall * sin, 1.0];
        for ((row, target), x) in products.iter_mut().zip(&mut targets).zip(base) {
            for (product, y) in row.iter_mut().zip(base) {
                *product += x * y;
            }
            *target += x * value;
        }
        squares += value * value;
    }
    let whole = determinant(products);
    let explained = [0, 1, 2].map(|i| {
        let mut replaced = products;
        replaced[i] = targets;
        determinant(replaced) / whole * targets[i]
    });
    (squares - explained.iter().sum::<f64>()) / squares
}

fn determinant([a, b, c]: [[f64; 3]; 3]) -> f64 {
    a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_fit_finds_a_swing() {
        let value = |t: f64| 0.1 + (-0.7 * t).exp() * (6.0 * t + 0.3).cos();
        let samples: Vec<[f64; 2]> = (0..200).map(|i| f64::from(i) / 100.0).map(|t| [t, value(t)]).collect();
        let (swing, left) = fit(&samples, 5.0);
        assert!((swing.period * 6.0 / (2.0 * PI) - 1.0).abs() < 1e-4 && (swing.decay - 0.7).abs() < 1e-3);
        assert!(left < 1e-7);
    }

    #[test]
    fn layers_slow_a_drop_down_as_much_as_they_damp_it() {
        // thin layers: the decay and the loss of frequency are omega delta / (2 R) each
        let (omega, nu, radius) = (20.0, 1e-6f64, 0.2);
        let share = (2.0 * nu / omega).sqrt() / (2.0 * radius);
        let [decay, slower] = between_like_fluids(omega, nu, radius);
        assert!((decay / omega / share - 1.0).abs() < 0.01 && ((1.0 - slower / omega) / share - 1.0).abs() < 0.01);
    }

    #[test]
    fn the_product_of_bessel_functions() {
        // I_2(10) K_2(10), from tables of both
        let product = 2_281.518_967_726_004 * 2.150_981_700_693_277e-5;
        assert!((bessel_product([100.0, 0.0])[0] / product - 1.0).abs() < 1e-6);
    }
}
