//! The solver: a scene in memory lent by the caller, advanced step by step.
use crate::arithmetic::level::Simd;
use crate::clock::{Clock, SteadyTime};
use crate::derive::emission::fill_emitters;
use crate::derive::kernel_tables::fill_tables;
use crate::error::{SceneError, StepError};
use crate::executor::{AnyExecutor, Executor};
use crate::flux::Flux;
use crate::hash::Fnv;
use crate::layout::{MOST_ATTEMPTS, Model, f32x4};
use crate::live::{Constants, LiveScene};
use crate::memory::{Arrays, Memory, Requirements};
use crate::passes::columns::Columns;
use crate::passes::context::{Found, Setup, Step};
use crate::plan::Plan;
use crate::plan::passes::Pass;
use crate::plan::schedule::{Command, Schedule, evaluation};
use crate::record::{CorrectionReport, fingerprint};
use crate::scene::{InitialParticle, Scene};
use crate::solids::motion::move_all;
use crate::step;
use crate::terms::time_step::step_half;
use crate::validate::{Checked, check_count};

/// A fluid in motion: the particles of a scene, which [`Solver::step`] advances in time.
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
    pub(crate) simd: Simd,
    pub(crate) clock: Clock,
    pub(crate) steps: u64,
    pub(crate) correction: CorrectionReport,
    pub(crate) census: Flux,
    /// Time up to which [`Solver::advance`] was asked to advance the fluid, s.
    pub(crate) due: f64,
    /// Index of the state that is the fluid. A step is tried in the state with the other index.
    pub(crate) current: usize,
    /// Whether the neighbour lists of the last step are still in memory.
    pub(crate) has_lists: bool,
    pub(crate) requirements: Requirements,
    pub(crate) fingerprint: u64,
    pub(crate) memory: Arrays<'m>,
}

impl<'m> Solver<'m> {
    /// Creates a solver of a scene at its start: places the particles and evaluates their first accelerations.
    ///
    /// # Errors
    /// A [`SceneError`] if the scene cannot run, if the memory is too small for it, or if the forces at the start
    /// cannot be evaluated.
    pub fn new(scene: &Scene, memory: Memory<'m>) -> Result<Solver<'m>, SceneError> {
        let scene = scene.check()?;
        let mut particles = scene.initial_particles();
        Solver::start(&scene, &Plan::of(&scene), scene.derived().particles(), &mut particles, memory)
    }

    /// Creates a solver with a plan of the scene and with `count` particles supplied by the caller, whose ids are 0, 1,
    /// 2 ... in the order given. The plan is [`Plan::of`] or [`Plan::everything`] of the scene. With a layer of air the
    /// last [`Air::capacity`](crate::scene::Air::capacity) particles belong to it: each has the material of the layer's
    /// fluid, or is inactive.
    ///
    /// # Errors
    /// Those of [`Solver::new`]; also [`SceneError::PlanOfAnotherScene`], [`SceneError::TooManyParticles`], and
    /// [`SceneError::WrongLength`] if `particles` yields more or fewer than `count` items. A particle is rejected if a
    /// quantity of it is not finite, if its mass is not positive, if it lies outside of the plane in 2D, or if it has a
    /// material or a mass that the plan does not support.
    pub fn with_particles(
        scene: &Checked<'_>,
        plan: Plan,
        count: usize,
        particles: impl IntoIterator<Item = InitialParticle>,
        memory: Memory<'m>,
    ) -> Result<Solver<'m>, SceneError> {
        Solver::start(scene, &plan, count, &mut particles.into_iter(), memory)
    }

    /// The same, compiled once for all iterators, and without a copy of them on the stack.
    fn start(
        scene: &Checked<'_>,
        plan: &Plan,
        count: usize,
        particles: &mut dyn Iterator<Item = InitialParticle>,
        memory: Memory<'m>,
    ) -> Result<Solver<'m>, SceneError> {
        check_count(count as u64)?;
        if *plan != Plan::of(scene) && *plan != Plan::everything(scene) {
            return Err(SceneError::PlanOfAnotherScene);
        }
        let requirements = Requirements::by_plan(scene, plan).for_particles(count);
        let memory = memory.carve(&requirements)?;
        // a drain or the host can make any particle inactive
        let first_spare = if scene.has_turnover() { 0 } else { count.saturating_sub(scene.inactive_at_start()) };
        let live = LiveScene::new(scene, plan.model, [count as u32, first_spare as u32]);
        let constants = live.constants(scene.derived());
        let simd = Simd::of_new_solver();
        let mut solver = Solver {
            plan: *plan,
            schedule: plan.schedule(),
            constants,
            live,
            steady: SteadyTime::default(),
            simd,
            clock: Clock::default(),
            steps: 0,
            correction: CorrectionReport::default(),
            census: Flux::default(),
            due: 0.0,
            current: 0,
            has_lists: false,
            fingerprint: fingerprint(plan, &constants.parameters, &constants.materials, &requirements),
            requirements,
            memory,
        };
        fill_tables(scene, solver.memory.given.kernel_tables);
        let given = &mut solver.memory.given;
        fill_emitters(scene, given.emitters, given.emitter_points);
        // saved bytes do not contain them, so they must not go to a scene with other emitters
        let numbers = given.emitters.iter().chain(given.emitter_points.iter()).flatten();
        solver.fingerprint = numbers.fold(Fnv(solver.fingerprint), |hash, x| hash.word(x.to_bits())).0;
        solver.memory.given.acceleration_field.fill([0.0; 4]);
        solver.fill(scene, particles)?;
        solver.evaluate(None)?;
        // springs are made after the first evaluation, which does not need them: at rest length they exert no force
        solver.join(scene)?;
        solver.remember();
        Ok(solver)
    }

    /// Sets the SIMD level, or the fastest level of the processor if it lacks this one (default: the fastest level, in
    /// builds with debug assertions AVX2 at most). The level changes the speed of steps, and never a bit of the result.
    /// Unoptimised steps in AVX-512 need 2 MiB of stack.
    #[must_use]
    pub fn at_level(mut self, simd: Simd) -> Self {
        self.simd = simd.or_best();
        self
    }

    /// Makes one time step. `executor` runs the passes: [`Serial`](crate::Serial) on the calling thread, or an
    /// [`Executor`] of your own on several threads. To follow the clock of a game use [`Solver::advance`].
    ///
    /// # Errors
    /// A [`StepError`] if the step cannot be made. The fluid is then as it was before the step.
    pub fn step(&mut self, executor: &impl Executor) -> Result<(), StepError> {
        self.step_observed(executor, &mut |_| ())
    }

    /// Makes one time step, and calls `begins` with each pass before it runs. Use it to measure the time of the passes.
    ///
    /// # Errors
    /// Those of [`Solver::step`].
    pub fn step_observed(
        &mut self,
        executor: &impl Executor,
        begins: &mut (dyn FnMut(Pass) + Send),
    ) -> Result<(), StepError> {
        executor.enter(|executor| self.step_inside(executor, begins))
    }

    fn step_inside(
        &mut self,
        executor: &dyn AnyExecutor,
        begins: &mut (dyn FnMut(Pass) + Send),
    ) -> Result<(), StepError> {
        let (model, schedule) = (self.plan.model, self.schedule.clone());
        let (mut constants, mut clock) = (self.constants, self.clock);
        let (mut rejected, mut shortened) = (0, 0);
        while rejected < MOST_ATTEMPTS {
            let found = match self.attempt(executor, &model, &constants, None, &schedule, begins) {
                Err(_) if shortened < model.most_halvings => {
                    shortened += 1;
                    constants.step = constants.step.with_time_step(step_half::<f32>(constants.step.time_step));
                    continue;
                }
                found => found?,
            };
            if !clock.after(&model, &constants.parameters, &mut constants.step, found.maxima) {
                // the rejected state is not accepted, and the next attempt overwrites it
                rejected += 1;
                continue;
            }
            clock.shortened(shortened);
            self.accept();
            (self.constants, self.clock) = (constants, clock);
            self.steps += 1;
            self.correction = CorrectionReport {
                iterations: found.iterations,
                total_iterations: self.correction.total_iterations + u64::from(found.iterations),
                residual: found.residual,
            };
            self.census.add(found.flux);
            return Ok(());
        }
        Err(StepError::NoTimeStep { attempts: MOST_ATTEMPTS, step: self.steps + 1 })
    }

    /// Evaluates forces with time at rest or running backwards, and writes the result into the state that is not the
    /// fluid.
    pub(crate) fn attempt_evaluation(
        &mut self,
        executor: &dyn AnyExecutor,
        model: &Model,
        constants: &Constants,
        field: Option<&[f32x4]>,
    ) -> Result<Found, StepError> {
        self.attempt(executor, model, constants, field, &evaluation(model), &mut |_| ())
    }

    /// Tries a step, and writes the new state into the state that is not the fluid. `field`, if given, replaces the
    /// solver's acceleration field.
    fn attempt(
        &mut self,
        executor: &dyn AnyExecutor,
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
        let (old, new) = if self.current == 0 { (&*a, b) } else { (&*b, a) };
        // all passes read where the solids are at the end of the step, and none of them writes it
        let poses = core::mem::take(&mut new.pose);
        move_all((model, parameters, uniform), self.clock.time(), old.pose, poses);
        let simd = self.simd;
        let setup = Setup { model, parameters, materials, columns, uniform, tables, field, poses: &*poses, simd };
        self.has_lists = false;
        let found = Found::nothing(self.steps as u32);
        let command = Command::Run(Pass::IntegrateBefore);
        let list_words = *list_words;
        let mut step = Step { setup, executor, old, new: &mut *new, scratch, given, list_words, found, command };
        let ran = step::run(&mut step, commands, begins);
        let found = step.found;
        new.pose = poses;
        ran.map_err(|error| error.at_step(self.steps + 1))?;
        self.has_lists = self.plan.model.makes_lists();
        Ok(found)
    }

    /// Makes the state that was tried the new state of the fluid.
    pub(crate) fn accept(&mut self) {
        let [a, b] = &mut self.memory.states;
        a.pass_on_constants(b, &self.plan.model);
        self.current = 1 - self.current;
    }
}
