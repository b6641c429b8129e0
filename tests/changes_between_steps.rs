//! Promise: gravity, wind, the time step, and a fluid's viscosity, surface tension and stiffness can be changed between
//! steps, on both backends with the same bits. A change before the first step is equivalent to a scene created with the
//! new value, except for the masses of a hydrostatic start and for variable supports. A change of a term that the plan
//! left out, or to a value that no scene can have, is rejected with an error that names the field, and changes nothing.
use millpond::compare::difference;
use millpond::snapshot::Snapshot;
use millpond_core::glam::Vec3;
use millpond_core::scene::{
    AccelerationField, AdaptiveTimeStep, Adjustable, Block, Container, Dimension, Fluid, Formulation, Grid, Integrator,
    Motion, PlaneModel, Recipe, Scene, Shape, Solid, SolidModel, SurfaceTension, Viscosity, Wind,
};
use millpond_core::{OwnedMemory, Requirements, SceneError, Serial, SolidError, SolidState, Solver};
use millpond_gpu::{GpuError, GpuSolver, Mode};

mod support;
use support::device;

/// Returns a block that falls into its box, with every property that can be changed.
fn scene() -> Scene {
    let water = Fluid { dynamic_viscosity: 2.0, surface_tension: 3.0, ..Fluid::default() };
    let block =
        Block { corner: Vec3::new(0.1, 0.05, 0.0), size: Vec3::new(0.4, 0.5, 0.0), jitter: 0.2, ..Block::default() };
    let mut scene = Scene::of(Dimension::Two, 0.05, 0.001, water, block);
    scene.model = Formulation::of(Recipe::Pirovano);
    scene.average_neighbours = Some(18.0);
    scene.gravity = Vec3::new(0.0, -9.81, 0.0);
    scene.wind = Some(Wind { velocity: Vec3::new(2.0, 0.0, 0.0), drag: 1.0 });
    scene.model.surface_tension = SurfaceTension::Attraction;
    scene.container = Some(Container { model: PlaneModel::Penalty, ..Container::closed([0.0; 3], [0.8, 0.8, 0.4]) });
    scene.grid = Grid { cells: [8, 8, 4], ..Grid::default() };
    scene
}

type OnCpu = fn(&mut Solver<'_>) -> Result<(), SceneError>;
type OnGpu = fn(&mut GpuSolver) -> Result<(), GpuError>;
type InScene = fn(&mut Scene);

/// Each change: its name, how to make it on either backend, and how to make it in a scene.
const CHANGES: &[(&str, OnCpu, OnGpu, InScene)] = &[
    (
        "gravity",
        |s| s.set_gravity([3.0, -4.0, 0.0]),
        |s| s.set_gravity([3.0, -4.0, 0.0]),
        |s| s.gravity = Vec3::new(3.0, -4.0, 0.0),
    ),
    ("no wind", |s| s.set_wind(None), |s| s.set_wind(None), |s| s.wind = None),
    ("time step", |s| s.set_time_step(0.0007), |s| s.set_time_step(0.0007), |s| s.time_step = 0.0007),
    ("viscosity", |s| s.set_viscosity(0, 9.0), |s| s.set_viscosity(0, 9.0), |s| s.fluids[0].dynamic_viscosity = 9.0),
    (
        "tension",
        |s| s.set_surface_tension(0, 8.0),
        |s| s.set_surface_tension(0, 8.0),
        |s| s.fluids[0].surface_tension = 8.0,
    ),
    (
        "sound",
        |s| s.set_speed_of_sound(0, 14.0),
        |s| s.set_speed_of_sound(0, 14.0),
        |s| s.fluids[0].speed_of_sound = 14.0,
    ),
    ("stiffness", |s| s.set_stiffness(0, 9e3), |s| s.set_stiffness(0, 9e3), |s| s.fluids[0].stiffness = Some(9e3)),
];

fn memory(scene: &Scene) -> OwnedMemory {
    OwnedMemory::of(&scene.check().expect("a scene"))
}

fn steps(solver: &mut Solver<'_>, count: u32) {
    (0..count).for_each(|_| solver.step(&Serial).expect("a step"));
}

#[test]
fn a_change_before_the_first_step_is_another_scene() {
    for (name, change, _, in_scene) in CHANGES {
        let mut other = scene();
        in_scene(&mut other);
        let mut heaps = [memory(&scene()), memory(&scene())];
        let [first, second] = &mut heaps;
        let mut changed = Solver::new(&scene(), first.lend()).expect("a scene");
        change(&mut changed).expect("a change");
        // the plan of the other scene may leave out a term that the changed solver has at 0
        let mut created = Solver::new(&other, second.lend()).expect("a scene");
        steps(&mut changed, 12);
        steps(&mut created, 12);
        assert_eq!(changed.full_hash(), created.full_hash(), "{name}");
        assert_eq!(changed.time(), created.time(), "{name}");
    }
}

#[test]
fn a_change_between_steps_gives_the_same_bits_on_a_device() {
    let gpu = device("changes_between_steps", Mode::Strict);
    for integrator in [Integrator::ModifiedVelocityVerlet, Integrator::Verlet] {
        let mut base = scene();
        base.model.integrator = integrator;
        for (name, on_cpu, on_gpu, _) in CHANGES {
            let mut heaps = [memory(&base), memory(&base)];
            let [first, second] = &mut heaps;
            let mut solver = Solver::new(&base, first.lend()).expect("a scene");
            let mut left_alone = Solver::new(&base, second.lend()).expect("a scene");
            let mut fluid = gpu.as_ref().map(|gpu| GpuSolver::new(gpu, &solver).expect("a device that takes it"));
            steps(&mut solver, 9);
            on_cpu(&mut solver).expect("a change");
            steps(&mut solver, 9);
            steps(&mut left_alone, 18);
            let want = Snapshot::of_cpu(&solver);
            assert!(difference(&Snapshot::of_cpu(&left_alone), &want).is_some(), "{name} changes something");
            if let Some(fluid) = &mut fluid {
                fluid.step(9).expect("steps");
                on_gpu(fluid).expect("a change");
                fluid.step(9).expect("steps");
                let got = Snapshot::of_gpu(fluid).expect("a state");
                assert_eq!(difference(&want, &got).map(|found| found.first), None, "{name}, {integrator:?}");
            }
        }
    }
}

#[test]
fn time_goes_on_from_where_the_step_was_changed() {
    let mut heap = memory(&scene());
    let mut solver = Solver::new(&scene(), heap.lend()).expect("a scene");
    steps(&mut solver, 10);
    solver.set_time_step(0.0005).expect("a change");
    steps(&mut solver, 4);
    let [before, after] = [0.001f32, 0.0005].map(f64::from);
    assert_eq!(solver.time(), 10.0 * before + 4.0 * after);
    assert_eq!(solver.time_report().time_step, 0.0005);
}

#[test]
fn a_displacement_that_is_remembered_follows_the_time_step() {
    // without any force Verlet's displacement is v dt, however dt changes
    let mut alone = scene();
    (alone.gravity, alone.wind, alone.container) = (Vec3::ZERO, None, None);
    alone.blocks[0] =
        Block { size: Vec3::new(0.05, 0.05, 0.0), velocity: Vec3::new(1.0, 0.5, 0.0), ..Block::default() };
    alone.model.integrator = Integrator::Verlet;
    let mut heap = memory(&alone);
    let mut solver = Solver::new(&alone, heap.lend()).expect("a scene");
    steps(&mut solver, 3);
    solver.set_time_step(0.002).expect("a change");
    steps(&mut solver, 3);
    let particle = solver.particles().next().expect("a particle");
    // six roundings of numbers below 1
    assert!(
        (particle.velocity.x - 1.0).abs() < 6.0 * f32::EPSILON
            && (particle.velocity.y - 0.5).abs() < 6.0 * f32::EPSILON
    );
    assert!((particle.position.x - (0.025 + 0.009)).abs() < 6.0 * f32::EPSILON);
}

#[test]
fn what_the_plan_left_out_is_refused_by_name_unless_it_is_live() {
    let cases: [(Adjustable, OnCpu, &str); 4] = [
        (Adjustable::Gravity, |s| s.set_gravity([0.0, -1.0, 0.0]), "gravity"),
        (Adjustable::Wind, |s| s.set_wind(Some(Wind { velocity: Vec3::new(1.0, 0.0, 0.0), drag: 1.0 })), "wind"),
        (Adjustable::Viscosity, |s| s.set_viscosity(0, 1.0), "dynamic_viscosity"),
        (Adjustable::SurfaceTension, |s| s.set_surface_tension(0, 1.0), "surface_tension"),
    ];
    // the second form acts even without a viscosity of the fluid
    let forms = [Viscosity::Mueller, Viscosity::MorrisAndArtificial];
    for (viscosity, (live, change, field)) in forms.into_iter().flat_map(|form| cases.map(|case| (form, case))) {
        let mut still = scene();
        (still.gravity, still.wind, still.model.viscosity) = (Vec3::ZERO, None, viscosity);
        (still.fluids[0].dynamic_viscosity, still.fluids[0].surface_tension) = (0.0, 0.0);
        let mut keeps = still.clone();
        keeps.adjustable.push(live).expect("room");
        let mut heaps = [memory(&still), memory(&keeps)];
        let [first, second] = &mut heaps;
        let mut bare = Solver::new(&still, first.lend()).expect("a scene");
        let mut kept = Solver::new(&keeps, second.lend()).expect("a scene");
        steps(&mut bare, 5);
        steps(&mut kept, 5);
        assert_eq!(bare.full_hash(), kept.full_hash(), "a term that is kept at 0 changes no bit");
        let refused = change(&mut bare).expect_err("a term that is not there");
        assert!(matches!(refused, SceneError::LeftOut { field: of, .. } if of == field), "{refused}");
        assert!(refused.to_string().contains(&format!("list {live:?}")), "{refused}");
        change(&mut kept).expect("a change");
        steps(&mut bare, 5);
        steps(&mut kept, 5);
        assert_ne!(bare.full_hash(), kept.full_hash(), "{live:?}, {viscosity:?}");
    }
}

#[test]
fn a_speed_of_sound_that_follows_cannot_be_set() {
    let mut follows = scene();
    follows.stiffness_for_time_step = Some(0.2);
    let mut heap = memory(&follows);
    let mut solver = Solver::new(&follows, heap.lend()).expect("a scene");
    let refused = solver.set_speed_of_sound(0, 30.0).expect_err("it follows from the time step");
    assert!(refused.to_string().contains("stiffness_for_time_step"), "{refused}");
    let mut free = scene();
    (free.model.surface_tension, free.fluids[0].surface_tension) = (SurfaceTension::Off, 0.0);
    let mut heap = memory(&free);
    let mut solver = Solver::new(&free, heap.lend()).expect("a scene");
    let refused = solver.set_surface_tension(0, 1.0).expect_err("there is no model of it");
    assert!(refused.to_string().contains("model.surface_tension Off"), "{refused}");
}

#[test]
fn a_field_that_is_refused_leaves_the_one_before() {
    let mut scene = scene();
    scene.acceleration_field = Some(AccelerationField { low: Vec3::ZERO, spacing: 0.3, counts: [4, 4, 1] });
    scene.gravity = Vec3::new(1e33, 0.0, 0.0);
    let mut heaps = [memory(&scene), memory(&scene)];
    let [first, second] = &mut heaps;
    let mut asked = Solver::new(&scene, first.lend()).expect("a scene");
    let mut left_alone = Solver::new(&scene, second.lend()).expect("a scene");
    let good = [[1.0, 2.0, 0.0, 0.0]; 16];
    asked.set_acceleration_field(&good).expect("a field");
    left_alone.set_acceleration_field(&good).expect("a field");
    // added to this gravity, the largest number overflows
    let refused = asked.set_acceleration_field(&[[f32::MAX; 4]; 16]);
    assert!(matches!(refused, Err(SceneError::FirstStep(_))), "{refused:?}");
    assert_eq!(asked.acceleration_field(), good);
    assert_eq!(asked.full_hash(), left_alone.full_hash());
}

#[test]
fn what_no_scene_can_have_is_refused_and_changes_nothing() {
    let mut adaptive = scene();
    adaptive.adaptive = Some(AdaptiveTimeStep::default());
    let mut beeman = scene();
    beeman.model.integrator = Integrator::Beeman;
    let cases: Vec<(Scene, OnCpu, &str)> = vec![
        (scene(), |s| s.set_gravity([f32::NAN, 0.0, 0.0]), "gravity"),
        (scene(), |s| s.set_gravity([0.0, 0.0, 1.0]), "2D"),
        (scene(), |s| s.set_time_step(-1.0), "time_step"),
        (scene(), |s| s.set_viscosity(0, f32::INFINITY), "dynamic_viscosity"),
        (scene(), |s| s.set_viscosity(1, 1.0), "set_viscosity"),
        (scene(), |s| s.set_speed_of_sound(0, 0.0), "fluids[0].speed_of_sound"),
        (adaptive, |s| s.set_time_step(0.001), "adaptive"),
        (beeman, |s| s.set_time_step(0.002), "Beeman"),
    ];
    for (scene, change, word) in cases {
        let mut heaps = [memory(&scene), memory(&scene)];
        let [first, second] = &mut heaps;
        let mut solver = Solver::new(&scene, first.lend()).expect("a scene");
        let mut twin = Solver::new(&scene, second.lend()).expect("a scene");
        steps(&mut solver, 4);
        let refused = change(&mut solver).expect_err("a change that cannot be");
        assert!(refused.to_string().contains(word), "{refused}");
        steps(&mut solver, 4);
        steps(&mut twin, 8);
        assert_eq!(solver.full_hash(), twin.full_hash(), "{word}");
    }
}

#[test]
fn a_fresh_device_refuses_what_its_first_accelerations_would_not_know() {
    let Some(gpu) = device("changes_between_steps", Mode::Strict) else { return };
    let mut field = scene();
    field.acceleration_field = Some(AccelerationField { low: Vec3::ZERO, spacing: 0.4, counts: [3, 3, 1] });
    let mut heap = memory(&field);
    let solver = Solver::new(&field, heap.lend()).expect("a scene");
    let mut fluid = GpuSolver::new(&gpu, &solver).expect("a device that takes it");
    let points = [[1.0, 0.0, 0.0, 0.0]; 9];
    assert!(matches!(
        fluid.set_acceleration_field(&points),
        Err(GpuError::BeforeFirstStep { call: "set_acceleration_field" })
    ));
    assert!(matches!(fluid.set_gravity([0.0; 3]), Err(GpuError::BeforeFirstStep { call: "set_gravity" })));
    fluid.step(1).expect("a step");
    fluid.set_acceleration_field(&points).expect("a field");
    let requirements = Requirements::of(&field.check().expect("a scene"));
    assert!(requirements.counts.field_nodes == points.len());
}

#[test]
fn a_solid_that_the_host_drives_moves_alike_on_a_device() {
    let Some(gpu) = device("changes_between_steps", Mode::Strict) else { return };
    let mut scene = scene();
    let ball = Solid::still(Shape::Ball { radius: 0.15 }, [0.65, 0.2, 0.0]);
    scene.add_solid(Solid { motion: Motion::Driven, model: SolidModel::Penalty, ..ball }).expect("room");
    let mut heap = memory(&scene);
    let mut cpu = Solver::new(&scene, heap.lend()).expect("a scene");
    let mut fluid = GpuSolver::new(&gpu, &cpu).expect("a device that takes it");
    let to = SolidState {
        velocity: Vec3::new(-4.0, 0.5, 0.0),
        angular_velocity: Vec3::new(0.0, 0.0, 9.0),
        ..cpu.solid(0).expect("a solid")
    };
    assert!(matches!(fluid.move_solid(0, to), Err(GpuError::BeforeFirstStep { call: "move_solid" })));
    for steps_of_each in [7, 40] {
        steps(&mut cpu, steps_of_each);
        fluid.step(steps_of_each).expect("steps on the device");
        assert_eq!(difference(&Snapshot::of_cpu(&cpu), &Snapshot::of_gpu(&fluid).expect("a state")), None);
        cpu.move_solid(0, to).expect("it is driven");
        fluid.move_solid(0, to).expect("it is driven");
    }
    assert!(cpu.census().flux.hits > 0, "it met the fluid");
    assert_eq!(fluid.census().expect("a status"), cpu.census());
    assert!(matches!(fluid.move_solid(1, to), Err(GpuError::Solid(SolidError::NoSuchSolid { solid: 1, solids: 1 }))));
}
