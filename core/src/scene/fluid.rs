//! What flows, and where it is at the start.
use super::choice::EquationOfState;
use glam::Vec3;

/// Fluids that a scene can have.
pub const FLUIDS: usize = 8;

/// Properties of a fluid (Pirovano, section 4.1.4). The default is water that is as compressible as a simulation likes it.
///
/// Between two fluids viscosities act by their mean (Pirovano, section 3.3).
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(deny_unknown_fields, default))]
pub struct Fluid {
    /// Density at rest, kg/m3 (default 1000).
    pub rest_density: f32,
    /// Speed of sound, m/s (default 10); about ten times the fastest flow keeps the density within 1 %.
    pub speed_of_sound: f32,
    /// How pressure follows from density (default the model's). A scene whose pressure is iterated refuses it.
    pub equation_of_state: Option<EquationOfState>,
    /// Particles inside its own support radius (default the scene's). The scene then has the smallest support radius of its
    /// fluids (Pirovano, section 3.3).
    pub average_neighbours: Option<f32>,
    /// Tait's constant, Pa (default `rho0 c0^2 / 7`, the corrected constant of Roy): Hinsch's stiffness k. The speed of sound
    /// then follows from it, `sqrt(7 k / rho0)`, and `speed_of_sound` has no say.
    pub stiffness: Option<f32>,
    /// Dynamic viscosity, Pa s (default 0: none). For [`Viscosity`](super::Viscosity)`::{Mueller, Morris, MonaghanGingold}`.
    pub dynamic_viscosity: f32,
    /// Surface tension (default 0: none), by [`Formulation::surface_tension`](super::Formulation::surface_tension): N/m for
    /// `Curvature` and `NormalCurvature`; for the models that have no tension of their own a coefficient, m3/s2 for
    /// `Attraction` and m2/s2 for `GradientSum`.
    pub surface_tension: f32,
    /// Stiffness of the springs that join its particles, N/m (Pirovano eq. 2.26; default 0: none). Each end feels half of it, so a
    /// spring pulls with half of this stiffness. See [`Elasticity`](super::Elasticity).
    pub elastic_stiffness: f32,
    /// Near pressure over density, m2/s2 (default 0.1 c0^2, our choice: with c0^2 a liquid becomes a gas). Acts where
    /// [`Formulation::near_pressure`](super::Formulation::near_pressure) does.
    pub near_stiffness: Option<f32>,
    /// Thermal energy at the start, J/kg (default 0).
    #[cfg_attr(feature = "serde", serde(alias = "thermal_energy"))]
    pub internal_energy: f32,
    /// Colour that it is drawn with, red, green and blue from 0 to 1 (default one of a palette).
    pub colour: Option<[f32; 3]>,
}

impl Fluid {
    /// The default: water with a reduced speed of sound, as is usual in weakly compressible SPH.
    pub const WATER: Fluid = Fluid {
        rest_density: 1000.0,
        speed_of_sound: 10.0,
        equation_of_state: None,
        average_neighbours: None,
        stiffness: None,
        dynamic_viscosity: 0.0,
        surface_tension: 0.0,
        elastic_stiffness: 0.0,
        near_stiffness: None,
        internal_energy: 0.0,
        colour: None,
    };
}

impl Default for Fluid {
    fn default() -> Self {
        Fluid::WATER
    }
}

/// A box of fluid at the start, filled with particles at the centres of cells of the particle spacing.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(deny_unknown_fields))]
pub struct Block {
    /// Number of its fluid in [`Scene::fluids`](super::Scene::fluids), counted from 0 (default 0).
    #[cfg_attr(feature = "serde", serde(default))]
    pub fluid: u32,
    /// Lowest corner, m.
    pub corner: Vec3,
    /// Extent, m; rounded to whole spacings. In 2D the extent along z is ignored.
    pub size: Vec3,
    /// Velocity at the start, m/s (default at rest).
    #[cfg_attr(feature = "serde", serde(default))]
    pub velocity: Vec3,
    /// Random displacement at the start, in spacings (default 0; the seed is fixed, so it is always the same one).
    #[cfg_attr(feature = "serde", serde(default))]
    pub jitter: f32,
    /// Dynamic viscosity of this block, Pa s (default the fluid's).
    #[cfg_attr(feature = "serde", serde(default))]
    pub dynamic_viscosity: Option<f32>,
}
