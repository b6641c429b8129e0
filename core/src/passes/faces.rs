//! Faces: planes, or what stands for one, in front of a particle, and what they contribute to walls in closed form.
use super::context::Setup;
use crate::arithmetic::lanes::Lanes;
use crate::arithmetic::real::{abs, div, larger, vec3};
use crate::terms::beyond::{Beyond, normal_diagonal, normal_mixed, plane_drag, plane_surface};
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

const ZERO: vec3<f32> = vec3 { x: 0.0, y: 0.0, z: 0.0 };

/// What lies beyond no wall.
pub(super) const NOTHING: Beyond<f32> =
    Beyond { gamma: 0.0, surface: ZERO, lever: ZERO, lever_mixed: ZERO, approach: 0.0, drag: ZERO };

/// A plane, or what stands for one, in front of a particle.
#[derive(Clone, Copy)]
pub(super) struct Face {
    pub normal: vec3<f32>,
    /// Distance of the particle from it, m; negative behind it.
    pub height: f32,
    /// The same over the support radius of the particle.
    pub ratio: f32,
    /// Its velocity, m/s.
    pub velocity: vec3<f32>,
    /// Its dynamic viscosity, Pa s; negative for that of the particle.
    pub viscosity: f32,
}

/// Adds what a face contributes; `share` is the part of its surface that counts.
pub(super) fn with_face(
    setup: &Setup<'_>,
    front: Front<f32>,
    [_, surface, _]: [u32; 3],
    mut sum: Beyond<f32>,
    face: Face,
    share: f32,
) -> Beyond<f32> {
    let (p, t) = (setup.parameters, setup.tables);
    let Face { normal, height, ratio, velocity, viscosity } = face;
    let w1 = plane_surface(p, t, surface, abs(ratio), div(1.0, front.support), share);
    let slip = front.velocity - velocity;
    sum.surface = sum.surface + normal * w1;
    sum.lever = sum.lever + normal_diagonal(normal) * (w1 * height);
    sum.lever_mixed = sum.lever_mixed + normal_mixed(normal) * (w1 * height);
    sum.approach -= dot3(slip, normal) * w1;
    sum.drag = sum.drag + plane_drag(p, slip, normal, larger(height, 0.0), w1, viscosity, front.viscosity);
    sum
}
