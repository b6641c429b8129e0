//! What makes a scene impossible, said before anything is touched.
use super::{Dimension, GridStructure, Scene, lattice};
use crate::error::SceneError;
use crate::guided::{parameters, support_radius};

/// Most particles of a scene: an id shares a word with an axis or a quantity in an error report.
const MOST_PARTICLES: u64 = 1 << 30;

impl Scene {
    /// Refuses a scene that cannot run, naming the field and its value.
    ///
    /// # Errors
    /// The first [`SceneError`] found, fields in the order of their declaration.
    pub fn check(&self) -> Result<(), SceneError> {
        positive("particle_spacing", self.particle_spacing)?;
        positive("average_neighbours", self.average_neighbours)?;
        positive("time_step", self.time_step)?;
        finite("gravity", &self.gravity)?;
        self.check_fluid()?;
        self.check_blocks()?;
        self.check_container()?;
        self.check_grid()?;
        if self.dimension == Dimension::Two {
            let tilted = self.gravity[2] != 0.0 || self.blocks.iter().any(|b| b.velocity[2] != 0.0);
            if tilted {
                return Err(SceneError::OutOfPlane);
            }
        }
        // what follows from the fields must be a number too
        positive("particle_spacing", support_radius(self) as f32)?;
        let derived = parameters(self);
        positive("fluid.rest_density", derived.particle_mass)?;
        positive("fluid.speed_of_sound", derived.state_stiffness)?;
        finite("fluid.near_stiffness", &[derived.near_stiffness])?;
        let constants = [derived.density_constant, derived.pressure_constant, derived.near_constant];
        constants.iter().try_for_each(|constant| positive("particle_spacing", *constant))?;
        positive("particle_spacing", derived.viscosity_constant)
    }

    fn check_fluid(&self) -> Result<(), SceneError> {
        let fluid = &self.fluid;
        positive("fluid.rest_density", fluid.rest_density)?;
        positive("fluid.speed_of_sound", fluid.speed_of_sound)?;
        not_negative("fluid.dynamic_viscosity", fluid.dynamic_viscosity)?;
        not_negative("fluid.near_stiffness", fluid.near_stiffness.unwrap_or(0.0))
    }

    fn check_blocks(&self) -> Result<(), SceneError> {
        let mut particles = 0u64;
        for block in &self.blocks {
            finite("blocks.corner", &block.corner)?;
            finite("blocks.velocity", &block.velocity)?;
            not_negative("blocks.jitter", block.jitter)?;
            for &size in &block.size[..self.dimension.count()] {
                positive("blocks.size", size)?;
            }
            let [x, y, z] = lattice::counts(block, self);
            particles = particles.saturating_add(x.saturating_mul(y).saturating_mul(z));
        }
        check_count(particles)
    }

    fn check_container(&self) -> Result<(), SceneError> {
        let Some(container) = &self.container else { return Ok(()) };
        finite("container.low", &container.low)?;
        finite("container.high", &container.high)?;
        for axis in 0..self.dimension.count() {
            let (low, high) = (container.low[axis], container.high[axis]);
            if low >= high {
                return Err(SceneError::EmptyContainer { axis, low, high });
            }
        }
        share("container.bounce", container.bounce)?;
        share("container.slip", container.slip)
    }

    fn check_grid(&self) -> Result<(), SceneError> {
        for axis in 0..3 {
            let cells = self.grid.cells[axis];
            let layer = axis == 2 && self.dimension == Dimension::Two;
            if (layer && cells != 1) || (!layer && cells < 3) {
                return Err(SceneError::TooFewCells { axis, cells, layer });
            }
        }
        let total = self.grid.cells.iter().try_fold(1u32, |total, &cells| total.checked_mul(cells));
        let places = match self.grid.structure {
            GridStructure::IndexSort => 1,
            GridStructure::CellLists { places } => places,
        };
        if places == 0 {
            return Err(SceneError::NotPositive { field: "grid.structure.places", value: 0.0 });
        }
        if total.and_then(|total| total.checked_mul(places)).is_none_or(|total| total > i32::MAX as u32) {
            return Err(SceneError::TooManyCells { cells: self.grid.cells, places });
        }
        Ok(())
    }

    /// Particles of a scene that [`Scene::check`] accepts.
    #[must_use]
    pub fn particle_count(&self) -> usize {
        let count = |block| lattice::counts(block, self).iter().product::<u64>();
        self.blocks.iter().map(count).sum::<u64>() as usize
    }
}

/// Refuses more particles than a status word can name.
pub(crate) fn check_count(particles: u64) -> Result<(), SceneError> {
    if particles > MOST_PARTICLES {
        return Err(SceneError::TooManyParticles { particles, most: MOST_PARTICLES });
    }
    Ok(())
}

fn finite(field: &'static str, values: &[f32]) -> Result<(), SceneError> {
    match values.iter().find(|v| !v.is_finite()) {
        Some(&value) => Err(SceneError::NotFinite { field, value }),
        None => Ok(()),
    }
}

fn positive(field: &'static str, value: f32) -> Result<(), SceneError> {
    finite(field, &[value])?;
    if value > 0.0 { Ok(()) } else { Err(SceneError::NotPositive { field, value }) }
}

fn not_negative(field: &'static str, value: f32) -> Result<(), SceneError> {
    finite(field, &[value])?;
    if value >= 0.0 { Ok(()) } else { Err(SceneError::Negative { field, value }) }
}

fn share(field: &'static str, value: f32) -> Result<(), SceneError> {
    finite(field, &[value])?;
    if (0.0..=1.0).contains(&value) { Ok(()) } else { Err(SceneError::NotAShare { field, value }) }
}
