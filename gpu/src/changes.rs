//! Changes between two steps, as on the CPU: the acceleration field, and what else of a scene can change while it runs.
use crate::buffers::{Buffers, read};
use crate::error::GpuError;
use crate::solver::GpuSolver;
use core::mem::offset_of;
use millpond_core::backend::arithmetic::real::{div, vec3};
use millpond_core::backend::layout::{StepUniform, f32x4};
use millpond_core::backend::live::Change;
use millpond_core::backend::plan::arrays::Side;
use millpond_core::backend::terms::integrate::history_rescaled;
use millpond_core::glam::Vec3;
use millpond_core::scene::Wind;
use millpond_core::{Array, SceneError, SolidState};

impl GpuSolver {
    /// Sets the acceleration field supplied by the caller, from the next step on, as
    /// [`Solver::set_acceleration_field`](millpond_core::Solver::set_acceleration_field) does.
    ///
    /// # Errors
    /// [`SceneError::WrongLength`] if the scene has fewer or more nodes, [`SceneError::NotFinite`] for a value that is
    /// not finite, and [`GpuError::BeforeFirstStep`] before the first step of the fluid. The field stays as it was.
    pub fn set_acceleration_field(&mut self, points: &[f32x4]) -> Result<(), GpuError> {
        let (given, expected) = (points.len(), self.buffers.counts().field_nodes);
        if given != expected {
            return Err(
                SceneError::WrongLength { call: "set_acceleration_field", what: "points", given, expected }.into()
            );
        }
        if let Some(&value) = points.as_flattened().iter().find(|x| !x.is_finite()) {
            return Err(SceneError::NotFinite { field: "acceleration_field".into(), value }.into());
        }
        if expected > 0 {
            self.has_begun("set_acceleration_field")?;
            let field = self.buffers.array(Array::acceleration_field, Side::Only, 0);
            self.gpu.queue.write_buffer(field, 0, bytemuck::cast_slice(points));
        }
        Ok(())
    }

    /// Sets the acceleration of gravity, m/s2, from the next step on, as
    /// [`Solver::set_gravity`](millpond_core::Solver::set_gravity) does.
    ///
    /// # Errors
    /// Those of [`Solver::set_gravity`](millpond_core::Solver::set_gravity); also [`GpuError::BeforeFirstStep`] before
    /// the first step of the fluid: make the change on the CPU solver instead. The fluid stays as it was.
    pub fn set_gravity(&mut self, gravity: impl Into<Vec3>) -> Result<(), GpuError> {
        self.change("set_gravity", Change::Gravity(gravity.into()))
    }

    /// Sets the wind from the next step on, as [`Solver::set_wind`](millpond_core::Solver::set_wind) does.
    ///
    /// # Errors
    /// Those of [`Solver::set_wind`](millpond_core::Solver::set_wind) and [`GpuSolver::set_gravity`].
    pub fn set_wind(&mut self, wind: Option<Wind>) -> Result<(), GpuError> {
        self.change("set_wind", Change::Wind(wind))
    }

    /// Sets the time step, s, from the next step on, as [`Solver::set_time_step`](millpond_core::Solver::set_time_step)
    /// does.
    ///
    /// # Errors
    /// Those of [`Solver::set_time_step`](millpond_core::Solver::set_time_step) and [`GpuSolver::set_gravity`].
    pub fn set_time_step(&mut self, time_step: f32) -> Result<(), GpuError> {
        self.change("set_time_step", Change::TimeStep(time_step))
    }

    /// Sets the dynamic viscosity, Pa s, of a fluid from the next step on, as
    /// [`Solver::set_viscosity`](millpond_core::Solver::set_viscosity) does.
    ///
    /// # Errors
    /// Those of [`Solver::set_viscosity`](millpond_core::Solver::set_viscosity) and [`GpuSolver::set_gravity`].
    pub fn set_viscosity(&mut self, fluid: u32, viscosity: f32) -> Result<(), GpuError> {
        self.change("set_viscosity", Change::Viscosity(fluid, viscosity))
    }

    /// Sets the coefficient of surface tension of a fluid from the next step on, as
    /// [`Solver::set_surface_tension`](millpond_core::Solver::set_surface_tension) does.
    ///
    /// # Errors
    /// Those of [`Solver::set_surface_tension`](millpond_core::Solver::set_surface_tension) and
    /// [`GpuSolver::set_gravity`].
    pub fn set_surface_tension(&mut self, fluid: u32, tension: f32) -> Result<(), GpuError> {
        self.change("set_surface_tension", Change::SurfaceTension(fluid, tension))
    }

    /// Sets the speed of sound, m/s, of a fluid from the next step on, as
    /// [`Solver::set_speed_of_sound`](millpond_core::Solver::set_speed_of_sound) does.
    ///
    /// # Errors
    /// Those of [`Solver::set_speed_of_sound`](millpond_core::Solver::set_speed_of_sound) and
    /// [`GpuSolver::set_gravity`].
    pub fn set_speed_of_sound(&mut self, fluid: u32, speed: f32) -> Result<(), GpuError> {
        self.change("set_speed_of_sound", Change::SpeedOfSound(fluid, speed))
    }

    /// Sets the constant B of Tait's equation, Pa, of a fluid from the next step on, as
    /// [`Solver::set_stiffness`](millpond_core::Solver::set_stiffness) does.
    ///
    /// # Errors
    /// Those of [`Solver::set_stiffness`](millpond_core::Solver::set_stiffness) and [`GpuSolver::set_gravity`].
    pub fn set_stiffness(&mut self, fluid: u32, stiffness: f32) -> Result<(), GpuError> {
        self.change("set_stiffness", Change::Stiffness(fluid, stiffness))
    }

    /// Sets where a solid is and how fast it moves, from the next step on, as
    /// [`Solver::move_solid`](millpond_core::Solver::move_solid) does.
    ///
    /// # Errors
    /// Those of [`Solver::move_solid`](millpond_core::Solver::move_solid), as [`GpuError::Solid`]; also
    /// [`GpuError::BeforeFirstStep`] before the first step of the fluid: make the change on the CPU solver instead.
    pub fn move_solid(&mut self, solid: usize, to: SolidState) -> Result<(), GpuError> {
        let rows = to.to_rows(self.buffers.model(), &self.parameters, solid)?;
        self.has_begun("move_solid")?;
        let poses = self.buffers.array(Array::pose, Side::Old, self.current());
        let offset = (solid * size_of_val(&rows)) as u64;
        self.gpu.queue.write_buffer(poses, offset, bytemuck::cast_slice(&rows));
        Ok(())
    }

    /// Rejects a call before the first step. That step begins with accelerations that the CPU evaluated, so the change
    /// must be made on the CPU solver.
    fn has_begun(&self, call: &'static str) -> Result<(), GpuError> {
        if self.steps() == 0 { Err(GpuError::BeforeFirstStep { call }) } else { Ok(()) }
    }

    fn change(&mut self, call: &'static str, change: Change) -> Result<(), GpuError> {
        let (live, next) = self.live.changed(change)?;
        self.has_begun(call)?;
        let mut uniform = next.step;
        if matches!(change, Change::TimeStep(_)) {
            let times = div(uniform.time_step, self.uniform.time_step);
            self.rescale_history(times)?;
            self.steady = self.steady.changed(self.steps(), self.uniform.time_step);
        } else {
            let StepUniform { gravity, wind, .. } = next.step;
            uniform = StepUniform { gravity, wind, ..self.uniform };
        }
        self.live = live;
        self.uniform = uniform;
        let Buffers { parameters, materials, step, .. } = &self.buffers;
        let queue = &self.gpu.queue;
        queue.write_buffer(parameters, 0, bytemuck::bytes_of(&next.parameters));
        queue.write_buffer(materials, 0, bytemuck::bytes_of(&next.materials));
        // with steps of changing length, the device itself writes the time step
        let bytes = bytemuck::bytes_of(&uniform);
        let fixed =
            if self.has_changing_step() { offset_of!(StepUniform, time_step) } else { size_of::<StepUniform>() };
        queue.write_buffer(step, 0, &bytes[..fixed]);
        Ok(())
    }

    /// Rescales the history of the integrator for a time step that is `times` as long as the last one.
    fn rescale_history(&self, times: f32) -> Result<(), GpuError> {
        let words = self.buffers.words(Array::history);
        if words == 0 {
            return Ok(());
        }
        let buffer = self.buffers.array(Array::history, Side::Old, self.current());
        let mut history: Vec<f32x4> = read(&self.gpu, buffer, words / 4)?;
        for entry in &mut history {
            let vec3 { x, y, z } = history_rescaled::<f32>(self.buffers.model(), vec3::splat(*entry), times);
            *entry = [x, y, z, 0.0];
        }
        self.gpu.queue.write_buffer(buffer, 0, bytemuck::cast_slice(&history));
        Ok(())
    }
}
