//! Errors of scenes: why a scene cannot run, or a change of it cannot be made.
use super::{Field, StepError};
use crate::axis::Axis;
use crate::plan::arrays::Quantity;
use core::fmt;

/// A scene cannot run, or cannot be changed as requested. The state of the fluid is unchanged.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum SceneError {
    /// A field is NaN or infinite.
    NotFinite {
        /// Path of the field.
        field: Field,
        /// Value of the field.
        value: f32,
    },
    /// The scene has no fluid.
    NoFluid,
    /// A list of the scene is full, so no item can be added.
    ListIsFull {
        /// Path of the list.
        field: Field,
        /// Largest number of items.
        capacity: u32,
    },
    /// A field must be larger than zero.
    NotPositive {
        /// Path of the field.
        field: Field,
        /// Value of the field.
        value: f32,
    },
    /// A field must not be negative.
    Negative {
        /// Path of the field.
        field: Field,
        /// Value of the field.
        value: f32,
    },
    /// A field must lie between 0 and 1.
    NotAShare {
        /// Path of the field.
        field: Field,
        /// Value of the field.
        value: f32,
    },
    /// A field lies outside of its bounds.
    OutOfBounds {
        /// Path of the field.
        field: Field,
        /// Value of the field.
        value: f32,
        /// Smallest allowed value.
        least: f32,
        /// Largest allowed value.
        most: f32,
    },
    /// The container is empty: its low corner is not below its high corner along an axis.
    EmptyContainer {
        /// The axis.
        axis: Axis,
        /// Coordinate of the low corner, m.
        low: f32,
        /// Coordinate of the high corner, m.
        high: f32,
    },
    /// The container is so narrow along an axis that a particle would feel two opposite walls in closed form at once.
    NarrowContainer {
        /// The axis.
        axis: Axis,
        /// Its width along the axis, m.
        width: f32,
        /// Smallest allowed width, m: two support radii.
        least: f32,
    },
    /// A scene in 2D has gravity, a velocity or a position with a z component, or a wall perpendicular to z.
    OutOfPlane,
    /// A block is smaller than half a particle spacing along an axis, so it would have no particles.
    EmptyBlock {
        /// Index of the block, counted from 0.
        block: usize,
        /// The axis.
        axis: Axis,
        /// Extent of the block, m.
        size: f32,
    },
    /// A block reaches out of the container.
    BlockOutside {
        /// Index of the block, counted from 0.
        block: usize,
        /// The axis.
        axis: Axis,
        /// Distance by which the block reaches out, m.
        by: f32,
    },
    /// The periodic domain is empty: its low corner is not below its high corner along a periodic axis.
    EmptyDomain {
        /// The axis.
        axis: Axis,
        /// Coordinate of the low corner, m.
        low: f32,
        /// Coordinate of the high corner, m.
        high: f32,
    },
    /// A block or a wall is longer than the period of an axis, so it would overlap its own periodic image.
    LapsItself {
        /// `blocks` or `walls`.
        what: &'static str,
        /// Index in that list, counted from 0.
        index: usize,
        /// The axis.
        axis: Axis,
        /// Excess length, m.
        by: f32,
    },
    /// A plane has a velocity along its normal. Wall particles do not move, so its surface can only slide.
    WallAdvances {
        /// Index of the wall, counted from 0.
        wall: usize,
        /// Axis of the normal.
        axis: Axis,
        /// Velocity along that axis, m/s.
        velocity: f32,
    },
    /// Fluid particles start inside of a solid.
    FluidInSolid {
        /// Index of the solid.
        solid: usize,
        /// Number of these particles.
        particles: usize,
    },
    /// A wall is smaller than half a particle spacing or too large along an axis, or a plane has an extent along its
    /// normal.
    WallExtent {
        /// Index of the wall, counted from 0.
        wall: usize,
        /// The axis.
        axis: Axis,
        /// Extent of the wall, m.
        size: f32,
    },
    /// The acceleration field has fewer than the two nodes along an axis that linear interpolation needs.
    TooFewPoints {
        /// The axis.
        axis: Axis,
        /// Number of nodes along the axis.
        points: u32,
    },
    /// An index of a fluid that the scene does not have.
    NoSuchFluid {
        /// Path of the field, or name of the method, that has the index.
        field: Field,
        /// The index.
        fluid: u32,
        /// Number of fluids of the scene, which are counted from 0.
        fluids: u32,
    },
    /// Two settings cannot be combined.
    NotTogether {
        /// Path of a field with its value, or name of a method.
        choice: Field,
        /// The setting that it conflicts with.
        other: Field,
        /// The reason, and what to change.
        why: &'static str,
    },
    /// A coefficient cannot be changed between steps, because the plan left out its term.
    LeftOut {
        /// Name of the coefficient.
        field: &'static str,
        /// Item that [`Scene::adjustable`](crate::scene::Scene::adjustable) must contain to keep the term.
        item: &'static str,
    },
    /// The pressure correction with [`Iteration::Literal`](crate::scene::Iteration::Literal) would diverge, because
    /// sound travels too far in a step.
    CannotConverge {
        /// Distance that sound travels in a step, in particle spacings.
        spacings: f32,
        /// Largest distance for which the iteration converges.
        most: f32,
    },
    /// A field makes derived constants that f32 cannot represent, or a support radius too large for sums over the
    /// lattice.
    OutOfScale {
        /// Path of the field.
        field: Field,
        /// Value of the field.
        value: f32,
    },
    /// The plan was made for another scene.
    PlanOfAnotherScene,
    /// A particle has a material or a mass that the plan does not support, or its material does not fit its id: with a
    /// layer of air the last `air.capacity` particles must be air.
    UnplannedParticle {
        /// Id of the particle.
        particle: u32,
    },
    /// A quantity of a particle at the start is NaN or infinite.
    ParticleNotFinite {
        /// Id of the particle.
        particle: u32,
        /// The quantity.
        quantity: Quantity,
    },
    /// The grid has fewer than three cells along an axis. Because cells wrap around, neighbours would be found twice.
    TooFewCells {
        /// The axis.
        axis: Axis,
        /// Number of cells along the axis.
        cells: u32,
    },
    /// The grid has more cells, or places in cells, than an index can address.
    TooManyCells {
        /// Number of cells along x, y, z.
        cells: [u32; 3],
        /// Places per cell; 1 with the index sort.
        places: u32,
    },
    /// The scene has more particles than can be addressed.
    TooManyParticles {
        /// Number of particles of the scene.
        particles: u64,
        /// Largest number of particles.
        most: u64,
    },
    /// A method got more or fewer items than it needs.
    WrongLength {
        /// Name of the method.
        call: &'static str,
        /// Name of the items.
        what: &'static str,
        /// Number of items given; one more than expected if an iterator has more items than that.
        given: usize,
        /// Number of items expected.
        expected: usize,
    },
    /// Fewer particles were given than `air.capacity`.
    TooFewParticles {
        /// Number of particles given.
        particles: usize,
        /// Number of air particles, `air.capacity`.
        air: usize,
    },
    /// The memory lent to the solver is too small, or the scene needs more springs than `elasticity.capacity`.
    CapacityExceeded {
        /// Name of the array or group of arrays.
        what: &'static str,
        /// Number of entries needed.
        needed: usize,
        /// Number of entries available.
        capacity: usize,
    },
    /// The forces at the start could not be evaluated.
    FirstStep(StepError),
}

impl fmt::Display for SceneError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            SceneError::NotFinite { field, value } => write!(f, "{field} is {value}, but must be a finite number"),
            SceneError::NoFluid => write!(f, "fluids is empty; a scene needs at least one fluid"),
            SceneError::ListIsFull { field, capacity } => {
                write!(f, "{field} is full; a scene can have at most {capacity} of them")
            }
            SceneError::NotPositive { field, value } => write!(f, "{field} is {value}, but must be larger than 0"),
            SceneError::Negative { field, value } => write!(f, "{field} is {value}, but must not be negative"),
            SceneError::NotAShare { field, value } => write!(f, "{field} is {value}, but must lie between 0 and 1"),
            SceneError::OutOfBounds { field, value, least, most } if most == f32::MAX => {
                write!(f, "{field} is {value}, but must be at least {least}")
            }
            SceneError::OutOfBounds { field, value, least, most } => {
                write!(f, "{field} is {value}, but must lie between {least} and {most}")
            }
            SceneError::EmptyContainer { axis, low, high } => {
                write!(f, "container.low {low} m is not below container.high {high} m along {axis}")
            }
            SceneError::NarrowContainer { axis, width, least } => {
                write!(
                    f,
                    "container is {width} m wide along {axis}, but with container.model ClosedForm it must be at least \
                     {least} m wide, two support radii; make it wider, use a smaller particle_spacing, walls of \
                     particles, or container.model Penalty"
                )
            }
            SceneError::OutOfPlane => write!(f, "dimension is 2D: gravity, positions, velocities, normals need z = 0"),
            SceneError::EmptyBlock { block, axis, size } => {
                write!(f, "blocks[{block}].size is {size} m along {axis}, but must be at least half a particle_spacing")
            }
            SceneError::BlockOutside { block, axis, by } => {
                write!(f, "blocks[{block}] reaches {by} m out of the container along {axis}")
            }
            SceneError::EmptyDomain { axis, low, high } => {
                write!(f, "periodic.low {low} m is not below periodic.high {high} m along {axis}")
            }
            SceneError::LapsItself { what, index, axis, by } => {
                write!(f, "{what}[{index}] is {by} m longer than the period along {axis}")
            }
            SceneError::WallAdvances { wall, axis, velocity } => {
                write!(f, "walls[{wall}].velocity is {velocity} m/s along {axis}, the wall's normal, but must be 0")
            }
            SceneError::WallExtent { wall, axis, size } => {
                write!(f, "walls[{wall}] extends {size} m along {axis}; a plane must extend 0 m along its normal, ")?;
                write!(f, "and every other extent must be half a particle_spacing to 2^28 particle_spacings")
            }
            SceneError::FluidInSolid { solid, particles } => write!(
                f,
                "{particles} fluid particles start inside of solids[{solid}]; move the solid or the blocks, set \
                 around_solids in the blocks, or change hollow if the fluid is on the wrong side"
            ),
            SceneError::TooFewPoints { axis, points } => {
                write!(f, "acceleration_field.counts is {points} along {axis}, but must be at least 2")
            }
            SceneError::NoSuchFluid { field, fluid, fluids } => {
                write!(f, "{field} names fluid {fluid}, but fluids has length {fluids}, and fluids are counted from 0")
            }
            SceneError::NotTogether { choice, other, why } => write!(f, "{choice} conflicts with {other}: {why}"),
            SceneError::LeftOut { field, item } => {
                write!(f, "{field} cannot be changed, because the plan left out its term; list {item} in adjustable")
            }
            SceneError::CannotConverge { spacings, most } => {
                write!(f, "time_step lets sound travel {spacings} particle spacings, but model.correction.iteration ")?;
                write!(f, "Literal converges only up to {most}; use iteration Relaxed, or a smaller time step")
            }
            SceneError::OutOfScale { field, value } => {
                write!(f, "{field} is {value}, too large or too small for the constants derived from it")
            }
            SceneError::PlanOfAnotherScene => write!(f, "the plan was made for another scene; make one for this scene"),
            SceneError::UnplannedParticle { particle } => {
                write!(f, "particle {particle} has a material or a mass that the plan does not support")
            }
            SceneError::ParticleNotFinite { particle, quantity } => {
                write!(f, "{quantity:?} of particle {particle} is not a finite number")
            }
            SceneError::TooFewCells { axis, cells } => {
                write!(f, "grid.cells has {cells} along {axis}, but needs at least 3 (lengthen a periodic axis)")
            }
            SceneError::TooManyCells { cells: [x, y, z], places } => {
                write!(f, "grid.cells {x} x {y} x {z} with {places} places each exceed the limit of 2^31 - 1 places")
            }
            SceneError::TooManyParticles { particles, most } => {
                write!(f, "the scene has {particles} particles, but at most {most} are possible")
            }
            SceneError::WrongLength { call, what, given, expected } => {
                write!(f, "`{call}` got {given} {what}, expected {expected}")
            }
            SceneError::TooFewParticles { particles, air } => {
                write!(f, "air.capacity is {air}, but only {particles} particles were given; the last ones are the air")
            }
            SceneError::CapacityExceeded { what, needed, capacity } => {
                write!(f, "the scene needs {needed} of {what}, but only {capacity} are available; provide more")
            }
            SceneError::FirstStep(error) => write!(f, "the scene cannot start: {error}"),
        }
    }
}

impl core::error::Error for SceneError {}

impl From<StepError> for SceneError {
    fn from(error: StepError) -> Self {
        SceneError::FirstStep(error)
    }
}
