//! What is refused: every reason for which a scene cannot run, said by name before anything is touched.
//!
//! The order is part of the promise: first the numbers one by one, which everything else follows from, then where things are,
//! then choices that do not go together, then numbers that no f32 can hold.
mod bounds;
mod checked;
mod combinations;
mod ranges;
mod scale;
mod shapes;
mod time;
mod traversal;

pub(crate) use bounds::check_count;
pub use checked::Checked;
pub use shapes::MOST_SPACINGS_AWAY;

use crate::derive::Derived;
use crate::derive::counts::Counts;
use crate::derive::domain::cells;
use crate::derive::scales::Scales;
use crate::error::SceneError;
use crate::scene::Scene;

impl Scene {
    /// Refuses a scene that cannot run, naming the field and its value; or gives proof that it can, with what follows from it.
    ///
    /// # Errors
    /// The first [`SceneError`] found: numbers first, then what does not go together.
    pub fn check(&self) -> Result<Checked<'_>, SceneError> {
        ranges::numbers(self)?;
        let scales = Scales::of(self);
        let (counts, cells) = (Counts::of(self, &scales), cells(self, &scales));
        ranges::reach(self, &scales)?;
        ranges::surface(self)?;
        ranges::elasticity(self)?;
        shapes::blocks(self, &counts)?;
        shapes::container(self)?;
        shapes::periodic(self)?;
        shapes::grid(self, cells)?;
        shapes::walls(self, &counts)?;
        shapes::plane(self)?;
        combinations::check(self, &scales)?;
        let derived = Derived::of(self, &scales, &counts, cells);
        scale::check(self, &derived)?;
        Ok(Checked::new(self, derived))
    }
}
