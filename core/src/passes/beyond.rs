//! Walls in closed form: adds up what lies beyond the planes around a particle.
use super::context::Setup;
use crate::arithmetic::lanes::Lanes;
use crate::arithmetic::real::{div, less, vec3};
use crate::layout::PLANES;
use crate::passes::lists::GROUP;
use crate::terms::beyond::{
    Beyond, DENSITY_GAMMA, DENSITY_SURFACE, PRESSURE_GAMMA, PRESSURE_SURFACE, height_in_front, normal_diagonal,
    normal_mixed, part_in_front, plane_drag, plane_surface,
};
use crate::terms::geometry::dot3;
use crate::terms::pair::Local;

/// A particle in front of walls.
#[derive(Clone, Copy)]
pub(crate) struct Front<R> {
    pub position: vec3<R>,
    pub velocity: vec3<R>,
    /// Support radius over that of the scene.
    pub support: R,
    /// Dynamic viscosity, Pa s.
    pub viscosity: R,
}

impl<R: Lanes> Front<R> {
    /// Returns a particle of a pass over pairs.
    #[inline(always)]
    pub(crate) fn of(a: Local<R>) -> Self {
        Front { position: a.position, velocity: a.velocity, support: a.support, viscosity: a.viscosity }
    }
}

/// Returns what of the pressure kernel lies beyond the walls.
#[inline(always)]
pub(crate) fn of_pressure<R: Lanes>(setup: &Setup<'_>, front: Front<R>) -> Beyond<R> {
    in_lanes(setup, front, [PRESSURE_GAMMA, PRESSURE_SURFACE])
}

/// Returns what of the density kernel lies beyond the walls.
#[inline(always)]
pub(crate) fn of_density<R: Lanes>(setup: &Setup<'_>, front: Front<R>) -> Beyond<R> {
    in_lanes(setup, front, [DENSITY_GAMMA, DENSITY_SURFACE])
}

/// Returns for each plane which part of the pressure kernel lies beyond it.
pub(crate) fn beyond_each(setup: &Setup<'_>, front: Front<f32>) -> [f32; PLANES] {
    parts_in_front(setup, front, PRESSURE_GAMMA).map(|part| 1.0 - part)
}

/// Receiver by receiver, because most are far from all walls.
#[inline(always)]
fn in_lanes<R: Lanes>(setup: &Setup<'_>, front: Front<R>, tables: [u32; 2]) -> Beyond<R> {
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

const ZERO: vec3<f32> = vec3 { x: 0.0, y: 0.0, z: 0.0 };

/// What lies beyond no wall.
const NOTHING: Beyond<f32> =
    Beyond { gamma: 0.0, surface: ZERO, lever: ZERO, lever_mixed: ZERO, approach: 0.0, drag: ZERO };

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
fn beyond(setup: &Setup<'_>, front: Front<f32>, [gamma, surface]: [u32; 2]) -> Beyond<f32> {
    let (p, t) = (setup.parameters, setup.tables);
    let parts = parts_in_front(setup, front, gamma);
    let in_front = parts.iter().fold(1.0, |all, part| all * part);
    let scale = div(1.0, front.support);
    let mut sum = Beyond { gamma: 1.0 - in_front, ..NOTHING };
    let planes = &p.planes[..p.closed_planes as usize];
    for ((part, plane), wall) in parts.iter().zip(planes).zip(&p.plane_velocities) {
        let normal = vec3::splat(*plane);
        let height = height_in_front(front.position, normal, plane[3]);
        let ratio = height * scale * p.inverse_support;
        if !less(ratio, 1.0) {
            continue;
        }
        let w1 = plane_surface(p, t, surface, ratio, scale, div(in_front, *part));
        let slip = front.velocity - vec3::splat(*wall);
        sum.surface = sum.surface + normal * w1;
        sum.lever = sum.lever + normal_diagonal(normal) * (w1 * height);
        sum.lever_mixed = sum.lever_mixed + normal_mixed(normal) * (w1 * height);
        sum.approach -= dot3(slip, normal) * w1;
        sum.drag = sum.drag + plane_drag(p, slip, normal, height, w1, wall[3], front.viscosity);
    }
    sum
}
