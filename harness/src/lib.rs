//! millpond: the program that runs fluid scenes on CPU and GPU, shows that both give the same bits, and measures speed
//! and error.
//!
//! Each command has its own module: [`run`], [`compare`], [`mod@bench`], [`plan_view`], [`error_study`], [`check`],
//! [`stability`], and [`showcase`], which runs if no command is given. They share [`scenes`] (scene files), [`fluid`]
//! (a scene on a backend), [`state_summary`] (summary of a state), [`extremes`] (extreme scenes for tests) and the
//! drawing in [`paint`], [`frames`] and [`plot`].

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
pub mod gauge;
pub mod gauges;
pub mod guide_view;
pub mod nearest;
mod outcome;
pub mod output;
mod overrides;
pub mod paint;
pub mod plan_view;
pub mod plot;
pub mod pool;
pub mod run;
pub mod run_length;
mod scene_errors;
pub mod scene_file;
pub mod scene_text;
pub mod scenes;
pub mod showcase;
pub mod snapshot;
pub mod stability;
pub mod state_summary;
pub mod timing;
pub mod warnings;

pub use failure::Failure;
