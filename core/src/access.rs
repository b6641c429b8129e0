//! Reading a solver: its state, its clock, its constants, and what the other files of core change in it.
use crate::arithmetic::level::Simd;
use crate::clock::{SteadyTime, TimeReport, set_step};
use crate::hash::{full_state_hash, state_hash};
use crate::layout::{Materials, Parameters, Status, StepUniform, f32x4, u32x2};
use crate::live::{Constants, LiveScene};
use crate::memory::{Requirements, State};
use crate::plan::Plan;
use crate::plan::arrays::{Array, Class};
use crate::record::{CorrectionReport, Record};
use crate::solver::Solver;

impl<'m> Solver<'m> {
    /// Simulated time as a function of the number of steps, in scenes with a fixed time step.
    #[must_use]
    pub fn steady_time(&self) -> SteadyTime {
        self.steady
    }

    /// The scene with the values that it has now, after all changes between steps.
    #[must_use]
    pub fn live(&self) -> &LiveScene {
        &self.live
    }

    /// The current state, as it lies in memory. Particles are sorted by the cells in which they were when forces were
    /// evaluated. Penalty planes and some integrators move particles once more after that. To read single particles in
    /// order of their ids use [`Solver::particles`].
    #[must_use]
    pub fn state(&self) -> &State<'m> {
        &self.memory.states[self.current]
    }

    pub(crate) fn state_mut(&mut self) -> &mut State<'m> {
        &mut self.memory.states[self.current]
    }

    pub(crate) fn current_index(&self) -> usize {
        self.current
    }

    /// Slot of each particle in the arrays of [`Solver::state`], by id.
    #[must_use]
    pub fn slots(&self) -> &[u32] {
        self.state().slot_of_id
    }

    /// The spring ends of the current state: for each the id of the particle at the other end, and the rest length in m
    /// as the bits of an f32, negative once the spring is broken. Empty in scenes without elastic fluids.
    #[must_use]
    pub fn spring_ends(&self) -> &[u32x2] {
        self.state().spring_ends
    }

    /// Takes the spring ends of the current state and of the other state out of the solver, to be filled and put back.
    /// Those of the other state are empty if springs do not change, because there is only one copy then.
    pub(crate) fn take_spring_ends(&mut self) -> [&'m mut [u32x2]; 2] {
        let [a, b] = &mut self.memory.states;
        let (now, other) = if self.current == 0 { (a, b) } else { (b, a) };
        [now, other].map(|state| core::mem::take(&mut state.spring_ends))
    }

    pub(crate) fn put_spring_ends(&mut self, [own, others]: [&'m mut [u32x2]; 2]) {
        let current = self.current;
        (self.memory.states[current].spring_ends, self.memory.states[1 - current].spring_ends) = (own, others);
    }

    /// An array of the current state, or an array that steps only read, as words of four bytes. Empty for any other
    /// array, and for one that the scene does not need.
    #[must_use]
    pub fn words(&self, array: Array) -> &[u32] {
        if array.class() == Class::Given { self.memory.given.words(array) } else { self.state().words(array) }
    }

    /// Result of the pressure correction; all zero with an equation of state.
    #[must_use]
    pub fn correction(&self) -> CorrectionReport {
        self.correction
    }

    /// Nodes of the acceleration field supplied by the caller, m/s2, x fastest; the fourth numbers are unused. Empty in
    /// scenes without such a field.
    #[must_use]
    pub fn acceleration_field(&self) -> &[f32x4] {
        self.memory.given.acceleration_field
    }

    /// Hash of all positions and velocities. Equal bits have equal hashes, and for practical purposes different bits
    /// have different ones. Use it to compare runs.
    #[must_use]
    pub fn hash(&self) -> u64 {
        let state = self.state();
        state_hash(state.slot_of_id, state.position, state.velocity)
    }

    /// Hash of every array of the current state, including the history of the integrator, the spring ends, the emitters and
    /// the poses of solids.
    #[must_use]
    pub fn full_hash(&self) -> u64 {
        let s = self.state();
        let arrays: [&[f32x4]; 9] = [
            s.position,
            s.velocity,
            s.acceleration,
            s.density_pressure,
            s.drift_velocity,
            s.internal_energy,
            s.normal,
            s.history,
            s.life,
        ];
        full_state_hash(s.slot_of_id, &arrays, s.spring_ends, &[s.emitter_state, s.pose])
    }

    /// Number of steps made.
    #[must_use]
    pub fn steps(&self) -> u64 {
        self.steps
    }

    /// Simulated time, s.
    #[must_use]
    pub fn time(&self) -> f64 {
        if self.plan.model.has_changing_step == 1 {
            return self.clock.report(&self.constants.step).time;
        }
        self.steady.after(self.steps, self.constants.step.time_step)
    }

    /// Report on the time step: simulated time, the last and the next time step, and how many steps were rejected or
    /// shortened.
    #[must_use]
    pub fn time_report(&self) -> TimeReport {
        TimeReport { time: self.time(), ..self.clock.report(&self.constants.step) }
    }

    /// Time up to which [`Solver::advance`] was asked to advance the fluid, s.
    #[doc(hidden)]
    #[must_use]
    pub fn due(&self) -> f64 {
        self.due
    }

    /// Sets the length of the next step, s, in scenes with an adaptive time step.
    pub(crate) fn set_next_step(&mut self, step: f32) {
        set_step(&mut self.constants.step, step);
    }

    /// Writes the state of the clock into the status from which a GPU continues.
    pub fn fill_status(&self, status: &mut Status) {
        self.clock.fill(&self.constants.step, status);
    }

    /// Fingerprint of the scene and its plan. Saved bytes contain it, so that those of another scene are recognised.
    #[must_use]
    pub fn fingerprint(&self) -> u64 {
        self.fingerprint
    }

    /// An array of the current state, or an array that steps only read, as mutable words of four bytes.
    pub(crate) fn words_mut(&mut self, array: Array) -> &mut [u32] {
        if array.class() == Class::Given {
            self.memory.given.words_mut(array)
        } else {
            self.memory.states[self.current].words_mut(array)
        }
    }

    /// Sets the ids and slots of particles that lie in the order of their ids: particle `i` in slot `i`.
    pub(crate) fn number_in_order(&mut self) {
        let state = &mut self.memory.states[self.current];
        for (id, (slot, slot_of_id)) in (0..).zip(state.id.iter_mut().zip(state.slot_of_id.iter_mut())) {
            (*slot, *slot_of_id) = (id, id);
        }
    }

    /// Continues with these constants, and with the counters of a saved record.
    pub(crate) fn continue_from(&mut self, live: LiveScene, constants: &Constants, record: &Record) {
        (self.live, self.constants) = (live, *constants);
        (self.steps, self.steady, self.correction) = (record.steps, record.steady, record.correction);
        self.due = record.due;
    }

    /// The arrays that the solver uses, and the memory that they need.
    #[must_use]
    pub fn requirements(&self) -> &Requirements {
        &self.requirements
    }

    /// The plan: the arrays, passes and terms of a step.
    #[must_use]
    pub fn plan(&self) -> &Plan {
        &self.plan
    }

    /// The constants of the scene.
    #[must_use]
    pub fn parameters(&self) -> &Parameters {
        &self.constants.parameters
    }

    /// The constants of the materials.
    #[must_use]
    pub fn materials(&self) -> &Materials {
        &self.constants.materials
    }

    /// The numbers of the next step: its length, its number, gravity and wind.
    #[must_use]
    pub fn uniform(&self) -> &StepUniform {
        &self.constants.step
    }

    /// The SIMD level that the solver uses.
    #[must_use]
    pub fn simd(&self) -> Simd {
        self.simd
    }
}
