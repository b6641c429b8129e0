//! Promise: `advance` and `step_until` make the same steps on a device as on the CPU, bit for bit, with fixed and with
//! adaptive time steps, however many steps the device is given at once.
//!
//! `core/tests/time_is_advanced.rs` checks that these are the right steps.
use millpond_core::scene::Scene;
use millpond_core::{OwnedMemory, Serial, Solver};
use millpond_gpu::{GpuSolver, Mode};

mod support;
use support::falling::{falling, impact};
use support::{Words, dam_break_2d, device, words_of};

#[test]
fn a_device_makes_the_same_steps() {
    let Some(gpu) = device("time_is_advanced", Mode::Strict) else { return };
    let scenes: [fn() -> Scene; 3] = [|| dam_break_2d(0.5), falling, impact];
    for scene in scenes {
        let scene = scene();
        let mut heap = OwnedMemory::of(&scene.check().expect("a scene"));
        let mut cpu = Solver::new(&scene, heap.lend()).expect("a scene");
        let mut fluid = GpuSolver::new(&gpu, &cpu).expect("a device that takes it");
        for (frame, most) in [(1.0 / 60.0, 100), (1e-4, 100), (0.05, 100_000), (0.05, 3), (1.0 / 60.0, 100)] {
            let want = cpu.advance(frame, most, &Serial).expect("steps");
            assert_eq!(fluid.advance(frame, most).expect("steps on the device"), want);
            assert!(words_of(&fluid) == Words::of_cpu(&cpu), "frames of {frame} s");
        }
        for time in [0.2, 0.201, 0.25] {
            let want = cpu.step_until(time, 100_000, &Serial).expect("steps");
            assert_eq!(fluid.step_until(time, 100_000).expect("steps on the device"), want);
            assert!(words_of(&fluid) == Words::of_cpu(&cpu), "up to {time} s");
        }
        let want = cpu.advance(1.0 / 60.0, 100, &Serial).expect("steps");
        assert_eq!(fluid.advance(1.0 / 60.0, 100).expect("steps on the device"), want);
        assert!(words_of(&fluid) == Words::of_cpu(&cpu), "after it landed");
    }
}
