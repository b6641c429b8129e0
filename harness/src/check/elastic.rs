//! `elastic`: Pirovano test 3 (section 5.3.3), an elastic cube, and the spring that it is made of (Pirovano, eq. 2.26).
//!
//! Two particles on one spring oscillate with the period that follows from its stiffness and their masses. The error of
//! the period falls with the number of steps per period. An elastic cube that falls onto the floor of a box flattens,
//! bounces, vibrates and recovers its shape. The sum of its energies must not grow: penalty planes take energy away and
//! supply none.
use super::flow::{checked, fluid, grid, larger, mean, start_with, step, steps_to};
use super::formulas::WENDLAND;
use super::{Context, Metric, Outcome};
use crate::failure::Failure;
use crate::outcome::table;
use glam::Vec3;
use millpond_core::OwnedMemory;
use millpond_core::backend::report::Energies;
use millpond_core::scene::{Block, Container, Dimension, Fluid, Formulation, InitialParticle, PlaneModel, Scene};
use millpond_core::{Particle, Solver};
use std::f64::consts::{PI, TAU};

const NAME: &str = "elastic";

/// The pair: spacing, m; stiffness, N/m; speed of each particle, m/s, which stretches the spring by a sixth.
const PAIR_SPACING: f32 = 0.1;
const PAIR_STIFFNESS: f32 = 400.0;
const PAIR_SPEED: f32 = 0.05;

/// Steps per period, and number of periods that are measured.
const STEPS: [u16; 2] = [50, 100];
const PERIODS: u64 = 10;

/// Required limits of the error of the period and of its order. The error of the Verlet method is `(omega dt)^2 / 24`:
/// 0.066 % with 50 steps per period.
const PERIOD_LIMIT: f64 = 1e-3;
const ORDER: f64 = 1.9;

/// Limit of the energy error of the pair. The Verlet method conserves an energy close to the true one, which oscillates
/// about it by `(omega dt)^2 / 4`: 0.1 % with 100 steps per period.
const PAIR_ENERGY_LIMIT: f64 = 2e-3;

/// The cube: particles along an edge, in a full and in a quick study; spacing, m; height above the floor at the
/// start, m; distance from the side walls, m; gravity, m/s2.
const EDGE: u16 = 10;
const QUICK_EDGE: u16 = 8;
const SPACING: f32 = 0.05;
const DROP: f32 = 0.3;
const MARGIN: f32 = 0.3;
const GRAVITY: f32 = 9.81;

/// Stiffness, N/m. A lattice whose nearest and diagonal springs pull with k/2 has a Young's modulus of
/// `5/4 k / spacing`. Landing with 2.5 m/s flattens the cube by an eighth, and its own weight flattens it by a
/// hundredth.
const STIFFNESS: f32 = 10_000.0;

/// Speed of sound, m/s, and dynamic viscosity, Pa s. With this viscosity the vibrations decay within the time of the
/// study.
const SPEED_OF_SOUND: f32 = 20.0;
const VISCOSITY: f32 = 60.0;

/// Time step, s: a third of the limit of the stiffest wave in the lattice.
const TIME_STEP: f32 = 0.0005;
const END: f64 = 2.5;
const STEPS_PER_SAMPLE: u64 = 10;

/// Limits of the change of the total energy, over that at the start. In free flight only f32 rounds off. Later the
/// energy only falls, except that the internal energy does not fully account for walls that put particles back.
const FLIGHT_LIMIT: f64 = 1e-4;
const RISE_LIMIT: f64 = 0.01;

/// Limit of the relative difference between the solver's elastic energy and the sum over the springs made here.
const SPRINGS_LIMIT: f64 = 1e-3;

/// Limits that show a soft cube: smallest height over that at the start, then rise of the centre and of the lowest
/// particle after the bounce, m.
const FLATTEST: f64 = 0.95;
const BOUNCE: f64 = 0.1;
const CLEARANCE: f64 = 0.05;

/// Limits that show a recovered shape: rms strain of the springs, and relative errors of the extents.
const STRAIN_LIMIT: f64 = 0.02;
const EXTENT_LIMIT: f64 = 0.05;

pub(super) fn run(context: &Context) -> Result<Outcome, Failure> {
    let [few, many] = STEPS;
    let [coarse, fine] = [swing(context, few)?, swing(context, many)?];
    let order = ((coarse.period - 1.0) / (fine.period - 1.0)).abs().log2();
    let cube = fall(context)?;
    let figures = vec![
        Metric::below(format!("period error of a pair, {few} steps"), (coarse.period - 1.0).abs(), PERIOD_LIMIT),
        Metric::above(format!("order of that error, {few} to {many} steps"), order, ORDER),
        Metric::below(format!("energy error of a pair, {many} steps"), fine.energy, PAIR_ENERGY_LIMIT),
        Metric::below("energy error of a falling cube", cube.flight, FLIGHT_LIMIT),
        Metric::below("largest rise of its energy, over that at the start", cube.rise, RISE_LIMIT),
        Metric::below("error of its elastic energy against the sum over springs", cube.springs, SPRINGS_LIMIT),
        Metric::below("its smallest height over that at the start", cube.flattest, FLATTEST),
        Metric::above("rise of its centre after the bounce, m", cube.restitution, BOUNCE),
        Metric::above("rise of its lowest particle after the bounce, m", cube.clearance, CLEARANCE),
        Metric::below("rms strain of its springs at the end", cube.strain, STRAIN_LIMIT),
        Metric::below("largest error of its extents at the end", cube.extent, EXTENT_LIMIT),
    ];
    let pairs = [(few, coarse), (many, fine)].map(|(steps, swing)| {
        // the frequency omega' of velocity Verlet: sin(omega' dt / 2) = omega dt / 2
        let half = PI / f64::from(steps);
        [steps.to_string(), format!("{:.6}", swing.period), format!("{:.6}", half / half.asin())]
    });
    let moments = cube.moments.iter().map(|(moment, time, energies)| {
        let Energies { kinetic, internal, potential, elastic } = *energies;
        let [kinetic, internal, potential, elastic] =
            [kinetic, internal, potential, elastic].map(|energy| format!("{energy:.1}"));
        [(*moment).into(), format!("{time:.2}"), kinetic, internal, potential, elastic]
    });
    let notes = vec![
        table(["steps per period", "period of a pair over 2 pi sqrt(m/k)", "Verlet in theory"], pairs),
        table(["cube", "t, s", "kinetic, J", "internal", "potential", "elastic"], moments),
    ];
    Ok(Outcome::new(NAME, figures, notes))
}

/// Results of a pair.
#[derive(Clone, Copy, Debug)]
struct Swing {
    /// Period over `2 pi sqrt(m/k)`, the exact period: the spring has half of the stiffness, and the reduced mass of
    /// two particles is half of their mass.
    period: f64,
    /// Largest relative change of the total energy.
    energy: f64,
}

/// Returns a scene of two particles that interact only by a spring: the density of one pair is far below the rest
/// density, and negative pressure is off.
fn pair() -> Scene {
    let fluid = Fluid { elastic_stiffness: PAIR_STIFFNESS, ..Fluid::default() };
    let block = Block { size: Vec3::new(2.0 * PAIR_SPACING, PAIR_SPACING, 0.0), ..Block::default() };
    let mut scene = Scene::of(Dimension::Two, PAIR_SPACING, 1.0, fluid, block);
    scene.model = Formulation { negative_pressure: false, ..WENDLAND };
    scene.grid = grid(Dimension::Two, 8);
    scene
}

fn swing(context: &Context, steps: u16) -> Result<Swing, Failure> {
    let mut scene = pair();
    let exact = TAU * (checked(NAME, &scene)?.derived().particle_mass / f64::from(PAIR_STIFFNESS)).sqrt();
    scene.time_step = (exact / f64::from(steps)) as f32;
    let apart = [-PAIR_SPEED, PAIR_SPEED].map(|speed| [speed, 0.0, 0.0]);
    let scene = checked(NAME, &scene)?;
    let places = scene
        .initial_particles()
        .zip(apart)
        .map(|(place, velocity)| InitialParticle { velocity: velocity.into(), ..place });
    let mut heap = OwnedMemory::of(&scene);
    let mut solver = start_with(NAME, &scene, places.collect(), &mut heap)?;
    let start = total(&solver.energies());
    let (mut last, mut crossings, mut energy) = (0.0, Vec::new(), 0.0);
    let title = format!("{NAME} pair {steps}");
    let all = u64::from(steps) * (PERIODS + 1);
    step(&title, context, &mut solver, all, 1, |solver| {
        let now = stretches(solver).first().map_or(f64::NAN, |[stretch, _]| *stretch);
        if last < 0.0 && now >= 0.0 {
            crossings.push(solver.time() - f64::from(scene.time_step) * now / (now - last));
        }
        last = now;
        energy = larger(energy, (total(&solver.energies()) / start - 1.0).abs());
    })?;
    let period = match crossings[..] {
        [first, .., last] => (last - first) / (crossings.len() - 1) as f64,
        _ => f64::NAN,
    };
    Ok(Swing { period: period / exact, energy })
}

/// Results of a cube.
#[derive(Clone, Debug)]
struct Fall {
    /// Largest change of the total energy before contact with the floor, over that at the start.
    flight: f64,
    /// Largest rise of the total energy, over that at the start.
    rise: f64,
    /// Relative error of the solver's elastic energy at its largest value.
    springs: f64,
    /// Smallest height over that at the start.
    flattest: f64,
    /// Largest rise of the centre from its lowest position, m.
    restitution: f64,
    /// Largest height of the lowest particle after the first contact, m.
    clearance: f64,
    /// Root mean square strain of the springs at the end.
    strain: f64,
    /// Largest relative error of an extent at the end, against the start.
    extent: f64,
    /// Names of moments, their times, s, and energies, J.
    moments: Vec<(&'static str, f64, Energies)>,
}

/// Returns a cube above the floor of a box whose walls return no energy.
fn cube(context: &Context) -> Scene {
    let edge = f32::from(if context.quick { QUICK_EDGE } else { EDGE }) * SPACING;
    let fluid = Fluid {
        speed_of_sound: SPEED_OF_SOUND,
        dynamic_viscosity: VISCOSITY,
        elastic_stiffness: STIFFNESS,
        ..Fluid::default()
    };
    let block = Block { corner: Vec3::new(MARGIN, DROP, MARGIN), size: Vec3::splat(edge), ..Block::default() };
    let mut scene = Scene::of(Dimension::Three, SPACING, TIME_STEP, fluid, block);
    scene.average_neighbours = Some(32.0);
    scene.gravity = Vec3::new(0.0, -GRAVITY, 0.0);
    let width = edge + 2.0 * MARGIN;
    let model = PlaneModel::Penalty;
    scene.container = Some(Container { model, ..Container::closed([0.0; 3], [width, 2.0 * (edge + DROP), width]) });
    scene.model = Formulation { normalize_mass: true, negative_pressure: false, internal_energy: true, ..WENDLAND };
    scene.grid = grid(Dimension::Three, 16);
    scene
}

fn fall(context: &Context) -> Result<Fall, Failure> {
    let scene = cube(context);
    let contact = (2.0 * f64::from(DROP + SPACING / 2.0) / f64::from(GRAVITY)).sqrt();
    let scene = checked(NAME, &scene)?;
    let mut heap = OwnedMemory::of(&scene);
    let mut solver = start_with(NAME, &scene, scene.initial_particles().collect(), &mut heap)?;
    let (energies, size) = (solver.energies(), extents(&solver).map(length));
    let start = total(&energies);
    let (mut flight, mut rise, mut bounce, mut clearance) = (0.0, 0.0, 0.0, 0.0);
    let (mut flattest, mut lowest_centre) = (f64::INFINITY, f64::INFINITY);
    // at the largest elastic energy: the solver's energies, the sum over the springs, and the time
    let mut fullest = (Energies::default(), f64::NAN, 0.0);
    step(NAME, context, &mut solver, steps_to(&scene, END), STEPS_PER_SAMPLE, |solver| {
        let now = solver.energies();
        let change = total(&now) / start - 1.0;
        rise = larger(rise, change);
        if solver.time() < contact - f64::from(TIME_STEP) {
            flight = larger(flight, change.abs());
            return;
        }
        let centre = mean(&fluid(solver), |particle| f64::from(particle.position.y));
        let [_, [low, high], _] = extents(solver);
        lowest_centre = lowest_centre.min(centre);
        bounce = larger(bounce, centre - lowest_centre);
        clearance = larger(clearance, low);
        flattest = flattest.min((high - low) / size[1]);
        if now.elastic > fullest.0.elastic {
            // half of the stiffness with which it pulls, which is half of the fluid's
            let energy = |stretch: f64| 0.25 * f64::from(STIFFNESS) * stretch * stretch;
            fullest = (now, stretches(solver).iter().map(|[stretch, _]| energy(*stretch)).sum(), solver.time());
        }
    })?;
    let sizes = extents(&solver).map(length).into_iter().zip(size);
    let (at_fullest, summed, time) = fullest;
    Ok(Fall {
        flight,
        rise,
        springs: (at_fullest.elastic / summed - 1.0).abs(),
        flattest,
        restitution: bounce,
        clearance,
        strain: mean(&stretches(&solver), |[stretch, rest]| (stretch / rest).powi(2)).sqrt(),
        extent: sizes.map(|(now, before)| (now / before - 1.0).abs()).fold(0.0, larger),
        moments: vec![
            ("at the start", 0.0, energies),
            ("largest elastic energy", time, at_fullest),
            ("at the end", solver.time(), solver.energies()),
        ],
    })
}

/// Returns the total energy, J.
fn total(energies: &Energies) -> f64 {
    energies.kinetic + energies.internal + energies.potential + energies.elastic
}

/// Returns the elongation and the rest length of each spring, m.
fn stretches(solver: &Solver<'_>) -> Vec<[f64; 2]> {
    let particles: Vec<Particle> = solver.particles().collect();
    let place = |id: u32| particles.get(id as usize).map_or(Vec3::NAN, |particle| particle.position);
    let stretch = |a: u32, b: u32, rest: f64| [f64::from(place(a).distance(place(b))) - rest, rest];
    solver.springs().map(|spring| stretch(spring.a, spring.b, f64::from(spring.rest_length))).collect()
}

/// Returns the lowest and the highest coordinate along x, y and z, m.
fn extents(solver: &Solver<'_>) -> [[f64; 2]; 3] {
    let particles = fluid(solver);
    [0, 1, 2].map(|axis: usize| {
        let along = particles.iter().map(|particle| f64::from(particle.position[axis]));
        along.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| [low.min(x), high.max(x)])
    })
}

fn length([low, high]: [f64; 2]) -> f64 {
    high - low
}
