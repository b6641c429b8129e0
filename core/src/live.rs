//! What can be changed between steps: the scene is changed, checked as at creation, and all that follows from it follows again.
use crate::derive::Derived;
use crate::error::SceneError;
use crate::layout::{Materials, Model, Parameters, StepUniform};
use crate::scene::{Adjustable, FLUIDS, Fluid, Integrator, Scene, SurfaceTension, Viscosity, Wind};
use glam::Vec3;

/// A change between two steps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Change {
    /// Acceleration of gravity, m/s2.
    Gravity(Vec3),
    /// The wind, or none.
    Wind(Option<Wind>),
    /// The time step, s.
    TimeStep(f32),
    /// The dynamic viscosity of a fluid by number, Pa s.
    Viscosity(u32, f32),
    /// The surface tension of a fluid by number ([`Fluid::surface_tension`]).
    SurfaceTension(u32, f32),
    /// The speed of sound of a fluid by number, m/s.
    SpeedOfSound(u32, f32),
    /// Tait's constant of a fluid by number, Pa ([`Fluid::stiffness`]).
    Stiffness(u32, f32),
}

/// The constants of a scene as they are now.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Constants {
    /// What every pass reads.
    pub parameters: Parameters,
    /// What each material has of its own.
    pub materials: Materials,
    /// The numbers of the step.
    pub step: StepUniform,
    /// Largest kinematic viscosity, m2/s.
    pub kinematic_viscosity: f32,
}

/// What may have been changed between steps, as it is saved.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LiveValues {
    gravity: [f32; 3],
    wind: [f32; 4],
    has_wind: bool,
    time_step: f32,
    /// Of each fluid its viscosity, tension, speed of sound, and stiffness or 0.
    fluids: [[f32; LiveValues::OF_FLUID]; FLUIDS],
}

impl LiveValues {
    const OF_FLUID: usize = 4;

    /// Words of them.
    pub const WORDS: usize = 9 + LiveValues::OF_FLUID * FLUIDS;

    pub(crate) fn to_words(self) -> [u32; LiveValues::WORDS] {
        let mut words = [0; LiveValues::WORDS];
        let numbers = self.gravity.iter().chain(&self.wind).chain([&self.time_step]).chain(self.fluids.as_flattened());
        let all = core::iter::once(u32::from(self.has_wind)).chain(numbers.map(|x| x.to_bits()));
        words.iter_mut().zip(all).for_each(|(place, word)| *place = word);
        words
    }

    pub(crate) fn of_words(words: &[u32]) -> LiveValues {
        let mut values = LiveValues::default();
        let mut words = words.iter().copied();
        values.has_wind = words.next() == Some(1);
        let LiveValues { gravity, wind, time_step, fluids, .. } = &mut values;
        let numbers = gravity.iter_mut().chain(wind).chain([time_step]).chain(fluids.as_flattened_mut());
        numbers.zip(words).for_each(|(number, word)| *number = f32::from_bits(word));
        values
    }
}

impl Constants {
    /// The same scene with time standing still: a step with these evaluates the forces and moves nothing.
    pub(crate) fn at_rest(&self) -> Constants {
        Constants { parameters: self.parameters.at_rest(), step: self.step.at_rest(), ..*self }
    }

    /// The same scene with time running back, with no walls to meet and springs that bear everything.
    pub(crate) fn backwards(&self) -> Constants {
        Constants { parameters: self.parameters.backwards(), step: self.step.backwards(), ..*self }
    }
}

/// A scene that runs.
#[derive(Clone, Debug)]
pub struct LiveScene {
    scene: Scene,
    model: Model,
    particles: u32,
    first_air: u32,
}

impl LiveScene {
    /// Of a scene that is run by this model, with so many particles, those of air from the second number on.
    pub(crate) fn new(scene: &Scene, model: Model, [particles, first_air]: [u32; 2]) -> LiveScene {
        let mut scene = scene.clone();
        // where particles start is over and done with
        scene.model.initialize_hydrostatic = false;
        LiveScene { scene, model, particles, first_air }
    }

    /// The constants of what was derived from its scene.
    pub(crate) fn constants(&self, derived: &Derived) -> Constants {
        let (particle_count, first_air) = (self.particles, self.first_air);
        Constants {
            parameters: Parameters { particle_count, first_air, ..derived.parameters },
            materials: derived.materials,
            step: derived.step,
            kinematic_viscosity: derived.kinematic_viscosity as f32,
        }
    }

    /// How many materials it has: fluids, blocks, walls.
    pub(crate) fn materials(&self) -> [usize; 3] {
        [self.scene.fluids.len(), self.scene.blocks.len(), self.scene.walls.len()]
    }

    /// The scene's time step, s.
    #[must_use]
    pub fn time_step(&self) -> f32 {
        self.scene.time_step
    }

    /// What may have been changed of it.
    #[must_use]
    pub fn values(&self) -> LiveValues {
        let scene = &self.scene;
        let mut fluids = [[0.0; LiveValues::OF_FLUID]; FLUIDS];
        for (values, fluid) in fluids.iter_mut().zip(scene.fluids.iter()) {
            let Fluid { dynamic_viscosity, surface_tension, speed_of_sound, stiffness, .. } = *fluid;
            *values = [dynamic_viscosity, surface_tension, speed_of_sound, stiffness.unwrap_or(0.0)];
        }
        let wind = scene.wind.map_or([0.0; 4], |wind| {
            let [x, y, z] = wind.velocity.to_array();
            [x, y, z, wind.drag]
        });
        LiveValues {
            gravity: scene.gravity.to_array(),
            wind,
            has_wind: scene.wind.is_some(),
            time_step: scene.time_step,
            fluids,
        }
    }

    /// The same scene with these values, and its constants.
    pub(crate) fn with_values(&self, values: &LiveValues) -> Result<(LiveScene, Constants), SceneError> {
        let mut next = self.clone();
        let [x, y, z, drag] = values.wind;
        next.scene.gravity = values.gravity.into();
        next.scene.wind = values.has_wind.then_some(Wind { velocity: [x, y, z].into(), drag });
        next.scene.time_step = values.time_step;
        let fluids = next.scene.fluids.iter_mut();
        for (fluid, [viscosity, tension, sound, stiffness]) in fluids.zip(values.fluids) {
            (fluid.dynamic_viscosity, fluid.surface_tension, fluid.speed_of_sound) = (viscosity, tension, sound);
            fluid.stiffness = (stiffness > 0.0).then_some(stiffness);
        }
        let derived = next.scene.check()?.derived().clone();
        let constants = next.constants(&derived);
        Ok((next, constants))
    }

    /// The same scene after a change, with its constants.
    ///
    /// # Errors
    /// A scene that could not be created like that, and a term that was left out.
    pub fn changed(&self, change: Change) -> Result<(LiveScene, Constants), SceneError> {
        let mut next = self.clone();
        next.apply(change)?;
        let derived = next.scene.check()?.derived().clone();
        let constants = next.constants(&derived);
        Ok((next, constants))
    }

    fn apply(&mut self, change: Change) -> Result<(), SceneError> {
        let m = self.model;
        let kept = |runs: bool, live: Adjustable| {
            let [live, field] = live.names();
            if runs { Ok(()) } else { Err(SceneError::LeftOut { field, live }) }
        };
        match change {
            Change::Gravity(gravity) => {
                self.scene.gravity = gravity;
                kept(m.has_gravity == 1 || gravity == Vec3::ZERO, Adjustable::Gravity)
            }
            Change::Wind(wind) => {
                self.scene.wind = wind;
                kept(m.has_wind == 1 || wind.is_none_or(|wind| wind.drag == 0.0), Adjustable::Wind)
            }
            Change::TimeStep(time_step) => self.apply_time_step(time_step),
            Change::Viscosity(fluid, viscosity) => {
                self.fluid("set_viscosity", fluid)?.dynamic_viscosity = viscosity;
                let choice = self.scene.model.viscosity;
                if matches!(choice, Viscosity::Artificial | Viscosity::VelocityExchange) {
                    let (choice, other) = ("set_viscosity", "model.viscosity Artificial or Exchange");
                    let why = "these have coefficients of their own, which stay as they are";
                    return Err(SceneError::NotTogether { choice, other, why });
                }
                kept(m.viscosity != 0 || viscosity == 0.0, Adjustable::Viscosity)
            }
            Change::SurfaceTension(fluid, tension) => {
                self.fluid("set_surface_tension", fluid)?.surface_tension = tension;
                // without a model of it the check says so
                let has_model = self.scene.model.surface_tension != SurfaceTension::Off;
                kept(m.tension != 0 || tension == 0.0 || !has_model, Adjustable::SurfaceTension)
            }
            Change::SpeedOfSound(fluid, speed) => {
                if self.scene.stiffness_for_time_step.is_some() {
                    let (choice, other) = ("set_speed_of_sound", "stiffness_for_time_step");
                    let why = "the speed of sound follows from the time step: set that";
                    return Err(SceneError::NotTogether { choice, other, why });
                }
                let fluid = self.fluid("set_speed_of_sound", fluid)?;
                fluid.speed_of_sound = speed;
                if fluid.stiffness.is_some() {
                    let (choice, other) = ("set_speed_of_sound", "stiffness");
                    let why = "the speed of sound follows from the stiffness: set that";
                    return Err(SceneError::NotTogether { choice, other, why });
                }
                Ok(())
            }
            Change::Stiffness(fluid, stiffness) => {
                self.fluid("set_stiffness", fluid)?.stiffness = Some(stiffness);
                Ok(())
            }
        }
    }

    fn apply_time_step(&mut self, time_step: f32) -> Result<(), SceneError> {
        use Integrator::{Beeman, PositionCorrectedBeeman, VelocityCorrectedBeeman};
        self.scene.time_step = time_step;
        let refused = |other, why| Err(SceneError::NotTogether { choice: "set_time_step", other, why });
        if self.scene.adaptive.is_some() {
            return refused("adaptive", "the time step follows from the state");
        }
        if matches!(self.scene.model.integrator, Beeman | VelocityCorrectedBeeman | PositionCorrectedBeeman) {
            return refused(
                "a model.integrator of Beeman's",
                "it remembers an acceleration one step of the same length ago",
            );
        }
        Ok(())
    }

    fn fluid(&mut self, field: &'static str, number: u32) -> Result<&mut Fluid, SceneError> {
        let fluids = self.scene.fluids.iter().count() as u32;
        let all = self.scene.fluids.iter_mut();
        all.into_iter().nth(number as usize).ok_or(SceneError::NoSuchFluid { field, fluid: number, fluids })
    }
}
