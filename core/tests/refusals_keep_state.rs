//! Promise: every error is a typed value that names what went wrong, and leaves every bit of the state unchanged,
//! whatever ran before.
//!
//! `gpu/tests/refusals_keep_state.rs` tests that a GPU returns the same errors.
use millpond_core::glam::Vec3;
use millpond_core::scene::{GridStructure, InitialParticle, Scene};
use millpond_core::{
    Axis, Field, Memory, Plan, Quantity, Requirements, SceneError, Serial, Simd, Solver, StepError, Storage,
};

mod support;
use support::refused::{self, Refused, places};
use support::{Words, checked, dam_break, dam_break_2d, heap_for, thesis_cube};

#[test]
fn a_step_that_is_refused() {
    for Refused { name, scene, places, good, error } in refused::all() {
        for simd in [Simd::Scalar, Simd::detect()] {
            let mut heap = heap_for(&scene, places.len());
            let scene = checked(&scene);
            let at = places.iter().copied();
            let start = Solver::with_particles(&scene, Plan::of(&scene), places.len(), at, heap.lend());
            let mut solver = start.expect("a scene that starts").at_level(simd);
            (0..good).for_each(|_| solver.step(&Serial).expect("a good step"));
            let before = (Words::of_cpu(&solver), solver.full_hash());
            // a second try returns the same error
            for _ in 0..2 {
                assert_eq!(solver.step(&Serial), Err(error), "{name}, {simd:?}");
                assert!((Words::of_cpu(&solver), solver.full_hash()) == before, "{name}, {simd:?}");
                assert_eq!(solver.steps(), good, "{name}, {simd:?}");
            }
        }
    }
}

#[test]
fn a_scene_that_cannot_start() {
    let scene = thesis_cube(0.8);
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
    let scene = thesis_cube(0.8);
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
    // arrays that a `Storage` does not have are taken from an arena
    let mut warm = scene.clone();
    warm.model.internal_energy = true;
    warm.grid.structure = GridStructure::IndexSort;
    let mut storage: Box<Storage<4096, 32_768>> = Storage::boxed();
    let beside = Requirements::of(&checked(&warm)).arena_bytes_beside_storage();
    assert_eq!(Solver::new(&warm, storage.lend()).err(), too_few("bytes of arena", beside, 0));
}

#[test]
fn scenes_that_cannot_be() {
    let base = dam_break(1.0);
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
    assert_eq!(field(refused(&|s| s.average_neighbours = Some(-1.0))), "average_neighbours");
    assert_eq!(field(refused(&|s| s.time_step = f32::NAN)), "time_step");
    assert_eq!(field(refused(&|s| s.gravity[1] = f32::NAN)), "gravity");
    assert_eq!(field(refused(&|s| s.fluids[0].rest_density = -1000.0)), "fluids[0].rest_density");
    let error = refused(&|s| s.fluids[0].speed_of_sound = 1e30);
    assert_eq!(error, SceneError::OutOfScale { field: Field::of_item("fluids.speed_of_sound", 0), value: 1e30 });
    let error = refused(&|s| s.particle_spacing = 3.0);
    assert_eq!(error, SceneError::EmptyBlock { block: 0, axis: Axis::X, size: 1.2 });
    let error = refused(&|s| s.blocks[0].corner[1] = 2.0);
    assert_eq!(error, SceneError::BlockOutside { block: 0, axis: Axis::Y, by: 1.0 });
    assert_eq!(field(refused(&|s| s.fluids[0].dynamic_viscosity = -1.0)), "fluids[0].dynamic_viscosity");
    assert_eq!(field(refused(&|s| s.fluids[0].near_stiffness = Some(-1.0))), "fluids[0].near_stiffness");
    assert_eq!(field(refused(&|s| s.blocks[0].size[0] = 0.0)), "blocks[0].size");
    assert_eq!(field(refused(&|s| s.blocks[0].corner[2] = f32::INFINITY)), "blocks[0].corner");
    assert_eq!(field(refused(&|s| s.container.as_mut().expect("a box").restitution = 1.5)), "container.restitution");
    assert_eq!(field(refused(&|s| s.container.as_mut().expect("a box").slip = -0.1)), "container.slip");
    // lengths whose fourth power f32 cannot represent
    let tiny = refused(&|s| (s.particle_spacing, s.blocks[0].size) = (1e-12, Vec3::splat(1e-12)));
    assert_eq!(tiny, SceneError::OutOfScale { field: "particle_spacing".into(), value: 1e-12 });
    // for support radii whose constants are not finite the error names the neighbours, not the spacing
    for value in [1e30, 1e-30] {
        let (field, least, most) = ("average_neighbours", 0.001, 268_435_455.0);
        let error = SceneError::OutOfBounds { field: field.into(), value, least, most };
        assert_eq!(refused(&|s| s.average_neighbours = Some(value)), error);
    }
    // at 1e4 m f32 resolves a millimetre
    let error = refused(&|s| s.blocks[0].corner[0] = 1e4);
    let most = 65_536.0 * base.particle_spacing;
    assert_eq!(
        error,
        SceneError::OutOfBounds { field: Field::of_item("blocks.corner", 0), value: 1e4, least: -most, most }
    );
    let error = refused(&|s| s.container.as_mut().expect("a box").high[1] = 0.0);
    assert_eq!(error, SceneError::EmptyContainer { axis: Axis::Y, low: 0.0, high: 0.0 });
    assert_eq!(refused(&|s| s.grid.cells[2] = 2), SceneError::TooFewCells { axis: Axis::Z, cells: 2 });
    let error = refused(&|s| s.grid.cells = [4096, 4096, 4096]);
    assert_eq!(error, SceneError::TooManyCells { cells: [4096; 3], places: 1 });
    let error = refused(&|s| s.grid.structure = GridStructure::CellLists { places: 0 });
    assert_eq!(field(error), "grid.structure.places");
    assert!(matches!(refused(&|s| s.blocks[0].size = Vec3::splat(1e3)), SceneError::TooManyParticles { .. }));

    let mut flat = dam_break_2d(1.0);
    flat.gravity[2] = 1.0;
    assert_eq!(flat.check().err(), Some(SceneError::OutOfPlane));
}

#[test]
fn plans_and_places_that_do_not_fit() {
    let scene = dam_break_2d(1.0);
    let start = |plan, count, at: &[InitialParticle]| {
        let mut heap = heap_for(&scene, count);
        Solver::with_particles(&checked(&scene), plan, count, at.iter().copied(), heap.lend()).err()
    };
    let plan = Plan::of(&checked(&scene));
    let one = places(&[([0.5, 0.5, 0.0], [0.0; 3])]);
    assert_eq!(start(plan, 1, &one), None);
    let spatial = Plan::of(&checked(&dam_break(1.0)));
    assert_eq!(start(spatial, 1, &one), Some(SceneError::PlanOfAnotherScene));
    let off = places(&[([0.5, 0.5, 0.1], [0.0; 3])]);
    assert_eq!(start(plan, 1, &off), Some(SceneError::OutOfPlane));
    let call = "with_particles";
    let short = SceneError::WrongLength { call, what: "particles", given: 1, expected: 2 };
    assert_eq!(start(plan, 2, &one), Some(short));
    let over = SceneError::WrongLength { call, what: "particles", given: 1, expected: 0 };
    assert_eq!(start(plan, 0, &one), Some(over));
}
