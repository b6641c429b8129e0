//! The memory of a simulation: how much of it a scene needs, how it is lent, and the arrays that it is cut into.
mod lend;
#[cfg(feature = "alloc")]
mod owned;
mod requirements;
mod storage;
mod views;

pub use lend::Memory;
#[cfg(feature = "alloc")]
pub use owned::OwnedMemory;
pub use requirements::{Counts, LIST_WORDS, Requirements};
pub use storage::{Arena, Storage};
pub(crate) use views::Sorting;
pub use views::{Arrays, Given, Scratch, State};
