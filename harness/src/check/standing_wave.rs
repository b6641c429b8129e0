//! `standing-wave`: case W1. A standing wave in a closed tank, against the period of linear theory. How fast it decays
//! is the numerical viscosity of the fluid, and it must not grow.
use super::enclosure::Enclosure;
use super::flow::{checked, fluid, grid, larger, start_with, step, steps_to};
use super::form::Form;
use super::formulas::{ROWS_STAY, WATER_WITH_SURFACE};
use super::{Context, Metric, Outcome};
use crate::failure::Failure;
use crate::outcome::table;
use glam::Vec3;
use millpond_core::backend::derive::support_radius;
use millpond_core::scene::{Block, DensityDiffusion, Dimension, Face, Fluid, Formulation, InitialParticle, Scene};
use millpond_core::{OwnedMemory, Particle, Solver};
use std::f64::consts::PI;

const NAME: &str = "standing-wave";

/// Spacing over the depth, in a full and in a quick study. The depth is 1 m and the tank 2 m wide, half a wave.
const SPACING: f32 = 0.02;
pub(super) const QUICK_SPACING: f32 = 0.04;

/// Number of periods, in a full and in a quick study.
const PERIODS: f64 = 20.0;
pub(super) const QUICK_PERIODS: f64 = 6.0;

/// Wave number, 1/m, and gravity, m/s2.
const WAVE_NUMBER: f64 = PI;
const GRAVITY: f32 = 9.81;

/// Height of the wave at its highest, m.
const AMPLITUDE: f64 = 0.03;

/// Speed of sound over `sqrt(g H)`, and time step over the time that sound takes through a support radius.
const SOUND: f32 = 10.0;
const COURANT: f64 = 0.1;

/// Coefficient of artificial viscosity, which with the support radius H implies a viscosity of `alpha H c / 8`, 6e-4
/// m2/s in a full study.
const ALPHA: f32 = 0.0025;

/// The formulas.
pub(super) const MODEL: Formulation = Formulation { alpha: ALPHA, ..WATER_WITH_SURFACE };

/// Required limits: error of the period, numerical viscosity in m2/s, and the amplitude of a later period over that of
/// the first.
pub(super) const PERIOD: f64 = 0.01;
const VISCOSITY: f64 = 3e-3;
const GROWTH: f64 = 1.0;

/// A numerical viscosity is proportional to the spacing.
pub(super) const QUICK_VISCOSITY: f64 = VISCOSITY * (QUICK_SPACING / SPACING) as f64;

const STEPS_PER_SAMPLE: u64 = 5;

/// Compared forms of walls and diffusion of density. The first one has the limits, and a quick study runs only
/// that one.
const FORMS: [(Enclosure, DensityDiffusion); 5] = [
    (Enclosure::EXTRAPOLATED, DensityDiffusion::Hydrostatic),
    (Enclosure::CLOSED_FORM, DensityDiffusion::Hydrostatic),
    (Enclosure::EXTRAPOLATED, DensityDiffusion::Off),
    (Enclosure::MIRRORED, DensityDiffusion::Hydrostatic),
    (Enclosure::DYNAMIC, DensityDiffusion::Hydrostatic),
];

/// What a run shows of the wave.
pub(super) struct Wave {
    /// Period over that of linear theory, minus one.
    pub(super) period: f64,
    /// Numerical viscosity, m2/s.
    pub(super) viscosity: f64,
    /// Largest later amplitude over the first one.
    pub(super) growth: f64,
}

/// Angular frequency by linear theory, `w^2 = g k tanh(k H)`, 1/s.
pub(super) fn frequency() -> f64 {
    (f64::from(GRAVITY) * WAVE_NUMBER * WAVE_NUMBER.tanh()).sqrt()
}

pub(super) fn run(context: &Context) -> Result<Outcome, Failure> {
    let (spacing, periods, limit, forms) = if context.quick {
        (QUICK_SPACING, QUICK_PERIODS, QUICK_VISCOSITY, 1)
    } else {
        (SPACING, PERIODS, VISCOSITY, FORMS.len())
    };
    let mut figures = Vec::new();
    let mut lines = Vec::new();
    for (i, (walls, diffusion)) in FORMS.into_iter().take(forms).enumerate() {
        let form = Form::of(MODEL, (walls, MODEL.density, diffusion));
        let line = match swing(context, spacing, periods, &form) {
            Err(Failure::Step(error)) if i > 0 => [error.to_string(), String::new(), String::new()],
            Err(failure) => return Err(failure),
            Ok(Wave { period, viscosity, growth }) => {
                if i == 0 {
                    figures.push(Metric::below("error of the period", period.abs(), PERIOD));
                    figures.push(Metric::below("numerical viscosity, m2/s", viscosity, limit));
                    figures.push(Metric::below("amplitude of a later period over the first", growth, GROWTH));
                }
                [format!("{:+.2} %", period * 100.0), format!("{viscosity:.1e}"), format!("{growth:.2}")]
            }
        };
        let [period, viscosity, growth] = line;
        lines.push([format!("{}, {}", walls.name(), diffusion.name()), period, viscosity, growth]);
    }
    let titles = ["walls, diffusion", "error of the period", "numerical viscosity, m2/s", "largest later amplitude"];
    Ok(Outcome::new(NAME, figures, vec![table(titles, lines)]))
}

fn scene(spacing: f32, form: &Form) -> Scene {
    let speed_of_sound = SOUND * GRAVITY.sqrt();
    let water = Fluid { rest_density: 1000.0, speed_of_sound, ..Fluid::default() };
    let block = Block { size: Vec3::new(2.0, 1.0, 0.0), ..Block::default() };
    let mut scene = Scene::of(Dimension::Two, spacing, 1.0, water, block);
    scene.gravity = Vec3::new(0.0, -GRAVITY, 0.0);
    scene.average_neighbours = Some(ROWS_STAY);
    scene.time_step = (COURANT * support_radius(&scene) / f64::from(speed_of_sound)) as f32;
    scene.model = form.model;
    form.walls.enclose(&mut scene, Vec3::new(2.0, 1.2, 0.0), &[Face::Ceiling], Some(0.0));
    scene.grid = grid(Dimension::Two, 32);
    scene
}

/// The velocity of the wave at a place when its surface is flat, over its largest value.
fn mode(position: Vec3) -> [f64; 2] {
    let [x, y] = [position.x, position.y].map(|x| WAVE_NUMBER * f64::from(x));
    let depth = WAVE_NUMBER.cosh();
    [-x.sin() * y.cosh() / depth, x.cos() * y.sinh() / depth]
}

/// Lets the wave swing.
pub(super) fn swing(context: &Context, spacing: f32, periods: f64, form: &Form) -> Result<Wave, Failure> {
    let scene = scene(spacing, form);
    let scene = checked(NAME, &scene)?;
    let mut heap = OwnedMemory::of(&scene);
    let speed = AMPLITUDE * f64::from(GRAVITY) * WAVE_NUMBER / frequency();
    let water = scene.derived().fluid_particles;
    let moving = |(i, mut place): (usize, InitialParticle)| {
        if i < water {
            let [x, y] = mode(place.position).map(|u| (speed * u) as f32);
            place.velocity = Vec3::new(x, y, 0.0);
        }
        place
    };
    let places = scene.initial_particles().enumerate().map(moving).collect();
    let mut solver = start_with(NAME, &scene, places, &mut heap)?;
    let title = format!("{NAME} {}", form.name());
    let mut samples = vec![(0.0, amplitude(&solver))];
    let steps = steps_to(&scene, periods * 2.0 * PI / frequency());
    step(&title, context, &mut solver, steps, STEPS_PER_SAMPLE, |solver| {
        samples.push((solver.time(), amplitude(solver)));
    })?;
    Ok(wave(&samples))
}

/// Returns the speed of the mode in the motion of the fluid, m/s.
fn amplitude(solver: &Solver<'_>) -> f64 {
    let (mut along, mut all) = (0.0, 0.0);
    for Particle { position, velocity, .. } in fluid(solver) {
        let [u, v] = mode(position);
        along += u * f64::from(velocity.x) + v * f64::from(velocity.y);
        all += u * u + v * v;
    }
    along / all
}

/// Returns period, decay and growth of a swing, from its zeros and from the extreme value between two zeros.
fn wave(samples: &[(f64, f64)]) -> Wave {
    let mut zeros = Vec::new();
    let mut extremes = vec![(0.0, 0.0)];
    for pair in samples.windows(2) {
        let [(t0, a0), (t1, a1)] = [pair[0], pair[1]];
        if (a0 < 0.0) != (a1 < 0.0) {
            zeros.push(t0 + (t1 - t0) * a0 / (a0 - a1));
            extremes.push((t1, 0.0));
        }
        if let Some(last) = extremes.last_mut()
            && a1.abs() > last.1
        {
            *last = (t1, a1.abs());
        }
    }
    let halves = zeros.len().saturating_sub(1) as f64;
    let [first, last] = [zeros.first(), zeros.last()].map(|zero| zero.copied().unwrap_or(f64::NAN));
    let period = 2.0 * (last - first) / halves * frequency() / (2.0 * PI) - 1.0;
    // the first and the last swing are cut off
    let whole = &extremes[1..extremes.len().saturating_sub(1).max(1)];
    let start = whole.first().map_or(f64::NAN, |(_, a)| *a);
    Wave {
        period,
        viscosity: -slope(whole) / (2.0 * WAVE_NUMBER.powi(2)),
        growth: whole.iter().skip(1).map(|(_, a)| a / start).fold(0.0, larger),
    }
}

/// Returns the slope of the straight line through the logarithms of numbers over time, 1/s.
fn slope(points: &[(f64, f64)]) -> f64 {
    let count = points.len() as f64;
    let [t, a] = [0, 1].map(|i| points.iter().map(|(t, a)| if i == 0 { *t } else { a.ln() }).sum::<f64>() / count);
    let both = points.iter().map(|(time, x)| (time - t) * (x.ln() - a)).sum::<f64>();
    both / points.iter().map(|(time, _)| (time - t).powi(2)).sum::<f64>()
}
