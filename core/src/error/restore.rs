//! Errors of saving and restoring a fluid.
use super::SceneError;
use core::fmt;

/// A fluid cannot be saved into, or restored from, the given bytes ([`Solver::save`](crate::Solver::save),
/// [`Solver::restore`](crate::Solver::restore)).
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum RestoreError {
    /// The bytes are not those of a saved fluid.
    NotSaved,
    /// The fluid was saved in another version of the format.
    WrongVersion {
        /// Version of the bytes.
        given: u32,
        /// Version that this library reads and writes.
        known: u32,
    },
    /// The fluid was saved from another scene, another plan of the scene, or with another number of particles.
    AnotherScene,
    /// The buffer does not have the length of a saved fluid of this scene,
    /// [`Solver::saved_bytes`](crate::Solver::saved_bytes).
    WrongLength {
        /// Length of the given buffer in bytes.
        given: usize,
        /// Expected length in bytes.
        expected: usize,
    },
    /// The bytes differ from those that were written.
    Damaged,
    /// The saved values that can be changed between steps, such as gravity, do not form a valid scene.
    Scene(SceneError),
}

impl fmt::Display for RestoreError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            RestoreError::NotSaved => write!(f, "these bytes are not a saved fluid: their header is missing"),
            RestoreError::WrongVersion { given, known } => {
                write!(
                    f,
                    "the fluid was saved in version {given} of the format, but this library reads version {known} only"
                )
            }
            RestoreError::AnotherScene => {
                write!(f, "the fluid was saved from another scene; create the solver from that scene")
            }
            RestoreError::WrongLength { given, expected } => {
                write!(f, "a saved fluid of this scene has {expected} bytes, but {given} were given")
            }
            RestoreError::Damaged => write!(f, "the saved bytes are damaged: their checksum does not match"),
            RestoreError::Scene(error) => write!(f, "the saved values do not form a valid scene: {error}"),
        }
    }
}

impl core::error::Error for RestoreError {}
