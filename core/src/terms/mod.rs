//! The physics, one family of formulas a file, each written once.
//!
//! rustc compiles this text for `f32` and for lanes; the GPU backend compiles the same text as WGSL. So it keeps to what
//! the two languages share: functions, `let`, `if`, `return`, `+ - *`, the words of
//! [`real`](crate::arithmetic::real), `vec3`, plain structs and `u32` constants. Literals stand on the right of an
//! operator, a literal 0 is never an operand of `+ - *`, attributes take one line. A function that reads the scene's
//! constants takes `m: &Model, p: &Parameters` first; in WGSL these two are global and the filter drops them.
//!
//! Accelerations are sums of force densities (N/m3) divided by the density of the receiving particle.
#![allow(clippy::needless_return, reason = "WGSL has no tail expressions")]

pub mod boundary;
pub mod density;
pub mod geometry;
pub mod integrate;
pub mod kernel;
pub mod neighbour;
pub mod pressure;
pub mod state;
pub mod viscosity;

macro_rules! texts {
    ($($name:literal),*) => { &[$(($name, include_str!(concat!($name, ".rs")))),*] };
}

/// Name and text of every term, for backends that compile it themselves.
pub const TEXTS: &[(&str, &str)] =
    texts!("geometry", "kernel", "density", "state", "pressure", "viscosity", "neighbour", "integrate", "boundary");
