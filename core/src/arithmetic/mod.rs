//! The numbers the physics is written in: one `f32`, or eight side by side.
//!
//! [`real`] holds the vocabulary of the terms, [`lanes`] its vector form, [`level`] chooses between them at run time;
//! [`double`] is for constants only.
pub mod double;
pub mod lanes;
pub mod level;
#[cfg(not(target_arch = "x86_64"))]
pub mod portable;
pub mod real;
mod root;
#[cfg(target_arch = "x86_64")]
pub mod x86;
