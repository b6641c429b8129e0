//! Promise: in strict mode a device gives the bits of the CPU over 500 steps, compared after each step or after
//! several, however many steps run between two reads of the status. `intrinsics_parity.rs` shows that strict mode is
//! the reason.
use millpond::compare::difference;
use millpond::snapshot::Snapshot;
use millpond_core::OwnedMemory;
use millpond_core::glam::Vec3;
use millpond_core::scene::{Block, Dimension, GridStructure, InitialParticle, Scene};
use millpond_core::{Plan, Requirements, Serial, Simd, Solver};
use millpond_gpu::{GpuSolver, Mode};

mod support;
use support::{checked, device};

/// Compares after every `stride` steps.
fn check(test: &str, scene: &Scene, steps: u64, stride: u32) {
    let Some(gpu) = device(test, Mode::Strict) else { return };
    let mut heap = OwnedMemory::of(&scene.check().expect("a scene"));
    let mut cpu = Solver::new(scene, heap.lend()).expect("a scene");
    let mut fluid = GpuSolver::new(&gpu, &cpu).expect("a device that takes it");
    while cpu.steps() < steps {
        fluid.step(stride).expect("steps on the device");
        (0..stride).for_each(|_| cpu.step(&Serial).expect("a step"));
        let got = Snapshot::of_gpu(&fluid).expect("a state");
        let found = difference(&Snapshot::of_cpu(&cpu), &got);
        assert_eq!(found, None, "{test}: at step {}", cpu.steps());
        assert_eq!((fluid.steps(), got.hash()), (cpu.steps(), cpu.hash()));
    }
}

#[test]
fn for_500_steps_of_a_dam_break() {
    check("bits_same_on_gpu, dam-break", &support::scaled("dam-break", 2000).file.scene, 500, 1);
}

#[test]
fn for_500_steps_of_the_thesis_cube() {
    // 67 steps at once are more than the 64 that are recorded before the status is read
    check("bits_same_on_gpu, thesis-cube", &support::scaled("thesis-cube", 1000).file.scene, 500, 67);
}

#[test]
fn with_more_cells_than_one_work_group_sums_up() {
    // a block has 4096 cells, and the threads of a work group process 256 blocks at once
    for (name, cells) in
        [("thesis-cube", [17, 17, 17]), ("thesis-cube", [20, 21, 22]), ("dam-break-2d", [1100, 1000, 1])]
    {
        let mut scene = support::scaled(name, 600).file.scene;
        scene.grid.structure = GridStructure::IndexSort;
        scene.grid.cells = cells;
        check(&format!("bits_same_on_gpu, {name} in {cells:?} cells"), &scene, 20, 5);
    }
    // air adds one cell, that of the inactive particles, which here forms a block of its own
    let mut scene = support::air::drop(Dimension::Three, 200);
    scene.grid.cells = [16, 16, 16];
    check("bits_same_on_gpu, air beyond a block", &scene, 20, 5);
}

#[test]
fn for_no_particle_and_for_one() {
    let mut scene = support::scaled("dam-break-2d", 800).file.scene;
    scene.blocks.clear();
    check("bits_same_on_gpu, no particle", &scene, 3, 1);
    let corner = Vec3::new(0.5, 1.0, 0.0);
    let block = Block { corner, size: Vec3::splat(scene.particle_spacing), ..Block::default() };
    scene.blocks = [block].into_iter().collect();
    assert_eq!(checked(&scene).derived().particles(), 1);
    check("bits_same_on_gpu, one particle", &scene, 100, 10);
}

#[test]
fn for_a_pair_at_the_very_edge_of_the_support() {
    // at this distance q squared rounds to 1, but q itself, the distance over the support radius, rounds to less than 1
    let mut scene = support::scene("thesis-cube", &["particle_spacing=0.027", "average_neighbours=32"]).file.scene;
    scene.blocks.clear();
    let apart: f32 = 0.053_176_23;
    let p = checked(&scene).derived().parameters;
    assert!(apart * apart * p.inverse_support_squared >= 1.0 && apart * p.inverse_support < 1.0, "the case there was");
    let points = [[0.0, 0.0, 0.0], [0.0, apart, 0.0], [0.0, 0.01, 0.0], [0.0, apart + 0.01, 0.0]];
    let places = points.map(|position| InitialParticle::at(position, [position[1], 1.0 - position[1], 0.3]));
    same_on_all_paths("edge of the support", &scene, &places);
}

/// Compares the scalar path, SIMD lanes with and without neighbour lists, and a device over ten steps.
fn same_on_all_paths(test: &str, scene: &Scene, places: &[InitialParticle]) {
    let scene = &checked(scene);
    let gpu = device(test, Mode::Strict);
    let start = |heap: &mut OwnedMemory, simd, list: bool| {
        let memory = heap.lend().with_neighbour_words(if list { usize::MAX } else { 0 });
        let at = places.iter().copied();
        let solver = Solver::with_particles(scene, Plan::of(scene), places.len(), at, memory).expect("a scene");
        let mut solver = solver.at_level(simd);
        let on_device = gpu.as_ref().map(|gpu| GpuSolver::new(gpu, &solver).expect("a device"));
        (0..10).for_each(|_| solver.step(&Serial).expect("a step"));
        let on_device = on_device.map(|mut fluid| {
            fluid.step(10).expect("steps on the device");
            Snapshot::of_gpu(&fluid).expect("a state").hash()
        });
        (solver.hash(), on_device)
    };
    let heap = || OwnedMemory::with(&Requirements::of(scene).for_particles(places.len()));
    let (want, on_device) = start(&mut heap(), Simd::Scalar, true);
    assert_eq!(on_device.unwrap_or(want), want, "{test}, on the device");
    for (simd, list) in Simd::available().flat_map(|simd| [(simd, true), (simd, false)]) {
        assert_eq!(start(&mut heap(), simd, list).0, want, "{test}, {simd:?}, lists {list}");
    }
}

#[test]
fn with_every_term_that_the_plan_leaves_out() {
    let Some(gpu) = device("bits_same_on_gpu, everything", Mode::Strict) else { return };
    let named = support::scaled("thesis-cube", 500);
    let scene = checked(&named.file.scene);
    let hashes = [Plan::of(&scene), Plan::everything(&scene)].map(|plan| {
        let mut heap = OwnedMemory::with(&Requirements::by_plan(&scene, &plan));
        let (count, places) = (scene.derived().particles(), scene.initial_particles());
        let cpu = Solver::with_particles(&scene, plan, count, places, heap.lend()).expect("a scene");
        let mut fluid = GpuSolver::new(&gpu, &cpu).expect("a device that takes it");
        fluid.step(50).expect("steps on the device");
        fluid.read().expect("a state").hash()
    });
    assert_eq!(hashes[0], hashes[1]);
}

#[test]
fn for_500_steps_in_the_plane_by_cell_lists() {
    let mut scene = support::scaled("dam-break-2d", 800).file.scene;
    scene.grid.structure = GridStructure::CellLists { places: 64 };
    check("bits_same_on_gpu, dam-break-2d", &scene, 500, 5);
}
