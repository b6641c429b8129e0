//! The numbers the physics is written in: one `f32`, or four, eight or sixteen side by side.
//!
//! [`real`] holds the vocabulary of the terms, `lanes` how pairs of particles get into the lanes and their sums out,
//! `blocks` what a vector must be able to do for that; `x86` and `portable` are the vectors, and `level` chooses
//! between them at run time. [`double`] is for constants only.
//!
//! The vector types are the crate's own: their instructions exist only where `level` has seen that the processor has
//! them, so nobody else may make one.
//!
//! ```compile_fail,E0603
//! use millpond_core::arithmetic::x86::Avx;
//! ```
//! ```compile_fail,E0603
//! use millpond_core::arithmetic::level::Base;
//! ```
mod blocks;
pub(crate) mod codes;
pub mod double;
pub(crate) mod lanes;
pub(crate) mod level;
#[cfg(not(target_arch = "x86_64"))]
mod portable;
pub mod probe;
pub mod real;
mod root;
#[cfg(target_arch = "x86_64")]
mod x86;
