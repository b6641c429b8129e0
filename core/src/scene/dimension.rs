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

    /// Returns the default number of neighbours, [`Scene::average_neighbours`](super::Scene::average_neighbours): a
    /// smoothing length of 1.6 spacings in 2D and of 1.2 in 3D. With these a fluid on a lattice stays at rest under its
    /// own weight.
    #[must_use]
    pub const fn average_neighbours(self) -> f32 {
        match self {
            Dimension::Two => 32.0,
            Dimension::Three => 58.0,
        }
    }
}
