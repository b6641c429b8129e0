//! Why a scene cannot run.
use super::StepError;
use crate::axis::Axis;
use crate::plan::arrays::Quantity;
use core::fmt;

/// A scene that cannot run.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum SceneError {
    /// A field is NaN or infinite.
    NotFinite {
        /// Which.
        field: &'static str,
        /// Its value.
        value: f32,
    },
    /// The scene has no fluid.
    NoFluid,
    /// A list of the scene has no room for another item.
    ListIsFull {
        /// Which list.
        field: &'static str,
        /// How many items it can have.
        capacity: u32,
    },
    /// A field must be larger than zero.
    NotPositive {
        /// Which.
        field: &'static str,
        /// Its value.
        value: f32,
    },
    /// A field must not be negative.
    Negative {
        /// Which.
        field: &'static str,
        /// Its value.
        value: f32,
    },
    /// A field must lie between 0 and 1.
    NotAShare {
        /// Which.
        field: &'static str,
        /// Its value.
        value: f32,
    },
    /// A field lies outside of its bounds.
    OutOfBounds {
        /// Which.
        field: &'static str,
        /// Its value.
        value: f32,
        /// Smallest allowed.
        least: f32,
        /// Largest allowed.
        most: f32,
    },
    /// The container has no inside along an axis.
    EmptyContainer {
        /// The axis.
        axis: Axis,
        /// Its low side, m.
        low: f32,
        /// Its high side, m.
        high: f32,
    },
    /// A scene in 2D has gravity or a velocity along z.
    OutOfPlane,
    /// A block is thinner than half a spacing along an axis, so it would have no particles.
    EmptyBlock {
        /// Which block, counted from 0.
        block: usize,
        /// The axis.
        axis: Axis,
        /// Its extent, m.
        size: f32,
    },
    /// A block reaches through a wall of the container.
    BlockOutside {
        /// Which block, counted from 0.
        block: usize,
        /// The axis.
        axis: Axis,
        /// How far, m.
        by: f32,
    },
    /// A periodic domain has no inside along an axis.
    EmptyDomain {
        /// The axis.
        axis: Axis,
        /// Its low side, m.
        low: f32,
        /// Its high side, m.
        high: f32,
    },
    /// A block or a wall is longer than the period of an axis, so that it would lie on its own image.
    LapsItself {
        /// `blocks` or `walls`.
        what: &'static str,
        /// Which of them, counted from 0.
        index: usize,
        /// The axis.
        axis: Axis,
        /// How much too long it is, m.
        by: f32,
    },
    /// A wall's particles stay where they are, so its surface can slide and not come nearer.
    WallAdvances {
        /// Which wall, counted from 0.
        wall: usize,
        /// The axis.
        axis: Axis,
        /// Its velocity along that axis, across itself, m/s.
        velocity: f32,
    },
    /// A wall is thinner than half a spacing along an axis, or a plane has an extent across itself.
    WallExtent {
        /// Which wall, counted from 0.
        wall: usize,
        /// The axis.
        axis: Axis,
        /// Its extent, m.
        size: f32,
    },
    /// A field of accelerations needs two nodes along each axis, between which it is linear.
    TooFewPoints {
        /// The axis.
        axis: Axis,
        /// Nodes along it.
        points: u32,
    },
    /// A number that no fluid of the scene has.
    NoSuchFluid {
        /// Which field names it.
        field: &'static str,
        /// That number.
        fluid: u32,
        /// Fluids of the scene, which are counted from 0.
        fluids: u32,
    },
    /// Two choices that do not go together.
    NotTogether {
        /// A field and what it is.
        choice: &'static str,
        /// Another.
        other: &'static str,
        /// Why not.
        why: &'static str,
    },
    /// A term that the plan left out, so that its coefficient cannot be changed.
    LeftOut {
        /// The field.
        field: &'static str,
        /// What [`Scene::adjustable`](crate::scene::Scene::adjustable) must list to keep the term.
        live: &'static str,
    },
    /// A pressure correction by the letter, whose iteration grows instead of settling.
    CannotConverge {
        /// How far sound travels in a step, in particle spacings.
        spacings: f32,
        /// How far it may.
        most: f32,
    },
    /// A field, with the others, makes constants that no f32 can hold.
    OutOfScale {
        /// Which.
        field: &'static str,
        /// Its value.
        value: f32,
    },
    /// A plan that was not made for this scene.
    PlanOfAnotherScene,
    /// A particle of a kind or a mass that the scene gives nobody, so that its plan leaves it out.
    UnplannedParticle {
        /// Its id.
        particle: u32,
    },
    /// A quantity that a particle is to start with is NaN or infinite.
    ParticleNotFinite {
        /// Its id.
        particle: u32,
        /// Which quantity.
        quantity: Quantity,
    },
    /// A wrapped axis needs three cells, else a neighbour would be met twice.
    TooFewCells {
        /// The axis.
        axis: Axis,
        /// Cells along it.
        cells: u32,
    },
    /// More cells or places than an index can name.
    TooManyCells {
        /// Cells along x, y, z.
        cells: [u32; 3],
        /// Places of each.
        places: u32,
    },
    /// More particles than a status word can name.
    TooManyParticles {
        /// Particles of the scene.
        particles: u64,
        /// The limit.
        most: u64,
    },
    /// A call got more or fewer entries than the scene has.
    WrongLength {
        /// The call.
        call: &'static str,
        /// What it takes.
        what: &'static str,
        /// Entries given; one more than expected where an iterator did not end.
        given: usize,
        /// Entries expected.
        expected: usize,
    },
    /// Fewer particles were given than the coat of air alone can have.
    TooFewParticles {
        /// Particles given.
        particles: usize,
        /// Particles of air, `air.capacity`.
        air: usize,
    },
    /// The memory lent is too small.
    CapacityExceeded {
        /// Which array or group of arrays.
        what: &'static str,
        /// Entries needed.
        needed: usize,
        /// Entries lent.
        capacity: usize,
    },
    /// The scene's first forces could not be evaluated.
    FirstStep(StepError),
}

impl fmt::Display for SceneError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            SceneError::NotFinite { field, value } => write!(f, "{field} is {value}, which is not a finite number"),
            SceneError::NoFluid => write!(f, "fluids is empty: a scene needs at least one fluid"),
            SceneError::ListIsFull { field, capacity } => {
                write!(f, "{field} is full: a scene can have at most {capacity} of them")
            }
            SceneError::NotPositive { field, value } => write!(f, "{field} is {value}, and must be larger than 0"),
            SceneError::Negative { field, value } => write!(f, "{field} is {value}, and must not be negative"),
            SceneError::NotAShare { field, value } => write!(f, "{field} is {value}, and must lie between 0 and 1"),
            SceneError::OutOfBounds { field, value, least, most } => {
                write!(f, "{field} is {value}, and must lie between {least} and {most}")
            }
            SceneError::EmptyContainer { axis, low, high } => {
                write!(f, "container has no inside along {axis}: low {low} m, high {high} m")
            }
            SceneError::OutOfPlane => write!(f, "a scene in 2D has gravity, a place or a velocity along z"),
            SceneError::EmptyBlock { block, axis, size } => {
                write!(f, "blocks[{block}].size is {size} m along {axis}: less than half a particle_spacing")
            }
            SceneError::BlockOutside { block, axis, by } => {
                write!(f, "blocks[{block}] reaches {by} m through a wall along {axis}")
            }
            SceneError::EmptyDomain { axis, low, high } => {
                write!(f, "periodic has no inside along {axis}: low {low} m, high {high} m")
            }
            SceneError::LapsItself { what, index, axis, by } => {
                write!(f, "{what}[{index}] is {by} m longer than the period along {axis}")
            }
            SceneError::WallAdvances { wall, axis, velocity } => {
                write!(f, "walls[{wall}].velocity is {velocity} m/s along {axis}, across it: a wall slides, and stays")
            }
            SceneError::WallExtent { wall, axis, size } => {
                write!(f, "walls[{wall}] is {size} m along {axis}: give a plane 0 m across, and at least half a ")?;
                write!(f, "particle_spacing along all else")
            }
            SceneError::TooFewPoints { axis, points } => {
                write!(f, "acceleration_field.counts has {points} along {axis}, and must have at least 2")
            }
            SceneError::NoSuchFluid { field, fluid, fluids } => {
                write!(f, "{field} names fluid {fluid}, and the scene has {fluids}, counted from 0")
            }
            SceneError::NotTogether { choice, other, why } => write!(f, "{choice} does not go with {other}: {why}"),
            SceneError::LeftOut { field, live } => {
                write!(
                    f,
                    "{field} cannot be changed, because the plan left its term out: list {live} in the scene's live"
                )
            }
            SceneError::CannotConverge { spacings, most } => {
                write!(f, "time_step lets sound travel {spacings} spacings, and the literal pressure correction ")?;
                write!(f, "converges up to {most}: use model.correction.iteration Relaxed, or smaller steps")
            }
            SceneError::OutOfScale { field, value } => {
                write!(f, "{field} is {value}, which makes constants that no f32 can hold")
            }
            SceneError::PlanOfAnotherScene => write!(f, "the plan was made for another scene"),
            SceneError::UnplannedParticle { particle } => {
                write!(f, "particle {particle} has a kind or a mass that no particle of the scene has")
            }
            SceneError::ParticleNotFinite { particle, quantity } => {
                write!(f, "{quantity:?} of particle {particle} is not a finite number")
            }
            SceneError::TooFewCells { axis, cells } => {
                write!(f, "grid.cells has {cells} along {axis}, and must have at least 3")
            }
            SceneError::TooManyCells { cells: [x, y, z], places } => {
                write!(f, "grid.cells {x} x {y} x {z}, with {places} places each, make more than 2^31 places")
            }
            SceneError::TooManyParticles { particles, most } => {
                write!(f, "the scene has {particles} particles, and at most {most} are possible")
            }
            SceneError::WrongLength { call, what, given, expected } => {
                write!(f, "`{call}` got {given} {what}, expected {expected}")
            }
            SceneError::TooFewParticles { particles, air } => {
                write!(f, "air.capacity is {air}, and only {particles} particles were given: the last ones are the air")
            }
            SceneError::CapacityExceeded { what, needed, capacity } => {
                write!(f, "the scene needs {needed} of {what}, and the memory lent has {capacity}")
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
