//! Errors of moving a solid.
use core::fmt;

/// Why a solid could not be moved.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum SolidError {
    /// The scene has no solid with this index.
    NoSuchSolid {
        /// The index.
        solid: usize,
        /// Number of solids.
        solids: usize,
    },
    /// The host does not drive this solid.
    NotDriven {
        /// Index of the solid.
        solid: usize,
    },
    /// A number is not finite.
    NotFinite,
    /// The rotation is not a unit quaternion.
    NotARotation {
        /// Its length, which must be 1.
        length: f32,
    },
    /// The motion leads out of the plane of a scene in 2D.
    OutOfPlane,
}

impl fmt::Display for SolidError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            SolidError::NoSuchSolid { solid, solids } => {
                write!(f, "there is no solid {solid}: the scene has {solids}, and they are counted from 0")
            }
            SolidError::NotDriven { solid } => {
                write!(f, "solids[{solid}] is not moved by the host program; set its motion to Driven")
            }
            SolidError::NotFinite => write!(f, "a position, rotation or velocity of the solid is not a finite number"),
            SolidError::NotARotation { length } => {
                write!(f, "the rotation has length {length}, but must be a unit quaternion")
            }
            SolidError::OutOfPlane => {
                write!(f, "dimension is 2D: a solid moves in the plane and turns about z")
            }
        }
    }
}

impl core::error::Error for SolidError {}
