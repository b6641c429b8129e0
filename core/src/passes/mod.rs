//! The loops over particles, one file a pass, in the order of a step. The GPU's passes have the same names.
//!
//! Loops only load, call a term and store. No job reads what another job of its pass writes.
pub(crate) mod p01_integrate_before;
pub(crate) mod p02_count;
pub(crate) mod p03_cell_lists;
pub(crate) mod p04_scan;
pub(crate) mod p05_place;
pub(crate) mod p06_order;
pub(crate) mod p07_gather;
pub(crate) mod p08_density;
pub(crate) mod p09_force;
pub(crate) mod p10_integrate_after;
pub(crate) mod p11_commit;

use crate::arithmetic::level::Simd;
use crate::arithmetic::real::{Real, vec3};
use crate::layout::{Model, Parameters, f32x4};

/// What every pass is told.
#[derive(Clone, Copy)]
pub(crate) struct Setup<'a> {
    pub model: &'a Model,
    pub parameters: &'a Parameters,
    pub simd: Simd,
}

/// Particles `first ..= last` in the lanes, the last one repeated to fill up.
#[inline(always)]
fn load<R: Real>(array: &[f32x4], first: usize, last: usize) -> vec3<R> {
    let at = |lane: usize, i: usize| array[(first + lane).min(last)][i];
    vec3(R::from_lanes(|l| at(l, 0)), R::from_lanes(|l| at(l, 1)), R::from_lanes(|l| at(l, 2)))
}

/// Component `i` of particles `first ..= last` in the lanes, the last one repeated to fill up.
#[inline(always)]
fn load_one<R: Real>(array: &[f32x4], first: usize, last: usize, i: usize) -> R {
    R::from_lanes(|lane| array[(first + lane).min(last)][i])
}

/// The lanes into as many entries as there are, w = 0.
#[inline(always)]
fn store<R: Real>(out: &mut [f32x4], v: vec3<R>) {
    for (lane, out) in out.iter_mut().take(R::LANES).enumerate() {
        *out = [v.x.lane(lane), v.y.lane(lane), v.z.lane(lane), 0.0];
    }
}
