//! The dimension of space.

/// Dimension of space.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Dimension {
    /// Two: the plane z = 0, with masses per metre of depth.
    Two,
    /// Three.
    Three,
}

impl Dimension {
    /// Returns 2 or 3.
    #[must_use]
    pub fn count(self) -> usize {
        match self {
            Dimension::Two => 2,
            Dimension::Three => 3,
        }
    }
}
