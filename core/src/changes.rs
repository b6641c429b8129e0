//! What a host changes between steps: its field, and whatever else of a scene may change while it runs.
use crate::arithmetic::real::{div, vec3};
use crate::error::SceneError;
use crate::layout::{StepUniform, f32x4};
use crate::live::Change;
use crate::scene::Wind;
use crate::solver::Solver;
use crate::terms::integrate::history_rescaled;
use glam::Vec3;

impl Solver<'_> {
    /// The host's field from now on, one acceleration a node of [`Scene::acceleration_field`](crate::scene::Scene::acceleration_field), x fastest, m/s2; the fourth numbers are
    /// unused. A field that changes with time is set again before each step, as it will be at the end of the step; set before
    /// the first step, it also acts in that step's first half.
    ///
    /// # Errors
    /// Fewer or more nodes than the scene says, or a value that is not finite; before the first step also one that makes
    /// accelerations that are no numbers. The field then stays as it was.
    pub fn set_field(&mut self, points: &[f32x4]) -> Result<(), SceneError> {
        let (given, expected) = (points.len(), self.memory.given.acceleration_field.len());
        if given != expected {
            return Err(SceneError::WrongLength { call: "set_field", what: "points", given, expected });
        }
        if let Some(&value) = points.as_flattened().iter().find(|x| !x.is_finite()) {
            return Err(SceneError::NotFinite { field: "field", value });
        }
        let begins = self.steps == 0 && expected > 0;
        if begins {
            // the first step begins with the accelerations at the start
            self.evaluate(Some(points))?;
        }
        self.memory.given.acceleration_field.copy_from_slice(points);
        if begins {
            self.remember();
        }
        Ok(())
    }

    /// Another acceleration of gravity from now on, m/s2; like every change between steps checked as at creation.
    ///
    /// A change before the first step finds the particles as the scene's start made them: masses of a hydrostatic start stay those for
    /// the values at creation, and supports that vary are found once more from the densities at the start.
    ///
    /// # Errors
    /// A value that no scene can have. A term that the plan left out, where the scene does not list it in
    /// [`Scene::adjustable`](crate::scene::Scene::adjustable). Before the first step also one that makes accelerations that are not finite. The fluid then is as it was.
    pub fn set_gravity(&mut self, gravity: impl Into<Vec3>) -> Result<(), SceneError> {
        self.change(Change::Gravity(gravity.into()))
    }

    /// Another wind from now on, or none.
    ///
    /// # Errors
    /// As for [`Solver::set_gravity`].
    pub fn set_wind(&mut self, wind: Option<Wind>) -> Result<(), SceneError> {
        self.change(Change::Wind(wind))
    }

    /// Another time step from now on, s. What an integrator remembers of the last step follows.
    ///
    /// # Errors
    /// As for [`Solver::set_gravity`]; also where the time step follows from the state, and with the integrators of Beeman.
    pub fn set_time_step(&mut self, time_step: f32) -> Result<(), SceneError> {
        self.change(Change::TimeStep(time_step))
    }

    /// Another dynamic viscosity of a fluid by number from now on, Pa s; blocks and walls with one of their own keep it.
    ///
    /// # Errors
    /// As for [`Solver::set_gravity`]; also a number that no fluid has.
    pub fn set_viscosity(&mut self, fluid: u32, viscosity: f32) -> Result<(), SceneError> {
        self.change(Change::Viscosity(fluid, viscosity))
    }

    /// Another surface tension of a fluid by number from now on ([`Fluid::surface_tension`](crate::scene::Fluid::surface_tension)).
    ///
    /// # Errors
    /// As for [`Solver::set_viscosity`].
    pub fn set_surface_tension(&mut self, fluid: u32, tension: f32) -> Result<(), SceneError> {
        self.change(Change::SurfaceTension(fluid, tension))
    }

    /// Another speed of sound of a fluid by number from now on, m/s. A near stiffness that the scene does not name follows.
    ///
    /// # Errors
    /// As for [`Solver::set_viscosity`]; also where it follows from a stiffness, or from the time step.
    pub fn set_speed_of_sound(&mut self, fluid: u32, speed: f32) -> Result<(), SceneError> {
        self.change(Change::SpeedOfSound(fluid, speed))
    }

    /// Another constant of Tait's equation of a fluid by number from now on, Pa
    /// ([`Fluid::stiffness`](crate::scene::Fluid::stiffness)).
    ///
    /// # Errors
    /// As for [`Solver::set_viscosity`].
    pub fn set_stiffness(&mut self, fluid: u32, stiffness: f32) -> Result<(), SceneError> {
        self.change(Change::Stiffness(fluid, stiffness))
    }

    /// Makes a change between two steps.
    fn change(&mut self, change: Change) -> Result<(), SceneError> {
        let (live, mut next) = self.live.changed(change)?;
        // the step's length and number are the clock's, unless it is they that change
        let was = self.constants.step.time_step;
        let before = (core::mem::replace(&mut self.live, live), self.constants);
        if !matches!(change, Change::TimeStep(_)) {
            let StepUniform { gravity, wind, .. } = next.step;
            next.step = StepUniform { gravity, wind, ..self.constants.step };
        }
        next.step.step = self.constants.step.step;
        self.constants = next;
        if self.steps == 0 {
            // the first step begins with the accelerations at the start
            if let Err(error) = self.evaluate(None) {
                (self.live, self.constants) = before;
                return Err(error.into());
            }
            self.remember();
        } else if matches!(change, Change::TimeStep(_)) {
            self.steady = self.steady.changed(self.steps, was);
            let times = div(self.constants.step.time_step, was);
            let model = self.plan.model;
            for history in self.memory.states[self.current].history.iter_mut() {
                let vec3 { x, y, z } = history_rescaled::<f32>(&model, vec3::splat(*history), times);
                *history = [x, y, z, 0.0];
            }
        }
        Ok(())
    }
}
