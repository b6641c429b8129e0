//! millpond-gpu: the same step on a wgpu device.
//!
//! The buffers hold core's bytes, the programs are core's terms taken as text, and each loop in `shaders/` stands beside
//! the one of the same name in core's `passes/`. In [`Mode::Strict`] the results are those of the CPU to the last bit.
//!
//! Read in this order: [`bindings`] (which pass touches what), [`text`] and [`program`] (how WGSL is made), [`strict`]
//! (why a driver obeys), [`solver`].

pub mod bindings;
pub mod device;
pub mod error;
pub mod float_controls;
pub mod intrinsics;
pub mod program;
pub mod solver;
pub mod strict;
pub mod text;

mod buffers;
mod functions;
mod open;
mod pass_times;
mod pipelines;

pub use device::{Gpu, Mode};
pub use error::GpuError;
pub use float_controls::FloatControls;
pub use solver::{GpuSolver, Readback};
pub use wgpu;
