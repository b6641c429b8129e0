//! Penalty walls (Pirovano, section 3.5.1). A wall is a plane `n . x = offset` with its normal n towards the fluid; a particle
//! found behind it is put back and its velocity reflected.
use super::geometry::*;
use super::wall::*;
use crate::arithmetic::real::*;
use crate::layout::{Model, Parameters, StepUniform};

/// How far a particle stands behind the plane, m; negative in front of it.
#[inline(always)]
pub fn depth_behind<R: Real>(position: vec3<R>, normal: vec3<R>, offset: R) -> R {
    return offset - dot3(position, normal);
}

/// The same for a particle of the fluid; one of a wall, or of air that is not there, stands where it stands.
#[inline(always)]
pub fn depth_if_free<R: Real>(m: &Model, depth: R, wall: R) -> R {
    if m.wall_particles + m.has_air == NO_WALLS {
        return depth;
    }
    return select(depth, real(0.0), less(real(0.0), wall));
}

/// `behind` for a particle behind the plane, else `before`.
#[inline(always)]
pub fn select_if_behind<R: Real>(before: vec3<R>, behind: vec3<R>, depth: R) -> vec3<R> {
    let nothing: R = real(0.0);
    return vec3(
        select(before.x, behind.x, less(nothing, depth)),
        select(before.y, behind.y, less(nothing, depth)),
        select(before.z, behind.z, less(nothing, depth)),
    );
}

/// The particle, put back on the plane along the normal where it stands behind (Pirovano figure 3.7).
#[inline(always)]
pub fn put_back<R: Real>(position: vec3<R>, normal: vec3<R>, depth: R) -> vec3<R> {
    return flush3(position + normal * larger(depth, real(0.0)));
}

/// How much of the normal velocity is given back: all that `restitution` says, or, conserving energy (Kelager 2006; Pirovano figure
/// 3.8), only the share of the step's path that lay behind the wall, `depth / (|v| dt)`, which is at most all of it.
#[inline(always)]
pub fn returned_share<R: Real>(m: &Model, p: &Parameters, u: &StepUniform, velocity: vec3<R>, depth: R) -> R {
    let all: R = real(p.restitution);
    if m.has_conserving_reflection == 0 {
        return all;
    }
    let path = root(length2(velocity)) * u.time_step;
    return smaller(div(depth, path), real(1.0)) * all;
}

/// `v' = -bounce v_n + slip v_t` for a particle behind the wall (Pirovano 3.5.1); one that already leaves it keeps its v_n.
#[inline(always)]
pub fn reflect<R: Real>(
    m: &Model,
    p: &Parameters,
    u: &StepUniform,
    velocity: vec3<R>,
    normal: vec3<R>,
    depth: R,
) -> vec3<R> {
    let along = dot3(velocity, normal);
    let leaving = larger(along, real(0.0));
    let entering = larger(-along, real(0.0));
    let new_along = leaving + entering * returned_share(m, p, u, velocity, depth);
    let tangent = (velocity - normal * along) * real(p.slip);
    let turned = tangent + normal * new_along;
    return flush3(select_if_behind(velocity, turned, depth));
}
