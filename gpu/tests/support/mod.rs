//! Helpers for tests of a device, in addition to core's: opening a device, or reporting that there is none, and reading
//! its state.
#![allow(dead_code, unreachable_pub, reason = "each test uses its part")]
use millpond_gpu::{Gpu, GpuSolver, Mode};
use std::io::Write as _;

#[path = "../../../core/tests/support/mod.rs"]
mod of_core;
#[allow(unused_imports, reason = "each test uses its part")]
pub use of_core::*;

/// Returns every word of the state on a device, and its clock.
pub fn words_of(solver: &GpuSolver) -> Words {
    let state = solver.read().expect("a state");
    Words::of(state.slots(), |array| state.words(array), solver.time_report().expect("a report"))
}

/// Opens a device. Without one, prints that the test is skipped and returns `None`; with `MILLPOND_REQUIRE_GPU=1` it
/// panics instead.
pub fn device(test: &str, mode: Mode) -> Option<Gpu> {
    match Gpu::open(None, mode) {
        Ok(gpu) => {
            println!("{test}: on {}, which offers {:?}", gpu.name(), gpu.float_controls());
            Some(gpu)
        }
        Err(error) => {
            let required = std::env::var_os("MILLPOND_REQUIRE_GPU").is_some_and(|v| v == "1");
            assert!(!required, "{test}: a GPU is required: {error}");
            // written to stderr directly, past the test runner's capture, so that a skipped test is visible
            let _ = writeln!(std::io::stderr(), "skipped: {test}: {error}");
            None
        }
    }
}
