//! Time stepping: the properties of the integrators, and the adaptive time step.
use super::choice::Integrator;

impl Integrator {
    /// Returns the order of its global error if forces do not depend on velocity. For forces that do, which includes
    /// those of a density integrated by the continuity equation, see [`Integrator::damped_order`].
    #[must_use]
    pub fn order(self) -> u32 {
        match self {
            Integrator::Euler | Integrator::SemiImplicitEuler | Integrator::Clavet => 1,
            Integrator::PositionCorrectedBeeman => 3,
            _ => 2,
        }
    }

    /// Returns the order of its global error if forces depend on velocity and are evaluated once per step.
    #[must_use]
    pub fn damped_order(self) -> u32 {
        match self {
            Integrator::VelocityCorrectedBeeman | Integrator::PositionCorrectedBeeman => 2,
            _ => 1,
        }
    }

    /// Returns the order of its global error if forces depend on velocity and are evaluated a second time at the end of
    /// each step ([`Formulation::reevaluate`](super::Formulation::reevaluate)).
    #[must_use]
    pub fn damped_order_twice(self) -> u32 {
        match self {
            Integrator::Verlet => 2,
            _ => self.damped_order(),
        }
    }

    /// Returns whether it conserves area in phase space, so that energy does not drift in an undamped motion.
    #[must_use]
    pub fn is_symplectic(self) -> bool {
        use Integrator::*;
        matches!(self, SemiImplicitEuler | Verlet | VelocityVerlet | ModifiedVelocityVerlet | Leapfrog)
    }

    /// Returns whether the length of steps may change. It may not if the integrator keeps a history of the last step,
    /// which assumes that the next step has the same length.
    #[must_use]
    pub fn allows_changing_steps(self) -> bool {
        use Integrator::*;
        matches!(self, Euler | SemiImplicitEuler | VelocityVerlet | ModifiedVelocityVerlet | Leapfrog | Clavet)
    }
}

/// An adaptive time step (Pirovano, section 2.3.5; Roy, section 3.3, step 5): the shortest that four criteria allow,
/// within bounds. H is the support radius. A criterion that is `None` is not used, but at least one must be set. No
/// criterion covers surface waves or springs: if they need a shorter step, set `largest` accordingly.
///
/// ```
/// use millpond_core::glam::Vec3;
/// use millpond_core::scene::{AdaptiveTimeStep, Block, Dimension, Fluid, Grid, Scene};
/// use millpond_core::{Serial, Solver, Storage};
///
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// let block = Block { size: Vec3::splat(0.5), ..Block::default() };
/// let mut scene = Scene::of(Dimension::Three, 0.05, 1e-4, Fluid::default(), block);
/// scene.gravity = Vec3::new(0.0, -9.81, 0.0);
/// scene.grid = Grid { cells: [8, 8, 8], ..Grid::default() };
/// scene.adaptive = Some(AdaptiveTimeStep { reject_ratio: Some(1.5), ..AdaptiveTimeStep::default() });
/// let mut storage: Box<Storage<1000, 512>> = Storage::boxed();
/// let mut solver = Solver::new(&scene, storage.lend())?;
/// while solver.time() < 0.02 {
///     solver.step(&Serial)?;
/// }
/// assert!(solver.time_report().time_step > 1e-4, "it may be longer, and so it became");
/// # Ok(())
/// # }
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(deny_unknown_fields, default))]
pub struct AdaptiveTimeStep {
    /// C of `C H / v`, v being the largest speed (Pirovano, eq. 2.41; default 0.15).
    pub speed: Option<f32>,
    /// C of `C sqrt(H / a)`, a being the largest acceleration (default 0.15).
    pub acceleration: Option<f32>,
    /// C of `C H / c`, c being the largest speed of sound (Roy; default 0.15). It is not used with pressure correction.
    pub sound: Option<f32>,
    /// C of `C H^2 / nu`, nu being the largest kinematic viscosity (default 0.03, which is about 0.125 if H is replaced
    /// by H / 2).
    pub viscosity: Option<f32>,
    /// Shortest time step, s (default 1e-7). Steps that should have been shorter are counted
    /// ([`TimeReport::clamped_steps`](crate::TimeReport::clamped_steps)).
    pub smallest: f32,
    /// Longest time step, s (default 0.01).
    pub largest: f32,
    /// Largest ratio of a time step to the one before, 1 or more (default 1.1).
    #[cfg_attr(feature = "serde", serde(alias = "growth"))]
    pub max_growth: f32,
    /// Ratio above which a step is rejected, 1 or more (Pirovano's option; default `None`, no step is rejected). The
    /// ratio is that of the time step to the longest one that the criteria allow at the end of the step. A rejected
    /// step is undone and repeated with the allowed length. If no step is rejected, only the next step is shorter.
    #[cfg_attr(feature = "serde", serde(alias = "redo_above"))]
    pub reject_ratio: Option<f32>,
}

impl AdaptiveTimeStep {
    /// Returns a time step without criteria, which always has the largest length.
    pub(crate) fn constant(time_step: f32) -> AdaptiveTimeStep {
        AdaptiveTimeStep {
            speed: None,
            acceleration: None,
            sound: None,
            viscosity: None,
            smallest: f32::MIN_POSITIVE,
            largest: time_step,
            max_growth: f32::MAX,
            reject_ratio: None,
        }
    }
}

impl Default for AdaptiveTimeStep {
    fn default() -> Self {
        AdaptiveTimeStep {
            speed: Some(0.15),
            acceleration: Some(0.15),
            sound: Some(0.15),
            viscosity: Some(0.03),
            smallest: 1e-7,
            largest: 0.01,
            max_growth: 1.1,
            reject_ratio: None,
        }
    }
}
