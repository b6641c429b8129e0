//! Every choice between formulas or structures that a scene can make. The numbers of those that a term compares are the
//! term's own, and so are their names.
use crate::terms::{correction, density, integrate, kernel, near, pressure, state, table, tension, viscosity, wall};

/// A choice between terms: its variants with the term's number and the names of what it computes.
macro_rules! choice {
    ($(#[$doc:meta])* pub enum $name:ident {
        $($(#[$variant_doc:meta])* $variant:ident = $number:expr => $terms:expr,)*
    }) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
        #[repr(u32)]
        pub enum $name { $($(#[$variant_doc])* $variant = $number,)* }

        impl $name {
            /// All of them.
            pub const ALL: &[$name] = &[$($name::$variant),*];

            /// Names of its terms.
            #[must_use]
            pub fn terms(self) -> &'static [&'static str] {
                match self { $($name::$variant => $terms,)* }
            }

            /// Its name in a scene.
            #[must_use]
            pub fn name(self) -> &'static str {
                match self { $($name::$variant => stringify!($variant),)* }
            }
        }
    };
}

choice! {
    /// A smoothing kernel. All vanish at the support radius; `terms` names its value and its slope.
    pub enum Kernel {
        /// Mueller et al. 2003, eq. 20 (Pirovano eq. 2.44); its gradient vanishes for close pairs: a poor pressure kernel.
        Poly6 = kernel::POLY6 => &["poly6_w", "poly6_slope"],
        /// Mueller et al. 2003, eq. 21 (Pirovano eq. 2.45); also the near density's kernel of Gourlay.
        Spiky = kernel::SPIKY => &["spiky_w", "spiky_slope"],
        /// Monaghan and Lattanzio 1985 (Pirovano eq. 2.43, Hinsch 2024, section 4.1), with the support radius as its 2 h.
        CubicSpline = kernel::CUBIC_SPLINE => &["cubic_spline_w", "cubic_spline_slope"],
        /// The Gaussian (Pirovano eq. 2.42; Gourlay table 1), cut off where it has fallen to e^-9.
        Gaussian = kernel::GAUSSIAN => &["gaussian_w", "gaussian_slope"],
        /// Lucy 1977 (Gourlay table 1).
        Lucy = kernel::LUCY => &["lucy_w", "lucy_slope"],
        /// Mueller et al. 2003, eq. 22 (Pirovano eq. 2.46). Infinite at no distance: not for densities.
        Viscosity = kernel::VISCOSITY => &["viscosity_w", "viscosity_slope"],
        /// Clavet et al. 2005: `(1 - q)^2`, the density kernel of Gourlay's near pair.
        Clavet = kernel::CLAVET => &["clavet_w", "clavet_slope"],
        /// Wendland 1995, C2: particles do not pair (Dehnen and Aly 2012).
        WendlandC2 = kernel::WENDLAND_C2 => &["wendland_c2_w", "wendland_c2_slope"],
        /// Wendland 1995, C4: smoother, for more neighbours.
        WendlandC4 = kernel::WENDLAND_C4 => &["wendland_c4_w", "wendland_c4_slope"],
    }
}

choice! {
    /// Where density comes from.
    pub enum DensityForm {
        /// `rho_a = sum m_b W_ab` (Pirovano eq. 2.10).
        Summation = density::SUMMATION => &["density_neighbour"],
        /// `d rho_a / dt = sum m_b (v_a - v_b) . grad W_ab`, stepped (Pirovano eq. 2.12; Roy): no deficiency at a free surface.
        Continuity = density::CONTINUITY => &["continuity_neighbour"],
        /// `n_a = sum W_ab`, particles per volume (Gourlay; Pirovano eq. 3.1).
        NumberDensity = density::NUMBER_DENSITY => &["number_density_neighbour"],
        /// `rho_a = m_a sum W_ab` (Solenthaler and Pajarola 2008; Pirovano eq. 3.5): as if all neighbours were of the particle's own
        /// fluid, so that no density is smeared across an interface.
        SummationAdapted = density::SUMMATION_ADAPTED => &["number_density_neighbour"],
        /// `d rho_a / dt = m_a sum (v_a - v_b) . grad W_ab` (Pirovano, section 4.1.2, corrected): the same, stepped.
        ContinuityAdapted = density::CONTINUITY_ADAPTED => &["continuity_neighbour"],
    }
}

choice! {
    /// How pressure follows from density.
    pub enum EquationOfState {
        /// Monaghan 1994, exponent 7 (Pirovano eq. 2.15; Hinsch 2024, section 4.4; Roy with the corrected constant).
        Tait = state::TAIT => &["pressure_tait"],
        /// Desbrun and Cani 1996, linear (Pirovano eq. 2.14; Gourlay's pseudo-pressure).
        #[cfg_attr(feature = "serde", serde(alias = "Desbrun"))]
        Linear = state::LINEAR => &["pressure_linear"],
        /// A gas at one temperature, `P = c0^2 rho` (Pirovano eq. 2.13).
        IdealGas = state::IDEAL_GAS => &["pressure_ideal_gas"],
    }
}

choice! {
    /// Where the pressure of a step comes from.
    #[derive(Default)]
    pub enum PressureSolver {
        /// From the density, by an [`EquationOfState`].
        #[default]
        EquationOfState = correction::EQUATION_OF_STATE => &[],
        /// From an iteration that ends when the predicted density fits ([`Correction`](super::Correction); Pirovano 3.2.2). No equation of
        /// state is used; where one is asked for, it is the linear one that the speed of sound makes.
        PressureCorrection = correction::PRESSURE_CORRECTION => &["pressure_correction"],
    }
}

choice! {
    /// How pressure becomes force: the forms of the gradient (Pirovano eqs. 2.4, 2.6, 2.7; Gourlay table 2).
    pub enum PressureForce {
        /// Mueller et al. 2003 (Pirovano eq. 2.19): cheap, and half of the gradient.
        Mueller = pressure::MUELLER => &["pressure_mueller"],
        /// Monaghan 1992 (Pirovano eq. 2.18), the symmetric gradient: with one kernel for density and gradient it conserves
        /// energy.
        Monaghan = pressure::MONAGHAN => &["pressure_monaghan"],
        /// The canonical gradient (Pirovano eq. 2.17): the plainest, and it keeps no momentum.
        Canonical = pressure::CANONICAL => &["pressure_canonical"],
        /// The difference gradient (Pirovano eq. 2.6): zero for an even pressure, and it keeps no momentum.
        Difference = pressure::DIFFERENCE => &["pressure_difference"],
        /// The symmetric gradient on the number density (Gourlay table 2): needs [`DensityForm::NumberDensity`].
        NumberDensity = pressure::NUMBER_DENSITY_FORCE => &["pressure_number_density"],
        /// Mueller's on the number density `delta` (Solenthaler and Pajarola 2008; Pirovano eq. 3.6, corrected): with it, a
        /// particle's volume is `1 / delta` in every term.
        MuellerAdapted = pressure::MUELLER_ADAPTED => &["pressure_mueller"],
        /// Monaghan's on the number density (Pirovano, section 4.1.2, corrected), likewise.
        MonaghanAdapted = pressure::MONAGHAN_ADAPTED => &["pressure_number_density"],
        /// Weighted by the densities of a pair, on the number density (Hu and Adams 2007): where two fluids meet, the one that
        /// holds the lighter one at rest too.
        DensityWeighted = pressure::DENSITY_WEIGHTED => &["pressure_density_weighted"],
    }
}

impl PressureForce {
    /// Is a particle's volume one over the number density?
    #[must_use]
    pub fn is_adapted(self) -> bool {
        matches!(self, PressureForce::MuellerAdapted | PressureForce::MonaghanAdapted | PressureForce::DensityWeighted)
    }
}

choice! {
    /// What keeps particles from pairing.
    pub enum NearPressure {
        /// Nothing.
        Off = near::NEAR_OFF => &[],
        /// `P_near = k_near rho` with a narrower slope (Pirovano, section 3.1, corrected).
        #[cfg_attr(feature = "serde", serde(alias = "Thesis"))]
        DensityProportional = near::DENSITY_PROPORTIONAL => &["near_pressure_proportional", "near_slope_proportional"],
        /// `P_near = k_near rho_near` on a density of its own (Gourlay after Clavet et al. 2005).
        #[cfg_attr(feature = "serde", serde(alias = "Article"))]
        DoubleDensity = near::DOUBLE_DENSITY => &["near_density_neighbour", "near_slope_double_density"],
    }
}

choice! {
    /// How velocities diffuse.
    pub enum Viscosity {
        /// Mueller et al. 2003 (Pirovano eq. 2.24), by the Laplacian of the viscosity kernel.
        Mueller = viscosity::MUELLER_VISCOSITY => &["viscosity_mueller"],
        /// Morris et al. 1997 (Pirovano eq. 2.23, corrected), by its slope.
        Morris = viscosity::MORRIS => &["viscosity_morris"],
        /// Monaghan 1992's artificial viscosity (Pirovano eqs. 2.20 to 2.22, corrected): `fluid.alpha`, `fluid.beta`.
        Artificial = viscosity::ARTIFICIAL => &["viscosity_artificial"],
        /// Hinsch's form (eq. 4.5, corrected), which keeps angular momentum.
        #[cfg_attr(feature = "serde", serde(alias = "Dotted"))]
        MonaghanGingold = viscosity::MONAGHAN_GINGOLD => &["viscosity_monaghan_gingold"],
        /// Gourlay's exchange of velocity: `fluid.velocity_exchange`, a share a step.
        #[cfg_attr(feature = "serde", serde(alias = "Exchange"))]
        VelocityExchange = viscosity::VELOCITY_EXCHANGE => &["exchange_neighbour"],
        /// Mueller's on the number density (Solenthaler and Pajarola 2008; Pirovano eq. 3.7, corrected): needs a density or a
        /// pressure force that is adapted too.
        MuellerAdapted = viscosity::MUELLER_ADAPTED_VISCOSITY => &["viscosity_mueller"],
    }
}

choice! {
    /// How the surface of a fluid pulls itself together: [`Fluid::surface_tension`](super::Fluid::surface_tension).
    pub enum SurfaceTension {
        /// Not at all.
        Off = tension::NO_TENSION => &[],
        /// By the curvature of its colour, `-laplacian C / |n|` (Morris 1999, Mueller et al. 2003; Pirovano eqs. 3.8 to 3.11): its
        /// tension is a tension, in N/m, where there is another fluid beyond the surface. In nothing half of the colour's
        /// profile is missing.
        Curvature = tension::CURVATURE => &["colour_gradient", "colour_laplacian", "curvature_of_colour", "tension_close"],
        /// By the divergence of its unit normals (Morris 2000): the same, and the better curvature where there is nothing
        /// beyond the surface.
        NormalCurvature = tension::NORMAL_CURVATURE =>
            &["colour_gradient", "normal_divergence", "curvature_of_normals", "tension_close"],
        /// By attraction between its particles (Becker and Teschner 2007; Pirovano eq. 3.12, corrected): a coefficient whose
        /// tension is to be measured.
        Attraction = tension::ATTRACTION => &["attraction"],
        /// By the sum of kernel gradients (Hinsch 2024, section 6.4): likewise.
        GradientSum = tension::GRADIENT_SUM => &["gradient_sum"],
    }
}

choice! {
    /// What a particle of a wall does to the pressure of its neighbours.
    pub enum WallPressure {
        /// It answers with their own pressure (Hinsch 2024 algorithm 1); two layers. What a wall gives back then is no pair's work: it
        /// feeds what moves along it, and fluids of little viscosity boil at such walls after a second or two.
        Mirrored = wall::MIRRORED => &["wall_mirrored"],
        /// It has density and pressure like the fluid (Pirovano, section 3.5.3); three layers.
        #[cfg_attr(feature = "serde", serde(alias = "QuasiFluid"))]
        Dynamic = wall::DYNAMIC => &["wall_dynamic"],
    }
}

choice! {
    /// How particles are moved from step to step (Pirovano, section 2.3.1 with the errata). Stable up to a product of the largest
    /// frequency and the time step which is given without damping, and critically damped.
    #[derive(Default)]
    pub enum Integrator {
        /// Half kick, drift, half kick (eq. 2.33): stable to 2, and 0.828.
        #[default]
        ModifiedVelocityVerlet = integrate::MODIFIED_VELOCITY_VERLET => &["modified_verlet_kick", "modified_verlet_kick"],
        /// Forward Euler (eq. 2.29): never stable, and to 2.
        Euler = integrate::EULER => &["euler_position", "euler_velocity"],
        /// Semi-implicit Euler (eq. 2.30): to 2, and 0.828.
        SemiImplicitEuler = integrate::SEMI_IMPLICIT_EULER => &["semi_implicit_position", "euler_velocity"],
        /// Verlet, by the last displacement (eq. 2.31): to 2, and 0.732.
        Verlet = integrate::VERLET => &["verlet_position", "verlet_velocity"],
        /// Velocity Verlet (eq. 2.32): to 2, and 0.732. Verlet's motion, with other roundings.
        VelocityVerlet = integrate::VELOCITY_VERLET => &["velocity_verlet_position", "velocity_verlet_velocity"],
        /// Leapfrog (eq. 2.34; Roy): to 2, and 0.732. Again the same motion.
        Leapfrog = integrate::LEAPFROG => &["leapfrog_position", "leapfrog_velocity"],
        /// Clavet's prediction and relaxation (eq. 2.35): to 1.155, and 0.667.
        Clavet = integrate::PREDICTION_RELAXATION => &["clavet_prediction", "clavet_relaxation", "clavet_velocity"],
        /// Beeman (eq. 2.36): to 2, and 0.534.
        Beeman = integrate::BEEMAN => &["beeman_position", "beeman_velocity"],
        /// With a predicted velocity (eq. 2.37): to 2, and 0.294.
        VelocityCorrectedBeeman = integrate::VELOCITY_CORRECTED_BEEMAN =>
            &["beeman_position", "beeman_prediction", "velocity_corrected"],
        /// With both predicted and corrected (eq. 2.38): not from 0 on, and to 0.26.
        PositionCorrectedBeeman = integrate::POSITION_CORRECTED_BEEMAN =>
            &["beeman_position", "beeman_prediction", "position_corrected", "position_corrected_velocity"],
    }
}

/// How kernels are evaluated (Pirovano, section 4.2.3).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[repr(u32)]
pub enum Evaluation {
    /// By their formulas.
    #[default]
    Direct = table::DIRECT,
    /// From tables over the distance, between entries along straight lines.
    Table = table::TABLE,
    /// From tables over the squared distance, which spares the root.
    SquaredTable = table::SQUARED_TABLE,
}

/// How a pressure correction is iterated.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[repr(u32)]
pub enum Iteration {
    /// Towards the density that the speed of sound allows, with a relaxation taken from the lattice; the pressure is kept
    /// from step to step.
    #[default]
    Relaxed = correction::RELAXED,
    /// As printed (Pirovano eqs. 3.3 and 3.4, corrected): from no pressure, by the full stiffness. Refused where it cannot
    /// converge.
    Literal = correction::LITERAL,
}

/// Dimension of space.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Dimension {
    /// The plane z = 0.
    Two,
    /// Space.
    Three,
}

impl Dimension {
    /// 2 or 3.
    #[must_use]
    pub fn count(self) -> usize {
        match self {
            Dimension::Two => 2,
            Dimension::Three => 3,
        }
    }
}

/// How much of a bounce a wall gives back.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Reflection {
    /// All that `restitution` says, however late the wall was found.
    Full = 0,
    /// Only the share of the path that lay behind the wall (Pirovano figure 3.8).
    #[default]
    EnergyConserving = 1,
}

/// Faces of a box.
pub const FACES: usize = 6;

/// A face of a box, named as seen from inside.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Face {
    /// Lowest x.
    Left,
    /// Highest x.
    Right,
    /// Lowest y.
    Floor,
    /// Highest y.
    Ceiling,
    /// Lowest z.
    Back,
    /// Highest z.
    Front,
}

impl Face {
    /// All of them, low and high along x, y, z.
    pub const ALL: [Face; FACES] = [Face::Left, Face::Right, Face::Floor, Face::Ceiling, Face::Back, Face::Front];

    /// 0, 1, 2 for x, y, z.
    #[must_use]
    pub fn axis(self) -> usize {
        self as usize / 2
    }

    /// Is it the high one of its axis?
    #[must_use]
    pub fn is_high(self) -> bool {
        self as usize % 2 == 1
    }
}

/// How a particle's neighbours are walked.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[repr(u32)]
pub enum Traversal {
    /// All cells around a particle's own: each pair is computed twice, once for each of its particles. It runs on both backends, and
    /// is the faster one in lanes.
    #[default]
    FullStencil = 0,
    /// The half of those cells that lies ahead: each pair is computed once, and both of its particles get their share (Gourlay, Gourlay).
    /// It works plane by plane, the even planes first. Its order of summation is its own and depends on the number of cells, and so
    /// do its bits; they are the same at every level, on any number of threads and with either structure. It runs on the CPU alone,
    /// and a scene is refused where a pair does not act alike on both particles, or where another pass needs all neighbours.
    HalfStencil = 1,
}

/// How particles get into cells. Both give the same bits: inside a cell the order is always that of the ids.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum GridStructure {
    /// Count, prefix sum, place (Hinsch 2024, section 6.2): a cell holds any number.
    IndexSort,
    /// A fixed number of places a cell (the CUDA design, Pirovano, section 4.4.2): one pass less, and a cell can be full.
    CellLists {
        /// Places of a cell.
        places: u32,
    },
}
