//! The rows of solids, and their poses at the start.
use super::materials::VISCOSITY_OF_PARTICLE;
use crate::layout::{DRIVEN, Model, ON_COURSE, POSE_STRIDE, Parameters, SOLID_ROWS, SOLID_STRIDE, SolidRows, f32x4};
use crate::scene::{Course, Dimension, Motion, SOLIDS, Scene, Shape, Solid};
use crate::solids::motion::on_course;
use crate::terms::shape::{BALL, BOX, CAPSULE, CYLINDER, FACET, PLANE, POLYGON};
use glam::{DQuat, Quat, Vec2, Vec3};

const _: () = assert!(SOLID_ROWS == SOLID_STRIDE * SOLIDS, "rows for each solid");

/// Number of rows of the poses of a scene, and of the sides of its polygons.
pub(crate) fn pose_rows(scene: &Scene) -> usize {
    POSE_STRIDE * scene.solids.len() + 2 * sides(scene)
}

/// Number of sides of all polygons of a scene.
pub(crate) fn sides(scene: &Scene) -> usize {
    scene.solids.iter().map(|solid| corners(solid).len()).sum()
}

/// Largest number of sides of all polygons of a scene.
pub(crate) const MOST_SIDES: usize = 64;

/// Largest number of rows of the poses, and of the sides of polygons, of any scene.
pub(crate) const MOST_POSE_ROWS: usize = POSE_STRIDE * SOLIDS + 2 * MOST_SIDES;

/// The corners of a polygon; none for other shapes.
fn corners(solid: &Solid) -> &[Vec2] {
    match &solid.shape {
        Shape::Polygon { corners } => corners,
        _ => &[],
    }
}

/// Kind of a shape, and its size.
fn kind(shape: &Shape) -> (u32, Vec3) {
    match shape {
        Shape::Plane => (PLANE, Vec3::ZERO),
        Shape::Ball { radius } => (BALL, Vec3::new(*radius, 0.0, 0.0)),
        Shape::Box { size } => (BOX, *size * 0.5),
        Shape::Cylinder { radius, height } => (CYLINDER, Vec3::new(*radius, *height * 0.5, 0.0)),
        Shape::Capsule { radius, length } => (CAPSULE, Vec3::new(*radius, *length * 0.5, 0.0)),
        Shape::Facet { length, near, far } => (FACET, Vec3::new(*near, *far, *length) * 0.5),
        Shape::Polygon { .. } => (POLYGON, Vec3::ZERO),
    }
}

/// The rotation of a solid at its start.
pub(crate) fn rotation(solid: &Solid) -> Quat {
    let about = |axis: usize| {
        let (sine, cosine) = libm::sincos(f64::from(solid.turned[axis]).to_radians() / 2.0);
        let mut q = [0.0, 0.0, 0.0, cosine];
        q[axis] = sine;
        DQuat::from_array(q)
    };
    let own = solid.rotation.as_dquat();
    (about(2) * about(1) * about(0) * own).normalize().as_quat()
}

/// The constants of the solids.
pub(crate) fn rows(scene: &Scene) -> SolidRows {
    let mut all = [[0.0; 4]; SOLID_ROWS];
    let mut first_side = POSE_STRIDE * scene.solids.len();
    for (rows, solid) in all.chunks_exact_mut(SOLID_STRIDE).zip(&scene.solids) {
        let (kind, size) = kind(&solid.shape);
        let (course, motion) = match solid.motion {
            Motion::Still => (Course::default(), 0.0),
            Motion::Prescribed(course) => (course, ON_COURSE),
            Motion::Driven => (Course::default(), DRIVEN),
        };
        let side = if solid.hollow { -1.0 } else { 1.0 };
        let viscosity = solid.dynamic_viscosity.unwrap_or(VISCOSITY_OF_PARTICLE);
        let axis = if scene.dimension == Dimension::Two { Vec3::Z } else { course.axis.normalize_or_zero() };
        rows[0] = [kind as f32, side, solid.model as u32 as f32, motion];
        rows[1] = size.extend(0.0).to_array();
        rows[2] = [solid.restitution, solid.slip, viscosity, solid.repulsion];
        rows[3] = solid.position.extend(course.frequency).to_array();
        rows[4] = rotation(solid).to_array();
        rows[5] = course.velocity.extend(course.phase).to_array();
        rows[6] = course.amplitude.extend(course.rocking_degrees / 360.0).to_array();
        rows[7] = axis.extend(course.turns_per_second).to_array();
        let sides = corners(solid).len();
        rows[8] = [first_side as f32, sides as f32, 0.0, 0.0];
        first_side += 2 * sides;
    }
    all
}

/// Fills the poses at the start, and the sides of polygons.
pub(crate) fn fill_poses(scene: &Scene, m: &Model, p: &Parameters, poses: &mut [f32x4]) {
    let (poses, sides) = poses.split_at_mut(poses.len().min(POSE_STRIDE * scene.solids.len()));
    for (rows, pose) in p.solids.chunks_exact(SOLID_STRIDE).zip(poses.chunks_exact_mut(POSE_STRIDE)) {
        pose.copy_from_slice(&on_course(m, p, rows, 0.0));
    }
    let all = scene.solids.iter().flat_map(|solid| {
        let corners = corners(solid);
        corners.iter().zip(corners.iter().cycle().skip(1)).map(|(from, to)| [*from, *to - *from])
    });
    for (rows, [from, side]) in sides.chunks_exact_mut(2).zip(all) {
        rows[0] = [from.x, from.y, 0.0, 0.0];
        rows[1] = [side.x, side.y, 0.0, 0.0];
    }
}

/// Radius of a ball around the origin of a solid that holds its shape, m; infinite for a plane.
#[must_use]
pub fn reach(solid: &Solid, dimension: Dimension) -> f32 {
    match &solid.shape {
        Shape::Plane => f32::INFINITY,
        Shape::Ball { radius } => *radius,
        Shape::Box { size } if dimension == Dimension::Two => size.truncate().length() * 0.5,
        Shape::Box { size } => size.length() * 0.5,
        Shape::Cylinder { radius, height } => Vec2::new(*radius, *height * 0.5).length(),
        Shape::Capsule { radius, length } => radius + length * 0.5,
        Shape::Facet { near, .. } if dimension == Dimension::Two => near * 0.5,
        Shape::Facet { length, near, far } => Vec2::new(near.max(*far), *length).length() * 0.5,
        Shape::Polygon { corners } => corners.iter().map(|corner| corner.length()).fold(0.0, f32::max),
    }
}
