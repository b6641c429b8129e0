//! Walls in closed form: adds up what lies beyond the planes and the solids around a particle.
use super::closed_solids;
use super::context::Setup;
pub(crate) use super::faces::Front;
use super::faces::{Face, NOTHING, with_face};
use crate::arithmetic::lanes::Lanes;
use crate::arithmetic::real::{div, less, vec3};
use crate::layout::PLANES;
use crate::passes::lists::GROUP;
use crate::terms::beyond::{
    Beyond, DENSITY_BENDING, DENSITY_GAMMA, DENSITY_SURFACE, PRESSURE_BENDING, PRESSURE_GAMMA, PRESSURE_SURFACE,
    height_in_front, part_in_front,
};

/// Returns what of the pressure kernel lies beyond the walls.
#[inline(always)]
pub(crate) fn of_pressure<R: Lanes>(setup: &Setup<'_>, front: Front<R>) -> Beyond<R> {
    in_lanes(setup, front, [PRESSURE_GAMMA, PRESSURE_SURFACE, PRESSURE_BENDING])
}

/// Returns what of the density kernel lies beyond the walls.
#[inline(always)]
pub(crate) fn of_density<R: Lanes>(setup: &Setup<'_>, front: Front<R>) -> Beyond<R> {
    in_lanes(setup, front, [DENSITY_GAMMA, DENSITY_SURFACE, DENSITY_BENDING])
}

/// What of the pressure kernel lies beyond one of the walls, for the forces on it.
pub(crate) struct OneWall {
    /// What it contributes to that of all walls.
    pub beyond: Beyond<f32>,
    /// Which share of the parts that lie beyond walls lies beyond this one.
    pub share: f32,
    /// Vector from the particle to its surface, m.
    pub foot: vec3<f32>,
}

/// Returns what lies beyond one wall, by its index: first the planes, then the solids. `None` if it is far away.
pub(crate) fn of_wall(setup: &Setup<'_>, front: Front<f32>, wall: usize) -> Option<OneWall> {
    let tables = [PRESSURE_GAMMA, PRESSURE_SURFACE, PRESSURE_BENDING];
    let parts = parts_in_front(setup, front, PRESSURE_GAMMA);
    let mut in_front = parts.iter().fold(1.0, |all, part| all * part);
    let mut sum = parts.iter().map(|part| 1.0 - part).sum::<f32>();
    for (_, part) in closed_solids::parts(setup, front, tables) {
        in_front *= 1.0 - part;
        sum += part;
    }
    if wall >= PLANES {
        let (beyond, part, foot) = closed_solids::of_solid(setup, front, tables, in_front, wall - PLANES)?;
        return (part > 0.0).then_some(OneWall { beyond, share: part / sum, foot });
    }
    let part = *parts.get(wall).filter(|part| **part < 1.0)?;
    let face = plane_face(setup, front, wall);
    let beyond = with_face(setup, front, tables, NOTHING, face, div(in_front, part));
    Some(OneWall { beyond, share: (1.0 - part) / sum, foot: face.normal * -face.height })
}

/// Returns a plane as a face.
fn plane_face(setup: &Setup<'_>, front: Front<f32>, plane: usize) -> Face {
    let p = setup.parameters;
    let (plane, wall) = (p.planes[plane], p.plane_velocities[plane]);
    let normal = vec3::splat(plane);
    let height = height_in_front(front.position, normal, plane[3]);
    let ratio = height * div(1.0, front.support) * p.inverse_support;
    Face { normal, height, ratio, velocity: vec3::splat(wall), viscosity: wall[3] }
}

/// Receiver by receiver, because most are far from all walls.
#[inline(always)]
fn in_lanes<R: Lanes>(setup: &Setup<'_>, front: Front<R>, tables: [u32; 3]) -> Beyond<R> {
    let mut each = [NOTHING; GROUP];
    for (receiver, own) in each.iter_mut().enumerate().take(R::RECEIVERS) {
        let lane = receiver * R::NEIGHBOURS;
        let of = |v: vec3<R>| vec3(v.x.lane(lane), v.y.lane(lane), v.z.lane(lane));
        let front = Front {
            position: of(front.position),
            velocity: of(front.velocity),
            support: front.support.lane(lane),
            viscosity: front.viscosity.lane(lane),
        };
        *own = beyond(setup, front, tables);
    }
    let number = |of: fn(&Beyond<f32>) -> f32| R::from_lanes(|lane| of(&each[lane / R::NEIGHBOURS]));
    let vector = |of: fn(&Beyond<f32>) -> vec3<f32>| {
        let along = |axis: fn(vec3<f32>) -> f32| R::from_lanes(|lane| axis(of(&each[lane / R::NEIGHBOURS])));
        vec3(along(|v| v.x), along(|v| v.y), along(|v| v.z))
    };
    Beyond {
        gamma: number(|b| b.gamma),
        surface: vector(|b| b.surface),
        lever: vector(|b| b.lever),
        lever_mixed: vector(|b| b.lever_mixed),
        approach: number(|b| b.approach),
        drag: vector(|b| b.drag),
    }
}

/// Returns for each plane which part of a kernel lies in front of it, by the table of its gamma.
fn parts_in_front(setup: &Setup<'_>, front: Front<f32>, gamma: u32) -> [f32; PLANES] {
    let (p, t) = (setup.parameters, setup.tables);
    let mut parts = [1.0; PLANES];
    for (part, plane) in parts.iter_mut().zip(&p.planes[..p.closed_planes as usize]) {
        let height = height_in_front(front.position, vec3::splat(*plane), plane[3]);
        let ratio = height * div(1.0, front.support) * p.inverse_support;
        if less(ratio, 1.0) {
            *part = part_in_front(t, gamma, ratio);
        }
    }
    parts
}

#[inline(never)]
fn beyond(setup: &Setup<'_>, front: Front<f32>, tables: [u32; 3]) -> Beyond<f32> {
    let p = setup.parameters;
    let [gamma, ..] = tables;
    let parts = parts_in_front(setup, front, gamma);
    let mut in_front = parts.iter().fold(1.0, |all, part| all * part);
    if setup.model.has_solids == 1 {
        in_front = closed_solids::part_in_front(setup, front, tables, in_front);
    }
    let mut sum = Beyond { gamma: 1.0 - in_front, ..NOTHING };
    for (plane, part) in parts.iter().enumerate().take(p.closed_planes as usize) {
        let face = plane_face(setup, front, plane);
        if less(face.ratio, 1.0) {
            sum = with_face(setup, front, tables, sum, face, div(in_front, *part));
        }
    }
    if setup.model.has_solids == 1 {
        sum = closed_solids::with_solids(setup, front, tables, sum, in_front);
    }
    sum
}
