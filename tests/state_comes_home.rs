//! Promise: a fluid saved as bytes continues with the same bits as if it had never stopped, from the CPU to a device
//! and back any number of times. Values changed between steps are restored too. Bytes of another length, version or
//! scene are rejected with an error that names the cause, and change nothing.
use millpond::compare::difference;
use millpond::snapshot::Snapshot;
use millpond_core::backend::save::VERSION;
use millpond_core::glam::Vec3;
use millpond_core::scene::{Adjustable, GridStructure, Scene};
use millpond_core::{NewParticle, OwnedMemory, RestoreError, Serial, Solver};
use millpond_gpu::{Gpu, GpuSolver, Mode};

mod support;
use support::device;

/// Scenes with much state to save: an adaptive time step, corrected pressure, plastic springs, air, an emitter, and two
/// integrators with a history.
const SCENES: &[&str] = &["stiff-tank", "corrected-column", "elastic-cube", "oil-and-water", "jet", "dam-break-2d"];

fn scene(name: &str) -> Scene {
    let mut scene = support::scaled(name, 400).file.scene;
    if name == "dam-break-2d" {
        scene.model.integrator = millpond_core::scene::Integrator::Beeman;
        (scene.model.xsph, scene.model.internal_energy) = (0.3, true);
        support::with_penalty_planes(&mut scene);
    }
    if name == "elastic-cube" {
        scene.elasticity.plasticity = Some(millpond_core::scene::Plasticity { rate: 20.0, yield_strain: 0.001 });
    }
    scene
}

fn memory(scene: &Scene) -> OwnedMemory {
    OwnedMemory::of(&scene.check().expect("a scene"))
}

fn saved(solver: &Solver<'_>) -> Vec<u8> {
    let mut bytes = vec![0; solver.saved_bytes()];
    solver.save(&mut bytes).expect("room");
    bytes
}

/// Restores these bytes, makes some steps on the CPU or on a device, and returns the new bytes.
fn go_on(scene: &Scene, bytes: &[u8], gpu: Option<&Gpu>, steps: u32) -> Vec<u8> {
    let mut heap = memory(scene);
    let mut solver = Solver::new(scene, heap.lend()).expect("a scene");
    solver.restore(bytes).expect("bytes of this scene");
    let Some(gpu) = gpu else {
        (0..steps).for_each(|_| solver.step(&Serial).expect("a step"));
        return saved(&solver);
    };
    let mut fluid = GpuSolver::new(gpu, &solver).expect("a device that takes it");
    fluid.step(steps).expect("steps");
    fluid.save().expect("bytes")
}

#[test]
fn any_number_of_times_between_backends() {
    let gpu = device("state_comes_home", Mode::Strict);
    for name in SCENES {
        let scene = scene(name);
        let mut heap = memory(&scene);
        let mut solver = Solver::new(&scene, heap.lend()).expect("a scene");
        let mut bytes = saved(&solver);
        for (on_device, steps) in [(false, 7), (true, 5), (true, 4), (false, 6), (true, 3)] {
            bytes = go_on(&scene, &bytes, gpu.as_ref().filter(|_| on_device), steps);
            (0..steps).for_each(|_| solver.step(&Serial).expect("a step"));
            assert!(bytes == saved(&solver), "{name} after {} steps", solver.steps());
        }
    }
}

#[test]
fn what_was_changed_between_steps_comes_along() {
    let mut scene = scene("dam-break-2d");
    scene.adjustable.push(Adjustable::Viscosity).expect("room");
    let (mut first, mut second) = (memory(&scene), memory(&scene));
    let mut solver = Solver::new(&scene, first.lend()).expect("a scene");
    (0..5).for_each(|_| solver.step(&Serial).expect("a step"));
    solver.set_gravity([4.0, -3.0, 0.0]).expect("a change");
    solver.set_viscosity(0, 7.0).expect("a change");
    let mut other = Solver::new(&scene, second.lend()).expect("a scene");
    other.restore(&saved(&solver)).expect("bytes of this scene");
    // a later change builds on the restored values
    for solver in [&mut solver, &mut other] {
        (0..5).for_each(|_| solver.step(&Serial).expect("a step"));
        solver.set_speed_of_sound(0, 30.0).expect("a change");
        (0..5).for_each(|_| solver.step(&Serial).expect("a step"));
    }
    assert_eq!(difference(&Snapshot::of_cpu(&solver), &Snapshot::of_cpu(&other)), None);
}

#[test]
fn whatever_the_structure_of_the_grid() {
    let by_index = scene("dam-break-2d");
    let mut by_lists = by_index.clone();
    by_lists.grid.structure = GridStructure::CellLists { places: 32 };
    by_lists.grid.cells = by_lists.grid.cells.map(|cells| cells + 3);
    let mut bytes = Vec::new();
    let mut halves = Vec::new();
    for scene in [&by_index, &by_lists] {
        let mut heap = memory(scene);
        let mut solver = Solver::new(scene, heap.lend()).expect("a scene");
        (0..5).for_each(|_| solver.step(&Serial).expect("a step"));
        bytes.push(saved(&solver));
    }
    assert!(bytes[0] == bytes[1], "where particles are looked up is not saved");
    for scene in [&by_index, &by_lists] {
        halves.push(go_on(scene, &bytes[0], None, 5));
    }
    assert!(halves[0] == halves[1]);
}

#[test]
fn of_a_scene_that_iterates_more_often_they_are_refused() {
    let scene = scene("corrected-column");
    let mut patient = scene.clone();
    patient.model.correction.iterations += 1;
    let (mut first, mut second) = (memory(&scene), memory(&patient));
    let solver = Solver::new(&scene, first.lend()).expect("a scene");
    let mut other = Solver::new(&patient, second.lend()).expect("a scene");
    assert_eq!(other.restore(&saved(&solver)), Err(RestoreError::AnotherScene));
}

#[test]
fn bytes_that_are_not_its_own_are_refused_by_name() {
    let scene = scene("dam-break-2d");
    let mut other_scene = scene.clone();
    other_scene.fluids[0].rest_density = 900.0;
    let (mut first, mut second) = (memory(&scene), memory(&other_scene));
    let mut solver = Solver::new(&scene, first.lend()).expect("a scene");
    let other = Solver::new(&other_scene, second.lend()).expect("a scene");
    (0..3).for_each(|_| solver.step(&Serial).expect("a step"));
    let (own, hash) = (saved(&solver), solver.full_hash());
    let mut newer = own.clone();
    newer[4] += 1;
    let mut damaged = own.clone();
    damaged[own.len() / 2] ^= 1;
    let cases = [
        (own[..own.len() - 4].to_vec(), RestoreError::WrongLength { given: own.len() - 4, expected: own.len() }),
        ([&own[..], &[0; 8]].concat(), RestoreError::WrongLength { given: own.len() + 8, expected: own.len() }),
        (Vec::new(), RestoreError::NotSaved),
        (vec![7; own.len()], RestoreError::NotSaved),
        (damaged, RestoreError::Damaged),
        (newer, RestoreError::WrongVersion { given: VERSION + 1, known: VERSION }),
        (saved(&other), RestoreError::AnotherScene),
    ];
    for (bytes, want) in cases {
        assert_eq!(solver.restore(&bytes), Err(want), "{want}");
        assert_eq!(solver.full_hash(), hash, "{want}");
    }
    assert_eq!(solver.save(&mut [0; 4]), Err(RestoreError::WrongLength { given: 4, expected: own.len() }));
}

#[test]
fn what_the_host_adds_on_either_backend() {
    let Some(gpu) = device("state_comes_home", Mode::Strict) else { return };
    let scene = scene("jet");
    let (mut first, mut second) = (memory(&scene), memory(&scene));
    let mut solver = Solver::new(&scene, first.lend()).expect("a scene");
    let mut host = Solver::new(&scene, second.lend()).expect("a scene");
    let mut fluid = GpuSolver::new(&gpu, &solver).expect("a device that takes it");
    for round in 0..3 {
        (0..40).for_each(|_| solver.step(&Serial).expect("a step"));
        fluid.step(40).expect("steps");
        let change = |solver: &mut Solver<'_>| {
            let old = solver.identify(3 + round).expect("a particle");
            let at = Vec3::new(0.8, 0.5 + 0.1 * round as f32, 0.0);
            let new = NewParticle { fluid: 0, position: at, velocity: Vec3::X, life: Some(0.1) };
            (solver.remove(old), solver.spawn(&new))
        };
        let made = change(&mut solver);
        assert!(made.0 && made.1.is_ok(), "{made:?}");
        assert_eq!(fluid.with_host(&mut host, change).expect("a host"), made);
        assert!(fluid.save().expect("bytes") == saved(&solver), "round {round}");
        assert_eq!(fluid.census().expect("a census"), solver.census());
    }
    (0..40).for_each(|_| solver.step(&Serial).expect("a step"));
    fluid.step(40).expect("steps");
    assert!(fluid.save().expect("bytes") == saved(&solver));
}
