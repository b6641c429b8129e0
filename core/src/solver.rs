//! The public face: a scene in lent memory, stepped.
use crate::arithmetic::level::Simd;
use crate::clock::{Clock, TimeReport};
use crate::derive::kernel_tables::fill_tables;
use crate::error::{SceneError, StepError};
use crate::executor::Executor;
use crate::hash::state_hash;
use crate::layout::{Model, Parameters, Status, f32x4, u32x2, u32x4};
use crate::memory::{Memory, Needs, State};
use crate::passes::Setup;
use crate::passes::p23_look::Seen;
use crate::plan::Plan;
use crate::scene::{InitialParticle, Scene};
use crate::step::{self, Pass, Settled, SpringEnds};
use crate::validate::{Checked, check_count};

/// A fluid that can be stepped.
///
/// ```
/// use millpond_core::scene::{Block, Dimension, Fluid, Grid, Scene};
/// use millpond_core::{Serial, Solver, Storage};
///
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// let water = Fluid { dynamic_viscosity: 1.0, ..Fluid::default() };
/// let block = Block { size: [0.5; 3], ..Block::default() };
/// let mut scene = Scene::of(Dimension::Three, 0.05, 0.001, water, block);
/// scene.gravity = [0.0, -9.81, 0.0];
/// scene.grid = Grid { cells: [8, 8, 8], ..Grid::default() };
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
    pub(crate) plan: Plan,
    pub(crate) parameters: Parameters,
    /// The scene's time step, s.
    pub(crate) first_step: f32,
    simd: Simd,
    pub(crate) clock: Clock,
    steps: u64,
    settled: Settled,
    total_iterations: u64,
    pub(crate) air_refused: u64,
    /// Which of the two states is the fluid; the other is where a step is tried.
    pub(crate) current: usize,
    pub(crate) memory: Memory<'m>,
}

/// What the pressure correction came to.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CorrectionReport {
    /// Iterations of the last step.
    pub iterations: u32,
    /// Iterations of all steps.
    pub total_iterations: u64,
    /// Largest density miss that the last step was left with, over the rest density.
    pub residual: f32,
}

impl<'m> Solver<'m> {
    /// A scene at its start, its first accelerations evaluated.
    ///
    /// # Errors
    /// A scene that cannot run, or memory too small for it.
    pub fn new(scene: &Scene, memory: Memory<'m>) -> Result<Solver<'m>, SceneError> {
        let scene = scene.check()?;
        Solver::with_particles(&scene, Plan::of(&scene), scene.derived().particles(), scene.initial_particles(), memory)
    }

    /// The same by a plan of the scene's, and with `count` particles wherever you like; their ids are 0, 1, 2 ... With air the
    /// last [`Air::capacity`](crate::scene::Air::capacity) of them are its own: of its fluid, or not there yet.
    ///
    /// # Errors
    /// Memory that is too small; a plan of another scene; more or fewer particles than `count`.
    pub fn with_particles(
        scene: &Checked<'_>,
        plan: Plan,
        count: usize,
        particles: impl IntoIterator<Item = InitialParticle>,
        memory: Memory<'m>,
    ) -> Result<Solver<'m>, SceneError> {
        check_count(count as u64)?;
        if plan != Plan::of(scene) && plan != Plan::everything(scene) {
            return Err(SceneError::PlanOfAnotherScene);
        }
        let memory = memory.cut(&Needs { particles: count, ..Needs::by_plan(scene, &plan) })?;
        let first_air = count.saturating_sub(scene.air_capacity()) as u32;
        let parameters = Parameters { particle_count: count as u32, first_air, ..scene.derived().parameters };
        let simd = Simd::detect();
        let settled = Settled::default();
        let mut solver = Solver {
            plan,
            parameters,
            first_step: scene.time_step,
            simd,
            clock: Clock::default(),
            steps: 0,
            settled,
            total_iterations: 0,
            air_refused: 0,
            current: 0,
            memory,
        };
        fill_tables(&scene.model, scene.dimension.count(), solver.memory.tables);
        solver.memory.field.fill([0.0; 4]);
        solver.fill(scene, particles)?;
        solver.evaluate()?;
        // no spring pulls at the start, so that it does not matter that they are made last
        solver.join(scene)?;
        solver.remember();
        Ok(solver)
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
        let model = self.plan.model;
        let (mut parameters, mut clock) = (self.parameters, self.clock);
        loop {
            let (settled, seen) = self.attempt(executor, &model, &parameters, begins)?;
            if !clock.after(&model, &mut parameters, seen) {
                // the state that was tried is left where it is, and another one is tried
                continue;
            }
            self.take();
            (self.parameters, self.clock) = (parameters, clock);
            self.steps += 1;
            self.settled = settled;
            self.total_iterations += u64::from(settled.iterations);
            self.air_refused += u64::from(settled.refused);
            return Ok(());
        }
    }

    /// The host's field from now on, one acceleration a node of [`Scene::field`], x fastest, m/s2; the fourth numbers are
    /// unused. A field that changes with time is set again before each step, as it will be at the end of the step; set before
    /// the first step, it also acts in that step's first half.
    ///
    /// # Errors
    /// Fewer or more nodes than the scene says, or a value that is not finite; the field then stays as it was. Before the first
    /// step also one that makes accelerations that are no numbers; the field then is 0, and the fluid as it was.
    pub fn set_field(&mut self, nodes: &[f32x4]) -> Result<(), SceneError> {
        let (given, expected) = (nodes.len(), self.memory.field.len());
        if given != expected {
            return Err(SceneError::WrongLength { call: "set_field", what: "nodes", given, expected });
        }
        if let Some(&value) = nodes.as_flattened().iter().find(|x| !x.is_finite()) {
            return Err(SceneError::NotFinite { field: "field", value });
        }
        self.memory.field.copy_from_slice(nodes);
        if self.steps == 0 && expected > 0 {
            // the first step begins with the accelerations at the start
            if let Err(error) = self.evaluate() {
                self.memory.field.fill([0.0; 4]);
                return Err(error.into());
            }
            self.remember();
        }
        Ok(())
    }

    /// Tries a step, in the state that is not the fluid.
    pub(crate) fn attempt(
        &mut self,
        executor: &impl Executor,
        model: &Model,
        parameters: &Parameters,
        begins: &mut dyn FnMut(Pass),
    ) -> Result<(Settled, Seen), StepError> {
        let Memory { states: [a, b], slot: _, scratch, springs, tables, field } = &mut self.memory;
        let [ends, other_ends] = &mut springs.ends;
        // where lengths at rest change, they trade places as the states do
        let (old_ends, new_ends): (&[_], &mut [_]) =
            if self.plan.model.plastic == 1 && self.current == 1 { (other_ends, ends) } else { (ends, other_ends) };
        let springs = SpringEnds { of: springs.of, old: old_ends, new: new_ends };
        let setup = Setup { model, parameters, tables, field, simd: self.simd };
        let (old, new) = if self.current == 0 { (&*a, b) } else { (&*b, a) };
        // time that stands still, or runs back, has no next density to aim at
        let iterations = if parameters.time_step > 0.0 { self.plan.iterations() } else { 0 };
        step::run(setup, executor, begins, (self.steps as u32, iterations), old, new, (scratch, springs))
    }

    /// Makes the state that was tried the fluid.
    pub(crate) fn take(&mut self) {
        self.current = 1 - self.current;
        for (slot, &id) in self.memory.states[self.current].id.iter().enumerate() {
            self.memory.slot[id as usize] = slot as u32;
        }
    }

    /// The fluid as it lies in memory, sorted by the cells that its particles had where forces were evaluated: walls, and some
    /// integrators, moved them once more.
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

    /// Ends of springs as they are now: see [`Springs::ends`](crate::memory::Springs::ends).
    #[must_use]
    pub fn spring_ends(&self) -> &[u32x2] {
        let plastic = self.plan.model.plastic == 1;
        self.memory.springs.ends[if plastic { self.current } else { 0 }]
    }

    /// What each particle has of springs, by id: see [`Springs::of`](crate::memory::Springs::of).
    #[must_use]
    pub fn springs_of(&self) -> &[u32x4] {
        self.memory.springs.of
    }

    /// What the pressure correction came to; all zero with an equation of state.
    #[must_use]
    pub fn correction(&self) -> CorrectionReport {
        let Settled { iterations, residual, .. } = self.settled;
        CorrectionReport { iterations, total_iterations: self.total_iterations, residual }
    }

    /// Kernels as tables; empty where the scene reads none.
    #[must_use]
    pub fn tables(&self) -> &[f32] {
        self.memory.tables
    }

    /// Nodes of the host's field; empty where the scene has none.
    #[must_use]
    pub fn field(&self) -> &[f32x4] {
        self.memory.field
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
        if self.plan.model.adaptive == 1 {
            return self.clock.report(&self.parameters).time;
        }
        // exact, where a clock that adds steps up is not
        self.steps as f64 * f64::from(self.parameters.time_step)
    }

    /// What became of the time step.
    #[must_use]
    pub fn time_report(&self) -> TimeReport {
        TimeReport { time: self.time(), ..self.clock.report(&self.parameters) }
    }

    /// Writes what a device's clock goes on from.
    pub fn fill_status(&self, status: &mut Status) {
        self.clock.fill(&self.parameters, status);
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
