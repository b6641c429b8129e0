//! The fluids of a scene, and the blocks that they fill at the start.
use super::choice::EquationOfState;
use glam::Vec3;

/// Largest number of fluids in a scene.
pub const FLUIDS: usize = 8;

/// Properties of a fluid (Pirovano, section 4.1.4). The default is water with a reduced speed of sound (10 m/s), as
/// usual in weakly compressible SPH.
///
/// Between particles of two fluids the mean of their viscosities acts (Pirovano, section 3.3).
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(deny_unknown_fields, default))]
pub struct Fluid {
    /// Rest density, kg/m3, larger than 0 (default 1000).
    pub rest_density: f32,
    /// Speed of sound at rest, m/s, larger than 0 (default 10). It sets how stiff the fluid is: about ten times the
    /// fastest flow keeps the density within 1 % of the rest density. A larger one needs a smaller time step.
    pub speed_of_sound: f32,
    /// How pressure follows from density (default `None`: that of
    /// [`Formulation::equation_of_state`](super::Formulation::equation_of_state)). It must be `None` with a pressure
    /// correction, which uses no equation of state.
    pub equation_of_state: Option<EquationOfState>,
    /// Number of particles inside the support radius of this fluid, 0.001 to 2^28 - 1 (default `None`: that of the
    /// scene). All fluids of a scene share the smallest of their support radii (Pirovano, section 3.3).
    pub average_neighbours: Option<f32>,
    /// Constant B of Tait's equation, Pa, larger than 0 (Hinsch's stiffness k; default `None`: `rho0 c0^2 / gamma`,
    /// Roy's constant, corrected; gamma is [`tait_exponent`](super::Formulation::tait_exponent)). If it is given, the
    /// speed of sound is `sqrt(gamma B / rho0)` and `speed_of_sound` is ignored.
    /// Give it instead of a speed of sound to reproduce a simulation that is specified by this constant.
    pub stiffness: Option<f32>,
    /// Dynamic viscosity, Pa s, 0 or more (default 0). Every form of [`Viscosity`](super::Viscosity) uses it except
    /// `Artificial` and `VelocityExchange`.
    pub dynamic_viscosity: f32,
    /// Coefficient of [`Formulation::surface_tension`](super::Formulation::surface_tension), 0 or more (default 0).
    /// For `Curvature` and `NormalCurvature` it is the surface tension in N/m. The other models have no physical
    /// tension, but a coefficient in m3/s2 (`Attraction`) or m2/s2 (`GradientSum`).
    pub surface_tension: f32,
    /// Stiffness k of the springs between the particles of this fluid, N/m, 0 or more (Pirovano, eq. 2.26, corrected;
    /// default 0, no springs). Each end gets half of the force `k (r - L)`, r being the distance and L the rest
    /// length, so the effective stiffness of a spring is k / 2. See [`Elasticity`](super::Elasticity).
    pub elastic_stiffness: f32,
    /// Near pressure over density, m2/s2, 0 or more (default `None`: 0.1 c0^2, our choice; larger values, near c0^2,
    /// make the fluid expand like a gas). It is the coefficient of
    /// [`Formulation::near_pressure`](super::Formulation::near_pressure). Increase it if particles pair.
    pub near_stiffness: Option<f32>,
    /// Internal energy at the start, J/kg, 0 or more (default 0). It is used if
    /// [`Formulation::internal_energy`](super::Formulation::internal_energy) is on.
    #[cfg_attr(feature = "serde", serde(alias = "thermal_energy"))]
    pub internal_energy: f32,
    /// Colour in which the fluid is drawn: red, green and blue in sRGB, 0 to 1 each (default `None`: a colour of a
    /// palette). The solver does not use it.
    pub colour: Option<[f32; 3]>,
}

impl Fluid {
    /// The default fluid: water with a reduced speed of sound (10 m/s), as usual in weakly compressible SPH.
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

/// Shape of a block.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum BlockShape {
    /// The whole box.
    #[default]
    Box,
    /// The ball (in 2D the disc) inscribed in the box; an ellipsoid if the extents differ.
    Ball,
}

/// A body of fluid at the start. It is filled with particles at the centres of cubes whose edge is the particle
/// spacing.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(deny_unknown_fields))]
pub struct Block {
    /// Index of the block's fluid in [`Scene::fluids`](super::Scene::fluids), counted from 0 (default 0).
    #[cfg_attr(feature = "serde", serde(default))]
    pub fluid: u32,
    /// Lowest corner, m. Its coordinates may be at most 65536 particle spacings from 0, where f32 still resolves 1/128
    /// of a spacing. In 2D the z coordinate is ignored.
    pub corner: Vec3,
    /// Extents, m, larger than 0. They are rounded to whole particle spacings, at least one. In 2D the extent along z
    /// is ignored.
    pub size: Vec3,
    /// Shape of the fluid within these extents (default the whole box).
    #[cfg_attr(feature = "serde", serde(default))]
    pub shape: BlockShape,
    /// Whether the block leaves out the places in solids and those nearer than half a particle spacing to one (default
    /// false: fluid that would start in a solid is an error).
    #[cfg_attr(feature = "serde", serde(default))]
    pub around_solids: bool,
    /// Velocity at the start, m/s (default 0). In 2D its z component must be 0.
    #[cfg_attr(feature = "serde", serde(default))]
    pub velocity: Vec3,
    /// Random displacement of the particles at the start, in particle spacings, 0 or more (default 0). Each coordinate
    /// is displaced by up to half of it in either direction. The seed is fixed, so every start is the same. Use it to
    /// break the symmetry of the lattice.
    #[cfg_attr(feature = "serde", serde(default))]
    pub jitter: f32,
    /// Dynamic viscosity of the particles of this block, Pa s, 0 or more (default `None`: that of the fluid).
    #[cfg_attr(feature = "serde", serde(default))]
    pub dynamic_viscosity: Option<f32>,
}
