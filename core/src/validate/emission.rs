//! Checks emitters, drains and spare particles.
use super::bounds::{bounded, finite, known_fluid, not_negative, not_together, positive};
use super::shapes::MOST_SPACINGS_AWAY;
use crate::derive::emission::{MOST_ACROSS, Point, points};
use crate::derive::scales::Scales;
use crate::error::{Field, SceneError};
use crate::scene::{Dimension, Drain, Emitter, Face, GridStructure, Scene};
use glam::DVec3;

/// Smallest edge of a cell with emitters, in particle spacings: the particles that could be too close to a new one lie
/// in the cells around it, as does a particle that requests air one spacing away.
const CELLS_WITH_EMITTERS: f64 = 1.75;

pub(super) fn check(scene: &Scene, scales: &Scales) -> Result<(), SceneError> {
    scene.emitters.iter().enumerate().try_for_each(|(number, emitter)| numbers(scene, number, emitter))?;
    scene.drains.iter().enumerate().try_for_each(|(number, drain)| region(scene, number, drain))?;
    if !scene.has_turnover() {
        return Ok(());
    }
    let layers: usize = scene.emitters.iter().map(|emitter| points(scene, emitter).count()).sum();
    bounded("spare_particles", scene.spare_particles as f32, layers as f32..=f32::MAX)?;
    scene.emitters.iter().enumerate().try_for_each(|(number, emitter)| placed(scene, number, emitter))?;
    apart(scene)?;
    together(scene, scales)
}

fn numbers(scene: &Scene, number: usize, emitter: &Emitter) -> Result<(), SceneError> {
    let field = |names| Field::of_item(names, number);
    known_fluid(scene, field("emitters.fluid"), emitter.fluid)?;
    let most = MOST_SPACINGS_AWAY * scene.particle_spacing;
    for &x in emitter.position.as_ref() {
        finite(field("emitters.position"), &[x])?;
        bounded(field("emitters.position"), x, -most..=most)?;
    }
    finite(field("emitters.direction"), emitter.direction.as_ref())?;
    finite(field("emitters.direction"), &[emitter.direction.length()])?;
    positive(field("emitters.direction (its length)"), emitter.direction.length())?;
    positive(field("emitters.speed"), emitter.speed)?;
    // at most one layer leaves in a step
    bounded(field("emitters.speed"), emitter.speed, 0.0..=scene.particle_spacing / scene.longest_step())?;
    let spacings = emitter.opening.width() / scene.particle_spacing;
    positive(field("emitters.opening"), emitter.opening.width())?;
    bounded(field("emitters.opening (over the particle_spacing)"), spacings, 0.0..=MOST_ACROSS as f32)?;
    bounded(field("emitters.spread_degrees"), emitter.spread_degrees, 0.0..=80.0)?;
    not_negative(field("emitters.start"), emitter.start)?;
    emitter.duration.map_or(Ok(()), |duration| positive(field("emitters.duration"), duration))?;
    emitter.life.map_or(Ok(()), |life| positive(field("emitters.life"), life))?;
    if scene.dimension == Dimension::Two && (emitter.position.z != 0.0 || emitter.direction.z != 0.0) {
        return Err(SceneError::OutOfPlane);
    }
    Ok(())
}

fn region(scene: &Scene, number: usize, drain: &Drain) -> Result<(), SceneError> {
    let field = |names| Field::of_item(names, number);
    match drain {
        Drain::Box { low, high } => {
            finite(field("drains.low"), low.as_ref())?;
            finite(field("drains.high"), high.as_ref())?;
            for axis in 0..scene.dimension.count() {
                positive(field("drains.high (above low)"), high[axis] - low[axis])?;
            }
            Ok(())
        }
        Drain::Ball { centre, radius } => {
            finite(field("drains.centre"), centre.as_ref())?;
            if scene.dimension == Dimension::Two && centre.z != 0.0 {
                return Err(SceneError::OutOfPlane);
            }
            positive(field("drains.radius"), *radius)?;
            positive(field("drains.radius (squared)"), radius * radius)
        }
    }
}

/// Rejects an emitter whose points lie behind a plane of the container or in a drain.
fn placed(scene: &Scene, number: usize, emitter: &Emitter) -> Result<(), SceneError> {
    let faces = scene.container.iter().flat_map(|container| {
        Face::ALL.iter().filter(|face| scene.is_closed(container, **face)).map(move |face| (container, face))
    });
    for (container, face) in faces {
        let axis = face.axis();
        let behind = |point: &Point| {
            let x = point.place[axis];
            if face.is_high() { x > f64::from(container.high[axis]) } else { x < f64::from(container.low[axis]) }
        };
        if points(scene, emitter).any(|point| behind(&point)) {
            return Err(not_together(
                Field::of_item("emitters.position", number),
                "container",
                "a part of the opening lies behind a plane of the container, where nothing is made; move the emitter \
                 into the container, make its opening smaller, or leave that face open",
            ));
        }
    }
    for drain in &scene.drains {
        let taken = |point: &Point| match drain {
            Drain::Box { low, high } => (0..scene.dimension.count())
                .all(|axis| (f64::from(low[axis])..=f64::from(high[axis])).contains(&point.place[axis])),
            Drain::Ball { centre, radius } => (point.place - centre.as_dvec3()).length() < f64::from(*radius),
        };
        if points(scene, emitter).any(|point| taken(&point)) {
            return Err(not_together(
                Field::of_item("emitters.position", number),
                "drains",
                "a drain would take the particles of this emitter as soon as they are made; move one of them",
            ));
        }
    }
    Ok(())
}

/// Rejects emitters with points less than a particle spacing apart: both would make particles at the same place.
fn apart(scene: &Scene) -> Result<(), SceneError> {
    let spacing = f64::from(scene.particle_spacing);
    let period = |axis: usize| scene.periodic.map_or(0.0, |p| f64::from(p.high[axis]) - f64::from(p.low[axis]));
    // across a periodic side the nearest image counts
    let distance = |a: DVec3, b: DVec3| {
        let mut x_ab = a - b;
        for axis in scene.periodic_axes() {
            x_ab[axis] -= period(axis) * libm::round(x_ab[axis] / period(axis));
        }
        x_ab.length()
    };
    for (number, one) in scene.emitters.iter().enumerate() {
        // across its diagonal a square is wider
        if scene.periodic_axes().any(|axis| f64::from(one.opening.width()) * 1.5 + spacing > period(axis)) {
            return Err(not_together(
                Field::of_item("emitters.opening", number),
                "periodic",
                "the opening is too wide for the period, so that its own image is in front of it; make it smaller",
            ));
        }
        for other in scene.emitters.iter().take(number) {
            // across its diagonal a square is wider
            let reach = f64::from(one.opening.width() + other.opening.width()) * 0.75 + 2.0 * spacing;
            let is_far = distance(one.position.as_dvec3(), other.position.as_dvec3()) > reach;
            let is_near = |a: Point| points(scene, other).any(|b| distance(a.place, b.place) < 0.999 * spacing);
            if !is_far && points(scene, one).any(is_near) {
                return Err(not_together(
                    Field::of_item("emitters.position", number),
                    "another emitter",
                    "their openings overlap; move one of them, or make it smaller",
                ));
            }
        }
    }
    Ok(())
}

/// Rejects choices that do not go with particles that come and go.
fn together(scene: &Scene, scales: &Scales) -> Result<(), SceneError> {
    let what = match (scene.emitters.is_empty(), scene.drains.is_empty()) {
        (false, _) => "emitters",
        (true, false) => "drains",
        (true, true) => "spare_particles",
    };
    if matches!(scene.grid.structure, GridStructure::CellLists { .. }) {
        return Err(not_together(
            what,
            "grid.structure CellLists",
            "inactive particles share one cell, which would need a place for each of them; use grid.structure \
             IndexSort",
        ));
    }
    if scales.least_cell < CELLS_WITH_EMITTERS * f64::from(scene.particle_spacing) {
        return Err(not_together(
            what,
            "such a small average_neighbours",
            "the support radius must be at least 1.75 particle spacings, so that new particles keep their distance; \
             increase average_neighbours",
        ));
    }
    if let Some(number) = scene.emitters.iter().position(|e| scene.air.is_some_and(|air| air.fluid == e.fluid)) {
        return Err(not_together(
            Field::of_item("emitters.fluid", number),
            "air.fluid",
            "air that no liquid exposes would be thin, and vanish; let the emitter make another fluid",
        ));
    }
    if !scene.model.integrator.allows_changing_steps() {
        return Err(not_together(
            what,
            "model.integrator Verlet or any variant of Beeman",
            "they need a history of the last step, which new particles do not have; use another integrator, such as \
             ModifiedVelocityVerlet",
        ));
    }
    if scene.model.internal_energy {
        return Err(not_together(
            what,
            "model.internal_energy",
            "the internal energy of new particles is not set yet; turn internal_energy off",
        ));
    }
    if scene.fluids.iter().any(|fluid| fluid.elastic_stiffness > 0.0) {
        return Err(not_together(
            what,
            "an elastic_stiffness above 0",
            "springs would stay attached to particles that have become inactive; set it to 0 in every fluid",
        ));
    }
    Ok(())
}
