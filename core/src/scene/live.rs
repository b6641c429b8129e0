//! Terms that a scene keeps although they do nothing yet, so that they can be switched on between steps.

/// A term that may be changed from nothing to something while the fluid runs ([`Scene::live`](super::Scene::live)).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Live {
    /// [`Solver::set_gravity`](crate::Solver::set_gravity).
    Gravity,
    /// [`Solver::set_wind`](crate::Solver::set_wind).
    Wind,
    /// [`Solver::set_viscosity`](crate::Solver::set_viscosity).
    Viscosity,
    /// [`Solver::set_surface_tension`](crate::Solver::set_surface_tension).
    SurfaceTension,
}

impl Live {
    /// How many there are.
    pub const COUNT: usize = 4;

    /// Its name in a scene, and the field that it is about.
    #[must_use]
    pub fn names(self) -> [&'static str; 2] {
        match self {
            Live::Gravity => ["Gravity", "gravity"],
            Live::Wind => ["Wind", "wind"],
            Live::Viscosity => ["Viscosity", "fluid.dynamic_viscosity"],
            Live::SurfaceTension => ["SurfaceTension", "fluid.surface_tension"],
        }
    }
}
