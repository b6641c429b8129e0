//! `oscillating-drop`: the catalogue's case S2. A calm drop is set going in its second mode, an ellipse that now lies and now
//! stands; its period is compared with theory.
//!
//! Models with a tension of their own must have the period of that tension. For those without, the tension is what the jumps
//! of pressure at three radii say, `sigma = jump R`, and the period must be that tension's.
//!
//! The theory has viscosity in it: where two like fluids slide past each other there are layers of some
//! `delta = sqrt(2 nu / omega)`, which make the period longer by about `delta / (2 R)` of itself. That is 6 % here, and
//! no formula for weak viscosity in a free drop has it. It also has the images of the drop in its periodic square: 2 %.
use super::drop::{Around, Calm, Droplet, REST_DENSITY, SIDE, SIGMA, SPACING, centre, of_drop};
use super::flow::{heap_for, larger, mean, start_with, step, steps_to};
use super::outcome::table;
use super::reference::{entry, number, rows};
use super::{Context, Figure, Outcome};
use crate::failure::Failure;
use millpond_core::Solver;
use millpond_core::scene::{Place, SurfaceTension};
use std::f64::consts::PI;

const NAME: &str = "oscillating-drop";

/// The models with a tension of their own, and those without.
const MODELS: [SurfaceTension; 2] = [SurfaceTension::Curvature, SurfaceTension::NormalCurvature];
const PAIRWISE: [SurfaceTension; 2] = [SurfaceTension::Attraction, SurfaceTension::GradientSum];

/// What is around the drops of the latter. What holds them together also presses them together, flat surface or not, some
/// fifty times as much as a tension does: in nothing the jump of pressure says little of the tension. A like fluid is pressed
/// together as much as the drop.
const PAIRWISE_AROUND: Around = Around::Like;

/// Radius in spacings.
const COARSE: u16 = 10;
const FINE: u16 = 20;

/// Those at which a tension is measured, all with one spacing; the last one's period is looked at.
const RADII: [u16; 3] = [10, 12, 15];
const QUICK_RADII: [u16; 3] = [8, 10, 12];

/// Kinematic viscosity while it swings, m2/s: an amplitude of the free drop falls by a tenth in a period.
const VISCOSITY: f32 = 0.005;

/// Of the swing, over the radius: the catalogue's.
const AMPLITUDE: f64 = 0.05;

/// From when on it is fitted, and how long it runs, in periods: at first the layers only form. In nothing, with half of its
/// tension, a drop is slower.
const FROM: f64 = 0.25;
const END: f64 = 2.0;
const END_IN_NOTHING: f64 = 3.5;
const SAMPLES: u64 = 400;

/// It does not run for longer than this, whatever a measured tension says, s.
const LONGEST: f64 = 5.0;

/// Of the issue: the period off, of the tension's and of the measured tension's.
const LIMIT: f64 = 0.05;
const PAIRWISE_LIMIT: f64 = 0.10;
const QUICK_LIMIT: f64 = 0.10;
const QUICK_PAIRWISE_LIMIT: f64 = 0.25;

/// The table has six digits.
const TABLE_LIMIT: f64 = 1e-5;

/// Values looked at on either side of the best one so far, in each round of a search; the next one looks at a third of it.
const GRID: i32 = 10;
const ROUNDS: u32 = 10;

/// Iterations of the frequency with layers, of which each mends all but a tenth.
const ITERATIONS: u32 = 12;

/// A damped swing.
#[derive(Clone, Copy, Debug)]
struct Swing {
    /// s.
    period: f64,
    /// Of the amplitude, 1/s.
    decay: f64,
}

/// What a drop came to.
#[derive(Clone, Copy, Debug)]
struct Run {
    /// Its tension, given or measured, N/m.
    sigma: f64,
    /// What it should have done.
    theory: Swing,
    /// What it did.
    found: Swing,
    /// Share of the squares that the fit leaves.
    left: f64,
}

impl Run {
    /// Miss of the period, over that of theory.
    fn off(&self) -> f64 {
        self.found.period / self.theory.period - 1.0
    }
}

pub(super) fn run(context: &Context) -> Result<Outcome, Failure> {
    let quick = context.quick;
    let (radius, limit) = if quick { (COARSE, QUICK_LIMIT) } else { (FINE, LIMIT) };
    let mut figures = vec![Figure::below("formula against the catalogue", table_error()?, TABLE_LIMIT)];
    let mut lines = Vec::new();
    for model in MODELS {
        let drop = Droplet::of_catalogue(model, Around::Like, radius);
        let run = swing_by_itself(context, &drop)?;
        figures.push(Figure::below(format!("period off, {}", drop.title()), run.off().abs(), limit));
        lines.push(line(&drop, &Ok(run)));
    }
    let (radii, limit) = if quick { (QUICK_RADII, QUICK_PAIRWISE_LIMIT) } else { (RADII, PAIRWISE_LIMIT) };
    let mut tensions = Vec::new();
    for model in PAIRWISE {
        let drops = radii.map(|radius| Droplet { tension: model, around: PAIRWISE_AROUND, radius, spacing: SPACING });
        let mut calm = Vec::new();
        for drop in drops {
            calm.push((drop, drop.calm(context, NAME)?));
        }
        let sigma = mean(&calm, |(_, calm)| calm.jump * calm.radius);
        tensions.extend(calm.iter().map(|(drop, calm)| tension_line(drop, calm, sigma)));
        if let Some((drop, calm)) = calm.last() {
            let run = swing(context, drop, calm, sigma)?;
            let name = format!("period off that of the measured tension, {}", drop.title());
            figures.push(Figure::below(name, run.off().abs(), limit));
            lines.push(line(drop, &Ok(run)));
        }
    }
    if !quick {
        for model in MODELS {
            for (around, radius) in [(Around::Like, COARSE), (Around::Nothing, COARSE)] {
                let drop = Droplet::of_catalogue(model, around, radius);
                lines.push(line(&drop, &swing_by_itself(context, &drop)));
            }
        }
    }
    let titles = ["drop", "sigma, N/m", "period, s", "of theory", "off", "decay, 1/s", "of theory", "fit leaves"];
    let measured = ["drop", "jump, Pa", "R, m", "sigma, N/m", "over the mean", "over the coefficient"];
    let note = "In nothing half of a colour's profile is missing, and the tension is about half of the one asked for.";
    Ok(Outcome::new(NAME, figures, vec![table(titles, lines), note.into(), table(measured, tensions)]))
}

fn line(drop: &Droplet, run: &Result<Run, Failure>) -> [String; 8] {
    let [sigma, found, theory, off, decay, decay_of_theory, left] = match run {
        Ok(run) => [
            format!("{:.4}", run.sigma),
            format!("{:.4}", run.found.period),
            format!("{:.4}", run.theory.period),
            format!("{:+.1} %", run.off() * 100.0),
            format!("{:.2}", run.found.decay),
            format!("{:.2}", run.theory.decay),
            format!("{:.1e}", run.left),
        ],
        Err(failure) => {
            let [a, b, c, d, e, f] = [(); 6].map(|()| String::new());
            [failure.to_string(), a, b, c, d, e, f]
        }
    };
    [drop.title(), sigma, found, theory, off, decay, decay_of_theory, left]
}

fn tension_line(drop: &Droplet, calm: &Calm, mean: f64) -> [String; 6] {
    let sigma = calm.jump * calm.radius;
    [
        drop.title(),
        format!("{:.3}", calm.jump),
        format!("{:.4}", calm.radius),
        format!("{sigma:.4}"),
        format!("{:.3}", sigma / mean),
        format!("{:.5}", sigma / drop.coefficient()),
    ]
}

/// A drop with a tension of its own.
fn swing_by_itself(context: &Context, drop: &Droplet) -> Result<Run, Failure> {
    let calm = drop.calm(context, NAME)?;
    swing(context, drop, &calm, f64::from(SIGMA))
}

/// Sets a calm drop going and compares its swing with that of a tension.
fn swing(context: &Context, drop: &Droplet, calm: &Calm, sigma: f64) -> Result<Run, Failure> {
    let theory = theory(drop.around, sigma, calm);
    if !theory.period.is_finite() {
        // pushed apart: no swing to be seen
        let found = Swing { period: f64::NAN, decay: f64::NAN };
        return Ok(Run { sigma, theory, found, left: f64::NAN });
    }
    let scene = drop.scene(VISCOSITY);
    let places = set_going(calm, AMPLITUDE * calm.radius * 2.0 * PI / theory.period);
    let mut heap = heap_for(&scene, places.len());
    let mut solver = start_with(NAME, &scene, places, &mut heap)?;
    let periods = if drop.around == Around::Like { END } else { END_IN_NOTHING };
    let steps = steps_to(&scene, (periods * theory.period).min(LONGEST));
    let mut samples = Vec::new();
    step(&format!("{NAME} {}", drop.title()), context, &mut solver, steps, steps / SAMPLES, |solver| {
        if solver.time() >= FROM * theory.period {
            samples.push([solver.time(), ellipticity(solver) / calm.radius.powi(2)]);
        }
    })?;
    let (found, left) = fit(&samples, 2.0 * PI / theory.period);
    Ok(Run { sigma, theory, found, left })
}

/// The calm drop with the velocities of its second mode where it is round: `U (x, -y) / R` inside, and outside what goes
/// with it without a source, `U (R / r)^3 (cos 3 theta, sin 3 theta)`. At the sides of the square an eighth of U is left,
/// which goes off as sound.
fn set_going(calm: &Calm, speed: f64) -> Vec<Place> {
    let going = |place: &Place| {
        let [x, y] = [0, 1].map(|axis| f64::from(place.position[axis]) - calm.centre[axis]);
        let (r2, radius) = (x * x + y * y, calm.radius);
        let [u, v] = if place.species == 0 {
            [x / radius, -y / radius]
        } else {
            let fall = (radius / r2).powi(3);
            [fall * x * (x * x - 3.0 * y * y), fall * y * (3.0 * x * x - y * y)]
        };
        Place { velocity: [(speed * u) as f32, (speed * v) as f32, 0.0], ..*place }
    };
    calm.places.iter().map(going).collect()
}

/// Mean of `x^2 - y^2` over the drop, from its centre, m2: to the first order its amplitude times R.
fn ellipticity(solver: &Solver<'_>) -> f64 {
    let drop = of_drop(solver);
    let centre = centre(&drop);
    let [x2, y2] = [0, 1].map(|i| mean(&drop, |particle| (f64::from(particle.position[i]) - centre[i]).powi(2)));
    x2 - y2
}

/// `omega^2 = n (n^2 - 1) sigma / ((rho_in + rho_out) R^3)`: the plane's form of Rayleigh 1879 and Lamb 1932, art. 275.
fn natural(n: f64, sigma: f64, densities: f64, radius: f64) -> f64 {
    (n * (n * n - 1.0) * sigma / (densities * radius.powi(3))).sqrt()
}

/// How a drop swings; a period that is no number where the tension is no tension.
fn theory(around: Around, sigma: f64, calm: &Calm) -> Swing {
    let nu = f64::from(VISCOSITY);
    let (radius, density) = (calm.radius, calm.density);
    // viscosity as the scene has it, Pa s, over the density of the packing
    let nu = nu * f64::from(REST_DENSITY) / density;
    let [decay, omega] = match around {
        Around::Nothing => {
            // 2 n (n - 1) nu / R^2 (the catalogue's, of weak viscosity)
            let (decay, omega) = (4.0 * nu / radius.powi(2), natural(2.0, sigma, density, radius));
            [decay, (omega.powi(2) - decay.powi(2)).sqrt()]
        }
        Around::Like => between_like_fluids(natural(2.0, sigma, density * (1.0 + images()), radius), nu, radius),
    };
    Swing { period: 2.0 * PI / omega, decay }
}

/// Density of the fluid outside as the second mode feels it with all images of the drop around, over that without any.
///
/// Outside the complex potential is Weierstrass' function of the square, `1 / z^2 + 3 G z^2` near the drop, with
/// `G = 3.1512 / L^4`, the sum of `w^-4` over its images: `(1 + e) / (1 - e)`, where `e = 3 G R^4`.
fn images() -> f64 {
    let share = 3.0 * 3.151_212 / f64::from(SIDE).powi(4);
    (1.0 + share) / (1.0 - share)
}

/// Decay and frequency of the second mode between two fluids that are alike, 1/s.
///
/// One fluid then, driven by a tension along a line. From the linear equations of Stokes with a force on the circle, modes
/// `e^(s t)` follow by Green's functions of `laplacian` and `laplacian - s / nu`:
/// `s^2 = -omega^2 (1 - 2 n I_n(z) K_n(z))`, `z^2 = s R^2 / nu`, the modified Bessel functions standing for the layers.
fn between_like_fluids(omega: f64, nu: f64, radius: f64) -> [f64; 2] {
    let mut s = [0.0, omega];
    for _ in 0..ITERATIONS {
        let layers = bessel_product(s.map(|part| part * radius.powi(2) / nu));
        let root = root([1.0 - 4.0 * layers[0], -4.0 * layers[1]]);
        s = times([0.0, omega], root);
    }
    [-s[0], s[1]]
}

/// `I_2(z) K_2(z)` of a `z^2` far from nothing (Abramowitz and Stegun 9.7.5): with `u = 1 / (2 z)^2`,
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

/// Product of two complex numbers.
fn times([a, b]: [f64; 2], [c, d]: [f64; 2]) -> [f64; 2] {
    [a * c - b * d, a * d + b * c]
}

/// One over a complex number.
fn inverse([a, b]: [f64; 2]) -> [f64; 2] {
    let square = a * a + b * b;
    [a / square, -b / square]
}

/// The root of a complex number, the one that is not to the left.
fn root([a, b]: [f64; 2]) -> [f64; 2] {
    let length = a.hypot(b);
    [((length + a) / 2.0).max(0.0).sqrt(), ((length - a) / 2.0).max(0.0).sqrt().copysign(b)]
}

/// The damped swing about some mean that fits samples of time and value best, near a frequency, and what share of their
/// squares it leaves. Frequency and decay are looked for on a grid that shrinks about its best point.
fn fit(samples: &[[f64; 2]], guess: f64) -> (Swing, f64) {
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
    // where nothing fits nothing is found
    let found = if left.is_finite() { best } else { [f64::NAN; 2] };
    (Swing { period: 2.0 * PI / found[0], decay: found[1] }, left)
}

/// Share of the squares that is left by the best `e^(-decay t) (a cos omega t + b sin omega t) + c`, by Cramer's rule.
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

/// Largest miss of a period by the formula, over that of the catalogue's table, drops in the plane.
fn table_error() -> Result<f64, Failure> {
    let mut worst = 0.0;
    for row in rows(include_str!("../../data/droplet-modes.csv")) {
        if entry(&row, 1)? == "2" {
            let at = |column: usize| number(entry(&row, column)?);
            let omega = natural(at(6)?, at(3)?, at(4)? + at(5)?, at(2)?);
            worst = larger(worst, (2.0 * PI / omega / at(9)? - 1.0).abs());
        }
    }
    Ok(worst)
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
        // thin ones: each by omega delta / (2 R)
        let (omega, nu, radius) = (20.0, 1e-6, 0.2);
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
