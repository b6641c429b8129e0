//! millpond-gpu: the time step of millpond-core on a wgpu device.
//!
//! The buffers hold the same bytes as core's arrays, the programs are generated from the Rust text of core's terms (its
//! formulas), and each loop in `shaders/` corresponds to the loop of the same name in core's `passes/`. In
//! [`Mode::Strict`] the results equal those of the CPU to the last bit.
//!
//! Suggested reading order: [`bindings`] (which pass accesses which buffer), [`text`] and [`program`] (how WGSL is
//! generated), [`strict`] (what keeps a driver from changing float arithmetic), [`solver`].

pub mod bindings;
pub mod device;
pub mod error;
pub mod float_controls;
pub mod intrinsics;
pub mod program;
pub mod solver;
pub mod strict;
pub mod text;

mod advance;
mod buffers;
mod changes;
mod functions;
mod open;
mod pass_times;
mod pipelines;
mod readback;

pub use device::{Gpu, Mode};
pub use error::GpuError;
pub use float_controls::FloatControls;
pub use readback::Readback;
pub use solver::GpuSolver;
pub use wgpu;
