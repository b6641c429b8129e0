//! The public face: a scene in lent memory, stepped.
use crate::arithmetic::level::Simd;
use crate::clock::{Clock, SteadyTime, TimeReport, set_step};
use crate::derive::kernel_tables::fill_tables;
use crate::error::{SceneError, StepError};
use crate::executor::Executor;
use crate::hash::{full_state_hash, state_hash};
use crate::layout::{MOST_ATTEMPTS, Materials, Model, Parameters, Status, StepUniform, f32x4, u32x2};
use crate::live::{Constants, LiveScene};
use crate::memory::{Arrays, Memory, Requirements, State};
use crate::passes::columns::Columns;
use crate::passes::context::{Found, Setup, Step};
use crate::plan::Plan;
use crate::plan::arrays::{Array, Class};
use crate::plan::passes::Pass;
use crate::plan::schedule::{Command, Schedule, evaluation};
use crate::record::{CorrectionReport, Record, fingerprint};
use crate::scene::{InitialParticle, Scene};
use crate::step;
use crate::validate::{Checked, check_count};

/// A fluid that can be stepped.
///
/// ```
/// use millpond_core::glam::Vec3;
/// use millpond_core::scene::{Block, Dimension, Fluid, Grid, Scene};
/// use millpond_core::{Serial, Solver, Storage};
///
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// let water = Fluid { dynamic_viscosity: 1.0, ..Fluid::default() };
/// let block = Block { size: Vec3::splat(0.5), ..Block::default() };
/// let mut scene = Scene::of(Dimension::Three, 0.05, 0.001, water, block);
/// scene.gravity = Vec3::new(0.0, -9.81, 0.0);
/// scene.grid = Grid { cells: [8, 8, 8], ..Grid::default() };
/// let mut storage: Box<Storage<1000, 512>> = Storage::boxed();
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
    schedule: Schedule,
    pub(crate) live: LiveScene,
    pub(crate) constants: Constants,
    pub(crate) steady: SteadyTime,
    simd: Simd,
    pub(crate) clock: Clock,
    pub(crate) steps: u64,
    correction: CorrectionReport,
    pub(crate) air_refused: u64,
    /// Up to when [`Solver::advance`] was asked for steps, s.
    pub(crate) due: f64,
    /// Which of the two states is the fluid; the other is where a step is tried.
    pub(crate) current: usize,
    /// Are the neighbour lists of the last step still in memory?
    pub(crate) has_lists: bool,
    requirements: Requirements,
    fingerprint: u64,
    pub(crate) memory: Arrays<'m>,
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
        let requirements = Requirements::by_plan(scene, &plan).for_particles(count);
        let memory = memory.carve(&requirements)?;
        let first_air = count.saturating_sub(scene.air_capacity()) as u32;
        let live = LiveScene::new(scene, plan.model, [count as u32, first_air]);
        let constants = live.constants(scene.derived());
        let simd = Simd::detect();
        let mut solver = Solver {
            plan,
            schedule: plan.schedule(),
            constants,
            live,
            steady: SteadyTime::default(),
            simd,
            clock: Clock::default(),
            steps: 0,
            correction: CorrectionReport::default(),
            air_refused: 0,
            due: 0.0,
            current: 0,
            has_lists: false,
            fingerprint: fingerprint(&plan, &constants.parameters, &constants.materials, &requirements),
            requirements,
            memory,
        };
        fill_tables(&scene.model, scene.dimension.count(), solver.memory.given.kernel_tables);
        solver.memory.given.acceleration_field.fill([0.0; 4]);
        solver.fill(scene, particles)?;
        solver.evaluate(None)?;
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
    pub fn step_observed(
        &mut self,
        executor: &impl Executor,
        begins: &mut (dyn FnMut(Pass) + Send),
    ) -> Result<(), StepError> {
        executor.enter(|executor| self.step_inside(executor, begins))
    }

    fn step_inside(
        &mut self,
        executor: &impl Executor,
        begins: &mut (dyn FnMut(Pass) + Send),
    ) -> Result<(), StepError> {
        let (model, schedule) = (self.plan.model, self.schedule.clone());
        let (mut constants, mut clock) = (self.constants, self.clock);
        for _ in 0..MOST_ATTEMPTS {
            let found = self.attempt(executor, &model, &constants, None, &schedule, begins)?;
            if !clock.after(&model, &constants.parameters, &mut constants.step, found.maxima) {
                // the state that was tried is left where it is, and another one is tried
                continue;
            }
            self.accept();
            (self.constants, self.clock) = (constants, clock);
            self.steps += 1;
            self.correction = CorrectionReport {
                iterations: found.iterations,
                total_iterations: self.correction.total_iterations + u64::from(found.iterations),
                residual: found.residual,
            };
            self.air_refused += u64::from(found.refused);
            return Ok(());
        }
        Err(StepError::NoTimeStep { attempts: MOST_ATTEMPTS, step: self.steps + 1 })
    }

    /// How simulated time follows from the steps, where they are all alike.
    #[must_use]
    pub fn steady_time(&self) -> SteadyTime {
        self.steady
    }

    /// The scene as it is now.
    #[must_use]
    pub fn live(&self) -> &LiveScene {
        &self.live
    }

    /// Evaluates forces in the state that is not the fluid, while time stands still or runs back.
    pub(crate) fn attempt_evaluation(
        &mut self,
        executor: &impl Executor,
        model: &Model,
        constants: &Constants,
        field: Option<&[f32x4]>,
    ) -> Result<Found, StepError> {
        self.attempt(executor, model, constants, field, &evaluation(model), &mut |_| ())
    }

    /// Tries a step, in the state that is not the fluid; in another field than its own where one is given.
    fn attempt(
        &mut self,
        executor: &impl Executor,
        model: &Model,
        constants: &Constants,
        field: Option<&[f32x4]>,
        commands: &[Command],
        begins: &mut (dyn FnMut(Pass) + Send),
    ) -> Result<Found, StepError> {
        let Arrays { states: [a, b], scratch, given, list_words } = &mut self.memory;
        let (tables, field) = (&*given.kernel_tables, field.unwrap_or(given.acceleration_field));
        let Constants { parameters, materials, step: uniform, .. } = constants;
        let columns = &Columns::of(materials, self.live.materials());
        let setup = Setup { model, parameters, materials, columns, uniform, tables, field, simd: self.simd };
        let (old, new) = if self.current == 0 { (&*a, b) } else { (&*b, a) };
        self.has_lists = false;
        let found = Found::nothing(self.steps as u32);
        let command = Command::Run(Pass::IntegrateBefore);
        let mut step = Step { setup, executor, old, new, scratch, given, list_words: *list_words, found, command };
        step::run(&mut step, commands, begins).map_err(|error| error.at_step(self.steps + 1))?;
        let found = step.found;
        self.has_lists = self.plan.model.makes_lists();
        Ok(found)
    }

    /// Makes the state that was tried the fluid.
    pub(crate) fn accept(&mut self) {
        let [a, b] = &mut self.memory.states;
        a.pass_on_constants(b, &self.plan.model);
        self.current = 1 - self.current;
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
        self.state().slot_of_id
    }

    /// Ends of springs as they are now.
    #[must_use]
    pub fn spring_ends(&self) -> &[u32x2] {
        self.state().spring_ends
    }

    /// The ends of springs of the state and, where they change, of the other one: to be filled and put back.
    pub(crate) fn take_spring_ends(&mut self) -> [&'m mut [u32x2]; 2] {
        let [a, b] = &mut self.memory.states;
        let (now, other) = if self.current == 0 { (a, b) } else { (b, a) };
        [now, other].map(|state| core::mem::take(&mut state.spring_ends))
    }

    pub(crate) fn put_spring_ends(&mut self, [own, others]: [&'m mut [u32x2]; 2]) {
        let current = self.current;
        (self.memory.states[current].spring_ends, self.memory.states[1 - current].spring_ends) = (own, others);
    }

    /// An array of the state, or one that steps only read, as words of four bytes.
    #[must_use]
    pub fn words(&self, array: Array) -> &[u32] {
        if array.class() == Class::Given { self.memory.given.words(array) } else { self.state().words(array) }
    }

    /// What the pressure correction came to; all zero with an equation of state.
    #[must_use]
    pub fn correction(&self) -> CorrectionReport {
        self.correction
    }

    /// Nodes of the host's field; empty where the scene has none.
    #[must_use]
    pub fn field(&self) -> &[f32x4] {
        self.memory.given.acceleration_field
    }

    /// Hash of all positions and velocities: equal if and, practically, only if every bit is.
    #[must_use]
    pub fn hash(&self) -> u64 {
        let state = self.state();
        state_hash(state.slot_of_id, state.position, state.velocity)
    }

    /// Hash of every array of the state, what is remembered of the steps before and the ends of springs included.
    #[must_use]
    pub fn full_hash(&self) -> u64 {
        let s = self.state();
        let arrays: [&[f32x4]; 8] = [
            s.position,
            s.velocity,
            s.acceleration,
            s.density_pressure,
            s.xsph_velocity,
            s.internal_energy,
            s.normal,
            s.history,
        ];
        full_state_hash(s.slot_of_id, &arrays, s.spring_ends)
    }

    /// Steps that were made.
    #[must_use]
    pub fn steps(&self) -> u64 {
        self.steps
    }

    /// Simulated time, s.
    #[must_use]
    pub fn time(&self) -> f64 {
        if self.plan.model.is_adaptive == 1 {
            return self.clock.report(&self.constants.step).time;
        }
        self.steady.after(self.steps, self.constants.step.time_step)
    }

    /// What became of the time step.
    #[must_use]
    pub fn time_report(&self) -> TimeReport {
        TimeReport { time: self.time(), ..self.clock.report(&self.constants.step) }
    }

    /// Up to when [`Solver::advance`] was asked for steps, s.
    #[doc(hidden)]
    #[must_use]
    pub fn due(&self) -> f64 {
        self.due
    }

    /// Sets the length of the next step, s, where lengths follow from the state.
    pub(crate) fn set_next_step(&mut self, step: f32) {
        set_step(&mut self.constants.step, step);
    }

    /// Writes what a device's clock goes on from.
    pub fn fill_status(&self, status: &mut Status) {
        self.clock.fill(&self.constants.step, status);
    }

    /// What tells its bytes from those of another scene.
    #[must_use]
    pub fn fingerprint(&self) -> u64 {
        self.fingerprint
    }

    /// An array of the state, or one that steps only read, to be written.
    pub(crate) fn words_mut(&mut self, array: Array) -> &mut [u32] {
        if array.class() == Class::Given {
            self.memory.given.words_mut(array)
        } else {
            self.memory.states[self.current].words_mut(array)
        }
    }

    /// Says that the particles lie in the order of their ids.
    pub(crate) fn lie_by_id(&mut self) {
        let state = &mut self.memory.states[self.current];
        for (id, (slot, slot_of_id)) in (0..).zip(state.id.iter_mut().zip(state.slot_of_id.iter_mut())) {
            (*slot, *slot_of_id) = (id, id);
        }
    }

    /// Goes on with these constants from what a record says.
    pub(crate) fn go_on(&mut self, live: LiveScene, constants: &Constants, record: &Record) {
        (self.live, self.constants) = (live, *constants);
        (self.steps, self.steady, self.correction) = (record.steps, record.steady, record.correction);
    }

    /// How much memory of which arrays it has.
    #[must_use]
    pub fn requirements(&self) -> &Requirements {
        &self.requirements
    }

    /// What a step consists of.
    #[must_use]
    pub fn plan(&self) -> &Plan {
        &self.plan
    }

    /// The scene's constants.
    #[must_use]
    pub fn parameters(&self) -> &Parameters {
        &self.constants.parameters
    }

    /// The constants of the materials.
    #[must_use]
    pub fn materials(&self) -> &Materials {
        &self.constants.materials
    }

    /// The numbers of the next step.
    #[must_use]
    pub fn uniform(&self) -> &StepUniform {
        &self.constants.step
    }

    /// The level computed at.
    #[must_use]
    pub fn simd(&self) -> Simd {
        self.simd
    }
}
