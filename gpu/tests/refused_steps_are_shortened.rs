//! Promise: a device shortens the steps that the CPU shortens, with the same bits, the same count and the same clock,
//! however many steps it is handed at once, and refuses the same step by the same error.
use millpond_core::scene::Recovery;
use millpond_core::{OwnedMemory, Serial, Solver};
use millpond_gpu::{GpuError, GpuSolver, Mode};

mod support;
use support::falling::leaving;
use support::{Words, device, words_of};

#[test]
fn a_device_shortens_the_same_steps() {
    let Some(gpu) = device("refused_steps_are_shortened", Mode::Strict) else { return };
    for at_once in [1, 2, 3] {
        let mut scene = leaving();
        scene.recovery = Recovery::ShortenStep { times: 5 };
        let mut heap = OwnedMemory::of(&scene.check().expect("a scene"));
        let mut cpu = Solver::new(&scene, heap.lend()).expect("a scene");
        let mut fluid = GpuSolver::new(&gpu, &cpu).expect("a device that takes it");
        let refused = loop {
            if let Err(error) = cpu.step(&Serial) {
                break error;
            }
            if cpu.steps().is_multiple_of(at_once) {
                fluid.step(at_once as u32).expect("steps on the device");
                assert!(words_of(&fluid) == Words::of_cpu(&cpu), "{at_once} at once, step {}", cpu.steps());
            }
        };
        assert!(cpu.time_report().halvings > 0, "steps that were shortened");
        assert!(matches!(fluid.step(1000), Err(GpuError::Step(error)) if error == refused), "{refused}");
        assert!(words_of(&fluid) == Words::of_cpu(&cpu), "{at_once} at once, refused");
    }
}
