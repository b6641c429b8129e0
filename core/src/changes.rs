//! Changes between steps: the acceleration field, and all other values of a scene that may change while it runs.
use crate::arithmetic::real::{div, vec3};
use crate::error::SceneError;
use crate::layout::{StepUniform, f32x4};
use crate::live::Change;
use crate::scene::Wind;
use crate::solver::Solver;
use crate::terms::integrate::history_rescaled;
use glam::Vec3;

impl Solver<'_> {
    /// Sets the acceleration field supplied by the caller, from the next step on. `points` has one acceleration, m/s2,
    /// per node of [`Scene::acceleration_field`](crate::scene::Scene::acceleration_field), x fastest; the fourth
    /// numbers are unused.
    ///
    /// Set a field that changes with time before each step, with its values at the end of that step. A field that is
    /// set before the first step also acts in the first half of that step.
    ///
    /// # Errors
    /// [`SceneError::WrongLength`] if the scene has fewer or more nodes, and [`SceneError::NotFinite`] for a value that
    /// is not finite; before the first step also [`SceneError::FirstStep`] if an acceleration is then not finite. The
    /// field stays as it was.
    pub fn set_acceleration_field(&mut self, points: &[f32x4]) -> Result<(), SceneError> {
        let (given, expected) = (points.len(), self.memory.given.acceleration_field.len());
        if given != expected {
            return Err(SceneError::WrongLength { call: "set_acceleration_field", what: "points", given, expected });
        }
        if let Some(&value) = points.as_flattened().iter().find(|x| !x.is_finite()) {
            return Err(SceneError::NotFinite { field: "acceleration_field".into(), value });
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

    /// Sets the acceleration of gravity, m/s2, from the next step on. Like every change between steps it is checked as
    /// at creation.
    ///
    /// Before the first step the particles stay as the scene's start created them: the masses of a hydrostatic start
    /// are still those for the values at creation, while variable support radii are computed again from the densities
    /// at the start.
    ///
    /// # Errors
    /// A [`SceneError`] if the scene is not valid with this value, and [`SceneError::LeftOut`] if the plan left out the
    /// term and [`Scene::adjustable`](crate::scene::Scene::adjustable) does not list it. Before the first step also
    /// [`SceneError::FirstStep`] if an acceleration is then not finite. The fluid stays as it was.
    pub fn set_gravity(&mut self, gravity: impl Into<Vec3>) -> Result<(), SceneError> {
        self.change(Change::Gravity(gravity.into()))
    }

    /// Sets the wind from the next step on; `None` for no wind.
    ///
    /// # Errors
    /// Those of [`Solver::set_gravity`].
    pub fn set_wind(&mut self, wind: Option<Wind>) -> Result<(), SceneError> {
        self.change(Change::Wind(wind))
    }

    /// Sets the time step, s, from the next step on. The history of the Verlet integrator, its last displacement, is
    /// scaled to the new length.
    ///
    /// # Errors
    /// Those of [`Solver::set_gravity`]; also [`SceneError::NotTogether`] if the time step is adaptive or
    /// [`Recovery`](crate::scene::Recovery) may shorten it, and with all variants of Beeman's integrator.
    pub fn set_time_step(&mut self, time_step: f32) -> Result<(), SceneError> {
        self.change(Change::TimeStep(time_step))
    }

    /// Sets the dynamic viscosity, Pa s, of the fluid with index `fluid` from the next step on. Blocks and walls with a
    /// viscosity of their own keep it.
    ///
    /// # Errors
    /// Those of [`Solver::set_gravity`]; also [`SceneError::NoSuchFluid`] if the scene has no such fluid, and
    /// [`SceneError::NotTogether`] if the form of the viscosity does not use the dynamic viscosity.
    pub fn set_viscosity(&mut self, fluid: u32, viscosity: f32) -> Result<(), SceneError> {
        self.change(Change::Viscosity(fluid, viscosity))
    }

    /// Sets the coefficient of surface tension ([`Fluid::surface_tension`](crate::scene::Fluid::surface_tension)) of
    /// the fluid with index `fluid` from the next step on.
    ///
    /// # Errors
    /// Those of [`Solver::set_gravity`]; also [`SceneError::NoSuchFluid`] if the scene has no such fluid.
    pub fn set_surface_tension(&mut self, fluid: u32, tension: f32) -> Result<(), SceneError> {
        self.change(Change::SurfaceTension(fluid, tension))
    }

    /// Sets the speed of sound, m/s, of the fluid with index `fluid` from the next step on. A near stiffness that the
    /// scene does not set is derived from the new value.
    ///
    /// # Errors
    /// Those of [`Solver::set_surface_tension`]; also [`SceneError::NotTogether`] if the speed of sound is derived from
    /// a stiffness or from the time step.
    pub fn set_speed_of_sound(&mut self, fluid: u32, speed: f32) -> Result<(), SceneError> {
        self.change(Change::SpeedOfSound(fluid, speed))
    }

    /// Sets the constant B of Tait's equation ([`Fluid::stiffness`](crate::scene::Fluid::stiffness)), Pa, of the fluid
    /// with index `fluid` from the next step on.
    ///
    /// # Errors
    /// Those of [`Solver::set_surface_tension`].
    pub fn set_stiffness(&mut self, fluid: u32, stiffness: f32) -> Result<(), SceneError> {
        self.change(Change::Stiffness(fluid, stiffness))
    }

    /// Makes a change between two steps. If it is rejected, the solver stays as it was.
    fn change(&mut self, change: Change) -> Result<(), SceneError> {
        let (live, mut next) = self.live.changed(change)?;
        // the length and the number of the next step are kept, because the clock sets them; only a new time step
        // replaces the length
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
