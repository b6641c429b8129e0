//! The memory of a simulation: how much a scene needs, how it is lent to a solver, and its division into arrays.
mod lend;
#[cfg(feature = "alloc")]
mod owned;
mod requirements;
mod storage;
mod views;

pub use lend::Memory;
#[cfg(feature = "alloc")]
pub use owned::OwnedMemory;
pub(crate) use requirements::MOST_LISTED;
pub use requirements::{Counts, LIST_WORDS, Requirements};
pub use storage::{Arena, Storage};
pub(crate) use views::Sorting;
pub use views::{Arrays, Given, Scratch, State};
