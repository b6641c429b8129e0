//! `oscillating-drop`: case S2. A calm drop is excited in its second mode, an ellipse whose long axis alternates
//! between the two axes. Its period is compared with linear theory (`swing`).
//!
//! Models whose coefficient is a surface tension must have the period of that tension. For the other models the tension
//! is measured from the pressure jumps at three radii, `sigma = jump R`, and the period must be that of the measured
//! tension.
//!
//! The theory includes viscosity. Where two identical fluids slide past each other there are boundary layers of about
//! `delta = sqrt(2 nu / omega)`, which make the period longer by a share of about `delta / (2 R)`. That is 6 % here,
//! and formulas for weak viscosity in a free drop do not contain it. The theory also includes the images of the drop in
//! its periodic square: 2 %.
use super::drop::{Around, Calm, Droplet, SIGMA, SPACING, centre, of_drop};
use super::flow::{checked, heap_for, larger, mean, start_with, step, steps_to};
use super::reference::{entry, number, rows};
use super::swing::{Swing, fit, natural, theory};
use super::{Context, Metric, Outcome};
use crate::failure::Failure;
use crate::outcome::table;
use glam::Vec3;
use millpond_core::Solver;
use millpond_core::scene::{InitialParticle, SurfaceTension};
use std::f64::consts::PI;

const NAME: &str = "oscillating-drop";

/// Models whose coefficient is a surface tension, and models whose tension is measured.
const MODELS: [SurfaceTension; 2] = [SurfaceTension::Curvature, SurfaceTension::NormalCurvature];
const PAIRWISE: [SurfaceTension; 2] = [SurfaceTension::Attraction, SurfaceTension::GradientSum];

/// Surroundings of the drops of the latter models. The forces that hold these drops together also compress them, even
/// with a flat surface, about fifty times as much as a surface tension does. In vacuum the pressure jump therefore says
/// little about the tension. An identical fluid is compressed as much as the drop.
const PAIRWISE_AROUND: Around = Around::Like;

/// Radius of a coarse and of a fine drop, in spacings.
const COARSE: u16 = 10;
const FINE: u16 = 20;

/// Radii at which a tension is measured, in spacings, all with one spacing, in a full and in a quick study. The period
/// is measured at the last one. Half of a radius, the inside of the drop, must be longer than the support radius of
/// 4.4 spacings.
const RADII: &[u16] = &[10, 15, 20];
const QUICK_RADII: &[u16] = &[10, 12];

/// Kinematic viscosity during the oscillation, m2/s. The amplitude of a free drop falls by a tenth in a period.
const VISCOSITY: f32 = 0.005;

/// Amplitude of the oscillation over the radius, as in case S2.
const AMPLITUDE: f64 = 0.05;

/// Start of the fit and end of the run, in periods; number of samples. The fit starts when the boundary layers have
/// formed. In vacuum a drop has half of its tension and is slower.
const FROM: f64 = 0.25;
const END: f64 = 2.0;
const END_IN_NOTHING: f64 = 3.5;
const SAMPLES: u64 = 400;

/// Longest time of a run with any measured tension, s.
const LONGEST: f64 = 5.0;

/// Required limits of the relative error of the period, for a given and for a measured tension; then the limits of a
/// quick study.
const LIMIT: f64 = 0.05;
const PAIRWISE_LIMIT: f64 = 0.10;
const QUICK_LIMIT: f64 = 0.10;
const QUICK_PAIRWISE_LIMIT: f64 = 0.25;

/// Limit for the formula against the reference table, which has six digits.
const TABLE_LIMIT: f64 = 1e-5;

/// Results of a drop.
#[derive(Clone, Copy, Debug)]
struct Run {
    /// Surface tension, given or measured, N/m.
    sigma: f64,
    /// Oscillation in theory.
    theory: Swing,
    /// Measured oscillation.
    found: Swing,
    /// Share of the sum of squares that the fit leaves.
    left: f64,
}

impl Run {
    /// Returns the relative error of the period.
    fn off(&self) -> f64 {
        self.found.period / self.theory.period - 1.0
    }
}

pub(super) fn run(context: &Context) -> Result<Outcome, Failure> {
    let quick = context.quick;
    let (radius, limit) = if quick { (COARSE, QUICK_LIMIT) } else { (FINE, LIMIT) };
    let mut figures = vec![Metric::below("formula against the reference table", table_error()?, TABLE_LIMIT)];
    let mut lines = Vec::new();
    for model in MODELS {
        let drop = Droplet::of_reference_case(model, Around::Like, radius);
        let run = swing_by_itself(context, &drop)?;
        figures.push(Metric::below(format!("period error, {}", drop.title()), run.off().abs(), limit));
        lines.push(line(&drop, &Ok(run)));
    }
    let (radii, limit) = if quick { (QUICK_RADII, QUICK_PAIRWISE_LIMIT) } else { (RADII, PAIRWISE_LIMIT) };
    let mut tensions = Vec::new();
    for model in PAIRWISE {
        let mut calm = Vec::new();
        for &radius in radii {
            let (around, offset) = (PAIRWISE_AROUND, [0.0; 2]);
            let drop = Droplet { tension: model, around, radius, spacing: SPACING, offset };
            calm.push((drop, drop.calm(context, NAME)?));
        }
        let sigma = mean(&calm, |(_, calm)| calm.jump * calm.radius);
        tensions.extend(calm.iter().map(|(drop, calm)| tension_line(drop, calm, sigma)));
        if let Some((drop, calm)) = calm.last() {
            let run = swing(context, drop, calm, sigma)?;
            let name = format!("period error against the measured tension, {}", drop.title());
            figures.push(Metric::below(name, run.off().abs(), limit));
            lines.push(line(drop, &Ok(run)));
        }
    }
    if !quick {
        for model in MODELS {
            for (around, radius) in [(Around::Like, COARSE), (Around::Nothing, COARSE)] {
                let drop = Droplet::of_reference_case(model, around, radius);
                lines.push(line(&drop, &swing_by_itself(context, &drop)));
            }
        }
    }
    let titles = ["drop", "sigma, N/m", "period, s", "in theory", "error", "decay, 1/s", "in theory", "fit residual"];
    let measured = ["drop", "jump, Pa", "R, m", "sigma, N/m", "over the mean", "over the coefficient"];
    let note = "In vacuum half of the colour's profile is missing, and the tension is about half of the coefficient.";
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

/// Runs a drop whose coefficient is a surface tension.
fn swing_by_itself(context: &Context, drop: &Droplet) -> Result<Run, Failure> {
    let calm = drop.calm(context, NAME)?;
    swing(context, drop, &calm, f64::from(SIGMA))
}

/// Excites a calm drop and compares its oscillation with the theory for a surface tension.
fn swing(context: &Context, drop: &Droplet, calm: &Calm, sigma: f64) -> Result<Run, Failure> {
    let theory = theory(drop.around, sigma, calm, VISCOSITY);
    if !theory.period.is_finite() {
        // the fluids push each other apart, so there is no oscillation
        let found = Swing { period: f64::NAN, decay: f64::NAN };
        return Ok(Run { sigma, theory, found, left: f64::NAN });
    }
    let scene = drop.scene(VISCOSITY);
    let places = set_going(calm, AMPLITUDE * calm.radius * 2.0 * PI / theory.period);
    let scene = checked(NAME, &scene)?;
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

/// Returns the calm drop with the velocities that its second mode has when the drop is round: `U (x, -y) / R` inside,
/// and the matching flow without sources outside, `U (R / r)^3 (cos 3 theta, sin 3 theta)`. An eighth of U is left at
/// the sides of the square, and propagates as sound.
fn set_going(calm: &Calm, speed: f64) -> Vec<InitialParticle> {
    let going = |place: &InitialParticle| {
        let [x, y] = [0, 1].map(|axis| f64::from(place.position[axis]) - calm.centre[axis]);
        let (r2, radius) = (x * x + y * y, calm.radius);
        let [u, v] = if place.material == 0 {
            [x / radius, -y / radius]
        } else {
            let fall = (radius / r2).powi(3);
            [fall * x * (x * x - 3.0 * y * y), fall * y * (3.0 * x * x - y * y)]
        };
        InitialParticle { velocity: Vec3::new((speed * u) as f32, (speed * v) as f32, 0.0), ..*place }
    };
    calm.places.iter().map(going).collect()
}

/// Returns the mean of `x^2 - y^2` over the drop, from its centre, m2. To first order it is the amplitude times R.
fn ellipticity(solver: &Solver<'_>) -> f64 {
    let drop = of_drop(solver);
    let centre = centre(&drop);
    let [x2, y2] = [0, 1].map(|i| mean(&drop, |particle| (f64::from(particle.position[i]) - centre[i]).powi(2)));
    x2 - y2
}

/// Returns the largest relative error of a period by the formula, against the reference table for drops in two
/// dimensions.
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
