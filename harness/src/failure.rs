//! Why the program could not do what it was asked, and the exit status that says so.
use millpond_core::{SceneError, StepError};
use millpond_gpu::GpuError;
use std::path::{Path, PathBuf};

/// Anything that ends a command early.
#[derive(Debug, thiserror::Error)]
pub enum Failure {
    /// The call is wrong.
    #[error("{0}")]
    Call(String),
    /// A scene file cannot be read as one.
    #[error("{}:{line}: {message}", .file.display())]
    SceneText {
        /// Which file.
        file: PathBuf,
        /// Line of the fault.
        line: usize,
        /// What is wrong, with the field's name.
        message: String,
    },
    /// A scene cannot run.
    #[error("{origin}: {error}")]
    Scene {
        /// The scene, with file and line where they are known.
        origin: String,
        /// What is wrong.
        error: SceneError,
    },
    /// A step failed.
    #[error(transparent)]
    Step(#[from] StepError),
    /// The GPU backend refused.
    #[error(transparent)]
    Gpu(GpuError),
    /// A file could not be read or written.
    #[error("{error}: {}", .path.display())]
    File {
        /// Which.
        path: PathBuf,
        /// What the system says.
        error: std::io::Error,
    },
    /// The system refused something else.
    #[error("{0}")]
    System(String),
}

impl Failure {
    /// 1: done, and a promise failed. 2: the call or the scene is wrong. 3: no such backend here.
    #[must_use]
    pub fn exit_status(&self) -> u8 {
        match self {
            Failure::Step(_) | Failure::Gpu(GpuError::Step(_)) => 1,
            // a scene that no device could run
            Failure::Gpu(GpuError::CpuOnly { .. }) => 2,
            Failure::Gpu(_) => 3,
            _ => 2,
        }
    }

    /// A file that could not be read or written.
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
