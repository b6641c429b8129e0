//! What makes a scene impossible, said before anything is touched.
use super::{Container, EquationOfState, Face, Fluid, GridStructure, Scene, WallShape, lattice, walls};
use crate::error::{Axis, SceneError};
use crate::guided::{average_neighbours, parameters, support_radius};
use crate::kinds::{near_stiffness, spring_pull};
use crate::lattice_sums::MOST_SPACINGS;

/// Most particles of a scene: an id shares a word with an axis or a quantity in an error report.
const MOST_PARTICLES: u64 = (1 << 30) - 1;

/// How far from the origin a block may start, in particle spacings: there f32 still tells 128 places apart between a particle and
/// the next.
pub const MOST_SPACINGS_AWAY: f32 = 65_536.0;

/// Most nodes of a host's field: 64 MiB.
const MOST_NODES: u32 = 1 << 22;

/// Name of a field of a fluid.
macro_rules! field {
    ($number:expr, $name:literal) => {
        if $number == 0 { concat!("fluid.", $name) } else { concat!("other_fluids.", $name) }
    };
}

impl Scene {
    /// Refuses a scene that cannot run, naming the field and its value.
    ///
    /// # Errors
    /// The first [`SceneError`] found, fields in the order of their declaration.
    pub fn check(&self) -> Result<(), SceneError> {
        positive("particle_spacing", self.particle_spacing)?;
        neighbours("average_neighbours", self.average_neighbours)?;
        positive("time_step", self.time_step)?;
        self.check_time()?;
        finite("gravity", &self.gravity)?;
        self.check_surroundings()?;
        (0..).zip(self.fluids()).try_for_each(check_fluid)?;
        let reach = support_radius(self) / f64::from(self.particle_spacing);
        let sums = self.model.calibrated_mass || self.model.equation_of_state == EquationOfState::PressureCorrection;
        let elastic = self.fluids().any(|fluid| fluid.elastic_stiffness > 0.0);
        if (sums || elastic || !self.walls.is_empty()) && reach > MOST_SPACINGS {
            return Err(SceneError::OutOfScale { field: "average_neighbours", value: average_neighbours(self) });
        }
        self.check_surface()?;
        self.check_elasticity()?;
        self.check_blocks()?;
        self.check_container()?;
        self.check_periodic()?;
        self.check_grid()?;
        self.check_walls()?;
        self.check_plane()?;
        self.check_combinations()?;
        // what follows from the fields must be a number too
        let derived = parameters(self);
        let scale = |field, value, derived: &[f32]| {
            let fine = derived.iter().all(|d| d.is_finite() && *d > 0.0);
            if fine { Ok(()) } else { Err(SceneError::OutOfScale { field, value }) }
        };
        for (number, fluid) in self.fluids().enumerate() {
            let [state, near, ..] = derived.states[number];
            let [thinning, offset, compressibility, _] = derived.corrections[number];
            let correction = thinning * self.time_step * self.time_step + offset;
            scale(field!(number, "speed_of_sound"), fluid.speed_of_sound, &[state, compressibility])?;
            if !near.is_finite() || (near == 0.0 && near_stiffness(self, fluid) > 0.0) {
                let (field, value) = match fluid.near_stiffness {
                    Some(stiffness) => (field!(number, "near_stiffness"), stiffness),
                    None => (field!(number, "speed_of_sound"), fluid.speed_of_sound),
                };
                return Err(SceneError::OutOfScale { field, value });
            }
            scale("time_step", self.time_step, &[correction, 1.0 / correction])?;
            scale(field!(number, "rest_density"), fluid.rest_density, &[derived.species[number][2]])?;
            if fluid.elastic_stiffness > 0.0 {
                let pull = spring_pull(self, fluid) as f32;
                scale(field!(number, "elastic_stiffness"), fluid.elastic_stiffness, &[pull])?;
            }
        }
        scale("time_step", self.time_step, &[derived.inverse_time_step])?;
        scale("fluid.rest_density", self.fluid.rest_density, &[derived.particle_mass])?;
        let of_length = [
            derived.density_constant,
            derived.inverse_cell[0],
            derived.inverse_support_squared,
            derived.continuity_constant,
            derived.pressure_constant,
            derived.near_constant,
            derived.viscosity_laplacian_constant,
        ];
        scale("particle_spacing", self.particle_spacing, &of_length)
    }

    fn check_surroundings(&self) -> Result<(), SceneError> {
        not_negative("ambient_density", self.ambient_density)?;
        if let Some(wind) = &self.wind {
            finite("wind.velocity", &wind.velocity)?;
            not_negative("wind.drag", wind.drag)?;
        }
        if let Some(field) = &self.field {
            finite("field.low", &field.low)?;
            positive("field.spacing", field.spacing)?;
            finite("field.spacing", &[1.0 / field.spacing])?;
            for (axis, &nodes) in field.counts.iter().enumerate().take(self.dimension.count()) {
                if nodes < 2 {
                    return Err(SceneError::TooFewNodes { axis: Axis::of(axis), nodes });
                }
            }
            let nodes = self.field_counts()[3];
            if nodes > MOST_NODES {
                let (value, least, most) =
                    (nodes as f32, 2u32.pow(self.dimension.count() as u32) as f32, MOST_NODES as f32);
                return Err(SceneError::OutOfBounds { field: "field.counts (multiplied)", value, least, most });
            }
        }
        Ok(())
    }

    fn check_surface(&self) -> Result<(), SceneError> {
        positive("model.surface_threshold", self.model.surface_threshold)?;
        let Some(air) = &self.air else { return Ok(()) };
        known_fluid(self, "air.fluid", air.fluid)?;
        positive("air.capacity", air.capacity as f32)?;
        positive("air.threshold", air.threshold)?;
        share("air.minimum_density", air.minimum_density)
    }

    fn check_elasticity(&self) -> Result<(), SceneError> {
        let elasticity = &self.elasticity;
        positive("elasticity.reach", elasticity.reach)?;
        if let Some(plasticity) = elasticity.plasticity {
            positive("elasticity.plasticity.rate", plasticity.rate)?;
            not_negative("elasticity.plasticity.yield_strain", plasticity.yield_strain)?;
            // a length that gave way by more than all of the strain would turn round
            let most = 1.0 / self.longest_step();
            if plasticity.rate > most {
                let (field, value) = ("elasticity.plasticity.rate", plasticity.rate);
                return Err(SceneError::OutOfBounds { field, value, least: 0.0, most });
            }
        }
        match elasticity.break_at {
            Some(stretch) => positive("elasticity.break_at", stretch),
            None => Ok(()),
        }
    }

    fn check_blocks(&self) -> Result<(), SceneError> {
        let mut particles = 0u64;
        for (block, b) in self.blocks.iter().enumerate() {
            finite("blocks.corner", &b.corner)?;
            finite("blocks.velocity", &b.velocity)?;
            not_negative("blocks.jitter", b.jitter)?;
            not_negative("blocks.dynamic_viscosity", b.dynamic_viscosity.unwrap_or(0.0))?;
            known_fluid(self, "blocks.fluid", b.fluid)?;
            for axis in 0..self.dimension.count() {
                self.check_distance("blocks.corner", b.corner[axis])?;
            }
            let counts = lattice::counts(b, self);
            for (axis, (&size, count)) in b.size.iter().zip(counts).enumerate().take(self.dimension.count()) {
                positive("blocks.size", size)?;
                if count == 0 {
                    return Err(SceneError::EmptyBlock { block, axis: Axis::of(axis), size });
                }
            }
            particles = particles.saturating_add(counts.iter().fold(1, |all, &n| all.saturating_mul(n)));
        }
        check_count(particles)
    }

    /// Refuses a coordinate where f32 has too few digits left for places between particles.
    fn check_distance(&self, field: &'static str, value: f32) -> Result<(), SceneError> {
        let most = MOST_SPACINGS_AWAY * self.particle_spacing;
        if value.abs() > most { Err(SceneError::OutOfBounds { field, value, least: -most, most }) } else { Ok(()) }
    }

    fn check_container(&self) -> Result<(), SceneError> {
        let Some(container) = &self.container else { return Ok(()) };
        finite("container.low", &container.low)?;
        finite("container.high", &container.high)?;
        for axis in 0..self.dimension.count() {
            let (low, high) = (container.low[axis], container.high[axis]);
            if low >= high {
                return Err(SceneError::EmptyContainer { axis: Axis::of(axis), low, high });
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
                    if by > slack && self.is_closed(container, face) {
                        return Err(SceneError::BlockOutside { block, axis: Axis::of(axis), by });
                    }
                }
            }
        }
        Ok(())
    }

    fn check_periodic(&self) -> Result<(), SceneError> {
        let Some(periodic) = &self.periodic else { return Ok(()) };
        finite("periodic.low", &periodic.low)?;
        finite("periodic.high", &periodic.high)?;
        for axis in self.periodic_axes() {
            let (low, high) = (periodic.low[axis], periodic.high[axis]);
            if low >= high {
                return Err(SceneError::EmptyDomain { axis: Axis::of(axis), low, high });
            }
            // sizes are rounded to whole particles
            let room = high - low + 0.51 * self.particle_spacing;
            let blocks = self.blocks.iter().map(|b| ("blocks", b.size[axis]));
            let walls = self.walls.iter().map(|w| {
                let (WallShape::Plane { low, high, .. } | WallShape::Box { low, high, .. }) = &w.shape;
                ("walls", high[axis] - low[axis])
            });
            for (index, (what, size)) in blocks.enumerate().chain(walls.enumerate()) {
                if size > room {
                    return Err(SceneError::LapsItself { what, index, axis: Axis::of(axis), by: size - (high - low) });
                }
            }
        }
        Ok(())
    }

    fn check_walls(&self) -> Result<(), SceneError> {
        let mut particles = self.fluid_count() as u64;
        for (wall, w) in self.walls.iter().enumerate() {
            finite("walls.velocity", &w.velocity)?;
            known_fluid(self, "walls.fluid", w.fluid)?;
            not_negative("walls.dynamic_viscosity", w.dynamic_viscosity.unwrap_or(0.0))?;
            let (low, high) = match &w.shape {
                WallShape::Plane { low, high, .. } | WallShape::Box { low, high, .. } => (low, high),
            };
            finite("walls.low", low)?;
            finite("walls.high", high)?;
            let across = match &w.shape {
                WallShape::Plane { face, .. } => Some(face.axis()),
                WallShape::Box { .. } => None,
            };
            if let Some(axis) = across
                && w.velocity[axis] != 0.0
            {
                return Err(SceneError::WallAdvances { wall, axis: Axis::of(axis), velocity: w.velocity[axis] });
            }
            for axis in 0..self.dimension.count() {
                let size = high[axis] - low[axis];
                let along = size.is_finite() && (1..=MOST_PARTICLES).contains(&lattice::whole(size, self));
                let fits = if Some(axis) == across { size == 0.0 } else { along };
                if !fits {
                    return Err(SceneError::WallExtent { wall, axis: Axis::of(axis), size });
                }
            }
            if !walls::is_in_space(w, self.dimension) {
                return Err(SceneError::OutOfPlane);
            }
            particles = particles.saturating_add(walls::wall_count(w, self));
        }
        check_count(particles.saturating_add(self.air_capacity() as u64))
    }

    fn check_plane(&self) -> Result<(), SceneError> {
        let tilted = self.gravity[2] != 0.0
            || self.blocks.iter().any(|b| b.velocity[2] != 0.0)
            || self.walls.iter().any(|w| w.velocity[2] != 0.0)
            || self.wind.is_some_and(|w| w.velocity[2] != 0.0);
        if self.dimension == super::Dimension::Two && tilted { Err(SceneError::OutOfPlane) } else { Ok(()) }
    }

    fn check_grid(&self) -> Result<(), SceneError> {
        for axis in 0..self.dimension.count() {
            let cells = self.cells()[axis];
            if cells < 3 {
                return Err(SceneError::TooFewCells { axis: Axis::of(axis), cells });
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
            return Err(SceneError::TooManyCells { cells: self.cells(), places });
        }
        Ok(())
    }
}

fn check_fluid((number, fluid): (u32, &Fluid)) -> Result<(), SceneError> {
    positive(field!(number, "rest_density"), fluid.rest_density)?;
    positive(field!(number, "speed_of_sound"), fluid.speed_of_sound)?;
    if let Some(neighbours) = fluid.average_neighbours {
        self::neighbours(field!(number, "average_neighbours"), neighbours)?;
    }
    if let Some(stiffness) = fluid.stiffness {
        positive(field!(number, "stiffness"), stiffness)?;
    }
    not_negative(field!(number, "dynamic_viscosity"), fluid.dynamic_viscosity)?;
    not_negative(field!(number, "surface_tension"), fluid.surface_tension)?;
    not_negative(field!(number, "elastic_stiffness"), fluid.elastic_stiffness)?;
    not_negative(field!(number, "alpha"), fluid.alpha)?;
    not_negative(field!(number, "beta"), fluid.beta)?;
    share(field!(number, "velocity_exchange"), fluid.velocity_exchange)?;
    share(field!(number, "radial_exchange"), fluid.radial_exchange)?;
    share(field!(number, "xsph"), fluid.xsph)?;
    not_negative(field!(number, "near_stiffness"), fluid.near_stiffness.unwrap_or(0.0))?;
    share(field!(number, "heat_gain"), fluid.heat_gain)?;
    not_negative(field!(number, "thermal_energy"), fluid.thermal_energy)?;
    fluid.colour.iter().flatten().try_for_each(|&colour| share(field!(number, "colour"), colour))
}

/// Refuses supports of hardly anything, and of more particles than there can be: their constants would be no numbers, and the
/// fault would seem to be another's.
fn neighbours(field: &'static str, value: f32) -> Result<(), SceneError> {
    positive(field, value)?;
    let (least, most) = (0.001, MOST_PARTICLES as f32);
    if (least..=most).contains(&value) { Ok(()) } else { Err(SceneError::OutOfBounds { field, value, least, most }) }
}

/// Refuses the number of a fluid that the scene has not.
fn known_fluid(scene: &Scene, field: &'static str, fluid: u32) -> Result<(), SceneError> {
    let fluids = scene.fluids().count() as u32;
    if fluid < fluids { Ok(()) } else { Err(SceneError::NoSuchFluid { field, fluid, fluids }) }
}

/// Refuses more particles than a status word can name.
pub(crate) fn check_count(particles: u64) -> Result<(), SceneError> {
    if particles > MOST_PARTICLES {
        return Err(SceneError::TooManyParticles { particles, most: MOST_PARTICLES });
    }
    Ok(())
}

pub(super) fn finite(field: &'static str, values: &[f32]) -> Result<(), SceneError> {
    match values.iter().find(|v| !v.is_finite()) {
        Some(&value) => Err(SceneError::NotFinite { field, value }),
        None => Ok(()),
    }
}

pub(super) fn positive(field: &'static str, value: f32) -> Result<(), SceneError> {
    finite(field, &[value])?;
    if value > 0.0 { Ok(()) } else { Err(SceneError::NotPositive { field, value }) }
}

pub(super) fn not_negative(field: &'static str, value: f32) -> Result<(), SceneError> {
    finite(field, &[value])?;
    if value >= 0.0 { Ok(()) } else { Err(SceneError::Negative { field, value }) }
}

pub(super) fn share(field: &'static str, value: f32) -> Result<(), SceneError> {
    finite(field, &[value])?;
    if (0.0..=1.0).contains(&value) { Ok(()) } else { Err(SceneError::NotAShare { field, value }) }
}
