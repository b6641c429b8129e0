//! What a scene asks for: the fluids, where they start, what holds and drives them, and which formulas move them.
//!
//! A scene is plain data in SI units. [`Scene::check`] says whether it can run; nothing else here is computed from it.
mod air;
mod choice;
mod elasticity;
mod fluid;
mod initial;
#[cfg(feature = "serde")]
mod list;
mod live;
mod model;
mod surroundings;
mod time;

pub use air::Air;
pub use choice::{
    DensityForm, Dimension, EquationOfState, Evaluation, FACES, Face, GridStructure, Integrator, Iteration, Kernel,
    NearPressure, PressureForce, PressureSolver, Reflection, SurfaceTension, Traversal, Viscosity, WallPressure,
};
pub use elasticity::{Elasticity, Plasticity};
pub use fluid::{Block, FLUIDS, Fluid};
pub use initial::InitialParticle;
pub use live::Adjustable;
pub use model::{Correction, Formulation, SupportRange};
pub use surroundings::{AccelerationField, Container, Grid, Periodic, WALLS, Wall, WallShape, Wind};
pub use time::AdaptiveTimeStep;

use crate::error::SceneError;
use glam::Vec3;
use heapless::Vec;

/// Blocks of fluid that a scene can have.
pub const BLOCKS: usize = 16;

/// A fluid and all that decides how it moves.
///
/// Lists have a fixed capacity ([`heapless::Vec`], re-exported as [`millpond_core::heapless`](crate::heapless)).
/// [`Scene::of`] fills in the defaults, so that only what differs needs to be written.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(deny_unknown_fields))]
pub struct Scene {
    /// Two or three dimensions. In 2D every z is 0 and masses are per metre of depth.
    pub dimension: Dimension,
    /// Distance between particles at the start, m. Smaller: finer, and at the same time step stiffer.
    pub particle_spacing: f32,
    /// Particles inside a support radius, itself counted (Pirovano, section 4.1.5; default 32). More: smoother and slower.
    #[cfg_attr(feature = "serde", serde(default = "default_average_neighbours"))]
    pub average_neighbours: f32,
    /// Time step, s; an adaptive one begins with it, or shorter. Too large against `spacing / speed_of_sound`, and the fluid
    /// explodes.
    pub time_step: f32,
    /// A time step that follows from the state (default: none, all steps are alike).
    #[cfg_attr(feature = "serde", serde(default))]
    pub adaptive: Option<AdaptiveTimeStep>,
    /// Share of the support that sound may cross in a step: given, speeds of sound are what the time step allows, the fastest
    /// fluid's `C H / time_step` and the others in proportion (Gourlay: stiffness for a wanted time step; default: none).
    #[cfg_attr(feature = "serde", serde(default))]
    pub stiffness_for_time_step: Option<f32>,
    /// Acceleration that acts everywhere, m/s2 (default none).
    #[cfg_attr(feature = "serde", serde(default))]
    pub gravity: Vec3,
    /// Density of what surrounds the fluid, kg/m3 (default 0): gravity then acts on the difference only (Gourlay's body force).
    #[cfg_attr(feature = "serde", serde(default))]
    pub ambient_density: f32,
    /// A wind, if any.
    #[cfg_attr(feature = "serde", serde(default))]
    pub wind: Option<Wind>,
    /// A field of accelerations that the host gives, if any (Pirovano, section 2.2.5).
    #[cfg_attr(feature = "serde", serde(default, alias = "field"))]
    pub acceleration_field: Option<AccelerationField>,
    /// What flows, one fluid at least. A scene file may also give a single fluid without the brackets of a list.
    #[cfg_attr(feature = "serde", serde(alias = "fluid", deserialize_with = "list::one_or_several"))]
    pub fluids: Vec<Fluid, FLUIDS>,
    /// Where the fluids are at the start.
    pub blocks: Vec<Block, BLOCKS>,
    /// The box that holds it, if any: planes that put particles back.
    #[cfg_attr(feature = "serde", serde(default))]
    pub container: Option<Container>,
    /// Walls made of particles.
    #[cfg_attr(feature = "serde", serde(default))]
    pub walls: Vec<Wall, WALLS>,
    /// Directions that wrap around, if any.
    #[cfg_attr(feature = "serde", serde(default))]
    pub periodic: Option<Periodic>,
    /// How particles of elastic fluids are joined.
    #[cfg_attr(feature = "serde", serde(default))]
    pub elasticity: Elasticity,
    /// A coat of air, if any.
    #[cfg_attr(feature = "serde", serde(default))]
    pub air: Option<Air>,
    /// Which formulas are used.
    #[cfg_attr(feature = "serde", serde(default))]
    pub model: Formulation,
    /// How neighbours are found.
    #[cfg_attr(feature = "serde", serde(default))]
    pub grid: Grid,
    /// Terms that are kept although their coefficient is 0, because it may be changed between steps (default none: what does nothing
    /// is left out, and costs nothing).
    #[cfg_attr(feature = "serde", serde(default, alias = "live"))]
    pub adjustable: Vec<Adjustable, { Adjustable::COUNT }>,
}

const AVERAGE_NEIGHBOURS: f32 = 32.0;

#[cfg(feature = "serde")]
fn default_average_neighbours() -> f32 {
    AVERAGE_NEIGHBOURS
}

/// Adds an item to a list of a scene.
fn push<T, const N: usize>(list: &mut Vec<T, N>, item: T, field: &'static str) -> Result<(), SceneError> {
    list.push(item).map_err(|_| SceneError::ListIsFull { field, capacity: N as u32 })
}

impl Scene {
    /// A scene of one block with everything else at its default: no gravity, no walls, the thesis' choices of formulas.
    #[must_use]
    pub fn of(dimension: Dimension, particle_spacing: f32, time_step: f32, fluid: Fluid, block: Block) -> Scene {
        Scene {
            dimension,
            particle_spacing,
            average_neighbours: AVERAGE_NEIGHBOURS,
            time_step,
            adaptive: None,
            stiffness_for_time_step: None,
            gravity: Vec3::ZERO,
            ambient_density: 0.0,
            wind: None,
            acceleration_field: None,
            fluids: [fluid].into_iter().collect(),
            blocks: [block].into_iter().collect(),
            container: None,
            walls: Vec::new(),
            periodic: None,
            elasticity: Elasticity::default(),
            air: None,
            model: Formulation::default(),
            grid: Grid::default(),
            adjustable: Vec::new(),
        }
    }

    /// Adds a fluid and returns its number, for [`Block::fluid`].
    ///
    /// # Errors
    /// [`SceneError::ListIsFull`] where the scene has [`FLUIDS`] fluids already.
    pub fn add_fluid(&mut self, fluid: Fluid) -> Result<u32, SceneError> {
        let number = self.fluids.len() as u32;
        push(&mut self.fluids, fluid, "fluids")?;
        Ok(number)
    }

    /// Adds a block of fluid.
    ///
    /// # Errors
    /// [`SceneError::ListIsFull`] where the scene has [`BLOCKS`] blocks already.
    pub fn add_block(&mut self, block: Block) -> Result<(), SceneError> {
        push(&mut self.blocks, block, "blocks")
    }

    /// Adds a wall of particles.
    ///
    /// # Errors
    /// [`SceneError::ListIsFull`] where the scene has [`WALLS`] walls already.
    pub fn add_wall(&mut self, wall: Wall) -> Result<(), SceneError> {
        push(&mut self.walls, wall, "walls")
    }

    /// A fluid by number. Where the scene has no fluid of that number, which [`Scene::check`] refuses, it is the first one.
    #[must_use]
    pub fn fluid_of(&self, number: u32) -> &Fluid {
        self.fluids.get(number as usize).unwrap_or_else(|| self.first_fluid())
    }

    /// Fluid 0, whose rest density is the unit of all densities inside the solver.
    #[must_use]
    pub fn first_fluid(&self) -> &Fluid {
        self.fluids.first().unwrap_or(&Fluid::WATER)
    }

    /// Axes that wrap around.
    pub(crate) fn periodic_axes(&self) -> impl Iterator<Item = usize> + use<> {
        let axes = self.periodic.map_or([false; 3], |periodic| periodic.axes);
        (0..self.dimension.count()).filter(move |&axis| axes[axis])
    }

    /// Is this face of the container there? Not where the scene leaves it open, nor along a periodic axis, nor across the
    /// plane in 2D.
    pub(crate) fn is_closed(&self, container: &Container, face: Face) -> bool {
        let axis = face.axis();
        axis < self.dimension.count()
            && !container.open.contains(&face)
            && !self.periodic_axes().any(|round| round == axis)
    }

    /// Particles that the coat of air can have: their ids come last.
    #[must_use]
    pub fn air_capacity(&self) -> usize {
        self.air.map_or(0, |air| air.capacity as usize)
    }

    /// How the pressure of one of its fluids follows from density.
    #[must_use]
    pub fn equation_of(&self, fluid: &Fluid) -> EquationOfState {
        if self.corrects_pressure() {
            // what the iterated pressure stands for is linear in the compression
            return EquationOfState::Linear;
        }
        fluid.equation_of_state.unwrap_or(self.model.equation_of_state)
    }

    /// Is pressure iterated?
    #[must_use]
    pub fn corrects_pressure(&self) -> bool {
        self.model.pressure_solver == PressureSolver::PressureCorrection
    }

    /// The longest step that there can be, s.
    #[must_use]
    pub fn longest_step(&self) -> f32 {
        self.adaptive.map_or(self.time_step, |adaptive| adaptive.largest)
    }
}
