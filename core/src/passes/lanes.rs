//! How particles get into the lanes and out of them, and what their materials have of their own.
use crate::arithmetic::real::{Real, real, vec3};
use crate::layout::{MATERIALS, MaterialRows, Materials, Model, f32x4};

/// The material of a particle; `w` is the fourth number of its velocity.
#[inline(always)]
pub(crate) fn kind(w: f32) -> usize {
    (w as usize).min(MATERIALS - 1)
}

/// Does a particle belong to a wall, or is it inactive? Nothing acts on those.
#[inline(always)]
pub(crate) fn is_wall(materials: &Materials, w: f32) -> bool {
    materials.species[kind(w)][1] > 0.0
}

/// Is it inactive?
#[inline(always)]
pub(crate) fn is_dormant(materials: &Materials, w: f32) -> bool {
    materials.species[kind(w)][1] > 1.0
}

/// Number `i` of the rows of particles `first ..= last` in the lanes: what their materials have of their own.
#[inline(always)]
pub(crate) fn row_of<R: Real>(
    m: &Model,
    rows: &MaterialRows,
    velocity: &[f32x4],
    first: usize,
    last: usize,
    i: usize,
) -> R {
    if m.species == 0 {
        return real(rows[0][i]);
    }
    R::from_lanes(|lane| rows[kind(velocity[(first + lane).min(last)][3])][i])
}

/// Particles `first ..= last` in the lanes, the last one repeated to fill up.
#[inline(always)]
pub(crate) fn load<R: Real>(array: &[f32x4], first: usize, last: usize) -> vec3<R> {
    let at = |lane: usize, i: usize| array[(first + lane).min(last)][i];
    vec3(R::from_lanes(|l| at(l, 0)), R::from_lanes(|l| at(l, 1)), R::from_lanes(|l| at(l, 2)))
}

/// The same of an array that may not exist: then 0.
#[inline(always)]
pub(crate) fn load_if_any<R: Real>(array: &[f32x4], first: usize, last: usize) -> vec3<R> {
    if array.is_empty() { vec3(real(0.0), real(0.0), real(0.0)) } else { load(array, first, last) }
}

/// Component `i` of particles `first ..= last` in the lanes, the last one repeated to fill up.
#[inline(always)]
pub(crate) fn load_one<R: Real>(array: &[f32x4], first: usize, last: usize, i: usize) -> R {
    R::from_lanes(|lane| array[(first + lane).min(last)][i])
}

/// An array of single numbers, likewise.
#[inline(always)]
pub(crate) fn load_scalar<R: Real>(array: &[f32], first: usize, last: usize) -> R {
    R::from_lanes(|lane| array[(first + lane).min(last)])
}

/// What a block has written so far: component `i` of its entries in the lanes.
#[inline(always)]
pub(crate) fn load_own<R: Real>(own: &[f32x4], i: usize) -> R {
    R::from_lanes(|lane| own[lane.min(own.len() - 1)][i])
}

/// The lanes into as many entries as there are, w = 0.
#[inline(always)]
pub(crate) fn store<R: Real>(out: &mut [f32x4], v: vec3<R>) {
    for (lane, out) in out.iter_mut().take(R::LANES).enumerate() {
        *out = [v.x.lane(lane), v.y.lane(lane), v.z.lane(lane), 0.0];
    }
}

/// The lanes into as many entries as there are, whose w stays.
#[inline(always)]
pub(crate) fn store_xyz<R: Real>(out: &mut [f32x4], v: vec3<R>) {
    for (lane, out) in out.iter_mut().take(R::LANES).enumerate() {
        *out = [v.x.lane(lane), v.y.lane(lane), v.z.lane(lane), out[3]];
    }
}
