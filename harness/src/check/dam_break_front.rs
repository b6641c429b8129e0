//! `dam-break-front`: case D1. A column of water, twice as high as wide, collapses onto a dry bed. The position of its
//! front over time is compared with the experiments of Martin and Moyce 1952, which have the limits, and of Koshizuka
//! and Oka 1996.
use super::flow::{checked, grid, start_with, step, steps_to};
use super::formulas::WENDLAND;
use super::reference::{along, pairs};
use super::{Context, Metric, Outcome};
use crate::failure::Failure;
use crate::outcome::table;
use glam::Vec3;
use millpond_core::OwnedMemory;
use millpond_core::backend::derive::support_radius;
use millpond_core::scene::{
    Block, DensityForm, Dimension, Face, Fluid, Formulation, Scene, Wall, WallPressure, WallShape,
};
use millpond_core::{Checked, Solver};

const NAME: &str = "dam-break-front";

/// Base a and height n^2 a of the column, m; size of the tank, m; gravity, m/s2.
const BASE: f32 = 1.0;
const HEIGHT: f32 = 2.0;
const TANK: [f32; 3] = [5.0, 2.4, 0.0];
const GRAVITY: f32 = 9.81;

/// Particles along the base. The limits are meant for the finer one, the middle resolution of case D1.
const COARSE: u16 = 25;
const FINE: u16 = 50;

/// Speed of sound, m/s: ten times `sqrt(2 g H)`, the speed after a fall from the top.
const SPEED_OF_SOUND: f32 = 62.6;

/// Share of the support radius that sound travels in a step; the front is ten times slower.
const COURANT: f64 = 0.2;

/// Dynamic viscosity, Pa s. The Reynolds number is about 1000, as with an artificial viscosity of 0.02. It damps the
/// jitter between neighbouring particles.
const VISCOSITY: f32 = 5.0;

/// End of the run, in units of T: the last point of Martin and Moyce is at T = 3.33.
const END: f64 = 3.4;
const STEPS_PER_SAMPLE: u64 = 10;

/// Least number of other particles in the support of a particle of the front. A particle with fewer has separated from
/// the tongue and counts as spray.
const COMPANY: u32 = 2;

/// Largest time shift, in units of T, and number of shifts that are tried. The gate of the experiment does not open
/// instantly, which delays the front by at most this much.
const LARGEST_SHIFT: f64 = 0.3;
const SHIFTS: u16 = 60;

/// Limits of case D1: root mean square of the relative error of Z against Martin and Moyce, without a time shift and
/// with the best one.
const RAW_LIMIT: f64 = 0.10;
const SHIFTED_LIMIT: f64 = 0.05;

/// Limit of the front speed `dZ/dT`, averaged over the later part of the table. In a frictionless dam break (Ritter
/// 1892) no front keeps moving faster than 2.
const SPEED_LIMIT: f64 = 2.0;
const LATER: [f64; 2] = [1.43, 3.33];

/// The forms that have the limits.
const BEST: (DensityForm, WallPressure) = (DensityForm::Summation, WallPressure::Dynamic);

/// The front: Z = z / a against T = n t sqrt(g / a).
type Front = Vec<[f64; 2]>;

pub(super) fn run(context: &Context) -> Result<Outcome, Failure> {
    let measured = pairs(include_str!("../../data/martin-moyce.csv"))?;
    let other = pairs(include_str!("../../data/koshizuka-oka.csv"))?;
    let judged = |front: &Front| {
        let (shift, shifted) = best_shift(front, &measured);
        let (other_shift, other_shifted) = best_shift(front, &other);
        let raw = [rms_error(front, &measured, 0.0), rms_error(front, &other, 0.0)];
        (raw, [shifted, other_shifted], [shift, other_shift])
    };
    let mut lines = Vec::new();
    let mut report = |side: u16, (density, wall): (DensityForm, WallPressure), front: &Result<Front, Failure>| {
        let name = format!("{}, {}", density.name(), wall.name());
        let errors = match front {
            Ok(front) => {
                let (raw, shifted, shift) = judged(front);
                let words =
                    |i: usize| format!("{:.1} %, {:.1} % by {:.2}", raw[i] * 100.0, shifted[i] * 100.0, shift[i]);
                [words(0), words(1)]
            }
            Err(failure) => [failure.to_string(), String::new()],
        };
        let [measured, other] = errors;
        lines.push([side.to_string(), name, measured, other]);
    };
    let coarse = collapse(context, COARSE, BEST)?;
    report(COARSE, BEST, &Ok(coarse.clone()));
    let (side, front) = if context.quick {
        (COARSE, coarse.clone())
    } else {
        let fine = collapse(context, FINE, BEST)?;
        report(FINE, BEST, &Ok(fine.clone()));
        for form in forms().filter(|form| *form != BEST) {
            report(COARSE, form, &collapse(context, COARSE, form));
        }
        (FINE, fine)
    };
    let (raw, shifted, _) = judged(&front);
    let speed = (along(&front, LATER[1]) - along(&front, LATER[0])) / (LATER[1] - LATER[0]);
    let mut figures = vec![
        Metric::below(format!("rms error of Z, a/dx = {side}"), raw[0], RAW_LIMIT),
        Metric::below(format!("rms error of Z with the best time shift, a/dx = {side}"), shifted[0], SHIFTED_LIMIT),
        Metric::below("mean dZ/dT from T = 1.43 to 3.33", speed, SPEED_LIMIT),
    ];
    if !context.quick {
        // with the shift, since the rest of the raw error comes from the gate of the experiment at any resolution
        let (_, coarse, _) = judged(&coarse);
        let ratio = shifted[0] / coarse[0];
        figures.push(Metric::below(format!("error with the best shift, over that with a/dx = {COARSE}"), ratio, 1.0));
    }
    let titles = ["a/dx", "density, walls", "Martin and Moyce: rms error, with best shift", "Koshizuka and Oka"];
    let points = measured.iter().map(|[t, z]| [format!("{t}"), format!("{z}"), format!("{:.2}", along(&front, *t))]);
    let notes = vec![table(titles, lines), table(["T", "Z measured", &format!("Z, a/dx = {side}")], points)];
    Ok(Outcome::new(NAME, figures, notes))
}

fn forms() -> impl Iterator<Item = (DensityForm, WallPressure)> {
    DensityForm::ALL.iter().flat_map(|density| WallPressure::ALL.iter().map(move |wall| (*density, *wall)))
}

fn scene(side: u16, (density, wall_pressure): (DensityForm, WallPressure)) -> Scene {
    let spacing = BASE / f32::from(side);
    let fluid = Fluid { speed_of_sound: SPEED_OF_SOUND, dynamic_viscosity: VISCOSITY, ..Fluid::default() };
    let block = Block { size: Vec3::new(BASE, HEIGHT, 0.0), ..Block::default() };
    let mut scene = Scene::of(Dimension::Two, spacing, 1.0, fluid, block);
    scene.time_step = (COURANT * support_radius(&scene) / f64::from(SPEED_OF_SOUND)) as f32;
    scene.gravity = Vec3::new(0.0, -GRAVITY, 0.0);
    // Before its release the column rests behind the gate, so it starts hydrostatic. A number density ignores particle
    // masses, so it cannot start like this.
    let initialize_hydrostatic = density != DensityForm::NumberDensity;
    scene.model = Formulation {
        density,
        wall_pressure,
        initialize_hydrostatic,
        normalize_mass: true,
        negative_pressure: false,
        ..WENDLAND
    };
    let shape = WallShape::Box { low: Vec3::ZERO, high: TANK.into(), open: [Face::Ceiling].into_iter().collect() };
    // no slip: the bed of the experiment was dry, and the front is the tongue that runs over it
    scene.walls = [Wall::still(shape)].into_iter().collect();
    scene.grid = grid(Dimension::Two, 64);
    scene
}

fn collapse(context: &Context, side: u16, form: (DensityForm, WallPressure)) -> Result<Front, Failure> {
    let scene = scene(side, form);
    let scene = checked(NAME, &scene)?;
    let mut heap = OwnedMemory::of(&scene);
    let mut solver = start_with(NAME, &scene, scene.initial_particles().collect(), &mut heap)?;
    // T = n t sqrt(g / a), with n^2 = H / a
    let rate = (f64::from(GRAVITY) * f64::from(HEIGHT)).sqrt() / f64::from(BASE);
    let mut front = vec![[0.0, 1.0]];
    let title = format!("{NAME} {side}");
    step(&title, context, &mut solver, steps_to(&scene, END / rate), STEPS_PER_SAMPLE, |solver| {
        let z = place_of_front(solver, &scene) / f64::from(BASE);
        front.push([solver.time() * rate, z]);
    })?;
    Ok(front)
}

/// Returns the far edge of the rightmost column, one spacing wide, that holds at least half of a full layer, m. A
/// particle is one spacing wide and counts for the columns that it overlaps, in proportion to the overlap.
fn place_of_front(solver: &mut Solver<'_>, scene: &Checked<'_>) -> f64 {
    let spacing = f64::from(scene.particle_spacing);
    let water = scene.derived().fluid_particles;
    let mut company = vec![0u32; water];
    solver.neighbours().each_pair(|a, b| {
        let (a, b) = (a as usize, b as usize);
        if a != b
            && b < water
            && let Some(others) = company.get_mut(a)
        {
            *others += 1;
        }
    });
    let columns = (f64::from(TANK[0]) / spacing).ceil() as usize + 1;
    let mut layers = vec![0.0; columns];
    for (particle, company) in solver.particles().zip(company) {
        if company >= COMPANY {
            let left = (f64::from(particle.position.x) / spacing - 0.5).clamp(0.0, (columns - 2) as f64);
            let (column, share) = (left as usize, left.fract());
            layers[column] += 1.0 - share;
            layers[column + 1] += share;
        }
    }
    let front = layers.iter().rposition(|layers| *layers >= 0.5);
    front.map_or(0.0, |column| (column + 1) as f64 * spacing)
}

/// Returns the root mean square of the relative error of Z, with the computed curve delayed by `shift`.
fn rms_error(front: &[[f64; 2]], measured: &[[f64; 2]], shift: f64) -> f64 {
    let square = |[t, z]: &[f64; 2]| ((along(front, t - shift) - z) / z).powi(2);
    (measured.iter().map(square).sum::<f64>() / measured.len() as f64).sqrt()
}

/// Returns the shift with the smallest error, and that error.
fn best_shift(front: &[[f64; 2]], measured: &[[f64; 2]]) -> (f64, f64) {
    let shifts = (0..=SHIFTS).map(|i| LARGEST_SHIFT * f64::from(i) / f64::from(SHIFTS));
    let tried = shifts.map(|shift| (shift, rms_error(front, measured, shift)));
    tried.min_by(|a, b| a.1.total_cmp(&b.1)).unwrap_or((0.0, f64::NAN))
}
