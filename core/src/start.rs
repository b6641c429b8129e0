//! The start of a fluid: writes the particles into memory, evaluates the first accelerations, and sets the history of
//! the integrator.
use crate::arithmetic::real::vec3;
use crate::clock::{Clock, set_step};
use crate::derive::emission::state_at_start;
use crate::derive::material::FIRST_SOLID;
use crate::derive::solids::fill_poses;
use crate::derive::{Material, material_of};
use crate::error::{SceneError, StepError};
use crate::executor::Serial;
use crate::layout::{Model, f32x4};
use crate::plan::arrays::Quantity;
use crate::scene::{Dimension, InitialParticle};
use crate::solids::solids;
use crate::solver::Solver;
use crate::terms::integrate::{MODIFIED_VELOCITY_VERLET, has_history, history_reversed, is_beeman};
use crate::validate::Checked;

impl Solver<'_> {
    /// Evaluates the first accelerations, sorts the particles, and finds the first time step.
    pub(crate) fn evaluate(&mut self, field: Option<&[f32x4]>) -> Result<(), StepError> {
        let mut constants = self.constants;
        set_step(&mut constants.step, self.live().time_step());
        // with time at rest, a step only evaluates forces and sorts the particles
        let at_rest = constants.at_rest();
        let found = self.attempt_evaluation(&Serial, &self.plan.model.at_rest(), &at_rest, field)?;
        self.accept();
        self.clock = Clock::start(&self.plan.model, &constants.parameters, &mut constants.step, found.maxima);
        self.constants = constants;
        Ok(())
    }

    /// Sets the history that the integrator would have from a step before the first one.
    ///
    /// The displacement of Verlet is computed from velocity and acceleration. The Beeman integrators need the
    /// acceleration one step before the start. A trial step backwards in time finds it with an error of order dt^2 (dt
    /// if forces depend on velocity), so that no order of accuracy is lost. If the trial step fails, the history is
    /// `a_{-1} = a_0`, as Beeman starts, which loses one order if velocities are not 0.
    pub(crate) fn remember(&mut self) {
        let (m, u) = (self.plan.model, self.constants.step);
        if is_beeman(&m) {
            let back = Model { integrator: MODIFIED_VELOCITY_VERLET, ..m.at_rest() };
            let found = self.attempt_evaluation(&Serial, &back, &self.constants.backwards(), None).is_ok();
            let [a, b] = &mut self.memory.states;
            let (now, before) = if self.current == 0 { (a, b) } else { (b, a) };
            let without_w = |[x, y, z, _]: f32x4| [x, y, z, 0.0];
            for (history, acceleration) in now.history.iter_mut().zip(&*now.acceleration) {
                *history = without_w(*acceleration);
            }
            if found {
                for (slot, &id) in before.id.iter().enumerate() {
                    now.history[now.slot_of_id[id as usize] as usize] = without_w(before.acceleration[slot]);
                }
            }
        } else if has_history(&m) {
            let now = &mut self.memory.states[self.current];
            for (slot, history) in now.history.iter_mut().enumerate() {
                let (v, a) = (vec3::<f32>::splat(now.velocity[slot]), vec3::<f32>::splat(now.acceleration[slot]));
                let vec3 { x, y, z } = history_reversed(&m, &u, v, a, v);
                *history = [x, y, z, 0.0];
            }
        }
    }

    /// Writes the particles into the current state.
    pub(crate) fn fill(
        &mut self,
        scene: &Checked<'_>,
        particles: &mut dyn Iterator<Item = InitialParticle>,
    ) -> Result<(), SceneError> {
        let state = &mut self.memory.states[self.current];
        let needed = state.id.len();
        let wrong =
            |given| SceneError::WrongLength { call: "with_particles", what: "particles", given, expected: needed };
        if needed < scene.inactive_at_start() {
            return Err(SceneError::TooFewParticles { particles: needed, air: scene.inactive_at_start() });
        }
        for slot in 0..needed {
            let Some(place) = particles.next() else {
                return Err(wrong(slot));
            };
            let ([x, y, z], [u, v, w]) = (place.position.to_array(), place.velocity.to_array());
            if scene.dimension == Dimension::Two && (z != 0.0 || w != 0.0) {
                return Err(SceneError::OutOfPlane);
            }
            let quantities = [
                (&place.position.as_ref()[..], Quantity::Position),
                (place.velocity.as_ref(), Quantity::Velocity),
                (&[place.deviation, place.pressure], Quantity::Density),
            ];
            // if one of these is not finite, a step would report a particle out of range, or would not report it at all
            if let Some((_, quantity)) = quantities.into_iter().find(|(of, _)| !of.iter().all(|x| x.is_finite())) {
                return Err(SceneError::ParticleNotFinite { particle: slot as u32, quantity });
            }
            let (masses, properties) = (self.plan.model.has_variable_mass == 1, self.plan.model.has_materials == 1);
            let material = material_of(place.material, scene);
            let is_spare = scene.has_inactive() && slot >= self.constants.parameters.first_spare as usize;
            let fits = match material {
                Some(Material::Inactive) => is_spare,
                Some(_) => {
                    !is_spare || scene.has_turnover() || scene.air.is_some_and(|air| air.fluid == place.material)
                }
                None => false,
            };
            if !fits || (place.material > 0 && !properties) || (place.mass != 1.0 && !masses) {
                return Err(SceneError::UnplannedParticle { particle: slot as u32 });
            }
            if !(place.mass > 0.0 && place.mass.is_finite()) {
                return Err(SceneError::NotPositive { field: "mass of a particle".into(), value: place.mass });
            }
            state.position[slot] = [x, y, z, place.mass];
            state.velocity[slot] = [u, v, w, place.material as f32];
            state.acceleration[slot] = [0.0; 4];
            state.density_pressure[slot] = [place.deviation, place.pressure, 0.0, 0.0];
            if let Some(heat) = state.internal_energy.get_mut(slot) {
                let energy = match material {
                    Some(Material::Fluid(fluid)) => scene.fluid_of(fluid).internal_energy,
                    Some(Material::Inactive) => self.constants.parameters.air_internal_energy,
                    _ => 0.0,
                };
                *heat = [energy, 0.0, 0.0, 0.0];
            }
            state.id[slot] = slot as u32;
            state.slot_of_id[slot] = slot as u32;
        }
        state.drift_velocity.fill([0.0; 4]);
        state.life.fill([0.0, f32::MAX, 0.0, 0.0]);
        for (state, emitter) in state.emitter_state.iter_mut().zip(&scene.emitters) {
            *state = state_at_start(scene, emitter);
        }
        fill_poses(scene, &self.plan.model, &self.constants.parameters, state.pose);
        let (m, p) = (self.plan.model, self.constants.parameters);
        for (slot, anchor) in self.memory.given.anchor.iter_mut().enumerate() {
            let number = state.velocity[slot][3] - FIRST_SOLID as f32;
            let solid = if number < 0.0 { None } else { solids(&m, &p, state.pose).nth(number as usize) };
            *anchor = solid.map_or([0.0, 0.0, 0.0, -1.0], |solid| {
                let local = solid.local_of(vec3::splat(state.position[slot]));
                [local.x, local.y, local.z, number]
            });
        }
        self.memory.given.spring_ranges.fill([0; 4]);
        match particles.next() {
            Some(_) => Err(wrong(needed + 1)),
            None => Ok(()),
        }
    }
}
