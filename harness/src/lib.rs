//! millpond: the program that runs fluid scenes on both backends and shows that they agree, how fast they are and how
//! far off.
//!
//! Each command has a module of its own: [`run`], [`compare`], [`mod@bench`], [`plan_view`], [`error_study`], [`check`],
//! [`stability`], and [`showcase`], which is what happens without any. They share [`scenes`] (what runs), [`fluid`] (a
//! scene on a backend), [`state_summary`] (what can be said of it), [`extremes`] (what no scene should be) and the drawing in
//! [`paint`], [`frames`] and [`plot`].

pub mod arguments;
pub mod bench;
pub mod check;
pub mod cli;
pub mod compare;
mod energy;
pub mod error_study;
pub mod extremes;
pub mod failure;
pub mod fluid;
pub mod frames;
mod outcome;
pub mod output;
pub mod paint;
pub mod plan_view;
pub mod plot;
pub mod pool;
pub mod run;
pub mod run_length;
pub mod scene_text;
pub mod scenes;
pub mod showcase;
pub mod snapshot;
pub mod stability;
pub mod state_summary;
pub mod timing;
pub mod warnings;

pub use failure::Failure;
