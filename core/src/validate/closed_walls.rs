//! Checks walls in closed form, and the settings of a container that only they use.
use super::bounds::{finite, not_negative, not_together};
use crate::axis::Axis;
use crate::derive::scales::Scales;
use crate::error::{Field, SceneError};
use crate::scene::{Face, Kernel, NearPressure, PlaneModel, Scene, SurfaceTension};

pub(super) fn check(scene: &Scene, scales: &Scales) -> Result<(), SceneError> {
    let Some(container) = &scene.container else { return Ok(()) };
    not_negative("container.dynamic_viscosity", container.dynamic_viscosity.unwrap_or(0.0))?;
    for (number, sliding) in container.sliding.iter().enumerate() {
        let field = |names| Field::of_item(names, number);
        finite(field("container.sliding[].velocity"), sliding.velocity.as_ref())?;
        if sliding.velocity[sliding.face.axis()] != 0.0 {
            return Err(not_together(
                field("container.sliding[].velocity"),
                "the normal of its face",
                "a face slides along itself; set the component along the normal to 0",
            ));
        }
        if !scene.is_closed(container, sliding.face) {
            return Err(not_together(
                field("container.sliding[].face"),
                "a face without a plane",
                "it is open, or its axis is periodic; omit it",
            ));
        }
        if container.sliding[..number].iter().any(|other| other.face == sliding.face) {
            return Err(not_together(
                field("container.sliding[].face"),
                "another item of container.sliding with the same face",
                "a face has one velocity; omit one of them",
            ));
        }
    }
    if container.model == PlaneModel::Penalty {
        let unused = [
            (container.dynamic_viscosity.is_some(), "container.dynamic_viscosity"),
            (!container.sliding.is_empty(), "container.sliding"),
        ];
        let first = unused.into_iter().find(|(is_set, _)| *is_set);
        return first.map_or(Ok(()), |(_, field)| {
            Err(not_together(field, "container.model Penalty", "penalty planes have no friction; use ClosedForm"))
        });
    }
    closed_form(scene, "container.model ClosedForm")?;
    // beyond two parallel planes a kernel must not lie at the same time
    for axis in 0..scene.dimension.count() {
        let [low, high] = [container.low[axis], container.high[axis]];
        let faces = Face::ALL[2 * axis..][..2].iter().filter(|face| scene.is_closed(container, **face)).count();
        let least = (2.0 * scales.least_cell) as f32;
        if faces == 2 && high - low < least {
            return Err(SceneError::NarrowContainer { axis: Axis::of(axis), width: high - low, least });
        }
    }
    Ok(())
}

/// Rejects choices that do not go with walls in closed form; `walls` names the choice that asks for these.
pub(super) fn closed_form(scene: &Scene, walls: &'static str) -> Result<(), SceneError> {
    let model = &scene.model;
    let refused = [
        (
            model.near_pressure != NearPressure::Off,
            "model.near_pressure",
            "near pressure would miss the walls; set near_pressure Off, and use shifting if particles pair, or \
             use model Penalty",
        ),
        (
            model.internal_energy,
            "model.internal_energy",
            "the work of the walls is not divided between the fluid and its continuation beyond them; use walls of \
             particles, or model Penalty",
        ),
        (
            model.surface_tension == SurfaceTension::Curvature,
            "model.surface_tension Curvature",
            "the Laplacian of the colour would miss the walls; use NormalCurvature, or model Penalty",
        ),
        (
            model.pressure_kernel == Kernel::Viscosity,
            "model.pressure_kernel Viscosity",
            "it is infinite at distance 0; use another pressure_kernel, or model Penalty",
        ),
    ];
    if let Some((_, field, why)) = refused.into_iter().find(|(is_asked, ..)| *is_asked) {
        return Err(not_together(walls, field, why));
    }
    Ok(())
}
