//! Checks the numbers of a scene one by one: finite, positive, within bounds.
use super::bounds::{MOST_PARTICLES, bounded, finite, known_fluid, not_negative, not_together, positive, share};
use super::time::step_lengths;
use crate::axis::Axis;
use crate::derive::counts::field_counts;
use crate::derive::lattice_sums::MOST_SPACINGS;
use crate::derive::scales::{Scales, average_neighbours, neighbours_within};
use crate::error::{Field, SceneError};
use crate::scene::{Fluid, Formulation, Scene};

/// Largest number of nodes of an acceleration field, 64 MiB.
const MOST_NODES: u32 = 1 << 22;

/// Checks the numbers from which all lengths, times and masses are derived.
pub(super) fn numbers(scene: &Scene) -> Result<(), SceneError> {
    positive("particle_spacing", scene.particle_spacing)?;
    if let Some(own) = scene.average_neighbours {
        neighbours("average_neighbours", own)?;
    }
    if let Some(ratio) = scene.smoothing_ratio {
        positive("smoothing_ratio", ratio)?;
        if scene.average_neighbours.is_some() {
            let why = "both set the support radius; leave one of them out";
            return Err(not_together("smoothing_ratio", "average_neighbours", why));
        }
        neighbours("smoothing_ratio", neighbours_within(scene.dimension, ratio))?;
    }
    positive("time_step", scene.time_step)?;
    step_lengths(scene)?;
    finite("gravity", scene.gravity.as_ref())?;
    surroundings(scene)?;
    if scene.fluids.is_empty() {
        return Err(SceneError::NoFluid);
    }
    scene.fluids.iter().enumerate().try_for_each(fluid)?;
    coefficients(&scene.model)
}

/// Rejects support radii of too many particle spacings for sums over the lattice, where the scene needs these sums.
pub(super) fn reach(scene: &Scene, scales: &Scales) -> Result<(), SceneError> {
    let sums = scene.model.normalize_mass || scene.corrects_pressure();
    let elastic = scene.fluids.iter().any(|fluid| fluid.elastic_stiffness > 0.0);
    if (sums || elastic || scene.has_wall_particles()) && scales.spacings(scene) > MOST_SPACINGS {
        let field = if scene.smoothing_ratio.is_some() { "smoothing_ratio" } else { "average_neighbours" };
        return Err(SceneError::OutOfScale {
            field: field.into(),
            value: scene.smoothing_ratio.unwrap_or(average_neighbours(scene)),
        });
    }
    Ok(())
}

fn surroundings(scene: &Scene) -> Result<(), SceneError> {
    not_negative("ambient_density", scene.ambient_density)?;
    if let Some(wind) = &scene.wind {
        finite("wind.velocity", wind.velocity.as_ref())?;
        not_negative("wind.drag", wind.drag)?;
    }
    if let Some(field) = &scene.acceleration_field {
        finite("acceleration_field.low", field.low.as_ref())?;
        positive("acceleration_field.spacing", field.spacing)?;
        finite("acceleration_field.spacing", &[1.0 / field.spacing])?;
        for (axis, &points) in field.counts.iter().enumerate().take(scene.dimension.count()) {
            if points < 2 {
                return Err(SceneError::TooFewPoints { axis: Axis::of(axis), points });
            }
        }
        let (points, least) = (field_counts(scene)[3] as f32, 2u32.pow(scene.dimension.count() as u32) as f32);
        bounded("acceleration_field.counts (multiplied)", points, least..=MOST_NODES as f32)?;
    }
    Ok(())
}

/// Checks the numbers of surfaces and of the layer of air.
pub(super) fn surface(scene: &Scene) -> Result<(), SceneError> {
    positive("model.surface_threshold", scene.model.surface_threshold)?;
    let Some(air) = &scene.air else { return Ok(()) };
    known_fluid(scene, "air.fluid", air.fluid)?;
    positive("air.capacity", air.capacity as f32)?;
    positive("air.threshold", air.threshold)?;
    share("air.minimum_density", air.minimum_density)
}

/// Checks the numbers of the springs.
pub(super) fn elasticity(scene: &Scene) -> Result<(), SceneError> {
    let elasticity = &scene.elasticity;
    positive("elasticity.reach", elasticity.reach)?;
    if let Some(plasticity) = elasticity.plasticity {
        positive("elasticity.plasticity.rate", plasticity.rate)?;
        not_negative("elasticity.plasticity.yield_strain", plasticity.yield_strain)?;
        // a step may not remove more than the whole strain, or its sign would change
        let most = 1.0 / scene.longest_step();
        bounded("elasticity.plasticity.rate", plasticity.rate, 0.0..=most)?;
    }
    match elasticity.break_at {
        Some(stretch) => positive("elasticity.break_at", stretch),
        None => Ok(()),
    }
}

/// Checks the coefficients of formulas, which are the same for all fluids.
fn coefficients(model: &Formulation) -> Result<(), SceneError> {
    bounded("model.tait_exponent", model.tait_exponent as f32, 1.0..=7.0)?;
    share("model.diffusion", model.diffusion)?;
    not_negative("model.alpha", model.alpha)?;
    not_negative("model.beta", model.beta)?;
    share("model.velocity_exchange", model.velocity_exchange)?;
    share("model.radial_exchange", model.radial_exchange)?;
    share("model.xsph", model.xsph)?;
    share("model.shifting_coefficient", model.shifting_coefficient)?;
    if let Some(speed) = model.shifting_speed {
        positive("model.shifting_speed", speed)?;
    }
    not_negative("model.wall_rigidity", model.wall_rigidity)?;
    share("model.heat_gain", model.heat_gain)
}

fn fluid((number, fluid): (usize, &Fluid)) -> Result<(), SceneError> {
    let field = |names| Field::of_item(names, number);
    positive(field("fluids.rest_density"), fluid.rest_density)?;
    positive(field("fluids.speed_of_sound"), fluid.speed_of_sound)?;
    if let Some(own) = fluid.average_neighbours {
        neighbours(field("fluids.average_neighbours"), own)?;
    }
    if let Some(stiffness) = fluid.stiffness {
        positive(field("fluids.stiffness"), stiffness)?;
    }
    not_negative(field("fluids.dynamic_viscosity"), fluid.dynamic_viscosity)?;
    not_negative(field("fluids.surface_tension"), fluid.surface_tension)?;
    not_negative(field("fluids.elastic_stiffness"), fluid.elastic_stiffness)?;
    not_negative(field("fluids.near_stiffness"), fluid.near_stiffness.unwrap_or(0.0))?;
    not_negative(field("fluids.internal_energy"), fluid.internal_energy)?;
    fluid.colour.iter().flatten().try_for_each(|&colour| share(field("fluids.colour"), colour))
}

/// Rejects neighbour counts for which derived constants would not be finite, so that the error names this field and
/// not another.
fn neighbours(field: impl Into<Field>, value: f32) -> Result<(), SceneError> {
    let field = field.into();
    positive(field, value)?;
    bounded(field, value, 0.001..=MOST_PARTICLES as f32)
}
