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
            RestoreError::NotSaved => write!(f, "these bytes are no saved fluid: their header is missing"),
            RestoreError::WrongVersion { given, known } => {
                write!(
                    f,
                    "the fluid was saved in version {given} of the format, and this library reads version {known}"
                )
            }
            RestoreError::AnotherScene => {
                write!(f, "the fluid was saved from another scene: create the solver from that scene")
            }
            RestoreError::WrongLength { given, expected } => {
                write!(f, "a saved fluid of this scene takes {expected} bytes, and {given} were given")
            }
            RestoreError::Damaged => write!(f, "the saved bytes are damaged: their checksum does not match"),
            RestoreError::Scene(error) => write!(f, "the values that were saved are not those of a scene: {error}"),
        }
    }
}

impl core::error::Error for RestoreError {}
