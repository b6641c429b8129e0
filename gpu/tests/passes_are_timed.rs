//! Promise: timing the passes of a step does not change a bit of its result, and each pass that the plan runs on a
//! device is timed.
use millpond_core::backend::plan::passes::Threads;
use millpond_core::{OwnedMemory, Plan, Solver};
use millpond_gpu::{GpuError, GpuSolver, Mode};

mod support;
use support::falling::impact;
use support::{checked, device, words_of};

#[test]
fn and_their_step_has_the_same_bits() {
    let Some(gpu) = device("passes_are_timed", Mode::Strict) else { return };
    let scene = impact();
    let mut heap = OwnedMemory::of(&checked(&scene));
    let cpu = Solver::new(&scene, heap.lend()).expect("a scene");
    let fluid = || GpuSolver::new(&gpu, &cpu).expect("a device that takes it");
    let (mut timed, mut plain) = (fluid(), fluid());
    for _ in 0..20 {
        match timed.step_timed() {
            Ok(times) => {
                let ran: Vec<_> = times.iter().map(|(pass, _)| *pass).collect();
                let plan = Plan::of(&checked(&scene));
                for pass in plan.passes().filter(|pass| pass.threads() != Threads::Host) {
                    assert!(ran.contains(&pass), "{} has no time", pass.name());
                }
                assert!(times.iter().all(|(_, ms)| ms.is_finite() && *ms >= 0.0), "{times:?}");
            }
            Err(GpuError::NoPassTimes { .. }) => {
                println!("passes_are_timed: this device has no clock for them");
                timed.step(1).expect("a step");
            }
            Err(error) => panic!("{error}"),
        }
        plain.step(1).expect("a step");
        assert!(words_of(&timed) == words_of(&plain), "step {}", plain.steps());
    }
}
