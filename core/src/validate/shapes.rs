//! Checks positions and extents: blocks, walls, container, periodic domain, and the cells of the grid.
use super::bounds::{MOST_PARTICLES, bounded, check_count, finite, known_fluid, not_negative, positive, share};
use crate::axis::Axis;
use crate::derive::counts::Counts;
use crate::derive::sampling::lattice::{MOST_AROUND_SOLIDS, counts, leaves_out, whole};
use crate::error::{Field, SceneError};
use crate::scene::{Container, Dimension, Face, GridStructure, Scene, Wall, WallShape};

/// Largest distance of a block's corner from the origin along an axis, in particle spacings. At this distance f32
/// still resolves 1/128 of a spacing.
pub const MOST_SPACINGS_AWAY: f32 = 65_536.0;

pub(super) fn blocks(scene: &Scene, count: &Counts) -> Result<(), SceneError> {
    for (block, b) in scene.blocks.iter().enumerate() {
        let field = |names| Field::of_item(names, block);
        finite(field("blocks.corner"), b.corner.as_ref())?;
        finite(field("blocks.velocity"), b.velocity.as_ref())?;
        not_negative(field("blocks.jitter"), b.jitter)?;
        not_negative(field("blocks.dynamic_viscosity"), b.dynamic_viscosity.unwrap_or(0.0))?;
        known_fluid(scene, field("blocks.fluid"), b.fluid)?;
        for axis in 0..scene.dimension.count() {
            distance(scene, field("blocks.corner"), b.corner[axis])?;
        }
        let counts = counts(b, scene);
        if leaves_out(b, scene) {
            let cells = counts.iter().fold(1.0, |all, &n| all * n as f32);
            bounded(field("blocks.size (its cells, with around_solids)"), cells, 0.0..=MOST_AROUND_SOLIDS as f32)?;
        }
        for (axis, (&size, count)) in b.size.as_ref().iter().zip(counts).enumerate().take(scene.dimension.count()) {
            positive(field("blocks.size"), size)?;
            if count == 0 {
                return Err(SceneError::EmptyBlock { block, axis: Axis::of(axis), size });
            }
        }
    }
    check_count(count.fluid)
}

/// Rejects a coordinate at which f32 has too few digits for distances between particles.
fn distance(scene: &Scene, field: Field, value: f32) -> Result<(), SceneError> {
    let most = MOST_SPACINGS_AWAY * scene.particle_spacing;
    bounded(field, value, -most..=most)
}

pub(super) fn container(scene: &Scene) -> Result<(), SceneError> {
    let Some(container) = &scene.container else { return Ok(()) };
    finite("container.low", container.low.as_ref())?;
    finite("container.high", container.high.as_ref())?;
    for axis in 0..scene.dimension.count() {
        let (low, high) = (container.low[axis], container.high[axis]);
        if low >= high {
            return Err(SceneError::EmptyContainer { axis: Axis::of(axis), low, high });
        }
    }
    share("container.restitution", container.restitution)?;
    share("container.slip", container.slip)?;
    blocks_inside(scene, container)
}

/// Rejects blocks that reach through a closed face of the container: the first step would project their particles onto
/// its plane.
fn blocks_inside(scene: &Scene, container: &Container) -> Result<(), SceneError> {
    // sizes are rounded to whole particles, and the ends are computed in f32
    let slack = 0.51 * scene.particle_spacing;
    for (block, b) in scene.blocks.iter().enumerate() {
        for axis in 0..scene.dimension.count() {
            let [low_face, high_face] = [Face::ALL[2 * axis], Face::ALL[2 * axis + 1]];
            let below = container.low[axis] - b.corner[axis];
            let above = b.corner[axis] + b.size[axis] - container.high[axis];
            for (face, by) in [(low_face, below), (high_face, above)] {
                if by > slack && scene.is_closed(container, face) {
                    return Err(SceneError::BlockOutside { block, axis: Axis::of(axis), by });
                }
            }
        }
    }
    Ok(())
}

pub(super) fn periodic(scene: &Scene) -> Result<(), SceneError> {
    let Some(periodic) = &scene.periodic else { return Ok(()) };
    finite("periodic.low", periodic.low.as_ref())?;
    finite("periodic.high", periodic.high.as_ref())?;
    for axis in scene.periodic_axes() {
        let (low, high) = (periodic.low[axis], periodic.high[axis]);
        if low >= high {
            return Err(SceneError::EmptyDomain { axis: Axis::of(axis), low, high });
        }
        // sizes are rounded to whole particles
        let room = high - low + 0.51 * scene.particle_spacing;
        let blocks = scene.blocks.iter().map(|b| ("blocks", b.size[axis]));
        let walls = scene.walls.iter().map(|w| {
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

pub(super) fn grid(scene: &Scene, cells: [u32; 3]) -> Result<(), SceneError> {
    for (axis, &cells) in cells.iter().enumerate().take(scene.dimension.count()) {
        if cells < 3 {
            return Err(SceneError::TooFewCells { axis: Axis::of(axis), cells });
        }
    }
    let total = cells.iter().try_fold(1u32, |total, &cells| total.checked_mul(cells));
    let places = match scene.grid.structure {
        GridStructure::IndexSort => 1,
        GridStructure::CellLists { places } => places,
    };
    if places == 0 {
        return Err(SceneError::NotPositive { field: "grid.structure.places".into(), value: 0.0 });
    }
    if total.and_then(|total| total.checked_mul(places)).is_none_or(|total| total > i32::MAX as u32) {
        return Err(SceneError::TooManyCells { cells, places });
    }
    Ok(())
}

pub(super) fn walls(scene: &Scene, count: &Counts) -> Result<(), SceneError> {
    for (wall, w) in scene.walls.iter().enumerate() {
        let field = |names| Field::of_item(names, wall);
        finite(field("walls.velocity"), w.velocity.as_ref())?;
        known_fluid(scene, field("walls.fluid"), w.fluid)?;
        not_negative(field("walls.dynamic_viscosity"), w.dynamic_viscosity.unwrap_or(0.0))?;
        let (low, high) = match &w.shape {
            WallShape::Plane { low, high, .. } | WallShape::Box { low, high, .. } => (low, high),
        };
        finite(field("walls.low"), low.as_ref())?;
        finite(field("walls.high"), high.as_ref())?;
        let across = match &w.shape {
            WallShape::Plane { face, .. } => Some(face.axis()),
            WallShape::Box { .. } => None,
        };
        if let Some(axis) = across
            && w.velocity[axis] != 0.0
        {
            return Err(SceneError::WallAdvances { wall, axis: Axis::of(axis), velocity: w.velocity[axis] });
        }
        for axis in 0..scene.dimension.count() {
            let size = high[axis] - low[axis];
            let along = size.is_finite() && (1..=MOST_PARTICLES).contains(&whole(size, scene));
            let fits = if Some(axis) == across { size == 0.0 } else { along };
            if !fits {
                return Err(SceneError::WallExtent { wall, axis: Axis::of(axis), size });
            }
        }
        if !is_in_space(w, scene.dimension) {
            return Err(SceneError::OutOfPlane);
        }
    }
    check_count(count.all())
}

/// Rejects gravity and velocities along z in 2D.
pub(super) fn plane(scene: &Scene) -> Result<(), SceneError> {
    let tilted = scene.gravity[2] != 0.0
        || scene.blocks.iter().any(|b| b.velocity[2] != 0.0)
        || scene.walls.iter().any(|w| w.velocity[2] != 0.0)
        || scene.wind.is_some_and(|w| w.velocity[2] != 0.0);
    if scene.dimension == Dimension::Two && tilted { Err(SceneError::OutOfPlane) } else { Ok(()) }
}

/// Returns whether a wall is possible in this dimension: in 2D no plane is perpendicular to z.
fn is_in_space(wall: &Wall, dimension: Dimension) -> bool {
    match &wall.shape {
        WallShape::Plane { face, .. } => face.axis() < dimension.count(),
        WallShape::Box { .. } => true,
    }
}
