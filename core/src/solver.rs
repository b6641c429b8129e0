//! The public face: a scene in lent memory, stepped.
use crate::arithmetic::level::Simd;
use crate::error::{SceneError, StepError};
use crate::executor::{Executor, Serial};
use crate::guided::parameters;
use crate::hash::state_hash;
use crate::layout::{Parameters, f32x4};
use crate::passes::Setup;
use crate::plan::Plan;
use crate::scene::{Dimension, Place, Scene, check_count, places};
use crate::step::{self, Pass};
use crate::storage::{Memory, Needs, State};
use glam::Vec3;

/// A fluid that can be stepped.
///
/// ```
/// use millpond_core::scene::{Block, Dimension, Fluid, Grid, ModelChoice, Scene};
/// use millpond_core::{Serial, Solver, Storage};
///
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// let block = Block { corner: [0.0; 3], size: [0.5; 3], velocity: [0.0; 3], jitter: 0.0 };
/// let scene = Scene {
///     dimension: Dimension::Three,
///     particle_spacing: 0.05,
///     average_neighbours: 32.0,
///     time_step: 0.001,
///     gravity: [0.0, -9.81, 0.0],
///     fluid: Fluid { rest_density: 1000.0, speed_of_sound: 10.0, dynamic_viscosity: 1.0, near_stiffness: None },
///     blocks: [block].into_iter().collect(),
///     container: None,
///     model: ModelChoice::default(),
///     grid: Grid { cells: [8, 8, 8], ..Grid::default() },
/// };
/// let mut storage = Box::new(Storage::<1000, 512>::new());
/// let mut solver = Solver::new(&scene, storage.lend())?;
/// for _ in 0..10 {
///     solver.step(&Serial)?;
/// }
/// let fastest = solver.particles().map(|p| p.velocity.length()).fold(0.0, f32::max);
/// assert!(fastest > 0.09, "10 ms of free fall");
/// # Ok(())
/// # }
/// ```
#[derive(Debug)]
pub struct Solver<'m> {
    plan: Plan,
    parameters: Parameters,
    simd: Simd,
    steps: u64,
    /// Which of the two states is the fluid; the other is where a step is tried.
    current: usize,
    pub(crate) memory: Memory<'m>,
}

/// One particle, as a host sees it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Particle {
    /// Its number for as long as it lives.
    pub id: u32,
    /// m.
    pub position: Vec3,
    /// m/s.
    pub velocity: Vec3,
    /// kg/m3.
    pub density: f32,
    /// Pa.
    pub pressure: f32,
}

impl<'m> Solver<'m> {
    /// A scene at its start, its first accelerations evaluated.
    ///
    /// # Errors
    /// A scene that cannot run, or memory too small for it.
    pub fn new(scene: &Scene, memory: Memory<'m>) -> Result<Solver<'m>, SceneError> {
        scene.check()?;
        Solver::with_particles(scene, Plan::of(scene), scene.particle_count(), places(scene), memory)
    }

    /// The same by a plan of the scene's, and with `count` particles wherever you like; their ids are 0, 1, 2 ...
    ///
    /// # Errors
    /// As for [`Solver::new`]; also a plan of another scene, and more or fewer places than `count`.
    pub fn with_particles(
        scene: &Scene,
        plan: Plan,
        count: usize,
        places: impl IntoIterator<Item = Place>,
        memory: Memory<'m>,
    ) -> Result<Solver<'m>, SceneError> {
        scene.check()?;
        check_count(count as u64)?;
        if plan != Plan::of(scene) && plan != Plan::everything(scene) {
            return Err(SceneError::PlanOfAnotherScene);
        }
        let memory = memory.cut(Needs { particles: count, ..Needs::of(scene) })?;
        let parameters = Parameters { particle_count: count as u32, ..parameters(scene) };
        let simd = Simd::detect();
        let mut solver = Solver { plan, parameters, simd, steps: 0, current: 0, memory };
        solver.fill(scene.dimension, places)?;
        // with time standing still a step evaluates the first accelerations and sorts the particles
        solver.advance(&Serial, &parameters.at_rest(), &mut |_| ())?;
        Ok(solver)
    }

    /// Writes the particles into the current state.
    fn fill(&mut self, dimension: Dimension, places: impl IntoIterator<Item = Place>) -> Result<(), SceneError> {
        let state = &mut self.memory.states[self.current];
        let needed = state.id.len();
        let mut places = places.into_iter();
        for slot in 0..needed {
            let Some(place) = places.next() else {
                return Err(SceneError::CapacityExceeded { what: "places of particles", needed, capacity: slot });
            };
            let ([x, y, z], [u, v, w]) = (place.position, place.velocity);
            if dimension == Dimension::Two && (z != 0.0 || w != 0.0) {
                return Err(SceneError::OutOfPlane);
            }
            state.position[slot] = [x, y, z, 0.0];
            state.velocity[slot] = [u, v, w, 0.0];
            state.acceleration[slot] = [0.0; 4];
            state.id[slot] = slot as u32;
        }
        match places.next() {
            Some(_) => {
                let needed = needed + 1;
                Err(SceneError::CapacityExceeded { what: "particles", needed, capacity: needed - 1 })
            }
            None => Ok(()),
        }
    }

    /// Computes at this level, or the best one below it that the processor has. Never changes a bit.
    #[must_use]
    pub fn at_level(mut self, simd: Simd) -> Self {
        self.simd = simd.or_best();
        self
    }

    /// One time step.
    ///
    /// # Errors
    /// A step that cannot be made; the fluid then is as it was before.
    pub fn step(&mut self, executor: &impl Executor) -> Result<(), StepError> {
        self.step_observed(executor, &mut |_| ())
    }

    /// One time step that tells `begins` of each pass before it runs: for a host with a clock.
    ///
    /// # Errors
    /// As for [`Solver::step`].
    pub fn step_observed(&mut self, executor: &impl Executor, begins: &mut dyn FnMut(Pass)) -> Result<(), StepError> {
        let parameters = self.parameters;
        self.advance(executor, &parameters, begins)?;
        self.steps += 1;
        Ok(())
    }

    fn advance(
        &mut self,
        executor: &impl Executor,
        parameters: &Parameters,
        begins: &mut dyn FnMut(Pass),
    ) -> Result<(), StepError> {
        let setup = Setup { model: &self.plan.model, parameters, simd: self.simd };
        let [a, b] = &mut self.memory.states;
        let (old, new) = if self.current == 0 { (&*a, b) } else { (&*b, a) };
        step::run(setup, executor, begins, self.steps as u32, old, new, &mut self.memory.scratch)?;
        for (slot, &id) in new.id.iter().enumerate() {
            self.memory.slot[id as usize] = slot as u32;
        }
        self.current = 1 - self.current;
        Ok(())
    }

    /// The fluid as it lies in memory, sorted by the cells that its particles had before walls moved them.
    #[must_use]
    pub fn state(&self) -> &State<'m> {
        &self.memory.states[self.current]
    }

    pub(crate) fn current_index(&self) -> usize {
        self.current
    }

    /// Slot of each particle in [`Solver::state`], by id.
    #[must_use]
    pub fn slots(&self) -> &[u32] {
        self.memory.slot
    }

    /// The particles, in order of their ids.
    pub fn particles(&self) -> impl ExactSizeIterator<Item = Particle> {
        let state = self.state();
        let vector = |[x, y, z, _]: f32x4| Vec3::new(x, y, z);
        self.memory.slot.iter().enumerate().map(move |(id, &slot)| {
            let slot = slot as usize;
            let [density, pressure, ..] = state.density_pressure[slot];
            let (position, velocity) = (vector(state.position[slot]), vector(state.velocity[slot]));
            Particle { id: id as u32, position, velocity, density, pressure }
        })
    }

    /// Hash of all positions and velocities: equal if and, practically, only if every bit is.
    #[must_use]
    pub fn hash(&self) -> u64 {
        let state = self.state();
        state_hash(self.memory.slot, state.position, state.velocity)
    }

    /// Steps that were made.
    #[must_use]
    pub fn steps(&self) -> u64 {
        self.steps
    }

    /// Simulated time, s.
    #[must_use]
    pub fn time(&self) -> f64 {
        self.steps as f64 * f64::from(self.parameters.time_step)
    }

    /// What a step consists of.
    #[must_use]
    pub fn plan(&self) -> &Plan {
        &self.plan
    }

    /// The scene's constants.
    #[must_use]
    pub fn parameters(&self) -> &Parameters {
        &self.parameters
    }

    /// The level computed at.
    #[must_use]
    pub fn simd(&self) -> Simd {
        self.simd
    }
}
