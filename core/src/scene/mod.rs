//! The scene: its fluids and where they start, the walls and forces that act on them, and the formulas of their motion.
//!
//! A scene is plain data in SI units. [`Scene::check`] returns whether it can run; everything that is derived from a
//! scene is computed elsewhere.
mod adjustable;
mod air;
mod choice;
mod container;
mod dimension;
mod elasticity;
mod emitter;
mod fluid;
mod formulas;
mod grid;
mod initial;
#[cfg(feature = "serde")]
mod list;
mod model;
mod recipe;
mod recovery;
mod solid;
mod surroundings;
mod time;

pub use adjustable::Adjustable;
pub use air::Air;
pub use choice::{
    DensityDiffusion, DensityForm, EquationOfState, Evaluation, Integrator, Iteration, Kernel, NearPressure,
    PressureForce, PressureSolver, Shifting, SurfaceTension, Viscosity, WallPressure,
};
pub use container::{Container, FACES, Face, PlaneModel, Reflection, Sliding};
pub use dimension::Dimension;
pub use elasticity::{Elasticity, Plasticity};
pub use emitter::{DRAINS, Drain, EMITTERS, Emitter, Opening};
pub use fluid::{Block, BlockShape, FLUIDS, Fluid};
pub use grid::{Grid, GridStructure, Traversal};
pub use initial::InitialParticle;
pub use model::{Correction, Formulation, SupportRange};
pub use recipe::Recipe;
pub use recovery::Recovery;
pub use solid::{CORNERS, Course, Motion, SOLIDS, Shape, Solid, SolidModel};
pub use surroundings::{AccelerationField, Periodic, WALLS, Wall, WallShape, Wind};
pub use time::AdaptiveTimeStep;

use crate::error::SceneError;
use glam::Vec3;
use heapless::Vec;

/// Largest number of blocks in a scene.
pub const BLOCKS: usize = 16;

/// Description of a simulation: fluids, surroundings and formulas.
///
/// Lists have a fixed capacity ([`heapless::Vec`], re-exported as [`millpond_core::heapless`](crate::heapless)).
/// [`Scene::of`] fills in the defaults, so you set only the fields that differ.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(deny_unknown_fields))]
pub struct Scene {
    /// Dimension of space, two or three. In 2D every z is 0 and masses are per metre of depth.
    pub dimension: Dimension,
    /// Distance between particles at the start, m, larger than 0. A smaller distance resolves more detail, and needs
    /// more particles and a shorter time step.
    pub particle_spacing: f32,
    /// Number of particles inside the support radius, including the particle itself (Pirovano, section 4.1.5; default
    /// `None`: 32 in 2D and 58 in 3D, [`Dimension::average_neighbours`]). More neighbours make the motion smoother and
    /// the step slower.
    #[cfg_attr(feature = "serde", serde(default))]
    pub average_neighbours: Option<f32>,
    /// Ratio of smoothing length to particle spacing, h/dx, as much of the literature gives it; the support radius is
    /// twice the smoothing length. It replaces `average_neighbours`, and a scene with both is rejected (default
    /// `None`).
    #[cfg_attr(feature = "serde", serde(default))]
    pub smoothing_ratio: Option<f32>,
    /// Time step, s, larger than 0. With an adaptive time step it is the upper bound of the first step. The fluid
    /// becomes unstable if the time step is too large compared with `particle_spacing / speed_of_sound`.
    pub time_step: f32,
    /// Adaptive time step, which follows from the state of the fluid (default `None`: all steps have the length
    /// `time_step`).
    #[cfg_attr(feature = "serde", serde(default))]
    pub adaptive: Option<AdaptiveTimeStep>,
    /// What happens if a step cannot be made (default: it is refused with an error).
    #[cfg_attr(feature = "serde", serde(default))]
    pub recovery: Recovery,
    /// Courant number C: the share of the support radius H that sound crosses in a step. If it is given, the speeds of
    /// sound are derived from the time step: that of the fastest fluid is `C H / time_step`, and those of the other
    /// fluids are in proportion (Gourlay; default `None`: the speeds of sound of the fluids). Use it to get the
    /// stiffest fluid that a given time step allows.
    #[cfg_attr(feature = "serde", serde(default))]
    pub stiffness_for_time_step: Option<f32>,
    /// Acceleration of gravity, m/s2 (default 0).
    #[cfg_attr(feature = "serde", serde(default))]
    pub gravity: Vec3,
    /// Density of the medium that surrounds the fluid, kg/m3, 0 or more (default 0). Gravity then acts on the
    /// difference between the two densities only (Gourlay's body force).
    #[cfg_attr(feature = "serde", serde(default))]
    pub ambient_density: f32,
    /// Wind (default none).
    #[cfg_attr(feature = "serde", serde(default))]
    pub wind: Option<Wind>,
    /// Lattice of an acceleration field supplied by the caller (Pirovano, section 2.2.5; default none).
    #[cfg_attr(feature = "serde", serde(default, alias = "field"))]
    pub acceleration_field: Option<AccelerationField>,
    /// The fluids, at least one. In a scene file a single fluid may be given without the brackets of a list.
    #[cfg_attr(feature = "serde", serde(alias = "fluid", deserialize_with = "list::one_or_several"))]
    pub fluids: Vec<Fluid, FLUIDS>,
    /// The blocks of fluid at the start.
    pub blocks: Vec<Block, BLOCKS>,
    /// Container of planes (default none).
    #[cfg_attr(feature = "serde", serde(default))]
    pub container: Option<Container>,
    /// Walls of fixed particles (default none).
    #[cfg_attr(feature = "serde", serde(default))]
    pub walls: Vec<Wall, WALLS>,
    /// Solids: obstacles and containers of any shape, at rest or in motion (default none).
    #[cfg_attr(feature = "serde", serde(default))]
    pub solids: Vec<Solid, SOLIDS>,
    /// Periodic domain (default none).
    #[cfg_attr(feature = "serde", serde(default))]
    pub periodic: Option<Periodic>,
    /// Springs between the particles of elastic fluids. Values other than the default need a fluid with an elastic
    /// stiffness.
    #[cfg_attr(feature = "serde", serde(default))]
    pub elasticity: Elasticity,
    /// Layer of air around the liquid (default none).
    #[cfg_attr(feature = "serde", serde(default))]
    pub air: Option<Air>,
    /// Emitters, which make particles during the run (default none).
    #[cfg_attr(feature = "serde", serde(default))]
    pub emitters: Vec<Emitter, EMITTERS>,
    /// Drains, which take fluid particles out of the scene (default none).
    #[cfg_attr(feature = "serde", serde(default))]
    pub drains: Vec<Drain, DRAINS>,
    /// Number of particles that are inactive at the start, for emitters and
    /// [`Solver::spawn`](crate::Solver::spawn) to use (default 0). If none is left, a particle
    /// is not made, and is counted in [`Flux::refused`](crate::Flux::refused). Particles that a drain has taken, or
    /// whose life has ended, can be used again. Inactive ones take memory, but hardly any time.
    #[cfg_attr(feature = "serde", serde(default))]
    pub spare_particles: u32,
    /// The formulas and their coefficients.
    #[cfg_attr(feature = "serde", serde(default))]
    pub model: Formulation,
    /// Grid of the neighbour search.
    #[cfg_attr(feature = "serde", serde(default))]
    pub grid: Grid,
    /// Terms that are kept although their coefficient is 0, so that it can be changed between steps (default none:
    /// terms with coefficient 0 are left out and cost nothing).
    #[cfg_attr(feature = "serde", serde(default, alias = "live"))]
    pub adjustable: Vec<Adjustable, { Adjustable::COUNT }>,
}

/// Adds an item to a list of a scene; `field` names the list in the error.
fn push<T, const N: usize>(list: &mut Vec<T, N>, item: T, field: &'static str) -> Result<(), SceneError> {
    list.push(item).map_err(|_| SceneError::ListIsFull { field: field.into(), capacity: N as u32 })
}

impl Scene {
    /// Returns a scene with one block and defaults for everything else: no gravity, no walls, and the formulas for a
    /// free surface ([`Recipe::FreeSurface`]).
    #[must_use]
    pub fn of(dimension: Dimension, particle_spacing: f32, time_step: f32, fluid: Fluid, block: Block) -> Scene {
        Scene {
            dimension,
            particle_spacing,
            average_neighbours: None,
            smoothing_ratio: None,
            time_step,
            adaptive: None,
            recovery: Recovery::default(),
            stiffness_for_time_step: None,
            gravity: Vec3::ZERO,
            ambient_density: 0.0,
            wind: None,
            acceleration_field: None,
            fluids: [fluid].into_iter().collect(),
            blocks: [block].into_iter().collect(),
            container: None,
            walls: Vec::new(),
            solids: Vec::new(),
            periodic: None,
            elasticity: Elasticity::default(),
            air: None,
            emitters: Vec::new(),
            drains: Vec::new(),
            spare_particles: 0,
            model: Formulation::default(),
            grid: Grid::default(),
            adjustable: Vec::new(),
        }
    }

    /// Adds a fluid and returns its index, which [`Block::fluid`] refers to.
    ///
    /// # Errors
    /// [`SceneError::ListIsFull`] if the scene already has [`FLUIDS`] fluids.
    pub fn add_fluid(&mut self, fluid: Fluid) -> Result<u32, SceneError> {
        let number = self.fluids.len() as u32;
        push(&mut self.fluids, fluid, "fluids")?;
        Ok(number)
    }

    /// Adds a block of fluid.
    ///
    /// # Errors
    /// [`SceneError::ListIsFull`] if the scene already has [`BLOCKS`] blocks.
    pub fn add_block(&mut self, block: Block) -> Result<(), SceneError> {
        push(&mut self.blocks, block, "blocks")
    }

    /// Adds a wall of particles.
    ///
    /// # Errors
    /// [`SceneError::ListIsFull`] if the scene already has [`WALLS`] walls.
    pub fn add_wall(&mut self, wall: Wall) -> Result<(), SceneError> {
        push(&mut self.walls, wall, "walls")
    }

    /// Adds a solid.
    ///
    /// # Errors
    /// [`SceneError::ListIsFull`] if the scene already has [`SOLIDS`] solids.
    pub fn add_solid(&mut self, solid: Solid) -> Result<(), SceneError> {
        push(&mut self.solids, solid, "solids")
    }

    /// Returns the fluid with the given index, or the first fluid if no fluid has this index. [`Scene::check`] rejects
    /// a scene that refers to such an index.
    #[must_use]
    pub fn fluid_of(&self, number: u32) -> &Fluid {
        self.fluids.get(number as usize).unwrap_or_else(|| self.first_fluid())
    }

    /// Returns fluid 0. Its rest density is the unit of all densities inside the solver.
    #[must_use]
    pub fn first_fluid(&self) -> &Fluid {
        self.fluids.first().unwrap_or(&Fluid::WATER)
    }

    /// The periodic axes.
    pub(crate) fn periodic_axes(&self) -> impl Iterator<Item = usize> + use<> {
        let axes = self.periodic.map_or([false; 3], |periodic| periodic.axes);
        (0..self.dimension.count()).filter(move |&axis| axes[axis])
    }

    /// Returns whether this face of the container has a plane. It has none if the scene leaves it open, if its
    /// axis is periodic, or if it is perpendicular to z in 2D.
    pub(crate) fn is_closed(&self, container: &Container, face: Face) -> bool {
        let axis = face.axis();
        axis < self.dimension.count()
            && !container.open.contains(&face)
            && !self.periodic_axes().any(|round| round == axis)
    }

    /// Returns whether the planes of the container, or some solids, are walls in closed form.
    pub(crate) fn has_closed_walls(&self) -> bool {
        self.has_closed_container() || self.solids.iter().any(|solid| solid.model == SolidModel::ClosedForm)
    }

    /// Returns whether there are wall particles: of walls or of solids.
    pub(crate) fn has_wall_particles(&self) -> bool {
        !self.walls.is_empty() || self.solids.iter().any(|solid| solid.model == SolidModel::Particles)
    }

    /// Returns whether the planes of the container are walls in closed form.
    pub(crate) fn has_closed_container(&self) -> bool {
        self.container.as_ref().is_some_and(|container| container.model == PlaneModel::ClosedForm)
    }

    /// Number of particles that are inactive at the start: for the layer of air, and for emitters. They have the last
    /// ids.
    #[must_use]
    pub fn inactive_at_start(&self) -> usize {
        self.air.map_or(0, |air| air.capacity as usize).saturating_add(self.spare_particles as usize)
    }

    /// Returns whether particles come and go by emitters, drains or the host.
    pub(crate) fn has_turnover(&self) -> bool {
        !self.emitters.is_empty() || !self.drains.is_empty() || self.spare_particles > 0
    }

    /// Returns whether particles can be inactive.
    pub(crate) fn has_inactive(&self) -> bool {
        self.air.is_some() || self.has_turnover()
    }

    /// Returns the equation of state of one of the scene's fluids.
    #[must_use]
    pub fn equation_of(&self, fluid: &Fluid) -> EquationOfState {
        if self.corrects_pressure() {
            // the pressure that the correction iterates is linear in the compression
            return EquationOfState::Linear;
        }
        fluid.equation_of_state.unwrap_or(self.model.equation_of_state)
    }

    /// Returns whether pressure is found by pressure correction.
    #[must_use]
    pub fn corrects_pressure(&self) -> bool {
        self.model.pressure_solver == PressureSolver::PressureCorrection
    }

    /// Returns how the time step changes, or `None` if it is fixed. It changes if it is adaptive, or if a step that
    /// cannot be made is shortened.
    pub(crate) fn changing_step(&self) -> Option<AdaptiveTimeStep> {
        let only_shortened = || AdaptiveTimeStep::constant(self.time_step);
        self.adaptive.or_else(|| (self.recovery != Recovery::Refuse).then(only_shortened))
    }

    /// Longest possible time step, s.
    #[must_use]
    pub fn longest_step(&self) -> f32 {
        self.adaptive.map_or(self.time_step, |adaptive| adaptive.largest)
    }
}
