//! The loops over particles, one file a pass, in the order of a step. The GPU's passes have the same names.
//!
//! Loops only load, call a term and store. No job reads what another job of its pass writes.
pub(crate) mod field;
pub(crate) mod local;
pub(crate) mod p01_integrate_before;
pub(crate) mod p02_count;
pub(crate) mod p03_cell_lists;
pub(crate) mod p04_scan;
pub(crate) mod p05_place;
pub(crate) mod p06_order;
pub(crate) mod p07_gather;
pub(crate) mod p08_support;
pub(crate) mod p09_density;
pub(crate) mod p10_force;
pub(crate) mod p11_normals;
pub(crate) mod p12_tension;
pub(crate) mod p13_springs;
pub(crate) mod p14_pressure_force;
pub(crate) mod p15_pressure_correct;
pub(crate) mod p16_pressure_settle;
pub(crate) mod p17_foresee;
pub(crate) mod p18_heat;
pub(crate) mod p19_smooth;
pub(crate) mod p20_coat;
pub(crate) mod p21_integrate_after;
pub(crate) mod p22_air;
pub(crate) mod p23_look;
pub(crate) mod p24_commit;
pub(crate) mod pairs;

use crate::arithmetic::level::Simd;
use crate::arithmetic::real::{Real, real, vec3};
use crate::layout::{Kinds, Model, Parameters, SPECIES, Tables, f32x4};

/// What every pass is told.
#[derive(Clone, Copy)]
pub(crate) struct Setup<'a> {
    pub model: &'a Model,
    pub parameters: &'a Parameters,
    pub tables: &'a Tables,
    pub field: &'a [f32x4],
    pub simd: Simd,
}

/// The kind of a particle; `w` is the fourth number of its velocity.
#[inline(always)]
pub(crate) fn kind(w: f32) -> usize {
    (w as usize).min(SPECIES - 1)
}

/// Does a particle belong to a wall, or is it air that is not there? Nothing acts on those.
#[inline(always)]
fn is_wall(p: &Parameters, w: f32) -> bool {
    p.species[kind(w)][1] > 0.0
}

/// Is it of air that is not there?
#[inline(always)]
pub(crate) fn is_dormant(p: &Parameters, w: f32) -> bool {
    p.species[kind(w)][1] > 1.0
}

/// Number `i` of the rows of particles `first ..= last` in the lanes: what their kinds have of their own.
#[inline(always)]
fn row_of<R: Real>(m: &Model, rows: &Kinds, velocity: &[f32x4], first: usize, last: usize, i: usize) -> R {
    if m.species == 0 {
        return real(rows[0][i]);
    }
    R::from_lanes(|lane| rows[kind(velocity[(first + lane).min(last)][3])][i])
}

/// Particles `first ..= last` in the lanes, the last one repeated to fill up.
#[inline(always)]
fn load<R: Real>(array: &[f32x4], first: usize, last: usize) -> vec3<R> {
    let at = |lane: usize, i: usize| array[(first + lane).min(last)][i];
    vec3(R::from_lanes(|l| at(l, 0)), R::from_lanes(|l| at(l, 1)), R::from_lanes(|l| at(l, 2)))
}

/// The same of an array that may not exist: then 0.
#[inline(always)]
fn load_if_any<R: Real>(array: &[f32x4], first: usize, last: usize) -> vec3<R> {
    if array.is_empty() { vec3(real(0.0), real(0.0), real(0.0)) } else { load(array, first, last) }
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

/// The lanes into as many entries as there are, whose w stays.
#[inline(always)]
fn store_xyz<R: Real>(out: &mut [f32x4], v: vec3<R>) {
    for (lane, out) in out.iter_mut().take(R::LANES).enumerate() {
        *out = [v.x.lane(lane), v.y.lane(lane), v.z.lane(lane), out[3]];
    }
}
