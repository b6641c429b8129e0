//! The formulation of a scene: which formulas it uses, and their coefficients.
use super::choice::{
    DensityDiffusion, DensityForm, EquationOfState, Evaluation, Integrator, Iteration, Kernel, NearPressure,
    PressureForce, PressureSolver, Shifting, SurfaceTension, Viscosity, WallPressure,
};
#[cfg(feature = "serde")]
use super::recipe::Recipe;

/// Defines the formulation, and the same fields as a scene file gives them: a recipe, and what differs from it.
macro_rules! formulation {
    ($(#[$doc:meta])* pub struct Formulation { $($(#[$about:meta])* pub $field:ident: $type:ty,)* }) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq)]
        #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(from = "Given"))]
        pub struct Formulation { $($(#[$about])* pub $field: $type,)* }

        #[cfg(feature = "serde")]
        #[derive(Default, serde::Deserialize)]
        #[serde(rename = "Formulation", deny_unknown_fields, default)]
        struct Given {
            recipe: Recipe,
            $($(#[$about])* #[serde(deserialize_with = "given")] $field: Option<$type>,)*
        }

        #[cfg(feature = "serde")]
        impl From<Given> for Formulation {
            fn from(file: Given) -> Formulation {
                let base = Formulation::of(file.recipe);
                Formulation { $($field: file.$field.unwrap_or(base.$field),)* }
            }
        }
    };
}

formulation! {
    /// The formulas of a scene and their coefficients, which are the same for all fluids.
    ///
    /// Start from a [`Recipe`](super::Recipe) ([`Formulation::of`]) and change what differs. The default is
    /// [`Recipe::FreeSurface`](super::Recipe::FreeSurface); the defaults named below are its choices. A scene file
    /// names the recipe by the field `recipe`.
    pub struct Formulation {
        /// Time integration (default modified velocity Verlet). [`AdaptiveTimeStep`](super::AdaptiveTimeStep), air and
        /// pressure correction each work with some integrators only.
        pub integrator: Integrator,
        /// Evaluates forces a second time at the end of each step, with the velocities of that time (Pirovano, eq.
        /// 2.33, corrected; default off). This doubles the cost of a step and allows larger steps under damping. An
        /// exception is Verlet, which becomes less stable but gains an order of accuracy; the other integrators keep
        /// their orders.
        pub reevaluate: bool,
        /// Kernel of the density sum and of XSPH (default Wendland C2).
        pub density_kernel: Kernel,
        /// Kernel of the pressure gradient and of the divergence in the continuity equation (default Wendland C2).
        pub pressure_kernel: Kernel,
        /// Kernel of the viscosity (default Wendland C2).
        pub viscosity_kernel: Kernel,
        /// Whether kernels are evaluated by their formulas or from tables (default formulas).
        pub evaluation: Evaluation,
        /// How density is computed (default by the continuity equation).
        pub density: DensityForm,
        /// Diffusion of the density (default hydrostatic), with [`DensityForm::Continuity`] or
        /// [`DensityForm::ContinuityAdapted`].
        pub density_diffusion: DensityDiffusion,
        /// Coefficient of the diffusion of density, 0 to 1 (default 0.1, as Molteni and Colagrossi 2009 and Fourtakas
        /// et al. 2019 use). The diffusivity is this times the smoothing length times the speed of sound.
        pub diffusion: f32,
        /// Starts with the hydrostatic density of a fluid at rest under gravity, and with particle masses that match it
        /// (Roy, section 3.1; default off). Each fluid is taken to be a layer perpendicular to gravity, from the
        /// highest to the lowest point of its blocks. Use it for a fluid that is to be at rest at the start.
        #[cfg_attr(feature = "serde", serde(alias = "hydrostatic_start"))]
        pub initialize_hydrostatic: bool,
        /// Scales the particle mass so that the density sum over the initial lattice is exactly the rest density
        /// (default on). Otherwise a particle has the mass `rest_density * particle_spacing^d` in d dimensions.
        #[cfg_attr(feature = "serde", serde(alias = "calibrated_mass"))]
        pub normalize_mass: bool,
        /// How pressure is found (default by an equation of state).
        pub pressure_solver: PressureSolver,
        /// How pressure follows from density (default Tait), with [`PressureSolver::EquationOfState`]. A fluid may have
        /// its own ([`Fluid::equation_of_state`](super::Fluid::equation_of_state)).
        pub equation_of_state: EquationOfState,
        /// Exponent of Tait's equation, a whole number from 1 to 7 (Roy's gamma; default 7, that of water). The larger
        /// it is, the less the density of a fluid that is compressed strongly differs from the rest density.
        pub tait_exponent: u32,
        /// How pressure is iterated, with [`PressureSolver::PressureCorrection`].
        pub correction: Correction,
        /// Whether pressure may be negative (default false). Negative pressure holds a fluid with free surfaces
        /// together, but lets particles pair where there is no near pressure.
        #[cfg_attr(feature = "serde", serde(alias = "suction"))]
        pub negative_pressure: bool,
        /// Form of the pressure gradient (default that of Monaghan 1992).
        pub pressure_force: PressureForce,
        /// Near pressure, which keeps particles from pairing (default off).
        pub near_pressure: NearPressure,
        /// Form of the viscosity (default that of Morris et al. 1997, and a little artificial viscosity). Its
        /// coefficient is [`Fluid::dynamic_viscosity`](super::Fluid::dynamic_viscosity); `Artificial` and
        /// `VelocityExchange` use the next fields instead, and `MorrisAndArtificial` uses `alpha` and `beta` too.
        pub viscosity: Viscosity,
        /// Linear coefficient of [`Viscosity::Artificial`] and of the artificial part of
        /// [`Viscosity::MorrisAndArtificial`], 0 or more (default 0.01). The formula uses the support radius where
        /// Monaghan 1992 uses the smoothing length, half of it. Therefore the same alpha gives twice his viscosity.
        pub alpha: f32,
        /// Quadratic coefficient of the same two, 0 or more (default 0).
        pub beta: f32,
        /// Coefficient of [`Viscosity::VelocityExchange`] (Gourlay), 0 to 1 (default 0): the share of the difference
        /// between two velocities that the two particles exchange in a step at distance 0. If the shares of all
        /// neighbours of a particle add up to more than 1, they are scaled down to a sum of 1.
        pub velocity_exchange: f32,
        /// The same coefficient for the part of the velocity with which two particles approach each other (Gourlay's
        /// shock viscosity), 0 to 1 (default 0). It acts in addition to any [`Formulation::viscosity`].
        pub radial_exchange: f32,
        /// Coefficient of XSPH, 0 to 1 (Monaghan 1989; Pirovano, eq. 2.16, corrected; default 0, off): how much the
        /// velocity with which a particle is moved is shifted towards the velocities of its neighbours. It makes the
        /// motion smoother.
        pub xsph: f32,
        /// Shifting of particles to an even distribution (default off).
        pub shifting: Shifting,
        /// Coefficient of the shifting, 0 to 1 (default 1). With [`Shifting::Fickian`] it scales the velocity of the
        /// shifting; with [`Shifting::TransportVelocity`] the background pressure is this times `rho0 c0^2`.
        pub shifting_coefficient: f32,
        /// Speed U of [`Shifting::Fickian`], m/s, larger than 0: about the fastest speed of the flow, as Sun et al.
        /// 2017 choose it (default `None`: about the largest speed with which the neighbours of a particle approach or
        /// leave it. It needs no knowledge of the flow, and vanishes where a fluid does not deform; but it shifts too
        /// little for a lattice on which a flow converges for long).
        pub shifting_speed: Option<f32>,
        /// Shifts particles across the interfaces of fluids, as if all particles were of one fluid (default off: at an
        /// interface particles move along it only). It smears interfaces. Only with [`Shifting::Fickian`].
        pub shift_across_interfaces: bool,
        /// Tensile control: inside the fluid particles with a negative pressure do not attract their neighbours; a pair
        /// exchanges the difference of its pressures instead (Sun et al. 2018; default off). It keeps stretched fluid
        /// from tearing. Such forces are not equal and opposite, so momentum is conserved only as well as the particles
        /// are evenly distributed; shifting sees to that.
        pub tensile_control: bool,
        /// Model of the surface tension (default off). Its coefficient is
        /// [`Fluid::surface_tension`](super::Fluid::surface_tension).
        pub surface_tension: SurfaceTension,
        /// Length of the normal, times the support radius, above which a particle counts as being at the surface
        /// (Pirovano, section 3.4.4; default 0.1; larger than 0). With [`SurfaceTension::Curvature`] and
        /// [`SurfaceTension::NormalCurvature`] tension acts only on these particles.
        pub surface_threshold: f32,
        /// Computes normals and surface flags for your program even if no surface tension needs them (default off).
        pub surface_normals: bool,
        /// Integrates the internal energy of the particles: the work of compression and the dissipation of viscosity
        /// (Roy; Gourlay; default off). It does not act back on the motion.
        #[cfg_attr(feature = "serde", serde(alias = "thermal_energy"))]
        pub internal_energy: bool,
        /// Share of the dissipated energy that becomes internal energy (Gourlay's gain), 0 to 1 (default 1). It is used
        /// if [`internal_energy`](Formulation::internal_energy) is on.
        pub heat_gain: f32,
        /// Bounds of a variable support radius, which follows the density so that the number of neighbours stays
        /// constant (Pirovano, eq. 4.2, corrected; default `None`, the scene's support radius for all particles).
        pub variable_support: Option<SupportRange>,
        /// The pressure that fluid particles see at wall particles (default that of the fluid around these,
        /// extrapolated).
        pub wall_pressure: WallPressure,
        /// Strength with which wall particles repel the fluid, over the square of the speed of sound, 0 or more (default
        /// 0.02). It needs to be about that of the square of the fastest flow, and results hardly depend on it (Monaghan
        /// 1994). Only with [`WallPressure::LennardJones`] and [`WallPressure::KernelForce`].
        pub wall_rigidity: f32,
    }
}

/// Reads the value of a field that a scene file gives.
#[cfg(feature = "serde")]
fn given<'d, T: serde::Deserialize<'d>, D: serde::Deserializer<'d>>(value: D) -> Result<Option<T>, D::Error> {
    T::deserialize(value).map(Some)
}

/// Settings of the pressure correction (Pirovano, section 3.2.2, corrected), used with
/// [`PressureSolver::PressureCorrection`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(deny_unknown_fields, default))]
pub struct Correction {
    /// Rule of the iteration (default [`Iteration::Relaxed`]).
    pub iteration: Iteration,
    /// Largest number of iterations in a step, 1 to [`Correction::MOST`] (default 20).
    pub iterations: u32,
    /// Largest deviation from the target density, as a share of the rest density, at which the iteration ends (default
    /// 0.001; larger than 0). Smaller values are more accurate and need more iterations.
    pub tolerance: f32,
}

impl Correction {
    /// Upper bound of [`Correction::iterations`]. It is finite because a GPU gets all iterations of a step in advance.
    pub const MOST: u32 = 200;
}

impl Default for Correction {
    fn default() -> Self {
        Correction { iteration: Iteration::Relaxed, iterations: 20, tolerance: 0.001 }
    }
}

/// Bounds of a particle's support radius, as multiples of the scene's support radius.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(deny_unknown_fields))]
pub struct SupportRange {
    /// Lower bound, 0.5 to 1.
    pub smallest: f32,
    /// Upper bound, 1 to 2. The cells of the neighbour search grow with it, so a large bound costs time.
    pub largest: f32,
}
