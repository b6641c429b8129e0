//! Promise: a device refuses what the CPU refuses, with the same error after the same step, and leaves every bit of the
//! state unchanged, however many steps were requested. If something is missing before a device can start, the error
//! names it.
use millpond_core::scene::Traversal;
use millpond_core::{Plan, Serial, Solver};
use millpond_gpu::{FloatControls, Gpu, GpuError, GpuSolver, Mode};

mod support;
use support::refused::{self, Refused};
use support::{Words, checked, device, heap_for, words_of};

#[test]
fn a_step_that_is_refused() {
    let Some(gpu) = device("refusals_keep_state", Mode::Strict) else { return };
    for Refused { name, scene, places, good, error } in refused::all() {
        let mut heap = heap_for(&scene, places.len());
        let scene = checked(&scene);
        let at = places.iter().copied();
        let start = Solver::with_particles(&scene, Plan::of(&scene), places.len(), at, heap.lend());
        let mut solver = start.expect("a scene that starts");
        let mut fluid = GpuSolver::new(&gpu, &solver).expect("a device that takes it");
        (0..good).for_each(|_| solver.step(&Serial).expect("a good step"));
        assert_eq!(solver.step(&Serial), Err(error), "{name}, on the CPU");
        for _ in 0..2 {
            // more steps are recorded than can succeed
            let refused = fluid.step(20);
            assert!(matches!(refused, Err(GpuError::Step(e)) if e == error), "{name}: {refused:?}");
            assert!(words_of(&fluid) == Words::of_cpu(&solver), "{name}");
            assert_eq!(fluid.steps(), good, "{name}");
        }
    }
}

#[test]
fn a_device_and_a_shader_that_are_not_there() {
    let missing = Gpu::open(Some("no such adapter"), Mode::Plain);
    assert!(matches!(missing, Err(GpuError::NoAdapter { wanted: Some(name) }) if name == "no such adapter"));
    let refused = millpond_gpu::strict::spirv("fn f() -> u32 { return 1.0; }", FloatControls::default());
    assert!(matches!(refused, Err(GpuError::Shader(message)) if message.contains("return")));
}

#[test]
fn the_choice_that_only_the_cpu_has() {
    let Some(gpu) = device("refusals_keep_state", Mode::Plain) else { return };
    let Refused { mut scene, .. } = refused::all().into_iter().next().expect("a scene");
    scene.grid.traversal = Traversal::HalfStencil;
    let mut heap = heap_for(&scene, checked(&scene).derived().particles());
    let solver = Solver::new(&scene, heap.lend()).expect("a scene that starts");
    let told = GpuSolver::new(&gpu, &solver).expect_err("no device adds to two particles at once").to_string();
    assert!(told.starts_with("grid.traversal HalfStencil is supported on the CPU only: "), "{told}");
}
