//! `solids`: water at rest in containers and around obstacles of every shape. The container carries the weight of the
//! water, an obstacle is lifted by the weight of the water that it displaces (Archimedes), and pressure grows with depth.
use super::flow::{checked, fluid, start_with};
use super::{Context, Metric, Outcome};
use crate::failure::Failure;
use crate::outcome::table;
use glam::{Vec2, Vec3};
use millpond_core::backend::derive::support_radius;
use millpond_core::scene::{
    Block, Container, Dimension, Fluid, Formulation, Grid, Recipe, Scene, Shape, Solid, SolidModel, WallPressure,
};
use millpond_core::{OwnedMemory, Particle};

const NAME: &str = "solids";

/// Particle spacings, m, in 2D and in 3D; twice as large in a quick study.
const SPACING: [f32; 2] = [0.02, 0.04];

const GRAVITY: f32 = 9.81;
const REST_DENSITY: f32 = 1000.0;

/// Speed of sound, m/s: more than ten times that of a fall through the depth of the water.
const SOUND: f32 = 50.0;
const COURANT: f32 = 0.25;

/// Damping of the settling water.
const ALPHA: f32 = 0.2;

/// Time to settle in a full and in a quick study, and time over which forces are averaged, s.
const SETTLED: [f64; 2] = [3.0, 1.2];
const AVERAGED: f64 = 0.5;
const STEPS_PER_SAMPLE: u64 = 20;

/// Limits: error of the force over the weight of the water (container); where the water acts on an obstacle, in spacings
/// outside of its surface, from the volume that its weight lifts (the surface lies somewhere between two rows of
/// particles, so half a spacing is all that can be asked, and we ask for less); and root mean square error of the
/// pressure, off a column of the same mean, over that of one spacing of depth, since the surface is a row of particles,
/// or of a share of the whole depth, if that is more.
const WEIGHT: f64 = 0.02;
const LIFT: f64 = 0.3;
const PRESSURE: f64 = 1.0;
const SHARE_OF_DEPTH: f64 = 0.05;

/// A case: name, solid, corner and size of the block of water, and volume and surface of the solid, m3 and m2 (m2 and m in
/// 2D); none for a container.
struct Case {
    name: String,
    dimension: Dimension,
    solid: Solid,
    corner: Vec3,
    size: Vec3,
    displaced: Option<[f64; 2]>,
}

/// What a case shows.
struct Rest {
    /// Upward force on the solid, N.
    force: f64,
    /// Force across, N.
    across: f64,
    /// Weight of the water, N.
    weight: f64,
    /// Root mean square error of the pressure, over what is allowed.
    pressure: f64,
    /// Root mean square speed, m/s.
    speed: f64,
    particles: usize,
}

/// Returns the particle spacing, m.
fn spacing(context: &Context, case: &Case) -> f64 {
    let spacing = SPACING[usize::from(case.dimension == Dimension::Three)];
    f64::from(if context.quick { 2.0 * spacing } else { spacing })
}

fn rest(context: &Context, case: &Case) -> Result<Rest, Failure> {
    let is_flat = case.dimension == Dimension::Two;
    let spacing = spacing(context, case) as f32;
    let block = Block { corner: case.corner, size: case.size, around_solids: true, ..Block::default() };
    let water = Fluid { rest_density: REST_DENSITY, speed_of_sound: SOUND, ..Fluid::default() };
    let mut scene = Scene::of(case.dimension, spacing, 1.0, water, block);
    scene.model = Formulation { alpha: ALPHA, ..Formulation::of(Recipe::FreeSurface) };
    scene.model.wall_pressure = WallPressure::Extrapolated;
    scene.gravity = Vec3::new(0.0, -GRAVITY, 0.0);
    scene.time_step = COURANT * support_radius(&scene) as f32 / SOUND;
    scene.grid = Grid { cells: [32, 32, if is_flat { 1 } else { 16 }], ..Grid::default() };
    scene.solids = [case.solid.clone()].into_iter().collect();
    if case.displaced.is_some() {
        let high = Vec3::new(case.size.x, 2.0 * case.size.y, if is_flat { 1.0 } else { case.size.z });
        scene.container = Some(Container::closed(case.corner, case.corner + high));
    }
    let checked = checked(NAME, &scene)?;
    let mut heap = OwnedMemory::of(&checked);
    let mut solver = start_with(NAME, &checked, checked.initial_particles().collect(), &mut heap)?;
    let (mut force, mut samples) = (Vec3::ZERO, 0.0);
    let settled = SETTLED[usize::from(context.quick)];
    while solver.time() < settled + AVERAGED {
        solver.step(&context.pool)?;
        if solver.time() >= settled && solver.steps().is_multiple_of(STEPS_PER_SAMPLE) {
            force += solver.neighbours().force_on_solid(0).unwrap_or_default().force;
            samples += 1.0;
        }
    }
    let force = force / samples;
    let water = fluid(&solver);
    let mass: f64 = water.iter().map(|particle| f64::from(particle.mass)).sum();
    let heights = water.iter().map(|particle| particle.position.y);
    let depth = heights.clone().fold(f32::MIN, f32::max) - heights.fold(f32::MAX, f32::min);
    let allowed = f64::from(REST_DENSITY * GRAVITY) * f64::from(spacing).max(SHARE_OF_DEPTH * f64::from(depth));
    let count = water.len() as f64;
    let head = |particle: &Particle| f64::from(particle.pressure + REST_DENSITY * GRAVITY * particle.position.y);
    let mean = water.iter().map(head).sum::<f64>() / count;
    let errors = water.iter().map(|particle| ((head(particle) - mean) / allowed).powi(2));
    let speeds: f64 = water.iter().map(|particle| f64::from(particle.velocity.length_squared())).sum();
    Ok(Rest {
        force: f64::from(force.y),
        across: f64::from(Vec2::new(force.x, force.z).length()),
        weight: mass * f64::from(GRAVITY),
        pressure: (errors.sum::<f64>() / count).sqrt(),
        speed: (speeds / count).sqrt(),
        particles: water.len(),
    })
}

fn cases() -> Vec<Case> {
    use std::f64::consts::PI;
    let tilted = Vec3::new(0.0, 0.0, 25.0);
    let in_space = Vec3::new(10.0, 0.0, 25.0);
    let square = Shape::Box { size: Vec3::new(0.3, 0.2, 0.3) };
    let triangle =
        Shape::Polygon { corners: [(-0.2, -0.15), (0.2, -0.15), (0.0, 0.2)].map(Vec2::from).into_iter().collect() };
    let container = |name: &str, dimension, shape: Shape, turned: Vec3| {
        let half = 0.8;
        let flat = dimension == Dimension::Two;
        let depth = if flat { 0.0 } else { half };
        Case {
            name: name.into(),
            dimension,
            solid: Solid { turned, ..Solid::still(shape, [0.0; 3]).hollow() },
            corner: Vec3::new(-half, -half, -depth),
            size: Vec3::new(2.0 * half, half, 2.0 * depth),
            displaced: None,
        }
    };
    let obstacle = |name: &str, dimension, shape: Shape, turned: Vec3, displaced: [f64; 2]| {
        let flat = dimension == Dimension::Two;
        let z = if flat { 0.0 } else { 0.4 };
        Case {
            name: name.into(),
            dimension,
            solid: Solid { turned, ..Solid::still(shape, [0.4, 0.4, z]) },
            corner: Vec3::ZERO,
            size: Vec3::new(0.8, 0.8, 2.0 * z),
            displaced: Some(displaced),
        }
    };
    let (two, three) = (Dimension::Two, Dimension::Three);
    vec![
        container("in a disc, 2D", two, Shape::Ball { radius: 0.6 }, Vec3::ZERO),
        container("in a tilted square, 2D", two, Shape::Box { size: Vec3::splat(1.0) }, tilted),
        container("in a ball", three, Shape::Ball { radius: 0.6 }, Vec3::ZERO),
        container("in a tilted cube", three, Shape::Box { size: Vec3::splat(0.9) }, in_space),
        container("in a tilted cylinder", three, Shape::Cylinder { radius: 0.5, height: 1.0 }, in_space),
        container("in a tilted capsule", three, Shape::Capsule { radius: 0.4, length: 0.5 }, in_space),
        obstacle("around a disc, 2D", two, Shape::Ball { radius: 0.15 }, Vec3::ZERO, [PI * 0.15 * 0.15, PI * 0.3]),
        obstacle("around a tilted rectangle, 2D", two, square.clone(), tilted, [0.06, 1.0]),
        obstacle("around a triangle, 2D", two, triangle, Vec3::ZERO, [0.07, 1.206]),
        obstacle("around a ball", three, Shape::Ball { radius: 0.2 }, Vec3::ZERO, [4.0 / 3.0 * PI * 0.008, PI * 0.16]),
        obstacle("around a tilted box", three, square, in_space, [0.018, 0.42]),
        obstacle(
            "around a tilted cylinder",
            three,
            Shape::Cylinder { radius: 0.2, height: 0.3 },
            in_space,
            [PI * 0.04 * 0.3, PI * 0.2],
        ),
    ]
}

pub(super) fn run(context: &Context) -> Result<Outcome, Failure> {
    let (mut figures, mut lines) = (Vec::new(), Vec::new());
    for case in cases() {
        for model in [SolidModel::ClosedForm, SolidModel::Particles] {
            let case = Case { solid: Solid { model, ..case.solid.clone() }, name: case.name.clone(), ..case };
            let Rest { force, across, weight, pressure, speed, particles } = rest(context, &case)?;
            let name = format!("{}, {model:?}", case.name);
            let per_volume = f64::from(REST_DENSITY * GRAVITY);
            let due = case.displaced.map_or(-weight, |[volume, _]| volume * per_volume);
            figures.push(if let Some([volume, surface]) = case.displaced {
                let outside = (force / per_volume - volume) / surface / spacing(context, &case);
                let figure = format!("{name}: where the water acts, outside of the surface, in spacings");
                Metric::below(figure, outside.abs(), LIFT)
            } else {
                let off = (force + weight).abs() / weight;
                Metric::below(format!("{name}: force, off the weight of the water"), off, WEIGHT)
            });
            figures.push(Metric::below(
                format!("{name}: pressure, rms off that of its depth, over what is allowed"),
                pressure,
                PRESSURE,
            ));
            lines.push([
                name,
                particles.to_string(),
                format!("{force:.1}"),
                format!("{due:.1}"),
                format!("{across:.2}"),
                format!("{speed:.4}"),
            ]);
        }
    }
    let head = ["case", "particles", "upward force, N", "in theory, N", "force across, N", "rms speed, m/s"];
    Ok(Outcome::new(NAME, figures, vec![table(head, lines)]))
}
