//! Promise: every error is a typed value that names what went wrong, the same on both backends, and leaves the state hash
//! as it was.
use millpond::snapshot::Snapshot;
use millpond_core::Quantity;
use millpond_core::scene::{GridStructure, InitialParticle, Scene};
use millpond_core::{Axis, Memory, Plan, Requirements, SceneError, Serial, Simd, Solver, StepError, Storage};
use millpond_gpu::{FloatControls, Gpu, GpuError, GpuSolver, Mode};

mod support;
use support::{checked, device, heap_for};

/// Particles of the thesis cube's fluid at these places.
fn places(at: &[([f32; 3], [f32; 3])]) -> Vec<InitialParticle> {
    at.iter().map(|&(position, velocity)| InitialParticle::at(position, velocity)).collect()
}

/// Steps both backends until they refuse; asserts that they do so with `error`, after `steps` good steps, keeping the state.
fn refuses(test: &str, scene: &Scene, places: &[InitialParticle], steps: u64, error: StepError) {
    let gpu = device(test, Mode::Strict);
    for simd in [Simd::Scalar, Simd::detect()] {
        refuses_at(simd, gpu.as_ref(), test, scene, places, steps, error);
    }
}

fn refuses_at(
    simd: Simd,
    gpu: Option<&Gpu>,
    test: &str,
    scene: &Scene,
    places: &[InitialParticle],
    steps: u64,
    error: StepError,
) {
    let mut heap = heap_for(scene, places.len());
    let scene = checked(scene);
    let start = Solver::with_particles(&scene, Plan::of(&scene), places.len(), places.iter().copied(), heap.lend());
    let mut solver = start.expect("a scene that starts").at_level(simd);
    let on_device = gpu.map(|gpu| GpuSolver::new(gpu, &solver).expect("a device that takes it"));

    (0..steps).for_each(|_| solver.step(&Serial).expect("a good step"));
    let before = solver.hash();
    // a second try is refused the same way
    for _ in 0..2 {
        assert_eq!(solver.step(&Serial), Err(error), "{test}");
        assert_eq!((solver.hash(), solver.steps()), (before, steps), "{test}");
    }
    if let Some(mut fluid) = on_device {
        for _ in 0..2 {
            // many more steps are recorded than can be made
            let refused = fluid.step(20);
            assert!(matches!(refused, Err(GpuError::Step(e)) if e == error), "{test}: {refused:?}");
            let state = Snapshot::of_gpu(&fluid).expect("a state");
            assert_eq!((state.hash(), fluid.steps()), (before, steps), "{test}, on the device");
        }
    }
}

#[test]
fn a_particle_beyond_the_grids_range() {
    let scene = support::scene("thesis-cube", &[]).file.scene;
    // at 1e8 m/s for 1 ms a step the third step passes 2^22 cells of 0.0931 m, or 390 km, for particles 2 and 3
    let places = places(&[
        ([0.0; 3], [0.0; 3]),
        ([1.0, 0.0, 0.0], [0.0, -1e8, 0.0]),
        ([2.0, 0.0, 0.0], [0.0, 1.9e8, 0.0]),
        ([3.0, 0.0, 0.0], [0.0, 1.93e8, 1.93e8]),
    ]);
    let error = StepError::OutOfRange { particle: 2, axis: Axis::Y, step: 3 };
    refuses("out of range", &scene, &places, 2, error);
}

#[test]
fn a_cell_with_more_particles_than_places() {
    let mut scene = support::scene("thesis-cube", &["near_pressure=Off"]).file.scene;
    scene.grid.structure = GridStructure::CellLists { places: 3 };
    // three rest in cell (0, 0, 0) of 32 x 32 x 32, a fourth flies in from above: at 0.02 m a step it enters at the 5th
    let mut at = vec![([0.01, 0.01, 0.01], [0.0; 3]), ([0.05, 0.01, 0.05], [0.0; 3]), ([0.01, 0.01, 0.08], [0.0; 3])];
    at.push(([0.05, 0.185, 0.05], [0.0, -20.0, 0.0]));
    let mut heap = heap_for(&scene, 4);
    let known = checked(&scene);
    let plan = Plan::of(&known);
    let mut solver = Solver::with_particles(&known, plan, 4, places(&at), heap.lend()).expect("it starts");
    let mut good = 0;
    while solver.step(&Serial).is_ok() {
        good += 1;
        assert!(good < 10, "the fourth particle never arrives");
    }
    assert!(good > 0, "it must fail in flight, not at the start");
    let error = StepError::CellFull { cell: 0, count: 4, capacity: 3, step: good + 1 };
    refuses("cell full", &scene, &places(&at), good, error);
}

#[test]
fn a_quantity_that_is_not_finite_any_more() {
    // so stiff a fluid that the first pair to meet overflows; apart, nothing acts. Both overflow: the smaller id is named
    let set = ["speed_of_sound=1e18", "near_pressure=Off", "pressure_kernel=CubicSpline"];
    let scene = support::scene("thesis-cube", &set).file.scene;
    // particle 0 stands in the cell of particle 1, out of everyone's reach, and must not be drawn in by a lane beside it
    let at = [[4.945, 0.0, 0.0], [5.025, 0.06, 0.06], [5.125, 0.06, 0.06]];
    let inverse_cell = checked(&scene).derived().parameters.inverse_cell[0];
    let cell = |x: [f32; 3]| x.map(|x| (x * inverse_cell).floor());
    assert_eq!(cell(at[0]), cell(at[1]));
    let places = places(&[(at[0], [0.0; 3]), (at[1], [0.0; 3]), (at[2], [-50.0, 0.0, 0.0])]);
    let error = StepError::NotFinite { particle: 1, quantity: Quantity::Velocity, step: 1 };
    refuses("not finite", &scene, &places, 0, error);
}

#[test]
fn a_scene_that_cannot_start() {
    let scene = support::scene("thesis-cube", &[]).file.scene;
    let start = |position: [f32; 3], velocity: [f32; 3]| {
        let mut heap = heap_for(&scene, 2);
        let at = places(&[([0.0; 3], [0.0; 3]), (position, velocity)]);
        let scene = checked(&scene);
        Solver::with_particles(&scene, Plan::of(&scene), 2, at, heap.lend()).err()
    };
    let far = SceneError::FirstStep(StepError::OutOfRange { particle: 1, axis: Axis::Y, step: 1 });
    assert_eq!(start([0.0, 1e30, 0.0], [0.0; 3]), Some(far));
    for bad in [f32::NAN, f32::INFINITY] {
        let none = |quantity| Some(SceneError::ParticleNotFinite { particle: 1, quantity });
        assert_eq!(start([0.0, bad, 0.0], [0.0; 3]), none(Quantity::Position));
        assert_eq!(start([0.0; 3], [bad, 0.0, 0.0]), none(Quantity::Velocity));
    }
}

#[test]
fn memory_that_is_too_small() {
    let scene = support::scene("thesis-cube", &[]).file.scene;
    let refused = |memory: Memory<'_>| Solver::new(&scene, memory).err();
    let too_few = |what, needed, capacity| Some(SceneError::CapacityExceeded { what, needed, capacity });
    let mut storage: Box<Storage<4095, 32_768>> = Storage::boxed();
    assert_eq!(refused(storage.lend()), too_few("position", 4096, 4095));
    let mut storage: Box<Storage<4096, 32_767>> = Storage::boxed();
    assert_eq!(refused(storage.lend()), too_few("grid_cell_counters", 32_768, 32_767));
    let needed = Requirements::of(&checked(&scene)).arena_bytes();
    let mut arena = vec![0u64; needed / 8 - 1];
    assert_eq!(
        refused(Memory::of_arena(bytemuck::cast_slice_mut(&mut arena))),
        too_few("bytes of arena", needed, needed - 8)
    );
    // and what a storage has no name for is looked for in an arena
    let mut warm = scene.clone();
    warm.model.thermal_energy = true;
    warm.grid.structure = GridStructure::IndexSort;
    let mut storage: Box<Storage<4096, 32_768>> = Storage::boxed();
    let beside = Requirements::of(&checked(&warm)).arena_bytes_beside_storage();
    assert_eq!(Solver::new(&warm, storage.lend()).err(), too_few("bytes of arena", beside, 0));
}

#[test]
fn scenes_that_cannot_be() {
    let base = support::scene("dam-break", &[]).file.scene;
    let refused = |change: &dyn Fn(&mut Scene)| {
        let mut scene = base.clone();
        change(&mut scene);
        scene.check().expect_err("a scene that cannot be")
    };
    let field = |error: SceneError| match error {
        SceneError::NotFinite { field, .. }
        | SceneError::NotPositive { field, .. }
        | SceneError::Negative { field, .. }
        | SceneError::NotAShare { field, .. } => field,
        other => panic!("{other:?}"),
    };
    assert_eq!(field(refused(&|s| s.particle_spacing = 0.0)), "particle_spacing");
    assert_eq!(field(refused(&|s| s.average_neighbours = -1.0)), "average_neighbours");
    assert_eq!(field(refused(&|s| s.time_step = f32::NAN)), "time_step");
    assert_eq!(field(refused(&|s| s.gravity[1] = f32::NAN)), "gravity");
    assert_eq!(field(refused(&|s| s.fluid.rest_density = -1000.0)), "fluid.rest_density");
    let error = refused(&|s| s.fluid.speed_of_sound = 1e30);
    assert_eq!(error, SceneError::OutOfScale { field: "fluid.speed_of_sound", value: 1e30 });
    let error = refused(&|s| s.particle_spacing = 3.0);
    assert_eq!(error, SceneError::EmptyBlock { block: 0, axis: Axis::X, size: 1.2 });
    let error = refused(&|s| s.blocks[0].corner[1] = 2.0);
    assert_eq!(error, SceneError::BlockOutside { block: 0, axis: Axis::Y, by: 1.0 });
    assert_eq!(field(refused(&|s| s.fluid.dynamic_viscosity = -1.0)), "fluid.dynamic_viscosity");
    assert_eq!(field(refused(&|s| s.fluid.near_stiffness = Some(-1.0))), "fluid.near_stiffness");
    assert_eq!(field(refused(&|s| s.blocks[0].size[0] = 0.0)), "blocks.size");
    assert_eq!(field(refused(&|s| s.blocks[0].corner[2] = f32::INFINITY)), "blocks.corner");
    assert_eq!(field(refused(&|s| s.container.as_mut().expect("a box").bounce = 1.5)), "container.bounce");
    assert_eq!(field(refused(&|s| s.container.as_mut().expect("a box").slip = -0.1)), "container.slip");
    // lengths whose fourth power is no f32
    let tiny = refused(&|s| (s.particle_spacing, s.blocks[0].size) = (1e-12, [1e-12; 3]));
    assert_eq!(tiny, SceneError::OutOfScale { field: "particle_spacing", value: 1e-12 });
    // supports whose constants are no numbers are no fault of the spacing
    for value in [1e30, 1e-30] {
        let (field, least, most) = ("average_neighbours", 0.001, 268_435_455.0);
        let error = SceneError::OutOfBounds { field, value, least, most };
        assert_eq!(refused(&|s| s.average_neighbours = value), error);
    }
    // at 1e4 m coordinates are a millimetre apart
    let error = refused(&|s| s.blocks[0].corner[0] = 1e4);
    let most = 65_536.0 * base.particle_spacing;
    assert_eq!(error, SceneError::OutOfBounds { field: "blocks.corner", value: 1e4, least: -most, most });
    let error = refused(&|s| s.container.as_mut().expect("a box").high[1] = 0.0);
    assert_eq!(error, SceneError::EmptyContainer { axis: Axis::Y, low: 0.0, high: 0.0 });
    assert_eq!(refused(&|s| s.grid.cells[2] = 2), SceneError::TooFewCells { axis: Axis::Z, cells: 2 });
    let error = refused(&|s| s.grid.cells = [4096, 4096, 4096]);
    assert_eq!(error, SceneError::TooManyCells { cells: [4096; 3], places: 1 });
    let error = refused(&|s| s.grid.structure = GridStructure::CellLists { places: 0 });
    assert_eq!(field(error), "grid.structure.places");
    assert!(matches!(refused(&|s| s.blocks[0].size = [1e3; 3]), SceneError::TooManyParticles { .. }));

    let mut flat = support::scene("dam-break-2d", &[]).file.scene;
    flat.gravity[2] = 1.0;
    assert_eq!(flat.check().err(), Some(SceneError::OutOfPlane));
}

#[test]
fn plans_and_places_that_do_not_fit() {
    let scene = support::scene("dam-break-2d", &[]).file.scene;
    let start = |plan, count, at: &[InitialParticle]| {
        let mut heap = heap_for(&scene, count);
        Solver::with_particles(&checked(&scene), plan, count, at.iter().copied(), heap.lend()).err()
    };
    let plan = Plan::of(&checked(&scene));
    let one = places(&[([0.5, 0.5, 0.0], [0.0; 3])]);
    assert_eq!(start(plan, 1, &one), None);
    let spatial = Plan::of(&support::scene("dam-break", &[]).checked().expect("a scene"));
    assert_eq!(start(spatial, 1, &one), Some(SceneError::PlanOfAnotherScene));
    let off = places(&[([0.5, 0.5, 0.1], [0.0; 3])]);
    assert_eq!(start(plan, 1, &off), Some(SceneError::OutOfPlane));
    let call = "with_particles";
    let short = SceneError::WrongLength { call, what: "particles", given: 1, expected: 2 };
    assert_eq!(start(plan, 2, &one), Some(short));
    let over = SceneError::WrongLength { call, what: "particles", given: 1, expected: 0 };
    assert_eq!(start(plan, 0, &one), Some(over));
}

#[test]
fn a_device_and_a_shader_that_are_not_there() {
    let missing = Gpu::open(Some("no such adapter"), Mode::Plain);
    assert!(matches!(missing, Err(GpuError::NoAdapter { wanted: Some(name) }) if name == "no such adapter"));
    let refused = millpond_gpu::strict::spirv("fn f() -> u32 { return 1.0; }", FloatControls::default());
    assert!(matches!(refused, Err(GpuError::Shader(message)) if message.contains("return")));
}
