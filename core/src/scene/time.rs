//! How time is stepped: what an integrator is good for, and how a time step follows from the state.
use super::choice::Integrator;

impl Integrator {
    /// Order of its global error where forces do not depend on velocity; where they do, and a density that is stepped makes
    /// them, see [`Integrator::damped_order`].
    #[must_use]
    pub fn order(self) -> u32 {
        match self {
            Integrator::Euler | Integrator::SemiImplicitEuler | Integrator::Clavet => 1,
            Integrator::PositionCorrectedBeeman => 3,
            _ => 2,
        }
    }

    /// And where they do, with one evaluation a step.
    #[must_use]
    pub fn damped_order(self) -> u32 {
        match self {
            Integrator::VelocityCorrectedBeeman | Integrator::PositionCorrectedBeeman => 2,
            _ => 1,
        }
    }

    /// The same with forces evaluated again ([`Formulation::reevaluate`](super::Formulation::reevaluate)).
    #[must_use]
    pub fn damped_order_twice(self) -> u32 {
        match self {
            Integrator::Verlet => 2,
            _ => self.damped_order(),
        }
    }

    /// Does it keep areas in phase space, so that energy does not drift where there is no damping?
    #[must_use]
    pub fn is_symplectic(self) -> bool {
        use Integrator::*;
        matches!(self, SemiImplicitEuler | Verlet | VelocityVerlet | ModifiedVelocityVerlet | Leapfrog)
    }

    /// May one step be longer than the last? Not where what is remembered of the steps before is taken for one of the same
    /// length.
    #[must_use]
    pub fn allows_changing_steps(self) -> bool {
        use Integrator::*;
        matches!(self, Euler | SemiImplicitEuler | VelocityVerlet | ModifiedVelocityVerlet | Leapfrog | Clavet)
    }
}

/// A time step that follows from the state (Pirovano, section 2.3.5; Roy, section 3.3, step 5): the shortest that one of four criteria
/// asks for, H being the support radius. A criterion that is `None` does not count. Waves of a surface and springs have none of
/// their own: `largest` is to keep their step.
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
    /// C of `C H / v`, v being the largest speed (Pirovano eq. 2.41; default 0.15).
    pub speed: Option<f32>,
    /// C of `C sqrt(H / a)`, a being the largest acceleration (default 0.15).
    pub acceleration: Option<f32>,
    /// C of `C H / c`, c being the largest speed of sound (Roy; default 0.15). Has no say where pressure is corrected.
    pub sound: Option<f32>,
    /// C of `C H^2 / nu`, nu being the largest kinematic viscosity (default 0.03, about 0.125 on half of the support).
    pub viscosity: Option<f32>,
    /// Shortest step, s (default 1e-7). Steps that should have been shorter are counted.
    pub smallest: f32,
    /// Longest step, s (default 0.01).
    pub largest: f32,
    /// Times that a step may be as long as the last one, 1 or more (default 1.1).
    #[cfg_attr(feature = "serde", serde(alias = "growth"))]
    pub max_growth: f32,
    /// A step that lasted more than so many times what the state at its end asks for is undone, and made again as short as that
    /// (Pirovano's option); 1 or more. Default: `None`, the next step is shorter.
    #[cfg_attr(feature = "serde", serde(alias = "redo_above"))]
    pub reject_ratio: Option<f32>,
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
