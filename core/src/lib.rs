//! millpond-core: the physics of a fixed-capacity SPH fluid and its CPU solver.
//!
//! No standard library, no allocation: you lend memory ([`Storage`], or slices of your own), say what the scene is
//! ([`scene::Scene`]), and call [`Solver::step`]. The same scene gives the same bits on any number of threads, at every
//! SIMD level, in debug and release, with either grid structure, and on the GPU backend in strict mode.
//!
//! Data flows one way, and the modules are the stations:
//! 1. [`scene`]: what is asked for, plain data;
//! 2. [`validate`]: what is refused; [`mod@derive`]: what follows from a scene, computed once;
//! 3. [`plan`]: what runs: the table of arrays, the table of passes, and the step as a list of commands;
//! 4. [`memory`] and [`layout`]: the arrays cut out of lent memory, and the bytes that both backends share;
//! 5. [`solver`]: the public face, with what it goes through: [`live`] (changes between steps), [`save`] (bytes), [`report`],
//!    [`springs`];
//! 6. `step`: the interpreter of the commands; `passes`: the loops, one file a pass, in folders that stand in the order of the step;
//! 7. [`terms`]: the physics, each formula once for scalar, lanes and WGSL; [`arithmetic`]: its vocabulary; [`grid`]: how neighbours
//!    are found.
//!
//! SI units throughout; in 2D every z is 0 and masses are per metre of depth.
#![no_std]
#![deny(unsafe_code)]

#[cfg(feature = "alloc")]
extern crate alloc;
#[cfg(test)]
extern crate std;

mod arithmetic;
mod axis;
#[doc(hidden)]
pub mod backend;
mod changes;
mod clock;
mod derive;
mod error;
mod executor;
mod grid;
mod hash;
mod layout;
mod live;
mod memory;
mod particle;
mod passes;
mod plan;
mod record;
mod report;
mod save;
pub mod scene;
mod solver;
mod springs;
mod start;
mod step;
mod terms;
mod validate;

pub use glam;
pub use heapless;

pub use arithmetic::level::Simd;
pub use axis::Axis;
pub use clock::TimeReport;
pub use derive::Derived;
pub use error::{RestoreError, SceneError, StepError};
pub use executor::{Executor, MOST_JOBS, Serial};
#[cfg(feature = "alloc")]
pub use memory::OwnedMemory;
pub use memory::{Arena, LIST_WORDS, Memory, Requirements, State, Storage};
pub use particle::Particle;
pub use plan::Plan;
pub use plan::arrays::{Array, Quantity};
pub use plan::passes::Pass;
pub use record::CorrectionReport;
pub use report::{AirReport, DensityError, Energies};
pub use solver::Solver;
pub use springs::Spring;
pub use validate::Checked;
