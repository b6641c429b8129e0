//! Promise: with an adaptive time step, a device's clock has the same bits as the CPU's, however many steps are
//! recorded at once. A step that the device refuses leaves clock and state unchanged, with the same error after the
//! same step.
//!
//! `core/tests/steps_follow_the_state.rs` checks that the CPU's clock is right.
use millpond_core::scene::GridStructure;
use millpond_core::{OwnedMemory, Serial, Solver, StepError};
use millpond_gpu::{GpuError, GpuSolver, Mode};

mod support;
use support::falling::impact;
use support::{Words, device, words_of};

#[test]
fn a_device_keeps_the_same_clock() {
    let Some(gpu) = device("clocks_agree", Mode::Strict) else { return };
    for at_once in [1, 67] {
        let scene = impact();
        let mut heap = OwnedMemory::of(&scene.check().expect("a scene"));
        let mut cpu = Solver::new(&scene, heap.lend()).expect("a scene");
        let mut fluid = GpuSolver::new(&gpu, &cpu).expect("a device that takes it");
        while cpu.steps() < 268 {
            fluid.step(at_once).expect("steps on the device");
            (0..at_once).for_each(|_| cpu.step(&Serial).expect("a step"));
            assert_eq!(fluid.steps(), cpu.steps());
            assert_eq!(fluid.time_report().expect("a report"), cpu.time_report(), "{at_once} at once");
            assert!(words_of(&fluid) == Words::of_cpu(&cpu), "{at_once} at once");
        }
        assert!(cpu.time_report().rejected_steps > 10, "attempts that sit out");
    }
}

#[test]
fn a_refused_step_leaves_the_clock_alone() {
    let Some(gpu) = device("clocks_agree, refused", Mode::Strict) else { return };
    let mut undone = 0;
    // from as many places as the fullest cell needs at the start upwards: some steps are undone before one is refused
    for places in 12..18 {
        let mut scene = impact();
        scene.grid.structure = GridStructure::CellLists { places };
        let mut heap = OwnedMemory::of(&scene.check().expect("a scene"));
        let mut solver = Solver::new(&scene, heap.lend()).expect("a scene");
        let mut fluid = GpuSolver::new(&gpu, &solver).expect("a device that takes it");
        let (before, refused) = loop {
            let before = Words::of_cpu(&solver);
            if let Err(error) = solver.step(&Serial) {
                break (before, error);
            }
            assert!(solver.steps() < 1000, "no cell was ever full");
        };
        assert!(matches!(refused, StepError::CellFull { capacity, .. } if capacity == places), "{refused}");
        undone += before.clock.rejected_steps;
        assert!(matches!(fluid.step(1000), Err(GpuError::Step(error)) if error == refused));
        assert!(words_of(&fluid) == before, "{places} places");
    }
    assert!(undone > 0, "steps that are made again");
}
