//! How time is stepped: what an integrator is good for, and how a time step follows from the state.
use super::check::{finite, positive};
use super::combinations::not_together;
use super::{EquationOfState, Integrator, ModelChoice, Scene, Viscosity};
use crate::error::SceneError;

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

    /// The same with forces evaluated again ([`ModelChoice::reevaluate`]).
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

impl ModelChoice {
    /// Evaluations of forces in a step: one with every integrator, and one more where that is asked for.
    #[must_use]
    pub fn evaluations(&self) -> u32 {
        1 + u32::from(self.reevaluate)
    }
}

/// A time step that follows from the state (S0 section 2.3.5; S3 section 3.3, step 5): the shortest that one of four criteria
/// asks for, H being the support radius. A criterion that is `None` does not count. Waves of a surface and springs have none of
/// their own: `largest` is to keep their step.
///
/// ```
/// use millpond_core::scene::{Adaptive, Block, Dimension, Fluid, Grid, Scene};
/// use millpond_core::{Serial, Solver, Storage};
///
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// let block = Block { size: [0.5; 3], ..Block::default() };
/// let mut scene = Scene::of(Dimension::Three, 0.05, 1e-4, Fluid::default(), block);
/// scene.gravity = [0.0, -9.81, 0.0];
/// scene.grid = Grid { cells: [8, 8, 8], ..Grid::default() };
/// scene.adaptive = Some(Adaptive { redo_above: Some(1.5), ..Adaptive::default() });
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
pub struct Adaptive {
    /// C of `C H / v`, v being the largest speed (S0 eq. 2.41; default 0.15).
    pub speed: Option<f32>,
    /// C of `C sqrt(H / a)`, a being the largest acceleration (default 0.15).
    pub acceleration: Option<f32>,
    /// C of `C H / c`, c being the largest speed of sound (S3; default 0.15). Has no say where pressure is corrected.
    pub sound: Option<f32>,
    /// C of `C H^2 / nu`, nu being the largest kinematic viscosity (default 0.03, about 0.125 on half of the support).
    pub viscosity: Option<f32>,
    /// Shortest step, s (default 1e-7). Steps that should have been shorter are counted.
    pub smallest: f32,
    /// Longest step, s (default 0.01).
    pub largest: f32,
    /// Times that a step may be as long as the last one, 1 or more (default 1.1).
    pub growth: f32,
    /// A step that lasted more than so many times what the state at its end asks for is undone, and made again as short as that
    /// (S0's option); 1 or more. Default: `None`, the next step is shorter.
    pub redo_above: Option<f32>,
}

impl Default for Adaptive {
    fn default() -> Self {
        Adaptive {
            speed: Some(0.15),
            acceleration: Some(0.15),
            sound: Some(0.15),
            viscosity: Some(0.03),
            smallest: 1e-7,
            largest: 0.01,
            growth: 1.1,
            redo_above: None,
        }
    }
}

impl Scene {
    pub(super) fn check_time(&self) -> Result<(), SceneError> {
        if let Some(courant) = self.stiffness_for_time_step {
            positive("stiffness_for_time_step", courant)?;
        }
        let Some(adaptive) = &self.adaptive else { return Ok(()) };
        let criteria = [
            ("adaptive.speed", adaptive.speed),
            ("adaptive.acceleration", adaptive.acceleration),
            ("adaptive.sound", adaptive.sound),
            ("adaptive.viscosity", adaptive.viscosity),
        ];
        for (field, courant) in criteria {
            courant.map_or(Ok(()), |courant| positive(field, courant))?;
        }
        positive("adaptive.smallest", adaptive.smallest)?;
        finite("adaptive.smallest", &[1.0 / adaptive.smallest])?;
        let bounds = [
            ("adaptive.largest", adaptive.largest, adaptive.smallest, f32::MAX),
            ("adaptive.growth", adaptive.growth, 1.0, f32::MAX),
            ("adaptive.redo_above", adaptive.redo_above.unwrap_or(1.0), 1.0, f32::MAX),
            ("time_step", self.time_step, adaptive.smallest, adaptive.largest),
        ];
        for (field, value, least, most) in bounds {
            if !(least..=most).contains(&value) {
                return Err(SceneError::OutOfBounds { field, value, least, most });
            }
        }
        Ok(())
    }

    /// The longest step that there can be, s.
    pub(super) fn longest_step(&self) -> f32 {
        self.adaptive.map_or(self.time_step, |adaptive| adaptive.largest)
    }

    pub(super) fn check_integrator(&self) -> Result<(), SceneError> {
        let model = &self.model;
        let changes = model.integrator.allows_changing_steps();
        let corrects = model.equation_of_state == EquationOfState::PressureCorrection;
        if let Some(Adaptive { speed, acceleration, sound, viscosity, .. }) = self.adaptive {
            if !changes {
                return Err(not_together(
                    "adaptive",
                    "a model.integrator Verlet or one of Beeman's",
                    "what it remembers of the step before is of a step of the same length",
                ));
            }
            if [speed, acceleration, sound, viscosity].iter().all(Option::is_none) {
                return Err(not_together("adaptive", "no criterion", "there is nothing for the time step to follow"));
            }
            if model.viscosity == Viscosity::Exchange || self.fluid.radial_exchange > 0.0 {
                return Err(not_together(
                    "adaptive",
                    "exchanges of velocity",
                    "their shares are of a step, so that with its length the viscosity would change",
                ));
            }
        }
        if self.air.is_some() && !changes {
            return Err(not_together(
                "air",
                "a model.integrator Verlet or one of Beeman's",
                "air that has just been made has no step before to remember",
            ));
        }
        let drifts = matches!(model.integrator, Integrator::ModifiedVelocityVerlet | Integrator::SemiImplicitEuler);
        if corrects && !drifts {
            return Err(not_together(
                "model.equation_of_state PressureCorrection",
                "a model.integrator other than ModifiedVelocityVerlet or SemiImplicitEuler",
                "pressure is iterated for the velocity that these drift with",
            ));
        }
        if model.reevaluate {
            if matches!(model.integrator, Integrator::Euler | Integrator::SemiImplicitEuler) {
                return Err(not_together(
                    "model.reevaluate",
                    "one of Euler's for model.integrator",
                    "forces are evaluated with the velocity at the end of the step already",
                ));
            }
            if matches!(model.integrator, Integrator::Clavet | Integrator::PositionCorrectedBeeman) {
                return Err(not_together(
                    "model.reevaluate",
                    "a model.integrator Clavet or PositionCorrectedBeeman",
                    "it moves particles after the forces, so that neighbours would have to be found again",
                ));
            }
            if corrects {
                return Err(not_together(
                    "model.reevaluate",
                    "model.equation_of_state PressureCorrection",
                    "the pressure was iterated for the forces without it",
                ));
            }
        }
        self.check_stiffness()
    }

    fn check_stiffness(&self) -> Result<(), SceneError> {
        if self.stiffness_for_time_step.is_none() {
            return Ok(());
        }
        if self.adaptive.is_some() {
            return Err(not_together(
                "stiffness_for_time_step",
                "adaptive",
                "either the stiffness follows from the time step or the time step from the stiffness",
            ));
        }
        if self.fluids().any(|fluid| fluid.stiffness.is_some()) {
            return Err(not_together("stiffness_for_time_step", "fluid.stiffness", "it already says how stiff"));
        }
        if self.model.equation_of_state == EquationOfState::PressureCorrection {
            return Err(not_together(
                "stiffness_for_time_step",
                "model.equation_of_state PressureCorrection",
                "sound that is iterated for does not limit the time step",
            ));
        }
        Ok(())
    }
}
