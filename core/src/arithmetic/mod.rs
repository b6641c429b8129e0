//! The numbers the physics is written in: one `f32`, or eight side by side.
//!
//! [`real`] holds the vocabulary of the terms, `lanes` its vector form, `level` chooses between them at run time;
//! [`double`] is for constants only.
//!
//! The vector types are the crate's own: their instructions exist only where `level` has seen that the processor has them, so nobody
//! else may make one.
//!
//! ```compile_fail,E0603
//! use millpond_core::arithmetic::x86::Avx;
//! ```
//! ```compile_fail,E0603
//! use millpond_core::arithmetic::lanes::Base;
//! ```
pub mod double;
mod lanes;
pub(crate) mod level;
#[cfg(not(target_arch = "x86_64"))]
mod portable;
pub mod real;
mod root;
#[cfg(target_arch = "x86_64")]
mod x86;
