//! Promise: a device in strict mode creates the same layer of air as the CPU, bit for bit, and counts the same number
//! of spawn requests that find no inactive air particle.
//!
//! `core/tests/air_keeps_its_bits.rs` checks that the CPU's layer of air is right.
use millpond_core::scene::Dimension;
use millpond_core::{OwnedMemory, Serial, Solver};
use millpond_gpu::{GpuSolver, Mode};

mod support;
use support::air::{both, drop, scenes};
use support::{Words, device, words_of};

const STEPS: u32 = 60;

#[test]
fn births_that_find_nobody_are_counted() {
    let Some(gpu) = device("air_is_the_same, births", Mode::Strict) else { return };
    for capacity in [1, 5] {
        let scene = drop(Dimension::Two, capacity);
        let mut heap = OwnedMemory::of(&scene.check().expect("a scene"));
        let mut solver = Solver::new(&scene, heap.lend()).expect("a scene");
        let mut on_device = GpuSolver::new(&gpu, &solver).expect("a device that takes it");
        for _ in 0..5 {
            solver.step(&Serial).expect("a step");
            on_device.step(1).expect("a step");
            assert!(solver.air().refused > 0, "each step asks");
            assert_eq!(on_device.air().expect("a report"), solver.air());
        }
    }
}

#[test]
fn the_same_bits_in_every_scene() {
    let Some(gpu) = device("air_is_the_same", Mode::Strict) else { return };
    for base in both() {
        for (name, scene) in scenes(&base) {
            let mut heap = OwnedMemory::of(&scene.check().expect("a scene"));
            let mut solver = Solver::new(&scene, heap.lend()).expect("a scene");
            let mut on_device = GpuSolver::new(&gpu, &solver).expect("a device that takes it");
            on_device.step(STEPS).expect("steps on the device");
            (0..STEPS).for_each(|_| solver.step(&Serial).expect("a step"));
            let what = format!("{name}, {:?}", scene.dimension);
            assert_eq!(on_device.air().expect("a report"), solver.air(), "{what}");
            assert!(words_of(&on_device) == Words::of_cpu(&solver), "{what}");
        }
    }
}
