//! The numbers the physics is written in: one `f32`, or eight side by side.
//!
//! [`real`] holds the vocabulary of the terms, [`lanes`] its vector form, [`level`] chooses between them at run time.
pub mod lanes;
pub mod level;
pub mod real;
mod root;
