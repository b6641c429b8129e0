//! The numbers in which the physics is written: one `f32`, or four, eight or sixteen of them in the lanes of a vector.
//!
//! [`real`] holds the intrinsics of the terms. `lanes` brings pairs of particles into lanes and adds up their sums, and
//! `blocks` lists the operations that a vector needs for that. `x86` and `portable` are the vectors, and `level`
//! selects one at run time. [`double`] is for constants only.
//!
//! The vector types are private to the crate: their instructions exist only where `level` has found that the processor
//! has them, so no other code may create one.
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
