//! Promise: in strict mode a device gives the bits of the CPU, at each of 500 steps, however many steps it makes between
//! two looks; and strict mode is what does it: plain mode breaks a spelling that strict mode keeps.
use millpond::compare::difference;
use millpond::fluid::Snapshot;
use millpond::memory::Heap;
use millpond_core::scene::{Block, GridStructure};
use millpond_core::{Serial, Solver};
use millpond_gpu::{GpuSolver, Mode};

mod support;
use support::device;

/// Compares after every `stride` steps.
fn check(test: &str, scene: &millpond_core::scene::Scene, steps: u64, stride: u32) {
    let Some(gpu) = device(test, Mode::Strict) else { return };
    let mut heap = Heap::of(scene);
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
    // 67 steps at once are more than are recorded before a look at the status
    check("bits_same_on_gpu, thesis-cube", &support::scaled("thesis-cube", 1000).file.scene, 500, 67);
}

#[test]
fn for_no_particle_and_for_one() {
    let mut scene = support::scaled("dam-break-2d", 800).file.scene;
    scene.blocks.clear();
    check("bits_same_on_gpu, no particle", &scene, 3, 1);
    let corner = [0.5, 1.0, 0.0];
    let block = Block { corner, size: [scene.particle_spacing; 3], velocity: [0.0; 3], jitter: 0.0 };
    scene.blocks = [block].into_iter().collect();
    assert_eq!(scene.particle_count(), 1);
    check("bits_same_on_gpu, one particle", &scene, 100, 10);
}

#[test]
fn for_500_steps_in_the_plane_by_cell_lists() {
    let mut scene = support::scaled("dam-break-2d", 800).file.scene;
    scene.grid.structure = GridStructure::CellLists { places: 64 };
    check("bits_same_on_gpu, dam-break-2d", &scene, 500, 5);
}
