//! Recipes: names for the formulas that suit a kind of flow, or that a source uses. The formulas are in `formulas.rs`.

/// A kind of flow, or a source, with the formulas for it. [`Formulation::of`](super::Formulation::of) returns them. The
/// recipes for kinds of flow did best in the tables of `docs/evidence.md` (`Drops` has no table).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Recipe {
    /// A liquid with a free surface: tanks, waves, sloshing, splashes (default).
    #[default]
    FreeSurface,
    /// A free surface that hits walls, where the pressure on them matters.
    Impact,
    /// A fluid that fills a closed box or a periodic domain.
    ClosedBox,
    /// Several fluids of different densities.
    SeveralFluids,
    /// Drops with surface tension in another fluid.
    Drops,
    /// A viscous fluid: channels, honey, lava.
    Viscous,
    /// The formulas of Pirovano, section 4.1.2, for a single fluid.
    Pirovano,
    /// The formulas of Hinsch 2024.
    Hinsch,
}

impl Recipe {
    /// All recipes, those for kinds of flow first.
    pub const ALL: &[Recipe] = &[
        Recipe::FreeSurface,
        Recipe::Impact,
        Recipe::ClosedBox,
        Recipe::SeveralFluids,
        Recipe::Drops,
        Recipe::Viscous,
        Recipe::Pirovano,
        Recipe::Hinsch,
    ];

    /// Returns its name in a scene file.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Recipe::FreeSurface => "FreeSurface",
            Recipe::Impact => "Impact",
            Recipe::ClosedBox => "ClosedBox",
            Recipe::SeveralFluids => "SeveralFluids",
            Recipe::Drops => "Drops",
            Recipe::Viscous => "Viscous",
            Recipe::Pirovano => "Pirovano",
            Recipe::Hinsch => "Hinsch",
        }
    }
}
