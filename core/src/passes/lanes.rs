//! Loads and stores for passes that process one particle per lane, and the lookup of material constants.
use crate::arithmetic::lanes::{Lanes, xyz};
use crate::arithmetic::real::{Real, real, vec3};
use crate::layout::{MATERIALS, MaterialRows, Materials, Model, f32x4};

/// Returns the number of the material of a particle; `w` is the fourth number of its velocity.
#[inline(always)]
pub(crate) fn material_of(w: f32) -> usize {
    (w as usize).min(MATERIALS - 1)
}

/// Returns whether a particle is a wall particle or inactive. These have no acceleration.
#[inline(always)]
pub(crate) fn is_wall(materials: &Materials, w: f32) -> bool {
    materials.properties[material_of(w)][1] > 0.0
}

/// Returns whether a particle is inactive.
#[inline(always)]
pub(crate) fn is_inactive(materials: &Materials, w: f32) -> bool {
    materials.properties[material_of(w)][1] > 1.0
}

/// Returns number `i` of the material constants of particles `first ..= last`, one particle per lane. The last particle
/// fills the remaining lanes.
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

/// Loads particles `first ..= last`, one per lane. The last particle fills the remaining lanes.
#[inline(always)]
pub(crate) fn load<R: Lanes>(array: &[f32x4], first: usize, last: usize) -> vec3<R> {
    xyz(R::load(|lane| &array[(first + lane).min(last)]))
}

/// Loads like [`load`], but returns zeros if the array is empty because the scene does not have it.
#[inline(always)]
pub(crate) fn load_if_any<R: Lanes>(array: &[f32x4], first: usize, last: usize) -> vec3<R> {
    if array.is_empty() { vec3(real(0.0), real(0.0), real(0.0)) } else { load(array, first, last) }
}

/// Loads component `i` of particles `first ..= last`, one per lane. The last particle fills the remaining lanes.
#[inline(always)]
pub(crate) fn load_one<R: Real>(array: &[f32x4], first: usize, last: usize, i: usize) -> R {
    R::from_lanes(|lane| array[(first + lane).min(last)][i])
}

/// Stores x, y and z of the lanes into the entries of `out`, one lane per entry. The w of each entry is kept.
#[inline(always)]
pub(crate) fn store_xyz<R: Lanes>(out: &mut [f32x4], vec3 { x, y, z }: vec3<R>) {
    let last = out.len() - 1;
    let [.., w] = R::load(|lane| &out[lane.min(last)]);
    R::store([x, y, z, w], out);
}
