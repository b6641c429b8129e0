//! Changes between steps: the scene is changed and checked as at creation, and its constants are derived again.
use crate::derive::Derived;
use crate::error::SceneError;
use crate::layout::{Materials, Model, Parameters, StepUniform};
use crate::scene::{
    Adjustable, FLUIDS, Fluid, Integrator, Recovery, Scene, SolidModel, SurfaceTension, Viscosity, Wind,
};
use crate::terms::viscosity::has_friction;
use crate::validate::not_together;
use glam::Vec3;

/// A change between two steps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Change {
    /// The acceleration of gravity, m/s2.
    Gravity(Vec3),
    /// The wind, or `None` for no wind.
    Wind(Option<Wind>),
    /// The time step, s.
    TimeStep(f32),
    /// The dynamic viscosity, Pa s, of the fluid with this index.
    Viscosity(u32, f32),
    /// The coefficient of surface tension ([`Fluid::surface_tension`]) of the fluid with this index.
    SurfaceTension(u32, f32),
    /// The speed of sound, m/s, of the fluid with this index.
    SpeedOfSound(u32, f32),
    /// The constant B of Tait's equation ([`Fluid::stiffness`]), Pa, of the fluid with this index.
    Stiffness(u32, f32),
}

/// The constants of a scene with its current values.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Constants {
    /// Constants that every pass reads.
    pub parameters: Parameters,
    /// Constants of each material.
    pub materials: Materials,
    /// The numbers of the next step.
    pub step: StepUniform,
    /// Largest kinematic viscosity, m2/s.
    pub kinematic_viscosity: f32,
}

/// The values of a scene that can be changed between steps, as they are saved.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LiveValues {
    gravity: [f32; 3],
    wind: [f32; 4],
    has_wind: bool,
    time_step: f32,
    /// For each fluid its dynamic viscosity, coefficient of surface tension, speed of sound, and stiffness or 0.
    fluids: [[f32; LiveValues::OF_FLUID]; FLUIDS],
}

impl LiveValues {
    const OF_FLUID: usize = 4;

    /// Number of words of the saved values.
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
    /// The constants with time at rest. A step with them evaluates the forces and moves nothing.
    pub(crate) fn at_rest(&self) -> Constants {
        Constants { parameters: self.parameters.at_rest(), step: self.step.at_rest(), ..*self }
    }

    /// The constants with time running backwards, without penalty planes, and with springs that never break.
    pub(crate) fn backwards(&self) -> Constants {
        Constants { parameters: self.parameters.backwards(), step: self.step.backwards(), ..*self }
    }
}

/// The scene of a running solver, with its current values.
#[derive(Clone, Debug)]
pub struct LiveScene {
    scene: Scene,
    model: Model,
    particles: u32,
    first_spare: u32,
}

impl LiveScene {
    /// Creates it from the scene, its model, the number of particles, and the id from which on particles can be
    /// inactive.
    pub(crate) fn new(scene: &Scene, model: Model, [particles, first_spare]: [u32; 2]) -> LiveScene {
        let mut scene = scene.clone();
        // a hydrostatic start only matters until the particles are created, and later changes need not fit it
        scene.model.initialize_hydrostatic = false;
        LiveScene { scene, model, particles, first_spare }
    }

    /// Returns the constants derived from the scene, with the particle counts of the solver.
    pub(crate) fn constants(&self, derived: &Derived) -> Constants {
        let (particle_count, first_spare) = (self.particles, self.first_spare);
        Constants {
            parameters: Parameters { particle_count, first_spare, ..derived.parameters },
            materials: derived.materials,
            step: derived.step,
            kinematic_viscosity: derived.kinematic_viscosity as f32,
        }
    }

    /// Numbers of fluids, blocks, walls and solids with particles, which determine the materials that the scene uses.
    pub(crate) fn materials(&self) -> [usize; 4] {
        let solids = self.scene.solids.iter().filter(|solid| solid.model == SolidModel::Particles);
        [self.scene.fluids.len(), self.scene.blocks.len(), self.scene.walls.len(), solids.count()]
    }

    /// Number of fluids.
    pub(crate) fn fluids(&self) -> u32 {
        self.scene.fluids.len() as u32
    }

    /// The scene's time step, s.
    #[must_use]
    pub fn time_step(&self) -> f32 {
        self.scene.time_step
    }

    /// The values of the scene that can be changed between steps.
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

    /// Returns the scene with these values, and its constants.
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

    /// Returns the scene after a change, and its constants.
    ///
    /// # Errors
    /// A [`SceneError`] if the changed scene is not valid, or if the plan left out the term that is to change.
    pub fn changed(&self, change: Change) -> Result<(LiveScene, Constants), SceneError> {
        let mut next = self.clone();
        next.apply(change)?;
        let derived = next.scene.check()?.derived().clone();
        let constants = next.constants(&derived);
        Ok((next, constants))
    }

    fn apply(&mut self, change: Change) -> Result<(), SceneError> {
        let m = self.model;
        let kept = |runs: bool, term: Adjustable| {
            let [item, field] = term.names();
            if runs { Ok(()) } else { Err(SceneError::LeftOut { field, item }) }
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
                    let (choice, other) = ("set_viscosity", "model.viscosity Artificial or VelocityExchange");
                    let why =
                        "these use coefficients in model instead of dynamic_viscosity; use another model.viscosity";
                    return Err(not_together(choice, other, why));
                }
                kept(has_friction(&m) || viscosity == 0.0, Adjustable::Viscosity)
            }
            Change::SurfaceTension(fluid, tension) => {
                self.fluid("set_surface_tension", fluid)?.surface_tension = tension;
                // if the scene has no model of surface tension, the check of the scene reports it
                let has_model = self.scene.model.surface_tension != SurfaceTension::Off;
                kept(m.tension != 0 || tension == 0.0 || !has_model, Adjustable::SurfaceTension)
            }
            Change::SpeedOfSound(fluid, speed) => {
                if self.scene.stiffness_for_time_step.is_some() {
                    let (choice, other) = ("set_speed_of_sound", "stiffness_for_time_step");
                    let why = "the speed of sound is derived from the time step; call set_time_step";
                    return Err(not_together(choice, other, why));
                }
                let fluid = self.fluid("set_speed_of_sound", fluid)?;
                fluid.speed_of_sound = speed;
                if fluid.stiffness.is_some() {
                    let (choice, other) = ("set_speed_of_sound", "the stiffness of that fluid");
                    let why = "the speed of sound is derived from the stiffness; call set_stiffness";
                    return Err(not_together(choice, other, why));
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
        let refused = |other: &'static str, why| Err(not_together("set_time_step", other, why));
        if self.scene.adaptive.is_some() {
            return refused("adaptive", "the time step is derived from the state of the fluid; omit adaptive");
        }
        if self.scene.recovery != Recovery::Refuse {
            return refused(
                "recovery ShortenStep",
                "the solver itself changes the time step after a failed step; use recovery Refuse",
            );
        }
        if matches!(self.scene.model.integrator, Beeman | VelocityCorrectedBeeman | PositionCorrectedBeeman) {
            return refused(
                "model.integrator Beeman or any variant of it",
                "its history of the last step assumes steps of equal length; use another integrator, such as \
                 ModifiedVelocityVerlet",
            );
        }
        Ok(())
    }

    fn fluid(&mut self, field: &'static str, number: u32) -> Result<&mut Fluid, SceneError> {
        let fluids = self.scene.fluids.iter().count() as u32;
        let all = self.scene.fluids.iter_mut();
        all.into_iter().nth(number as usize).ok_or(SceneError::NoSuchFluid {
            field: field.into(),
            fluid: number,
            fluids,
        })
    }
}
