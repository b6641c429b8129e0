//! What tests of a device share beside core's: a device or a word about its absence, and its state.
#![allow(dead_code, unreachable_pub, reason = "each test uses its part")]
use millpond_gpu::{Gpu, GpuSolver, Mode};
use std::io::Write as _;

#[path = "../../../core/tests/support/mod.rs"]
mod of_core;
#[allow(unused_imports, reason = "each test uses its part")]
pub use of_core::*;

/// Every word of the state on a device, and its clock.
pub fn words_of(solver: &GpuSolver) -> Words {
    let state = solver.read().expect("a state");
    Words::of(state.slots(), |array| state.words(array), solver.time_report().expect("a report"))
}

/// A device, or a line that the test is skipped; with `MILLPOND_REQUIRE_GPU=1` its absence is a failure.
pub fn device(test: &str, mode: Mode) -> Option<Gpu> {
    match Gpu::open(None, mode) {
        Ok(gpu) => {
            println!("{test}: on {}, which offers {:?}", gpu.name(), gpu.float_controls());
            Some(gpu)
        }
        Err(error) => {
            let required = std::env::var_os("MILLPOND_REQUIRE_GPU").is_some_and(|v| v == "1");
            assert!(!required, "{test}: a GPU is required: {error}");
            // past the test runner's capture, so that a skipped test is seen
            let _ = writeln!(std::io::stderr(), "skipped: {test}: {error}");
            None
        }
    }
}
