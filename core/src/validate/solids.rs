//! Checks solids: numbers, shapes, motion, and what would start inside of them.
use super::bounds::{bounded, finite, known_fluid, not_negative, not_together, positive, share};
use super::closed_walls::closed_form;
use super::shapes::MOST_SPACINGS_AWAY;
use crate::derive::emission::points;
use crate::derive::frames::Frames;
use crate::derive::scales::Scales;
use crate::derive::solids::{MOST_SIDES, reach, rotation, sides};
use crate::error::{Field, SceneError};
use crate::scene::{Course, Dimension, InitialParticle, Motion, Scene, Shape, Solid, SolidModel};
use glam::{Vec2, Vec3};

/// Checks each solid by itself; positions of particles may be derived after that.
pub(super) fn shapes(scene: &Scene) -> Result<(), SceneError> {
    bounded("solids (sides of all polygons)", sides(scene) as f32, 0.0..=MOST_SIDES as f32)?;
    scene.solids.iter().enumerate().try_for_each(|(number, solid)| {
        numbers(scene, number, solid)?;
        shape(scene, number, solid)?;
        if let Motion::Prescribed(course) = solid.motion {
            self::course(scene, number, &course)?;
        }
        Ok(())
    })
}

fn numbers(scene: &Scene, number: usize, solid: &Solid) -> Result<(), SceneError> {
    let field = |names| Field::of_item(names, number);
    let most = MOST_SPACINGS_AWAY * scene.particle_spacing;
    for &x in solid.position.as_ref() {
        finite(field("solids.position"), &[x])?;
        bounded(field("solids.position"), x, -most..=most)?;
    }
    finite(field("solids.rotation"), &solid.rotation.to_array())?;
    bounded(field("solids.rotation (its length)"), solid.rotation.length(), 0.999..=1.001)?;
    finite(field("solids.turned"), solid.turned.as_ref())?;
    share(field("solids.restitution"), solid.restitution)?;
    share(field("solids.slip"), solid.slip)?;
    not_negative(field("solids.dynamic_viscosity"), solid.dynamic_viscosity.unwrap_or(0.0))?;
    known_fluid(scene, field("solids.fluid"), solid.fluid)?;
    let own = rotation(solid);
    if scene.dimension == Dimension::Two && (solid.position.z != 0.0 || own.x.abs() > 1e-6 || own.y.abs() > 1e-6) {
        return Err(SceneError::OutOfPlane);
    }
    let has_friction = matches!(solid.model, SolidModel::ClosedForm | SolidModel::Particles);
    if !has_friction && solid.dynamic_viscosity.is_some() {
        return Err(not_together(
            field("solids.dynamic_viscosity"),
            "its model Penalty or Repulsion",
            "these have no friction but slip; use ClosedForm or Particles",
        ));
    }
    not_negative(field("solids.repulsion"), solid.repulsion)?;
    if solid.model != SolidModel::Repulsion && solid.repulsion != 1.0 {
        return Err(not_together(
            field("solids.repulsion"),
            "a model other than Repulsion",
            "nothing uses it; omit it, or use model Repulsion",
        ));
    }
    if solid.model != SolidModel::Particles && solid.fluid != 0 {
        return Err(not_together(
            field("solids.fluid"),
            "a model other than Particles",
            "only particles of a solid have a fluid; omit it, or use model Particles",
        ));
    }
    Ok(())
}

fn shape(scene: &Scene, number: usize, solid: &Solid) -> Result<(), SceneError> {
    let field = |names| Field::of_item(names, number);
    let is_flat = scene.dimension == Dimension::Two;
    let length = |name, value: f32| {
        positive(field(name), value)?;
        let least = 1e-3 * scene.particle_spacing;
        bounded(field(name), value, least..=MOST_SPACINGS_AWAY * scene.particle_spacing)
    };
    match &solid.shape {
        Shape::Plane => {}
        Shape::Ball { radius } => length("solids.shape.radius", *radius)?,
        Shape::Box { size } => (0..scene.dimension.count())
            .try_for_each(|axis| length("solids.shape.size", size[axis]))
            .and_then(|()| finite(field("solids.shape.size"), size.as_ref()))?,
        Shape::Cylinder { radius, height } => {
            length("solids.shape.radius", *radius)?;
            length("solids.shape.height", *height)?;
        }
        Shape::Capsule { radius, length: line } => {
            length("solids.shape.radius", *radius)?;
            length("solids.shape.length", *line)?;
        }
        Shape::Facet { length: along, near, far } => {
            length("solids.shape.near", *near)?;
            if !is_flat {
                length("solids.shape.length", *along)?;
                length("solids.shape.far", *far)?;
            }
        }
        Shape::Polygon { corners } => polygon(number, corners)?,
    }
    let dimension = match (&solid.shape, is_flat) {
        (Shape::Cylinder { .. }, true) => Some(("shape Cylinder", "dimension Two", "in 2D use a Ball or a Box")),
        (Shape::Polygon { .. }, false) => Some(("shape Polygon", "dimension Three", "in 3D use a Box")),
        _ => None,
    };
    if let Some((what, other, why)) = dimension {
        return Err(not_together(what, other, why));
    }
    let is_sheet = matches!(solid.shape, Shape::Facet { .. });
    if is_sheet && (solid.hollow || matches!(solid.model, SolidModel::ClosedForm | SolidModel::Particles)) {
        let (other, why) = if solid.hollow {
            (field("solids.hollow"), "turn the facet by 180 degrees instead")
        } else {
            (field("solids.model"), "a sheet has no inside; use Penalty or Repulsion, or a thin Box")
        };
        return Err(not_together("shape Facet", other, why));
    }
    if solid.shape == Shape::Plane && (solid.hollow || solid.model == SolidModel::Particles) {
        let (other, why) = if solid.hollow {
            (field("solids.hollow"), "turn the plane by 180 degrees instead")
        } else {
            (field("solids.model"), "a plane has no end; use one of the walls, or another model")
        };
        return Err(not_together("shape Plane", other, why));
    }
    let spans = |axis: usize| {
        let period = scene.periodic.map_or(f32::MAX, |periodic| periodic.high[axis] - periodic.low[axis]);
        reach(solid, scene.dimension) + scene.particle_spacing > 0.5 * period
    };
    if solid.shape == Shape::Plane {
        return plane_across_periods(scene, number, solid);
    }
    if scene.periodic_axes().any(spans) {
        return Err(not_together(
            field("solids.shape"),
            "periodic",
            "it reaches further than half of the period, so that its own image would be nearer; make it smaller, or \
             the period longer",
        ));
    }
    Ok(())
}

/// Rejects a plane that does not go on as it is across a periodic side.
fn plane_across_periods(scene: &Scene, number: usize, solid: &Solid) -> Result<(), SceneError> {
    let normal = rotation(solid) * Vec3::Y;
    let turns = match solid.motion {
        Motion::Still => false,
        Motion::Prescribed(course) => course.turns_per_second != 0.0 || course.rocking_degrees != 0.0,
        Motion::Driven => true,
    };
    if scene.periodic_axes().any(|axis| turns || normal[axis].abs() > 1e-6) {
        return Err(not_together(
            Field::of_item("solids.shape Plane", number),
            "periodic",
            "a plane must be parallel to every periodic axis, and must not turn, so that it goes on across the sides",
        ));
    }
    Ok(())
}

fn polygon(number: usize, corners: &[Vec2]) -> Result<(), SceneError> {
    let field = Field::of_item("solids.shape.corners", number);
    corners.iter().try_for_each(|corner| finite(field, corner.as_ref()))?;
    bounded(Field::of_item("solids.shape.corners (their number)", number), corners.len() as f32, 3.0..=f32::MAX)?;
    let sides = || corners.iter().zip(corners.iter().cycle().skip(1));
    let area: f32 = sides().map(|(a, b)| 0.5 * a.perp_dot(*b)).sum();
    if area < 0.0 {
        return Err(not_together(
            field,
            "clockwise order",
            "the normals would lead into the solid; reverse the order of the corners, or set hollow if the fluid is \
             inside",
        ));
    }
    positive(Field::of_item("solids.shape.corners (their area)", number), area)?;
    let crosses = |(a, b): (&Vec2, &Vec2), (c, d): (&Vec2, &Vec2)| {
        let turns = |p: &Vec2, q: &Vec2, r: &Vec2| (*q - *p).perp_dot(*r - *p);
        turns(a, b, c) * turns(a, b, d) < 0.0 && turns(c, d, a) * turns(c, d, b) < 0.0
    };
    if sides().enumerate().any(|(i, one)| sides().skip(i + 1).any(|other| crosses(one, other))) {
        return Err(not_together(field, "sides that cross", "inside and outside would not be clear; move a corner"));
    }
    if sides().any(|(a, b)| a == b) {
        return Err(not_together(field, "a side without length", "omit one of two equal corners"));
    }
    Ok(())
}

fn course(scene: &Scene, number: usize, course: &Course) -> Result<(), SceneError> {
    let field = |names| Field::of_item(names, number);
    finite(field("solids.motion.velocity"), course.velocity.as_ref())?;
    finite(field("solids.motion.amplitude"), course.amplitude.as_ref())?;
    finite(field("solids.motion.axis"), course.axis.as_ref())?;
    not_negative(field("solids.motion.frequency"), course.frequency)?;
    share(field("solids.motion.phase"), course.phase)?;
    finite(field("solids.motion.turns_per_second"), &[course.turns_per_second])?;
    finite(field("solids.motion.rocking_degrees"), &[course.rocking_degrees])?;
    let turns = course.turns_per_second != 0.0 || course.rocking_degrees != 0.0;
    let along = Vec3::new(course.axis.x, course.axis.y, 0.0);
    if scene.dimension == Dimension::Two {
        if course.velocity.z != 0.0 || course.amplitude.z != 0.0 || along != Vec3::ZERO {
            return Err(SceneError::OutOfPlane);
        }
    } else if turns {
        positive(field("solids.motion.axis (its length)"), course.axis.length())?;
    }
    if (course.amplitude != Vec3::ZERO || course.rocking_degrees != 0.0) && course.frequency == 0.0 {
        return Err(not_together(
            field("solids.motion.frequency"),
            "an oscillation",
            "without a frequency nothing oscillates; set frequency, or omit amplitude and rocking_degrees",
        ));
    }
    Ok(())
}

/// Checks what solids in closed form need, and that no fluid starts or is emitted inside of a solid.
pub(super) fn check<I: Iterator<Item = InitialParticle>>(
    scene: &Scene,
    scales: &Scales,
    frames: Frames<'_>,
    fluid: impl Fn() -> I,
) -> Result<(), SceneError> {
    if scene.solids.is_empty() {
        return Ok(());
    }
    for (number, solid) in scene.solids.iter().enumerate() {
        if solid.model == SolidModel::ClosedForm {
            closed_form(scene, "solids[].model ClosedForm")?;
            wide_enough(number, solid, scales)?;
        }
        let slack = 1e-4 * scene.particle_spacing;
        let particles = fluid().filter(|particle| frames.distance_of(number, particle.position) < -slack).count();
        if particles > 0 {
            return Err(SceneError::FluidInSolid { solid: number, particles });
        }
        for (emitter, e) in scene.emitters.iter().enumerate() {
            if points(scene, e).any(|point| frames.distance_of(number, point.place.as_vec3()) < 0.0) {
                return Err(not_together(
                    Field::of_item("emitters.position", emitter),
                    Field::of_item("solids", number),
                    "a part of the opening lies inside of the solid, where nothing is made; move one of them, or make \
                     the opening smaller",
                ));
            }
        }
    }
    Ok(())
}

/// Rejects a solid in closed form whose surface bends too much, or that is too narrow for the fluid inside of it.
fn wide_enough(number: usize, solid: &Solid, scales: &Scales) -> Result<(), SceneError> {
    let support = scales.support_radius as f32;
    let field = |names| Field::of_item(names, number);
    let least = if solid.hollow { 2.0 * support } else { support };
    match solid.shape {
        Shape::Ball { radius } | Shape::Cylinder { radius, .. } | Shape::Capsule { radius, .. } => {
            // to first order in the curvature, a surface that bends more would be of no use
            bounded(field("solids.shape.radius (with model ClosedForm)"), radius, least..=f32::MAX)
        }
        Shape::Box { size } if solid.hollow => {
            let narrowest = size.min_element();
            bounded(field("solids.shape.size (with model ClosedForm)"), narrowest, least..=f32::MAX)
        }
        _ => Ok(()),
    }
}
