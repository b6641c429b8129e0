//! What makes a scene impossible, said before anything is touched.
use super::{Container, Dimension, Face, GridStructure, Scene, lattice};
use crate::error::SceneError;
use crate::guided::parameters;

/// Most particles of a scene: an id shares a word with an axis or a quantity in an error report.
const MOST_PARTICLES: u64 = (1 << 30) - 1;

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
        let derived = parameters(self);
        let scale = |field, value, derived: &[f32]| {
            let fine = derived.iter().all(|d| d.is_finite() && *d > 0.0);
            if fine { Ok(()) } else { Err(SceneError::OutOfScale { field, value }) }
        };
        scale("fluid.speed_of_sound", self.fluid.speed_of_sound, &[derived.state_stiffness])?;
        if self.model.near_pressure && self.fluid.near_stiffness.is_none() {
            scale("fluid.speed_of_sound", self.fluid.speed_of_sound, &[derived.near_stiffness])?;
        }
        scale("fluid.rest_density", self.fluid.rest_density, &[derived.particle_mass, derived.density_constant])?;
        let of_length = [
            derived.inverse_cell,
            derived.inverse_support_squared,
            derived.pressure_constant,
            derived.near_constant,
            derived.viscosity_constant,
        ];
        scale("particle_spacing", self.particle_spacing, &of_length)
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
        for (block, b) in self.blocks.iter().enumerate() {
            finite("blocks.corner", &b.corner)?;
            finite("blocks.velocity", &b.velocity)?;
            not_negative("blocks.jitter", b.jitter)?;
            let counts = lattice::counts(b, self);
            for (axis, (&size, count)) in b.size.iter().zip(counts).enumerate().take(self.dimension.count()) {
                positive("blocks.size", size)?;
                if count == 0 {
                    return Err(SceneError::EmptyBlock { block, axis, size });
                }
            }
            particles = particles.saturating_add(counts.iter().fold(1, |all, &n| all.saturating_mul(n)));
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
        share("container.slip", container.slip)?;
        self.check_blocks_inside(container)
    }

    /// A block that reaches through a closed wall would be crushed onto it by the first step.
    fn check_blocks_inside(&self, container: &Container) -> Result<(), SceneError> {
        // sizes are rounded to whole particles, and ends computed in f32
        let slack = 0.51 * self.particle_spacing;
        for (block, b) in self.blocks.iter().enumerate() {
            for axis in 0..self.dimension.count() {
                let [low_face, high_face] = [Face::ALL[2 * axis], Face::ALL[2 * axis + 1]];
                let below = container.low[axis] - b.corner[axis];
                let above = b.corner[axis] + b.size[axis] - container.high[axis];
                for (face, by) in [(low_face, below), (high_face, above)] {
                    if by > slack && !container.open.contains(&face) {
                        return Err(SceneError::BlockOutside { block, axis, by });
                    }
                }
            }
        }
        Ok(())
    }

    fn check_grid(&self) -> Result<(), SceneError> {
        for axis in 0..self.dimension.count() {
            let cells = self.grid.cells[axis];
            if cells < 3 {
                return Err(SceneError::TooFewCells { axis, cells });
            }
        }
        let total = self.cells().iter().try_fold(1u32, |total, &cells| total.checked_mul(cells));
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

    /// Cells along x, y, z: those of `grid`, and in 2D one along z.
    #[must_use]
    pub fn cells(&self) -> [u32; 3] {
        let [x, y, z] = self.grid.cells;
        [x, y, if self.dimension == Dimension::Two { 1 } else { z }]
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
