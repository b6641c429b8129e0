//! Why a fluid cannot go on from bytes.
use super::SceneError;
use core::fmt;

/// Bytes that a fluid cannot go on from.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum RestoreError {
    /// Bytes that no fluid was saved to.
    NotSaved,
    /// Bytes of another version.
    WrongVersion {
        /// Their version.
        given: u32,
        /// The one that this library reads and writes.
        known: u32,
    },
    /// Bytes of a fluid of another scene, another plan of it, or another number of particles.
    AnotherScene,
    /// Bytes of another length than those of this scene.
    WrongLength {
        /// Bytes given.
        given: usize,
        /// Bytes expected.
        expected: usize,
    },
    /// Bytes that are not those that were written.
    Damaged,
    /// Values that were changed between steps and that no scene can have.
    Scene(SceneError),
}

impl fmt::Display for RestoreError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            RestoreError::NotSaved => write!(f, "the bytes do not begin as those of a saved fluid do"),
            RestoreError::WrongVersion { given, known } => {
                write!(f, "the bytes are of version {given}, and this library reads version {known}")
            }
            RestoreError::AnotherScene => {
                write!(f, "the bytes are of another scene: create the solver from the scene that was saved")
            }
            RestoreError::WrongLength { given, expected } => {
                write!(f, "a fluid of this scene is {expected} bytes long, and {given} were given")
            }
            RestoreError::Damaged => write!(f, "the bytes are damaged: they are not those that were saved"),
            RestoreError::Scene(error) => write!(f, "the saved values do not make a scene: {error}"),
        }
    }
}

impl core::error::Error for RestoreError {}
