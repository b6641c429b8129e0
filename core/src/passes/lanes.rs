//! How particles get into the lanes and out of them, and what their materials have of their own.
use crate::arithmetic::lanes::{Lanes, xyz};
use crate::arithmetic::real::{Real, real, vec3};
use crate::layout::{MATERIALS, MaterialRows, Materials, Model, f32x4};

/// The material of a particle; `w` is the fourth number of its velocity.
#[inline(always)]
pub(crate) fn material_of(w: f32) -> usize {
    (w as usize).min(MATERIALS - 1)
}

/// Does a particle belong to a wall, or is it inactive? Nothing acts on those.
#[inline(always)]
pub(crate) fn is_wall(materials: &Materials, w: f32) -> bool {
    materials.properties[material_of(w)][1] > 0.0
}

/// Is it inactive?
#[inline(always)]
pub(crate) fn is_inactive(materials: &Materials, w: f32) -> bool {
    materials.properties[material_of(w)][1] > 1.0
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
    if m.has_materials == 0 {
        return real(rows[0][i]);
    }
    R::from_lanes(|lane| rows[material_of(velocity[(first + lane).min(last)][3])][i])
}

/// Particles `first ..= last` in the lanes, the last one repeated to fill up.
#[inline(always)]
pub(crate) fn load<R: Lanes>(array: &[f32x4], first: usize, last: usize) -> vec3<R> {
    xyz(R::load(|lane| &array[(first + lane).min(last)]))
}

/// The same of an array that may not exist: then 0.
#[inline(always)]
pub(crate) fn load_if_any<R: Lanes>(array: &[f32x4], first: usize, last: usize) -> vec3<R> {
    if array.is_empty() { vec3(real(0.0), real(0.0), real(0.0)) } else { load(array, first, last) }
}

/// Component `i` of particles `first ..= last` in the lanes, the last one repeated to fill up.
#[inline(always)]
pub(crate) fn load_one<R: Real>(array: &[f32x4], first: usize, last: usize, i: usize) -> R {
    R::from_lanes(|lane| array[(first + lane).min(last)][i])
}

/// The lanes into as many entries as there are, whose w stays.
#[inline(always)]
pub(crate) fn store_xyz<R: Lanes>(out: &mut [f32x4], vec3 { x, y, z }: vec3<R>) {
    let last = out.len() - 1;
    let [.., w] = R::load(|lane| &out[lane.min(last)]);
    R::store([x, y, z, w], out);
}
