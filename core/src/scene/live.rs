//! Terms that a scene keeps although they do nothing yet, so that they can be switched on between steps.

/// A term that may be changed from nothing to something while the fluid runs ([`Scene::adjustable`](super::Scene::adjustable)).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Adjustable {
    /// [`Solver::set_gravity`](crate::Solver::set_gravity).
    Gravity,
    /// [`Solver::set_wind`](crate::Solver::set_wind).
    Wind,
    /// [`Solver::set_viscosity`](crate::Solver::set_viscosity).
    Viscosity,
    /// [`Solver::set_surface_tension`](crate::Solver::set_surface_tension).
    SurfaceTension,
}

impl Adjustable {
    /// How many there are.
    pub const COUNT: usize = 4;

    /// Its name in a scene, and the field that it is about.
    #[must_use]
    pub fn names(self) -> [&'static str; 2] {
        match self {
            Adjustable::Gravity => ["Gravity", "gravity"],
            Adjustable::Wind => ["Wind", "wind"],
            Adjustable::Viscosity => ["Viscosity", "dynamic_viscosity"],
            Adjustable::SurfaceTension => ["SurfaceTension", "surface_tension"],
        }
    }
}
