//! Penalty planes (Pirovano, section 3.5.1). A plane is `n . x = offset`, and its normal n points towards the fluid. A
//! particle found behind the plane is moved back onto it, and its velocity is reflected.
use super::geometry::*;
use super::wall::*;
use crate::arithmetic::real::*;
use crate::layout::{Model, Parameters, StepUniform};

/// Returns the distance of a particle behind the plane, m; negative in front of it.
#[inline(always)]
pub fn depth_behind<R: Real>(position: vec3<R>, normal: vec3<R>, offset: R) -> R {
    return offset - dot3(position, normal);
}

/// Returns `depth` for a fluid particle, and 0 for a wall particle or an inactive particle, which planes do not
/// move.
#[inline(always)]
pub fn depth_if_free<R: Real>(m: &Model, depth: R, wall: R) -> R {
    if m.wall_particles + m.has_inactive == NO_WALLS {
        return depth;
    }
    return select(depth, real(0.0), less(real(0.0), wall));
}

/// Returns `behind` for a particle behind the plane, else `before`.
#[inline(always)]
pub fn select_if_behind<R: Real>(before: vec3<R>, behind: vec3<R>, depth: R) -> vec3<R> {
    let nothing: R = real(0.0);
    return vec3(
        select(before.x, behind.x, less(nothing, depth)),
        select(before.y, behind.y, less(nothing, depth)),
        select(before.z, behind.z, less(nothing, depth)),
    );
}

/// Returns the position of a particle, moved along the normal onto the plane if it is behind it (Pirovano, figure 3.7).
#[inline(always)]
pub fn put_back<R: Real>(position: vec3<R>, normal: vec3<R>, depth: R) -> vec3<R> {
    return flush3(position + normal * larger(depth, real(0.0)));
}

/// Returns the share of the normal velocity that the plane gives back. It is `restitution`, or, if the reflection
/// conserves energy (Kelager 2006; Pirovano, figure 3.8), `restitution` times the share of the step's path that lay
/// behind the plane, `depth / (|v| dt)`, which is at most 1.
#[inline(always)]
pub fn returned_share<R: Real>(m: &Model, p: &Parameters, u: &StepUniform, velocity: vec3<R>, depth: R) -> R {
    let all: R = real(p.restitution);
    if m.has_conserving_reflection == 0 {
        return all;
    }
    return all * share_behind(u, velocity, depth);
}

/// Returns the share of a step's path that lay behind the plane, `depth / (|v| dt)`, which is at most 1.
#[inline(always)]
pub fn share_behind<R: Real>(u: &StepUniform, velocity: vec3<R>, depth: R) -> R {
    let path = root(length2(velocity)) * u.time_step;
    return smaller(div(depth, path), real(1.0));
}

/// Returns `v' = -bounce v_n + slip v_t` for a particle behind the plane (Pirovano, section 3.5.1), where `bounce` is
/// the [`returned_share`]. A particle that already moves away from the plane keeps its v_n.
#[inline(always)]
pub fn reflect<R: Real>(
    m: &Model,
    p: &Parameters,
    u: &StepUniform,
    velocity: vec3<R>,
    normal: vec3<R>,
    depth: R,
) -> vec3<R> {
    let turned = reflected(velocity, normal, returned_share(m, p, u, velocity, depth), real(p.slip));
    return flush3(select_if_behind(velocity, turned, depth));
}

/// Returns `v' = -bounce v_n + slip v_t`, where a velocity that already leads away keeps its v_n.
#[inline(always)]
pub fn reflected<R: Real>(velocity: vec3<R>, normal: vec3<R>, bounce: R, slip: R) -> vec3<R> {
    let along = dot3(velocity, normal);
    let leaving = larger(along, real(0.0));
    let entering = larger(-along, real(0.0));
    let tangent = (velocity - normal * along) * slip;
    return tangent + normal * (leaving + entering * bounce);
}

/// Returns which share of a way of this length has been traced; 0 for no way.
#[inline(always)]
pub fn share_of_way<R: Real>(traced: R, length: R) -> R {
    let nothing: R = real(0.0);
    let one: R = real(1.0);
    let has_length = less(nothing, length);
    return select(nothing, div(traced, select(one, length, has_length)), has_length);
}
