//! Shapes: signed distance from a surface, its outward normal, and its curvature, in the frame of the shape. The
//! distance is positive outside. Nowhere does it change faster than the position does, which is what a search for the
//! first point of a path inside of a shape relies on (Hart 1996).
//!
//! `size` is the radius (ball); half of the edges (box); radius and half of the height (cylinder); radius and half of
//! the length (capsule); half of the widths at the two ends and half of the length (facet).
use super::geometry::*;
use crate::arithmetic::real::*;
use crate::layout::{Model, Parameters};

/// The half space below y = 0.
pub const PLANE: u32 = 0;
/// A ball.
pub const BALL: u32 = 1;
/// A box.
pub const BOX: u32 = 2;
/// A cylinder along y.
pub const CYLINDER: u32 = 3;
/// A capsule along y.
pub const CAPSULE: u32 = 4;
/// A polygon in the plane.
pub const POLYGON: u32 = 5;
/// A flat sheet with one side.
pub const FACET: u32 = 6;

/// Returns -1 for a negative number, else 1.
#[inline(always)]
pub fn sign_of<R: Real>(x: R) -> R {
    return select(real(1.0), real(-1.0), less(x, real(0.0)));
}

/// Returns a vector over its length, or `other` if it has none.
#[inline(always)]
pub fn direction_or<R: Real>(v: vec3<R>, other: vec3<R>) -> vec3<R> {
    let length = root(length2(v));
    let nothing: R = real(0.0);
    let has_one = less(nothing, length);
    let safe = select(real(1.0), length, has_one);
    return vec3(
        select(other.x, div(v.x, safe), has_one),
        select(other.y, div(v.y, safe), has_one),
        select(other.z, div(v.z, safe), has_one),
    );
}

/// Returns the distance from a rectangle or a box from how far the point lies beyond each pair of its sides.
#[inline(always)]
pub fn distance_beyond<R: Real>(beyond: vec3<R>) -> R {
    let nothing: R = real(0.0);
    let out = vec3(larger(beyond.x, nothing), larger(beyond.y, nothing), larger(beyond.z, nothing));
    let most = larger(larger(beyond.x, beyond.y), beyond.z);
    return root(length2(out)) + smaller(most, nothing);
}

/// Returns the normal at the point of a box that is nearest to `x`.
#[inline(always)]
pub fn normal_beyond<R: Real>(beyond: vec3<R>, x: vec3<R>) -> vec3<R> {
    let nothing: R = real(0.0);
    let one: R = real(1.0);
    let out = vec3(larger(beyond.x, nothing), larger(beyond.y, nothing), larger(beyond.z, nothing));
    // inside: the side that is nearest
    let along_y = select(nothing, one, less(beyond.x, beyond.y));
    let y_or_x = larger(beyond.x, beyond.y);
    let along_z = select(nothing, one, less(y_or_x, beyond.z));
    let not_z = one - along_z;
    let nearest = vec3((one - along_y) * not_z, along_y * not_z, along_z);
    let n = direction_or(out, nearest);
    return vec3(n.x * sign_of(x.x), n.y * sign_of(x.y), n.z * sign_of(x.z));
}

/// Returns how far a point lies beyond each pair of sides of a box, m; negative between them. In 2D there are none
/// along z.
#[inline(always)]
pub fn beyond_sides<R: Real>(m: &Model, size: vec3<R>, x: vec3<R>) -> vec3<R> {
    let inside: R = real(-1.0e30);
    if m.is_3d == 0 {
        return vec3(abs(x.x) - size.x, abs(x.y) - size.y, inside);
    }
    return vec3(abs(x.x) - size.x, abs(x.y) - size.y, abs(x.z) - size.z);
}

/// Returns how far a point lies beyond the side of a cylinder and beyond its ends, m.
#[inline(always)]
pub fn beyond_cylinder<R: Real>(size: vec3<R>, x: vec3<R>) -> vec3<R> {
    let away = root(x.x * x.x + x.z * x.z);
    return vec3(away - size.x, abs(x.y) - size.y, real(-1.0e30));
}

/// Returns the vector from the nearest point of the line in a capsule.
#[inline(always)]
pub fn from_line<R: Real>(size: vec3<R>, x: vec3<R>) -> vec3<R> {
    let over = larger(abs(x.y) - size.y, real(0.0));
    return vec3(x.x, over * sign_of(x.y), x.z);
}

/// Returns the signed distance from a shape that is not a polygon, m.
#[inline(always)]
pub fn shape_distance<R: Real>(m: &Model, kind: u32, size: vec3<R>, x: vec3<R>) -> R {
    if kind == BALL {
        return root(length2(x)) - size.x;
    }
    if kind == BOX {
        return distance_beyond(beyond_sides(m, size, x));
    }
    if kind == CYLINDER {
        return distance_beyond(beyond_cylinder(size, x));
    }
    if kind == CAPSULE {
        return root(length2(from_line(size, x))) - size.x;
    }
    return x.y;
}

/// Returns the outward normal at the nearest point of the surface of a shape that is not a polygon.
#[inline(always)]
pub fn shape_normal<R: Real>(m: &Model, kind: u32, size: vec3<R>, x: vec3<R>) -> vec3<R> {
    let nothing: R = real(0.0);
    let along_x = vec3(real(1.0), nothing, nothing);
    if kind == BALL {
        return direction_or(x, along_x);
    }
    if kind == BOX {
        return normal_beyond(beyond_sides(m, size, x), x);
    }
    if kind == CYLINDER {
        let away = direction_or(vec3(x.x, nothing, x.z), along_x);
        let n = normal_beyond(beyond_cylinder(size, x), vec3(real(1.0), x.y, real(1.0)));
        return vec3(away.x * n.x, n.y, away.z * n.x);
    }
    if kind == CAPSULE {
        return direction_or(from_line(size, x), along_x);
    }
    return vec3(nothing, real(1.0), nothing);
}

/// Returns the sum of the principal curvatures at the nearest point of the surface, 1/m; positive for a ball.
#[inline(always)]
pub fn shape_curvature<R: Real>(p: &Parameters, kind: u32, size: vec3<R>, x: vec3<R>) -> R {
    let nothing: R = real(0.0);
    let directions: R = real(p.surface_directions);
    if kind == BALL {
        return div(directions, size.x);
    }
    if kind == CYLINDER {
        let beyond = beyond_cylinder(size, x);
        return select(nothing, div(directions - 1.0, size.x), less(beyond.y, beyond.x));
    }
    if kind == CAPSULE {
        return div(select(directions - 1.0, directions, less(size.y, abs(x.y))), size.x);
    }
    return nothing;
}

/// Returns 1 for a point above or below a facet, and 0 for one beside it.
#[inline(always)]
pub fn is_over_facet<R: Real>(m: &Model, size: vec3<R>, x: vec3<R>) -> R {
    let nothing: R = real(0.0);
    let one: R = real(1.0);
    if m.is_3d == 0 {
        return select(one, nothing, less(size.x, abs(x.x)));
    }
    let share = div(x.z, size.z) * 0.5 + 0.5;
    let half_width = size.x + (size.y - size.x) * share;
    let across = select(one, nothing, less(half_width, abs(x.x)));
    return select(across, nothing, less(size.z, abs(x.z)));
}

/// Returns the share of a path at which it comes through a facet from above, or 2 if it does not. `touch` is how far
/// below the facet the path may begin.
#[inline(always)]
pub fn facet_crossing<R: Real>(m: &Model, size: vec3<R>, touch: R, start: vec3<R>, way: vec3<R>) -> R {
    let never: R = real(2.0);
    let nothing: R = real(0.0);
    let falls = less(way.y, nothing);
    let safe = select(real(-1.0), way.y, falls);
    let share = larger(div(-start.y, safe), nothing);
    let crosses = select(never, share, falls);
    let begins_above = select(never, crosses, less(-touch, start.y));
    let over = is_over_facet(m, size, start + way * share);
    let at = select(begins_above, never, less(over, real(0.5)));
    return select(at, never, less(real(1.0), at));
}

/// Returns the acceleration with which a solid repels what is at a distance from it, m/s2 (Roy). Nearer than
/// a thousandth of the support radius it grows no more.
#[inline(always)]
pub fn repulsion<R: Real>(p: &Parameters, strength: R, distance: R) -> R {
    let one: R = real(1.0);
    let support: R = real(p.support);
    let near = larger(distance, support * 0.001);
    return larger(div(one, near) - p.inverse_support, real(0.0)) * strength;
}

/// Returns the vector from the nearest point of a side of a polygon; the side begins at `start` and leads along `side`.
#[inline(always)]
pub fn from_side<R: Real>(start: vec3<R>, side: vec3<R>, x: vec3<R>) -> vec3<R> {
    let away = x - start;
    let share = smaller(larger(div(dot3(away, side), length2(side)), real(0.0)), real(1.0));
    return away - side * share;
}

/// Returns by how much a side of a polygon changes the number of turns that the polygon makes around a point: 1, 0 or
/// -1 (Hormann and Agathos 2001).
#[inline(always)]
pub fn winding<R: Real>(start: vec3<R>, side: vec3<R>, x: vec3<R>) -> R {
    let nothing: R = real(0.0);
    let one: R = real(1.0);
    let away = x - start;
    let to_left = side.x * away.y - away.x * side.y;
    let begins_below = select(one, nothing, less(away.y, nothing));
    let ends_below = select(one, nothing, less(away.y, side.y));
    let upward = begins_below * (one - ends_below) * select(nothing, one, less(nothing, to_left));
    let downward = (one - begins_below) * ends_below * select(nothing, one, less(to_left, nothing));
    return upward - downward;
}
