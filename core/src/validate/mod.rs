//! Validation of scenes: finds every reason for which a scene cannot run, before any memory is written.
//!
//! The order of the checks is part of the contract: first the single numbers, from which everything else is derived,
//! then positions and extents, then combinations of choices, then derived constants that f32 cannot represent.
mod bounds;
mod checked;
mod closed_walls;
mod combinations;
mod emission;
mod ranges;
mod scale;
mod shapes;
mod shifting;
mod solids;
mod time;
mod traversal;

pub(crate) use bounds::{check_count, not_together};
pub use checked::Checked;
pub use shapes::MOST_SPACINGS_AWAY;

use crate::derive::Derived;
use crate::derive::counts::Counts;
use crate::derive::domain::cells;
use crate::derive::frames::Frames;
use crate::derive::initial_particles::initial_particles;
use crate::derive::scales::Scales;
use crate::error::SceneError;
use crate::scene::Scene;

impl Scene {
    /// Checks whether the scene can run, and returns it together with all that is derived from it.
    ///
    /// # Errors
    /// The first [`SceneError`] found, which names the field and its value. Numbers are checked first, then positions
    /// and extents, then combinations of choices.
    pub fn check(&self) -> Result<Checked<'_>, SceneError> {
        ranges::numbers(self)?;
        let scales = Scales::of(self);
        let (counts, cells) = (Counts::of(self, &scales), cells(self, &scales));
        ranges::reach(self, &scales)?;
        solids::shapes(self)?;
        ranges::surface(self)?;
        ranges::elasticity(self)?;
        shapes::blocks(self, &counts)?;
        shapes::container(self)?;
        shapes::periodic(self)?;
        shapes::grid(self, cells)?;
        shapes::walls(self, &counts)?;
        shapes::plane(self)?;
        combinations::check(self, &scales)?;
        emission::check(self, &scales)?;
        let derived = Derived::of(self, &scales, &counts, cells);
        scale::check(self, &derived)?;
        solids::check(self, &scales, Frames::of(self, &derived.parameters, &derived.poses), || {
            initial_particles(self, &derived).take(derived.fluid_particles)
        })?;
        Ok(Checked::new(self, derived))
    }
}
