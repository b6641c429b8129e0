//! millpond-core: a fluid of particles (smoothed particle hydrodynamics, SPH) that you step inside your own program.
//!
//! The crate needs no standard library, and allocates nothing unless you enable its feature `alloc`. You lend it memory
//! ([`Storage`], slices of your own, or with `alloc` an `OwnedMemory`), describe what flows ([`scene::Scene`]), and
//! advance it ([`Solver::advance`]). The same scene gives the same bits on any number of threads, with any vector
//! instructions of the processor, in debug and release builds, and on a GPU in strict mode (`millpond-gpu`).
//!
//! All quantities are in SI units. In two dimensions every z is 0 and masses are per metre of depth.
//!
//! ```
//! use millpond_core::glam::Vec3;
//! use millpond_core::scene::{Block, Container, Dimension, Fluid, Scene};
//! use millpond_core::{OwnedMemory, Serial, Solver};
//!
//! fn main() -> Result<(), Box<dyn std::error::Error>> {
//!     let water = Fluid { speed_of_sound: 20.0, ..Fluid::default() };
//!     let column = Block { size: Vec3::splat(0.8), ..Block::default() };
//!     let mut scene = Scene::of(Dimension::Three, 0.05, 0.001, water, column); // spacing in m, time step in s
//!     scene.gravity = Vec3::new(0.0, -9.81, 0.0);
//!     scene.container = Some(Container::closed(Vec3::ZERO, Vec3::new(2.0, 2.0, 0.8)));
//!     scene.time_step = scene.check()?.recommended_time_step(); // instead of that 0.001 s
//!     let mut memory = OwnedMemory::of(&scene.check()?);
//!     let mut pond = Solver::new(&scene, memory.lend())?;
//!     for frame in 0..60 {
//!         pond.advance(1.0 / 60.0, 50, &Serial)?; // a frame of a game, in at most 50 steps
//!         let highest = pond.fluid_positions().map(|position| position.y).fold(0.0, f32::max);
//!         println!("frame {frame}: the water reaches up to {highest:.2} m");
//!     }
//!     Ok(())
//! }
//! ```
//!
//! Debug builds need `opt-level = 3` for this package ("Embed it" in the README), or the fluid is about 100 times
//! slower.
//!
//! # For readers of the source
//!
//! A scene is validated, turned into a plan (which arrays and passes it needs), and stepped. Data flows one way through
//! the folders of `core/src`:
//! 1. `scene`: what a scene asks for, as plain data;
//! 2. `validate`: what is refused, and why; `derive`: what follows from a scene, computed once;
//! 3. `plan`: the tables of arrays and passes, and a time step as a list of commands;
//! 4. `memory` and `layout`: the arrays, cut out of the memory you lend, and the bytes that both backends share;
//! 5. `solver`: the public API, with `live` (changes between steps), `save` (bytes), `report` and `springs`;
//! 6. `step` runs the commands; `passes` has the loops, one file a pass, in folders in the order of the step;
//! 7. `terms`: the physics, each formula once for scalars, SIMD lanes and WGSL; `arithmetic`: the functions that
//!    formulas may call; `grid`: how neighbours are found.
//!
//! A formula names its source by author and year, and `docs/references.md` of the repository lists the sources.
//! "Corrected" beside an equation means that the source misprints it: `docs/errata.md` has what it should say.
#![no_std]
#![deny(unsafe_code)]

#[cfg(feature = "alloc")]
extern crate alloc;
#[cfg(test)]
extern crate std;

mod access;
mod advance;
mod arithmetic;
mod axis;
#[doc(hidden)]
pub mod backend;
mod census;
mod changes;
mod clock;
mod closed_wall_force;
mod derive;
mod error;
mod executor;
mod flux;
mod grid;
pub mod guide;
mod hash;
mod layout;
mod live;
mod memory;
mod neighbours;
mod particle;
mod passes;
mod plan;
mod probe;
mod record;
mod report;
mod requests;
mod save;
pub mod scene;
mod solid_state;
mod solids;
mod solver;
mod springs;
mod start;
mod step;
mod terms;
mod validate;
mod wall_force;

pub use glam;
pub use heapless;

pub use advance::Advance;
pub use arithmetic::level::Simd;
pub use axis::Axis;
pub use census::Census;
pub use clock::TimeReport;
pub use derive::Derived;
pub use error::{Field, RestoreError, SceneError, SolidError, SpawnError, StepError};
pub use executor::{Executor, MOST_JOBS, Serial};
pub use flux::Flux;
#[cfg(feature = "alloc")]
pub use memory::OwnedMemory;
pub use memory::{Arena, LIST_WORDS, Memory, Requirements, State, Storage};
pub use neighbours::Neighbours;
pub use particle::Particle;
pub use plan::Plan;
pub use plan::arrays::{Array, Quantity};
pub use plan::passes::Pass;
pub use probe::Sample;
pub use record::CorrectionReport;
pub use report::{AirReport, DensityError, Energies};
pub use requests::{NewParticle, ParticleId};
pub use solid_state::SolidState;
pub use solver::Solver;
pub use springs::Spring;
pub use validate::Checked;
pub use wall_force::SolidForce;
