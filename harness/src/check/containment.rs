//! `containment`: nothing leaves a container, and nothing passes through a thin wall.
//!
//! A container of each shape is half full of water and is shaken, with each model of its walls. After every so many
//! steps no particle may be outside, and none may be lost. Then a block of water is thrown at a plate that is thinner
//! than a particle is wide, so fast that a particle crosses it within a step.
use super::flow::{checked, refused_by, start_with};
use super::{Context, Metric, Outcome};
use crate::failure::Failure;
use crate::outcome::table;
use glam::{Vec2, Vec3};
use millpond_core::backend::derive::support_radius;
use millpond_core::scene::{
    Block, Container, Course, Dimension, Fluid, Formulation, Grid, Motion, PlaneModel, Recipe, Scene, Shape, Solid,
    SolidModel, Wall, WallShape,
};
use millpond_core::{OwnedMemory, Solver};

const NAME: &str = "containment";

/// Time of a run, s, in a full and in a quick study; that of the large runs; and steps between two looks.
const TIME: [f64; 2] = [3.0, 0.3];
const LARGE_TIME: f64 = 10.0;
const STEPS_PER_LOOK: u64 = 10;

/// Spacings, m: with these there are about 2000 particles in 2D and in 3D, and in the large runs 20 000 in 3D.
const SPACING_2D: f32 = 0.02;
const SPACING_3D: f32 = 0.05;
const LARGE_SPACING: f32 = 0.0232;

/// Speed of sound, m/s: ten times the fastest flow of the shaken water.
const SOUND: f32 = 40.0;

/// Share of the support radius that sound crosses in a step.
const COURANT: f32 = 0.2;

/// Speeds of the thrown water, m/s, with the speed of sound ten times that; and the thickness of the plate over the
/// spacing.
const THROWN: [f32; 3] = [4.0, 12.0, 40.0];
const PLATE: f32 = 0.2;

/// Required limit of how far a particle may be outside, over the spacing: the distance at which a path counts as having
/// come to a surface is ten times smaller.
const OUTSIDE: f64 = 1e-3;

/// How the container is shaken.
const SHAKEN: Course = Course {
    velocity: Vec3::ZERO,
    amplitude: Vec3::new(0.1, 0.05, 0.0),
    frequency: 1.5,
    phase: 0.0,
    axis: Vec3::Z,
    turns_per_second: 0.0,
    rocking_degrees: 20.0,
};

/// Walls of a container.
#[derive(Clone, Debug)]
enum Walls {
    /// A hollow solid.
    Solid(Shape, SolidModel),
    /// The planes of a container, which cannot move: gravity is shaken instead.
    Planes(PlaneModel),
    /// A box of wall particles with planes behind it.
    Particles,
}

impl Walls {
    fn name(&self) -> String {
        match self {
            Walls::Solid(shape, model) => {
                let shape = format!("{shape:?}");
                format!("{}, {model:?}", shape.split(' ').next().unwrap_or_default())
            }
            Walls::Planes(model) => format!("planes, {model:?}"),
            Walls::Particles => "walls of particles".into(),
        }
    }
}

/// Returns a block of water in the middle of a container that is a metre wide.
fn shaken(dimension: Dimension, spacing: f32, walls: &Walls) -> Scene {
    let size = if dimension == Dimension::Two { Vec3::new(0.9, 0.9, 0.0) } else { Vec3::new(0.6, 0.6, 0.7) };
    let block = Block { corner: size * -0.5, size, ..Block::default() };
    let fluid = Fluid { speed_of_sound: SOUND, ..Fluid::default() };
    let mut scene = Scene::of(dimension, spacing, 1.0, fluid, block);
    scene.model = Formulation::of(Recipe::FreeSurface);
    scene.gravity = Vec3::new(0.0, -9.81, 0.0);
    scene.time_step = COURANT * support_radius(&scene) as f32 / SOUND;
    scene.grid = Grid { cells: [16, 16, if dimension == Dimension::Two { 1 } else { 16 }], ..Grid::default() };
    let half = Vec3::new(0.6, 0.6, 0.6);
    match walls {
        Walls::Solid(shape, model) => {
            let solid = Solid {
                model: *model,
                motion: Motion::Prescribed(SHAKEN),
                ..Solid::still(shape.clone(), [0.0; 3]).hollow()
            };
            scene.solids = [solid].into_iter().collect();
        }
        Walls::Planes(model) => {
            scene.container = Some(Container { model: *model, ..Container::closed(-half, half) });
        }
        Walls::Particles => {
            let model = PlaneModel::Penalty;
            scene.container = Some(Container { model, ..Container::closed(-half, half) });
            let shape = WallShape::Box { low: -half, high: half, open: millpond_core::heapless::Vec::new() };
            scene.walls = [Wall::still(shape)].into_iter().collect();
        }
    }
    scene
}

/// What became of the water.
struct Shaken {
    particles: usize,
    /// Largest distance of a particle outside of its container, over the spacing.
    outside: f64,
    /// Particles that were lost.
    lost: i64,
    /// Particles that were put back to a surface, per particle and second.
    hits: f64,
    /// Largest speed, m/s.
    fastest: f64,
}

/// Returns how far outside of the solids and of the container the farthest particle is, m.
fn farthest(solver: &Solver<'_>, scene: &Scene) -> f64 {
    let positions = solver.particles().filter(|particle| !particle.is_wall).map(|particle| particle.position);
    let outside = positions.map(|x| {
        let of_solids = (0..scene.solids.len()).filter_map(|solid| solver.distance_from_solid(solid, x));
        let of_planes = scene.container.iter().flat_map(|container| {
            let axes = 0..scene.dimension.count();
            axes.flat_map(move |axis| [x[axis] - container.low[axis], container.high[axis] - x[axis]])
        });
        -of_solids.chain(of_planes).fold(f32::MAX, f32::min)
    });
    f64::from(outside.fold(0.0, f32::max))
}

fn shake(context: &Context, scene: &Scene, time: f64) -> Result<Shaken, Failure> {
    let checked = checked(NAME, scene)?;
    let mut heap = OwnedMemory::of(&checked);
    let mut solver = start_with(NAME, &checked, checked.initial_particles().collect(), &mut heap)?;
    let start = i64::from(solver.census().active);
    let (mut outside, mut fastest) = (0.0f64, 0.0f32);
    while solver.time() < time {
        if scene.solids.is_empty() {
            // what a container that is shaken would feel
            let phase = std::f32::consts::TAU * SHAKEN.frequency * solver.time() as f32;
            let swing = SHAKEN.amplitude * (std::f32::consts::TAU * SHAKEN.frequency).powi(2) * phase.sin();
            let tilt = SHAKEN.rocking_degrees.to_radians() * phase.sin();
            let gravity = scene.gravity + swing + Vec3::new(9.81 * tilt.sin(), 0.0, 0.0);
            solver.set_gravity(gravity).map_err(refused_by(NAME))?;
        }
        solver.step(&context.pool)?;
        if solver.steps().is_multiple_of(STEPS_PER_LOOK) {
            outside = outside.max(farthest(&solver, scene));
            fastest = solver.particles().map(|particle| particle.velocity.length()).fold(fastest, f32::max);
        }
    }
    let census = solver.census();
    Ok(Shaken {
        particles: start as usize,
        outside: outside / f64::from(scene.particle_spacing),
        lost: start - i64::from(census.active),
        hits: census.flux.hits as f64 / start as f64 / solver.time(),
        fastest: f64::from(fastest),
    })
}

/// Returns how many particles of a thrown block pass a thin plate.
fn thrown(context: &Context, dimension: Dimension, model: SolidModel, speed: f32) -> Result<f64, Failure> {
    let spacing = if dimension == Dimension::Two { SPACING_2D } else { SPACING_3D };
    let size = Vec3::new(8.0, 8.0, if dimension == Dimension::Two { 0.0 } else { 8.0 }) * spacing;
    let velocity = Vec3::new(speed, 0.1 * speed, 0.0);
    let corner = Vec3::new(-10.0 * spacing, -0.5 * size.y, -0.5 * size.z);
    let fluid = Fluid { speed_of_sound: 10.0 * speed, ..Fluid::default() };
    let mut scene = Scene::of(dimension, spacing, 1.0, fluid, Block { corner, size, velocity, ..Block::default() });
    let room = Vec3::splat(40.0 * spacing);
    let plate = Vec3::new(PLATE * spacing, 60.0 * spacing, 60.0 * spacing);
    let solids = [
        Solid { model, ..Solid::still(Shape::Box { size: plate }, [0.0; 3]) },
        Solid { model, ..Solid::still(Shape::Box { size: room }, [0.0; 3]).hollow() },
    ];
    scene.solids = solids.into_iter().collect();
    // a particle crosses the plate in a step
    scene.time_step = COURANT * support_radius(&scene) as f32 / fluid.speed_of_sound;
    let checked = checked(NAME, &scene)?;
    let mut heap = OwnedMemory::of(&checked);
    let mut solver = start_with(NAME, &checked, checked.initial_particles().collect(), &mut heap)?;
    for _ in 0..(40.0 * spacing / speed / scene.time_step) as u32 {
        solver.step(&context.pool)?;
    }
    let passed = |x: Vec3| x.x > 0.0 || x.abs().max_element() > 0.5 * room.x + spacing;
    Ok(solver.fluid_positions().filter(|x| passed(*x)).count() as f64)
}

/// Returns the corners of a hexagon.
fn hexagon(radius: f32) -> Shape {
    let corner = |i: u16| Vec2::from_angle(f32::from(i) * std::f32::consts::FRAC_PI_3) * radius;
    Shape::Polygon { corners: (0..6).map(corner).collect() }
}

pub(super) fn run(context: &Context) -> Result<Outcome, Failure> {
    let models = [SolidModel::Penalty, SolidModel::ClosedForm, SolidModel::Particles];
    let flat = [Shape::Ball { radius: 0.75 }, Shape::Box { size: Vec3::splat(1.2) }, hexagon(0.85)];
    let solid = [
        Shape::Ball { radius: 0.6 },
        Shape::Box { size: Vec3::splat(1.0) },
        Shape::Cylinder { radius: 0.55, height: 1.1 },
        Shape::Capsule { radius: 0.5, length: 0.4 },
    ];
    let with_models = |shapes: &[Shape]| -> Vec<Walls> {
        shapes.iter().flat_map(|shape| models.map(|model| Walls::Solid(shape.clone(), model))).collect()
    };
    let others = [Walls::Planes(PlaneModel::Penalty), Walls::Planes(PlaneModel::ClosedForm), Walls::Particles];
    let time = TIME[usize::from(context.quick)];
    let mut cases: Vec<(Dimension, f32, Walls, f64)> = Vec::new();
    for (dimension, spacing, shapes) in
        [(Dimension::Two, SPACING_2D, &flat[..]), (Dimension::Three, SPACING_3D, &solid[..])]
    {
        let all = with_models(shapes).into_iter().chain(others.clone());
        cases.extend(all.map(|walls| (dimension, spacing, walls, time)));
    }
    if !context.quick {
        let large = models.map(|model| Walls::Solid(solid[0].clone(), model));
        cases.extend(large.map(|walls| (Dimension::Three, LARGE_SPACING, walls, LARGE_TIME)));
    }
    let (mut figures, mut lines) = (Vec::new(), Vec::new());
    for (dimension, spacing, walls, time) in cases {
        let shaken = shake(context, &shaken(dimension, spacing, &walls), time)?;
        let name = format!("{}D, {}, {} particles, {time} s", dimension.count(), walls.name(), shaken.particles);
        figures.push(Metric::below(format!("{name}: outside, in spacings"), shaken.outside, OUTSIDE));
        figures.push(Metric::below(format!("{name}: particles lost"), shaken.lost as f64, 0.0));
        lines.push([name, format!("{:.1}", shaken.hits), format!("{:.1}", shaken.fastest)]);
    }
    for dimension in [Dimension::Two, Dimension::Three] {
        for model in models {
            for speed in THROWN {
                let passed = thrown(context, dimension, model, speed)?;
                let name =
                    format!("{}D, {model:?}, thrown at {speed} m/s: particles that pass the plate", dimension.count());
                figures.push(Metric::below(name, passed, 0.0));
            }
        }
    }
    let notes = vec![table(["case", "put back to a surface, per particle and second", "fastest, m/s"], lines)];
    Ok(Outcome::new(NAME, figures, notes))
}
