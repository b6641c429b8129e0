//! Terms that a scene keeps although their coefficients are 0, so that they can be switched on between steps.

/// A term whose coefficient is 0 at the start and may be changed between steps
/// ([`Scene::adjustable`](super::Scene::adjustable)). The plan keeps these terms; without this list it leaves out
/// every term whose coefficient is 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Adjustable {
    /// Gravity: [`Solver::set_gravity`](crate::Solver::set_gravity).
    Gravity,
    /// Wind: [`Solver::set_wind`](crate::Solver::set_wind).
    Wind,
    /// Viscosity of fluids: [`Solver::set_viscosity`](crate::Solver::set_viscosity).
    Viscosity,
    /// Surface tension of fluids: [`Solver::set_surface_tension`](crate::Solver::set_surface_tension).
    SurfaceTension,
}

impl Adjustable {
    /// Number of variants.
    pub const COUNT: usize = 4;

    /// Returns its name in a scene file, and the name of the field that it concerns.
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
