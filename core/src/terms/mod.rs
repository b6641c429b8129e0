//! The physics, one family of formulas per file, with each formula written once.
//!
//! rustc compiles this text for `f32` and for SIMD lanes; the GPU backend compiles the same text as WGSL. The text
//! therefore uses only what the two languages share: functions, `let`, `if`, `return`, `+ - *`, the intrinsics of
//! [`real`](crate::arithmetic::real), `vec3`, plain structs and `u32` constants. Literals stand on the right of an
//! operator, a literal 0 is never an operand of `+ - *`, and an attribute takes one line. A function that reads the
//! scene's constants takes `m: &Model`, `p: &Parameters`, `u: &StepUniform`, `t: &Tables` first, in this order. In WGSL
//! these are global variables, and the conversion drops the arguments.
//!
//! Accelerations are sums of force densities (N/m3) divided by the density of the receiving particle.
#![allow(clippy::needless_return, reason = "WGSL has no tail expressions")]
#![allow(clippy::unreadable_literal, reason = "WGSL has no separators of digits")]
#![allow(clippy::too_many_arguments, reason = "WGSL has no tuples, and no constructors that Rust would take")]

/// Declares the name and text of each term of a folder, for backends that compile the terms themselves.
macro_rules! texts {
    ($($name:ident)*) => {
        /// Name and text of each term of this folder.
        pub const TEXTS: &[(&str, &str)] = &[$((stringify!($name), include_str!(concat!(stringify!($name), ".rs")))),*];
    };
}

pub mod air;
pub mod beyond;
pub mod boundary;
pub mod correction;
pub mod density;
pub mod diffusion;
pub mod elastic;
pub mod emission;
pub mod exchange;
pub mod external;
pub mod extrapolation;
pub mod geometry;
pub mod integrate;
pub mod internal_energy;
pub mod kernel;
pub mod motion;
pub mod near;
pub mod neighbour;
pub mod pair;
pub mod pressure;
pub mod renormalisation;
pub mod shape;
pub mod shifting;
pub mod state;
pub mod support;
pub mod table;
pub mod tension;
pub mod time_step;
pub mod viscosity;
pub mod wall;
pub mod xsph;

texts!(air beyond boundary correction density diffusion elastic emission exchange external extrapolation
    geometry internal_energy motion near neighbour pair pressure renormalisation shape shifting state support table
    tension time_step viscosity wall xsph);

/// Returns the name and text of every file of terms. The order is arbitrary, since WGSL does not depend on it.
pub fn texts() -> impl Iterator<Item = (&'static str, &'static str)> {
    let folders = [("kernel", include_str!("kernel/mod.rs")), ("integrate", include_str!("integrate/mod.rs"))];
    let of = |texts: &'static [(&'static str, &'static str)]| texts.iter().copied();
    folders.into_iter().chain(of(kernel::TEXTS)).chain(of(integrate::TEXTS)).chain(of(TEXTS))
}
