//! Promise: every choice that a scene can make gives the same bits on the scalar path, in SIMD lanes, on two threads,
//! after saving and restoring, and on a device in strict mode (without a device, its WGSL is validated instead). The
//! only choice left out is the half stencil, which no device supports; `core/tests/each_pair_once.rs` tests it.
//!
//! The list in `choices/` is made from the choices themselves, one of them at a time against the defaults.
use millpond::compare::difference;
use millpond::pool::Pool;
use millpond::snapshot::Snapshot;
use millpond_core::OwnedMemory;
use millpond_core::backend::layout::f32x4;
use millpond_core::scene::{Dimension, Scene};
use millpond_core::{Plan, Simd, Solver};
use millpond_gpu::program::{Intrinsics, program};
use millpond_gpu::strict::validate;
use millpond_gpu::{Gpu, GpuSolver, Mode};

mod choices;
mod support;
use choices::{base, choices, plainest};
use support::{checked, device};

/// Returns an acceleration field whose shape has no symmetry that could hide an error.
fn field(scene: &Scene) -> Vec<f32x4> {
    (0..checked(scene).derived().field_counts[3])
        .map(|i| [i as f32 * 0.7, 3.0 - (i * i) as f32 * 0.1, (i % 3) as f32, 0.0])
        .collect()
}

/// Returns another field, for the second half of the steps.
fn other_field(scene: &Scene) -> Vec<f32x4> {
    field(scene).into_iter().map(|[x, y, z, w]| [y, -x, z, w]).collect()
}

const STEPS: u32 = 8;

fn saved(solver: &Solver<'_>) -> Vec<u8> {
    let mut bytes = vec![0; solver.saved_bytes()];
    solver.save(&mut bytes).expect("room");
    bytes
}

/// Makes all steps in SIMD lanes, but saves the state halfway and continues with another solver.
fn with_a_break(scene: &Scene) -> Snapshot {
    let memory = || OwnedMemory::of(&scene.check().expect("a scene"));
    let (mut first, mut second) = (memory(), memory());
    let pool = Pool::new(1).expect("a thread");
    let mut solver = Solver::new(scene, first.lend()).expect("a scene");
    solver.set_acceleration_field(&field(scene)).expect("a field");
    (0..STEPS / 2).for_each(|_| solver.step(&pool).expect("a step"));
    let mut other = Solver::new(scene, second.lend()).expect("a scene");
    other.restore(&saved(&solver)).expect("bytes of this scene");
    assert!(saved(&other) == saved(&solver), "bytes that were read are written again");
    other.set_acceleration_field(&other_field(scene)).expect("a field");
    (STEPS / 2..STEPS).for_each(|_| other.step(&pool).expect("a step"));
    Snapshot::of_cpu(&other)
}

/// Makes all steps, the second half of them in another field.
fn half_and_half(scene: &Scene, solver: &mut Solver<'_>, pool: &Pool) {
    (0..STEPS / 2).for_each(|_| solver.step(pool).expect("a step"));
    solver.set_acceleration_field(&other_field(scene)).expect("a field");
    (STEPS / 2..STEPS).for_each(|_| solver.step(pool).expect("a step"));
}

fn by_cpu(
    scene: &Scene,
    simd: Simd,
    threads: usize,
    heap: &mut OwnedMemory,
    gpu: Option<&Gpu>,
) -> [Option<Snapshot>; 2] {
    let mut solver = Solver::new(scene, heap.lend()).expect("a scene").at_level(simd);
    solver.set_acceleration_field(&field(scene)).expect("a field");
    let on_device = gpu.map(|gpu| {
        let mut fluid = GpuSolver::new(gpu, &solver).expect("a device that takes it");
        fluid.step(STEPS / 2).expect("steps on the device");
        fluid.set_acceleration_field(&other_field(scene)).expect("a field");
        fluid.step(STEPS - STEPS / 2).expect("steps on the device");
        let reports = (
            fluid.correction().expect("a report"),
            fluid.time_report().expect("a report"),
            fluid.save().expect("bytes"),
        );
        (Snapshot::of_gpu(&fluid).expect("a state"), reports)
    });
    let pool = Pool::new(threads).expect("threads");
    half_and_half(scene, &mut solver, &pool);
    if let Some((_, reports)) = &on_device {
        let (correction, time, bytes) = reports;
        assert_eq!((correction, time), (&solver.correction(), &solver.time_report()), "pressure, and the time step");
        assert!(*bytes == saved(&solver), "the bytes of the two backends");
    }
    [Some(Snapshot::of_cpu(&solver)), on_device.map(|(state, _)| state)]
}

/// Returns the first difference in any bit of any array of the state, in words.
fn differs(want: &Snapshot, got: Option<&Snapshot>) -> Option<String> {
    difference(want, got.expect("a state")).map(|found| found.first)
}

fn check(dimension: Dimension) {
    let gpu = device("every_choice_keeps_its_bits", Mode::Strict);
    let base = base(dimension);
    let mut seen: Vec<(String, Scene, Snapshot)> = Vec::new();
    for (name, scene) in choices(&base) {
        let heap = || OwnedMemory::of(&scene.check().expect("a scene"));
        let [want, on_device] = by_cpu(&scene, Simd::Scalar, 1, &mut heap(), gpu.as_ref());
        let want = want.expect("a state");
        let fastest = want.velocity().iter().flat_map(|v| &v[..3]).fold(0.0f32, |all, v| all.max(v.abs()));
        assert!(fastest.is_finite() && fastest < 100.0, "{name}: a scene that explodes tests little");
        let [lanes, _] = by_cpu(&scene, Simd::detect(), 2, &mut heap(), None);
        assert_eq!(differs(&want, lanes.as_ref()), None, "{name}: lanes on two threads");
        for simd in Simd::available().skip(1) {
            let [lanes, _] = by_cpu(&scene, simd, 1, &mut heap(), None);
            assert_eq!(differs(&want, lanes.as_ref()), None, "{name}: lanes, {simd:?}");
        }
        assert_eq!(differs(&want, Some(&with_a_break(&scene))), None, "{name}: saved and gone on with");
        let known = checked(&scene);
        let plan = Plan::of(&known);
        if gpu.is_none() {
            for pass in plan.passes() {
                let read = validate(&program(pass, &plan.model, Intrinsics::Native));
                assert!(read.is_ok(), "{name}, {}: {:?}", pass.name(), read.err());
            }
        } else {
            assert_eq!(differs(&want, on_device.as_ref()), None, "{name}: on the device");
        }
        // the plan of the scene and a plan with every term must give the same bits
        let mut heap = OwnedMemory::with(&millpond_core::Requirements::by_plan(&known, &Plan::everything(&known)));
        let (count, places) = (known.derived().particles(), known.initial_particles());
        let plan = Plan::everything(&known);
        let mut whole = Solver::with_particles(&known, plan, count, places, heap.lend()).expect("a scene");
        whole.set_acceleration_field(&field(&scene)).expect("a field");
        let pool = Pool::new(1).expect("a thread");
        half_and_half(&scene, &mut whole, &pool);
        assert_eq!(whole.hash(), want.hash(), "{name}: with every term left in");
        seen.push((name, scene, want));
    }
    // a choice that changes no bit would not be tested at all
    let mut alike = Vec::new();
    for (i, (name, scene, state)) in seen.iter().enumerate() {
        let same = seen[..i]
            .iter()
            .find(|(_, other, known)| plainest(other) != plainest(scene) && difference(known, state).is_none());
        alike.extend(same.map(|(known, ..)| format!("{name} | {known}")));
    }
    // neither the structure of the grid nor a recovery that is not needed changes a bit
    let free = ["steps that are shortened where they cannot be made | defaults", "cell lists | defaults"];
    assert_eq!(alike, free);
}

#[test]
fn in_space() {
    check(Dimension::Three);
}

#[test]
fn in_the_plane() {
    check(Dimension::Two);
}
