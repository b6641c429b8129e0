//! `impact`: a column of water collapses and hits the far wall (Lobovsky et al. 2014, case D2). Arrival, peak and
//! impulse of the pressure at four sensors are compared with the experiment.
use super::enclosure::Enclosure;
use super::flow::{checked, fluid, grid, larger, start_with, step, steps_to};
use super::form::Form;
use super::formulas::{ROWS_STAY, WATER_WITH_SURFACE};
use super::reference::numbers;
use super::{Context, Metric, Outcome};
use crate::failure::Failure;
use crate::outcome::table;
use glam::Vec3;
use millpond_core::backend::derive::support_radius;
use millpond_core::scene::{Block, Dimension, Face, Fluid, Formulation, Scene};
use millpond_core::{OwnedMemory, Solver};

const NAME: &str = "impact";

/// Depth and length of the column, and length and height of the tank, m. The tank of the experiment is 0.6 m high; here
/// no splash may leave it.
const DEPTH: f32 = 0.3;
const LENGTH: f32 = 0.6;
const TANK: f32 = 1.61;
const HEIGHT: f32 = 1.5;

/// Heights of the sensors above the floor, m, their names, and the share of `rho g H` at which the water has arrived at
/// them.
const SENSORS: [(&str, f32, f64); 4] = [("s1", 0.003, 0.3), ("s2", 0.015, 0.3), ("s3", 0.03, 0.3), ("s4", 0.08, 0.1)];

/// Columns of the sensors in the table of the experiment.
const COLUMNS: [usize; 4] = [1, 2, 4, 5];

/// Particles over the depth, in a full study (twice) and in a quick one.
pub(super) const ACROSS: [f32; 2] = [38.0, 76.0];
pub(super) const QUICK_ACROSS: f32 = 25.0;

/// End of the run in units of `sqrt(H / g)`: the impulse at the highest sensor is known by then.
pub(super) const END: f64 = 4.0;

/// Pressures are means over windows of this half width, as those of the experiment are. The impulse is taken over this
/// time from the arrival on.
const WINDOW: f64 = 0.01;
const IMPULSE: f64 = 1.0;

const GRAVITY: f32 = 9.81;
const REST_DENSITY: f32 = 997.0;

/// Speed of sound over `sqrt(2 g H)`, the largest speed of the water, and time step over the time that sound takes
/// through a support radius.
const SOUND: f32 = 10.0;
const COURANT: f64 = 0.1;

/// Coefficient of artificial viscosity. It is used with the support radius, so it is 0.1 in Monaghan's form. It damps
/// the sound that the impact excites; the walls are without friction.
const ALPHA: f32 = 0.05;

/// The formulas.
pub(super) const MODEL: Formulation = Formulation { alpha: ALPHA, ..WATER_WITH_SURFACE };

const STEPS_PER_SAMPLE: u64 = 5;

/// Compared walls. The first ones, which are the default, have the limits.
const WALLS: [Enclosure; 2] = [Enclosure::CLOSED_FORM, Enclosure::EXTRAPOLATED];

/// Required limits with 76 particles over the depth: arrival at all sensors; peak, as a factor, and impulse at the
/// first three. With 38 particles, and in a quick study: arrival at the first three.
const ARRIVAL: f64 = 0.03;
const PEAK: f64 = 1.5;
const IMPULSE_ERROR: f64 = 0.3;
pub(super) const COARSE_ARRIVAL: f64 = 0.05;

/// What a sensor saw, in units of `sqrt(H / g)` and `rho g H`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Seen {
    pub(super) arrival: f64,
    pub(super) peak: f64,
    pub(super) impulse: f64,
}

pub(super) fn run(context: &Context) -> Result<Outcome, Failure> {
    let experiment = experiment()?;
    let mut figures = Vec::new();
    let (mut lines, mut notes) = (Vec::new(), Vec::new());
    let resolutions = if context.quick { vec![QUICK_ACROSS] } else { ACROSS.to_vec() };
    for (across, walls) in resolutions.into_iter().flat_map(|across| WALLS.map(|walls| (across, walls))) {
        let (seen, lost) = fall(context, across, &Form { walls, model: MODEL })?;
        let is_limited = walls == WALLS[0];
        notes.push(format!(
            "With {across} particles over the depth and {} walls, {lost} particles of the splash are more than half a \
             spacing behind a wall at the end.",
            walls.name()
        ));
        for (i, ((name, ..), (seen, real))) in SENSORS.iter().zip(seen.iter().zip(&experiment)).enumerate() {
            let off = (seen.arrival / real.arrival - 1.0).abs();
            let peak = (seen.peak / real.peak).max(real.peak / seen.peak);
            let impulse = (seen.impulse / real.impulse - 1.0).abs();
            let is_fine = across == ACROSS[1];
            let across = format!("{across}, {}", walls.name());
            let limit = if is_fine { ARRIVAL } else { COARSE_ARRIVAL };
            if is_limited && (is_fine || i < 3) {
                figures.push(Metric::below(format!("{name}, {across}: arrival, relative error"), off, limit));
            }
            if is_limited && is_fine && i < 3 {
                figures.push(Metric::below(format!("{name}, {across}: peak, as a factor"), peak, PEAK));
                let name = format!("{name}, {across}: impulse, relative error");
                figures.push(Metric::below(name, impulse, IMPULSE_ERROR));
            }
            let both = |of: fn(&Seen) -> f64| format!("{:.3} of {:.3}", of(seen), of(real));
            lines.push([
                format!("{across}, {name}"),
                both(|seen| seen.arrival),
                both(|seen| seen.peak),
                both(|seen| seen.impulse),
            ]);
        }
    }
    let titles =
        ["particles over the depth, walls, sensor", "arrival, t sqrt(g / H)", "peak, p / (rho g H)", "impulse"];
    notes.insert(0, table(titles, lines));
    Ok(Outcome::new(NAME, figures, notes))
}

fn scene(across: f32, form: &Form) -> Scene {
    let spacing = DEPTH / across;
    let speed_of_sound = SOUND * (2.0 * GRAVITY * DEPTH).sqrt();
    let water = Fluid { rest_density: REST_DENSITY, speed_of_sound, ..Fluid::default() };
    let block = Block { size: Vec3::new(LENGTH, DEPTH, 0.0), ..Block::default() };
    let mut scene = Scene::of(Dimension::Two, spacing, 1.0, water, block);
    scene.gravity = Vec3::new(0.0, -GRAVITY, 0.0);
    scene.average_neighbours = Some(ROWS_STAY);
    scene.time_step = (COURANT * support_radius(&scene) / f64::from(speed_of_sound)) as f32;
    scene.model = form.model;
    form.walls.enclose(
        &mut scene,
        Vec3::new(end_of_tank(spacing, form.walls), HEIGHT, 0.0),
        &[Face::Ceiling],
        Some(0.0),
    );
    scene.grid = grid(Dimension::Two, 64);
    scene
}

/// Returns `sqrt(H / g)`, s.
pub(super) fn unit_of_time() -> f64 {
    f64::from(DEPTH / GRAVITY).sqrt()
}

/// Returns where the tank ends, m. Walls of particles are whole spacings long.
fn end_of_tank(spacing: f32, walls: Enclosure) -> f32 {
    if matches!(walls, Enclosure::Particles(_)) { (TANK / spacing).round() * spacing } else { TANK }
}

/// Runs the collapse. Returns what the sensors saw, and the number of particles that went through the walls.
pub(super) fn fall(context: &Context, across: f32, form: &Form) -> Result<(Vec<Seen>, usize), Failure> {
    let scene = scene(across, form);
    let scene = checked(NAME, &scene)?;
    let mut heap = OwnedMemory::of(&scene);
    let mut solver = start_with(NAME, &scene, scene.initial_particles().collect(), &mut heap)?;
    let time = unit_of_time();
    let wall = end_of_tank(scene.particle_spacing, form.walls);
    let mut samples = vec![Vec::new(); SENSORS.len()];
    step(NAME, context, &mut solver, steps_to(&scene, END * time), STEPS_PER_SAMPLE, |solver| {
        let now = solver.time() / time;
        for (samples, pressure) in samples.iter_mut().zip(pressures(solver, wall)) {
            samples.push((now, pressure));
        }
    })?;
    // half a spacing further on lie the first particles of the walls
    let past = 0.5 * scene.particle_spacing;
    let lost = fluid(&solver).iter().filter(|p| p.position.y < -past || p.position.x > wall + past).count();
    let seen = samples.iter().zip(SENSORS).map(|(samples, (.., least))| seen(&averaged(samples), least));
    Ok((seen.collect(), lost))
}

/// Returns the pressures at the sensors, over `rho g H`.
fn pressures(solver: &mut Solver<'_>, wall: f32) -> Vec<f64> {
    let neighbours = solver.neighbours();
    let at = |height: f32| neighbours.sample(Vec3::new(wall, height, 0.0)).map_or(0.0, |there| there.pressure);
    SENSORS.iter().map(|(_, height, _)| f64::from(at(*height) / (REST_DENSITY * GRAVITY * DEPTH))).collect()
}

/// Returns means over windows, one for each half width.
fn averaged(samples: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let windows = (END / WINDOW) as usize;
    let mut sums = vec![(0.0, 0.0); windows + 1];
    for (time, pressure) in samples {
        // a sample counts for the windows around the two nearest centres
        let place = time / WINDOW;
        for centre in [place.floor(), place.ceil()] {
            if let Some((sum, count)) = sums.get_mut(centre as usize) {
                (*sum, *count) = (*sum + pressure, *count + 1.0);
            }
        }
    }
    let means = sums.into_iter().enumerate().filter(|(_, (_, count))| *count > 0.0);
    means.map(|(i, (sum, count))| (i as f64 * WINDOW, sum / count)).collect()
}

/// Returns arrival, peak and impulse of a record of pressure over time.
fn seen(record: &[(f64, f64)], least: f64) -> Seen {
    let arrival = record.iter().find(|(_, p)| *p > least).map_or(f64::NAN, |(t, _)| *t);
    let after: Vec<&(f64, f64)> = record.iter().filter(|(t, _)| (arrival..=arrival + IMPULSE).contains(t)).collect();
    Seen {
        arrival,
        peak: after.iter().map(|(_, p)| *p).fold(0.0, larger),
        impulse: after.windows(2).map(|pair| (pair[1].0 - pair[0].0) * (pair[0].1 + pair[1].1) / 2.0).sum(),
    }
}

/// Returns what the sensors of the experiment saw.
pub(super) fn experiment() -> Result<Vec<Seen>, Failure> {
    let rows = numbers(include_str!("../../data/lobovsky-pressure.csv"))?;
    let of = |column: usize| -> Vec<(f64, f64)> { rows.iter().map(|row| (row[0], row[column])).collect() };
    Ok(COLUMNS.iter().zip(SENSORS).map(|(column, (.., least))| seen(&of(*column), least)).collect())
}
