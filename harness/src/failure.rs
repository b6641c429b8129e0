//! Errors that end a command, and their exit statuses.
use millpond_core::{SceneError, StepError};
use millpond_gpu::GpuError;
use std::path::{Path, PathBuf};

/// An error that ends a command early.
#[derive(Debug, thiserror::Error)]
pub enum Failure {
    /// The arguments are wrong.
    #[error("{0}")]
    Call(String),
    /// A scene file cannot be parsed.
    #[error("{}:{line}: {message}", .file.display())]
    SceneText {
        /// The file.
        file: PathBuf,
        /// Line of the error, counted from 1.
        line: usize,
        /// What is wrong, with the name of the field.
        message: String,
    },
    /// A scene is invalid or cannot start.
    #[error("{origin}: {error}")]
    Scene {
        /// Name of the scene or the `--set` argument; file and line where they are known.
        origin: String,
        /// What is wrong.
        error: SceneError,
    },
    /// A time step failed.
    #[error(transparent)]
    Step(#[from] StepError),
    /// The GPU backend reported an error.
    #[error(transparent)]
    Gpu(GpuError),
    /// A file could not be read.
    #[error("{}: {error}", .path.display())]
    File {
        /// Path of the file.
        path: PathBuf,
        /// Error of the operating system.
        error: std::io::Error,
    },
    /// A result could not be written.
    #[error("{}: cannot be written: {error}", .path.display())]
    Unwritten {
        /// Path of the file or folder.
        path: PathBuf,
        /// What went wrong.
        error: String,
    },
    /// Another error of the operating system.
    #[error("{0}")]
    System(String),
}

impl Failure {
    /// Returns the exit status: 1 if a step failed, 2 if the arguments or the scene are wrong, 3 if the backend is not
    /// available, 4 if a result could not be written.
    #[must_use]
    pub fn exit_status(&self) -> u8 {
        match self {
            Failure::Step(_) | Failure::Gpu(GpuError::Step(_)) => 1,
            // no GPU could run this scene
            Failure::Gpu(GpuError::CpuOnly { .. }) => 2,
            Failure::Gpu(_) => 3,
            Failure::Unwritten { .. } => 4,
            _ => 2,
        }
    }

    /// Returns a function that turns an error of writing into a failure with this path.
    pub fn unwritten<E: ToString>(path: &Path) -> impl FnOnce(E) -> Failure {
        let path = path.to_owned();
        move |error| Failure::Unwritten { path, error: error.to_string() }
    }

    /// Returns a function that turns an error of reading into a failure with this path.
    pub fn file(path: &Path) -> impl FnOnce(std::io::Error) -> Failure {
        let path = path.to_owned();
        move |error| Failure::File { path, error }
    }
}

impl From<GpuError> for Failure {
    fn from(error: GpuError) -> Self {
        match error {
            GpuError::Step(step) => Failure::Step(step),
            other => Failure::Gpu(other),
        }
    }
}
