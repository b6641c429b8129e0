//! `poiseuille` and `couette`: start-up of viscous channel flows (case V1). A body force (Poiseuille) or a moving wall
//! (Couette) drives the fluid from rest. Velocity profiles at five times are compared with the series of Morris, Fox
//! and Zhu 1997 at their Reynolds number of 0.0125.
//!
//! One metre in the scene is one millimetre in the paper. The paper's kinematic viscosity of 1e-6 m2/s then becomes
//! 1 m2/s, times stay the same, and f32 resolves the particle spacing. It would not resolve the paper's spacing of
//! 2e-5 m at a distance of 1 m from the origin.
use super::enclosure::Enclosure;
use super::flow::{checked, fluid, grid, larger, start_with, step, steps_to};
use super::form::Form;
use super::formulas::WENDLAND;
use super::reference::{couette as couette_series, numbers, poiseuille as poiseuille_series};
use super::{Context, Metric, Outcome};
use crate::failure::Failure;
use crate::outcome::table;
use glam::Vec3;
use millpond_core::OwnedMemory;
use millpond_core::Solver;
use millpond_core::backend::derive::support_radius;
use millpond_core::scene::{
    Block, Container, Dimension, Face, Fluid, Formulation, Kernel, Periodic, PlaneModel, Scene, Sliding, Viscosity,
    Wall, WallShape,
};

/// Rest density, kg/m3, and dynamic viscosity, Pa s. The kinematic viscosity is 1 m2/s.
const REST_DENSITY: f32 = 1000.0;
const VISCOSITY: f32 = 1000.0;

/// Body force per mass, m/s2, and speed of the lid, m/s. In the paper they are 1e-4 m/s2 and 1.25e-5 m/s. The speed of
/// the lid is also the largest speed that the body force causes.
const FORCE: f32 = 0.1;
const LID: f32 = 0.0125;

/// Speed of sound over the largest speed. Compression is one part in 400.
const MACH: f32 = 20.0;

/// Particles across the channel, in two resolutions, and along it: enough for four grid cells.
const ACROSS: [u16; 2] = [25, 50];
const ALONG: u16 = 12;

/// With this support the lattice sum of a cubic spline gives a second derivative accurate to 1e-4, the softening
/// `0.01 (H / 2)^2` of Morris et al. included (H is the support radius). With 32 neighbours it would be 1.8 % too low,
/// and the channel flow too fast by as much.
const AVERAGE_NEIGHBOURS: f32 = 27.0;

/// Time step over `h^2 / nu`, h being half of the support radius. It is half of the limit 0.125 of Morris et al., since
/// wall particles respond twice as stiffly as the fluid.
const DIFFUSION: f64 = 0.0625;

/// Times at which the profile is compared, s, as in the paper.
const TIMES: [f64; 5] = [0.0225, 0.045, 0.1125, 0.225, 1.0];
const QUICK_TIMES: usize = 4;

/// The last of the times of a quick study, s.
pub(super) const LAST: f64 = TIMES[QUICK_TIMES - 1];

/// Required limit: 2 % of the largest speed at the time, with 50 particles across. Morris et al. report 0.7 %
/// (Poiseuille) and 0.5 % (Couette).
pub(super) const LIMIT: f64 = 0.02;

/// Limit for the series against the reference tables, which have six digits.
const SERIES_LIMIT: f64 = 1e-5;

/// What drives a channel flow, and its reference.
struct Drive {
    name: &'static str,
    /// Series for the velocity over `scale`, as a function of height and time.
    series: fn(f64, f64) -> f64,
    /// Factor from the series to the velocities of the scene, m/s.
    scale: f32,
    /// Acceleration along the channel, m/s2.
    force: f32,
    /// Velocity of the ceiling, m/s.
    lid: f32,
    /// Reference table, and the factor from the series to its velocities, m/s.
    table: &'static str,
    table_scale: f64,
}

const POISEUILLE: Drive = Drive {
    name: "poiseuille",
    series: poiseuille_series,
    scale: FORCE,
    force: FORCE,
    lid: 0.0,
    table: include_str!("../../data/poiseuille.csv"),
    table_scale: 1e-4,
};

const COUETTE: Drive = Drive {
    name: "couette",
    series: couette_series,
    scale: LID,
    force: 0.0,
    lid: LID,
    table: include_str!("../../data/couette.csv"),
    table_scale: 1.25e-5,
};

pub(super) fn poiseuille(context: &Context) -> Result<Outcome, Failure> {
    run(context, &POISEUILLE)
}

pub(super) fn couette(context: &Context) -> Result<Outcome, Failure> {
    run(context, &COUETTE)
}

/// Returns the largest error of another form in the coarser channel of a quick study.
pub(super) fn poiseuille_error(context: &Context, form: &Form, neighbours: f32) -> Result<f64, Failure> {
    Ok(worst(&errors_of(context, &POISEUILLE, ACROSS[0], form, neighbours, &TIMES[..QUICK_TIMES])?))
}

/// The same for the channel whose wall moves.
pub(super) fn couette_error(context: &Context, form: &Form, neighbours: f32) -> Result<f64, Failure> {
    Ok(worst(&errors_of(context, &COUETTE, ACROSS[0], form, neighbours, &TIMES[..QUICK_TIMES])?))
}

fn worst(errors: &[f64]) -> f64 {
    errors.iter().copied().fold(0.0, larger)
}

/// Kinds of walls with which each resolution is run. The first one has the limit of convergence.
const WALLS: [Enclosure; 2] = [Enclosure::MIRRORED, Enclosure::CLOSED_FORM];

/// The formulas of this study, and its number of neighbours.
const MODEL: Formulation = Formulation {
    density_kernel: Kernel::CubicSpline,
    pressure_kernel: Kernel::CubicSpline,
    viscosity_kernel: Kernel::CubicSpline,
    viscosity: Viscosity::Morris,
    normalize_mass: true,
    ..WENDLAND
};

fn run(context: &Context, drive: &Drive) -> Result<Outcome, Failure> {
    let times = if context.quick { &TIMES[..QUICK_TIMES] } else { &TIMES[..] };
    let mut errors = Vec::new();
    for walls in WALLS {
        for across in ACROSS {
            errors.push(errors_of(context, drive, across, &Form { walls, model: MODEL }, AVERAGE_NEIGHBOURS, times)?);
        }
    }
    let worst: Vec<f64> = errors.iter().map(|errors| worst(errors)).collect();
    let [coarse, fine, _, closed] = [0, 1, 2, 3].map(|i| worst.get(i).copied().unwrap_or(f64::NAN));
    let figures = vec![
        Metric::below("series against the reference table", series_error(drive)?, SERIES_LIMIT),
        Metric::below(format!("largest error over u_max, {} particles across", ACROSS[1]), fine, LIMIT),
        Metric::below(format!("that error over the error with {} particles across", ACROSS[0]), fine / coarse, 1.0),
        Metric::below(
            format!("largest error over u_max, {} particles across, walls in closed form", ACROSS[1]),
            closed,
            LIMIT,
        ),
    ];
    let percent = |i: usize, time: usize| format!("{:.2} %", errors[i][time] * 100.0);
    let lines = times
        .iter()
        .enumerate()
        .map(|(time, t)| [format!("{t}"), percent(0, time), percent(1, time), percent(2, time), percent(3, time)]);
    let titles = [
        "t, s",
        "error over u_max, 25 particles across",
        "50 particles across",
        "25 particles across, walls in closed form",
        "50 particles across, walls in closed form",
    ];
    let order = format!("Observed order of the largest error: {:.2}.", (coarse / fine).log2());
    Ok(Outcome::new(drive.name, figures, vec![table(titles, lines), order]))
}

fn scene(drive: &Drive, across: u16, form: &Form, neighbours: f32) -> Scene {
    let spacing = 1.0 / f32::from(across);
    let length = f32::from(ALONG) * spacing;
    let fluid = Fluid {
        rest_density: REST_DENSITY,
        speed_of_sound: MACH * LID,
        dynamic_viscosity: VISCOSITY,
        ..Fluid::default()
    };
    let block = Block { size: Vec3::new(length, 1.0, 0.0), ..Block::default() };
    let mut scene = Scene::of(Dimension::Two, spacing, 1.0, fluid, block);
    scene.average_neighbours = Some(neighbours);
    let h = support_radius(&scene) / 2.0;
    scene.time_step = (DIFFUSION * h * h * f64::from(REST_DENSITY / VISCOSITY)) as f32;
    scene.gravity = Vec3::new(drive.force, 0.0, 0.0);
    scene.model = form.model;
    let high = Vec3::new(length, 1.0, 0.0);
    scene.periodic = Some(Periodic { low: Vec3::ZERO, high, axes: [true, false, false] });
    let slides = Vec3::new(drive.lid, 0.0, 0.0);
    let plane = |face, y| WallShape::Plane { face, low: Vec3::new(0.0, y, 0.0), high: Vec3::new(length, y, 0.0) };
    let wall = |face, y, velocity| Wall { velocity, ..Wall::still(plane(face, y)) };
    match form.walls {
        Enclosure::Particles(wall_pressure) => {
            scene.model.wall_pressure = wall_pressure;
            scene.walls = [wall(Face::Floor, 0.0, Vec3::ZERO), wall(Face::Ceiling, 1.0, slides)].into_iter().collect();
        }
        Enclosure::Planes(model) => {
            let lid = Sliding { face: Face::Ceiling, velocity: slides };
            let sliding = Some(lid).filter(|_| model == PlaneModel::ClosedForm).into_iter().collect();
            scene.container = Some(Container { model, sliding, ..Container::closed(Vec3::ZERO, high) });
        }
    }
    scene.grid = grid(Dimension::Two, 32);
    scene
}

/// Returns the error of the profile at each time, over the largest exact speed at that time.
fn errors_of(
    context: &Context,
    drive: &Drive,
    across: u16,
    form: &Form,
    neighbours: f32,
    times: &[f64],
) -> Result<Vec<f64>, Failure> {
    let scene = scene(drive, across, form, neighbours);
    let scene = checked(drive.name, &scene)?;
    let mut heap = OwnedMemory::of(&scene);
    let mut solver = start_with(drive.name, &scene, scene.initial_particles().collect(), &mut heap)?;
    let title = format!("{} {across}", drive.name);
    let mut errors = Vec::new();
    for time in times {
        let steps = steps_to(&scene, *time).saturating_sub(solver.steps());
        step(&title, context, &mut solver, steps, steps, |_| ())?;
        errors.push(error(drive, &solver));
    }
    Ok(errors)
}

/// Returns the largest velocity error of a particle, over the largest exact speed.
fn error(drive: &Drive, solver: &Solver<'_>) -> f64 {
    let scale = f64::from(drive.scale);
    let (mut miss, mut fastest) = (0.0, 0.0);
    for particle in fluid(solver) {
        let exact = scale * (drive.series)(f64::from(particle.position.y), solver.time());
        miss = larger(miss, (f64::from(particle.velocity.x) - exact).abs());
        fastest = larger(fastest, exact.abs());
    }
    miss / fastest
}

/// Returns the largest difference between the series and the table, over the largest speed at each time.
fn series_error(drive: &Drive) -> Result<f64, Failure> {
    let table = numbers(drive.table)?;
    let mut worst = 0.0;
    for (column, time) in TIMES.iter().enumerate() {
        let (mut miss, mut fastest) = (0.0, 0.0);
        for row in &table {
            let [y, expected] = [0, column + 1].map(|i| row.get(i).copied().unwrap_or(f64::NAN));
            miss = larger(miss, (drive.table_scale * (drive.series)(y, *time) - expected).abs());
            fastest = larger(fastest, expected.abs());
        }
        worst = larger(worst, miss / fastest);
    }
    Ok(worst)
}
