//! Walls in closed form: the part of a kernel that lies beyond a plane `n . x = offset`, whose normal n points towards
//! the fluid (the semi-analytical walls of Kulasegaram et al. 2004 and Ferrand et al. 2013, for planes). Beyond the
//! plane the fluid is thought to go on as it is at the particle, with the pressure that its weight gives it:
//! `P_a + rho_a g . (x - x_a)`.
//!
//! For a plane at distance d two quantities are enough: `gamma(d)`, the integral of W over the space beyond, and
//! `W1(d) = -d gamma / dd`, the integral of W over the plane. The integral of `(x - x_a) grad W` over the space beyond
//! is `T = gamma 1 + d W1 n n`. A sum over neighbours, together with what the plane adds by W1, is `1 - gamma` of the
//! whole, and so is divided by it. Where several planes are near, the part in front of all of them is the product of
//! the parts in front of each, which is exact for a Gaussian.
use super::geometry::*;
use super::pair::*;
use super::pressure::*;
use crate::arithmetic::real::*;
use crate::layout::{Model, Parameters, Tables};

/// What lies beyond the walls around a particle.
#[derive(Clone, Copy)]
pub struct Beyond<R> {
    /// `gamma`, the part of the kernel that lies beyond.
    pub gamma: R,
    /// `sum W1 n`, 1/m.
    pub surface: vec3<R>,
    /// The diagonal of `sum d W1 n n` (xx, yy, zz).
    pub lever: vec3<R>,
    /// The rest of `sum d W1 n n` (xy, xz, yz).
    pub lever_mixed: vec3<R>,
    /// `sum (v_w - v) . n W1`, with the velocity of the wall v_w, 1/s.
    pub approach: R,
    /// `sum mu (v - v_w) W1 / d` along the planes, N/m3.
    pub drag: vec3<R>,
}

/// Table of gamma of the density kernel, over d / H.
pub const DENSITY_GAMMA: u32 = 3;
/// Table of H W1 of the density kernel, over d / H.
pub const DENSITY_SURFACE: u32 = 4;
/// Table of gamma of the pressure kernel, over d / H.
pub const PRESSURE_GAMMA: u32 = 5;
/// Table of H W1 of the pressure kernel, over d / H.
pub const PRESSURE_SURFACE: u32 = 6;

/// Table of what a curved surface takes away from gamma of the density kernel, over d / H.
pub const DENSITY_BENDING: u32 = 7;
/// Table of what a curved surface takes away from gamma of the pressure kernel, over d / H.
pub const PRESSURE_BENDING: u32 = 8;

/// Returns the distance of a particle in front of a plane, m; 0 behind it.
#[inline(always)]
pub fn height_in_front<R: Real>(position: vec3<R>, normal: vec3<R>, offset: R) -> R {
    return larger(dot3(position, normal) - offset, real(0.0));
}

/// Returns the value of a table at `x`, which is at least 0, by the cubic through the four entries around it. From
/// x = 1 on it is 0.
#[inline(always)]
pub fn interpolated_smoothly<R: Real>(t: &Tables, table: u32, x: R) -> R {
    let one: R = real(1.0);
    let place = smaller(x, one) * 1024.0;
    let entry = smaller(larger(floor(place), one), real(1022.0));
    let f = place - entry;
    let before = lookup(t, table, entry - 1.0);
    let low = lookup(t, table, entry);
    let high = lookup(t, table, entry + 1.0);
    let after = lookup(t, table, entry + 2.0);
    let below = (f - 1.0) * (f - 2.0);
    let above = (f + 1.0) * f;
    let inner = (low * (f + 1.0) * below - high * above * (f - 2.0)) * 0.5;
    let outer = (after * above * (f - 1.0) - before * f * below) * 0.16666667;
    return select(real(0.0), inner + outer, less(x, one));
}

/// Returns the part of the kernel that lies in front of a plane, `1 - gamma`; `ratio` is d / H.
#[inline(always)]
pub fn part_in_front<R: Real>(t: &Tables, table: u32, ratio: R) -> R {
    let one: R = real(1.0);
    return one - interpolated_smoothly(t, table, ratio);
}

/// Returns the part of the kernel that lies in front of a curved surface; `bend` is half of the sum of its principal
/// curvatures times the support radius. It is exact to first order in the curvature: where the surface bends away from
/// the plane that touches it, `d gamma = -(curvature / 2) integral s^2 W`, over the plane with its distance s from the
/// particle's foot, and this is the integral of `t W1` from d on.
#[inline(always)]
pub fn part_in_front_of_curved<R: Real>(t: &Tables, gamma: u32, bending: u32, ratio: R, bend: R) -> R {
    return part_in_front(t, gamma, ratio) + interpolated_smoothly(t, bending, ratio) * bend;
}

/// Returns the factor of W1 of a curved surface: `W1 = -d gamma / dd` again, with gamma as above.
#[inline(always)]
pub fn curved_share<R: Real>(ratio: R, bend: R) -> R {
    let one: R = real(1.0);
    return one - ratio * bend;
}

/// Returns the part of the kernel on this side of a plane at the distance `ratio`, which is negative behind the plane.
#[inline(always)]
pub fn part_below<R: Real>(t: &Tables, gamma: u32, ratio: R) -> R {
    let one: R = real(1.0);
    let beyond = interpolated_smoothly(t, gamma, abs(ratio));
    return select(one - beyond, beyond, less(ratio, real(0.0)));
}

/// Returns the part of the kernel within a round side at the distance `ratio`, which is negative outside of it; `bend` is
/// half of its curvature times the support radius.
#[inline(always)]
pub fn part_within<R: Real>(t: &Tables, gamma: u32, bending: u32, ratio: R, bend: R) -> R {
    return part_below(t, gamma, ratio) - interpolated_smoothly(t, bending, abs(ratio)) * bend;
}

/// Returns the part of the kernel between two planes at the distances `half` from their middle; `at` is the place of
/// the particle.
#[inline(always)]
pub fn part_between<R: Real>(t: &Tables, gamma: u32, half: R, at: R) -> R {
    return part_below(t, gamma, half - at) + part_below(t, gamma, half + at) - 1.0;
}

/// Returns W1 of a plane, 1/m; `in_front` is the part of the kernel in front of all other planes, and `scale` is the
/// support radius of the scene over that of the particle.
#[inline(always)]
pub fn plane_surface<R: Real>(p: &Parameters, t: &Tables, table: u32, ratio: R, scale: R, in_front: R) -> R {
    return interpolated_smoothly(t, table, ratio) * in_front * scale * p.inverse_support;
}

/// Returns the diagonal of `n n`.
#[inline(always)]
pub fn normal_diagonal<R: Real>(n: vec3<R>) -> vec3<R> {
    return vec3(n.x * n.x, n.y * n.y, n.z * n.z);
}

/// Returns the rest of `n n`: xy, xz, yz.
#[inline(always)]
pub fn normal_mixed<R: Real>(n: vec3<R>) -> vec3<R> {
    return vec3(n.x * n.y, n.x * n.z, n.y * n.z);
}

/// Returns `mu (v - v_w) W1 / d` along a plane, N/m3. Beyond the plane the velocity is continued so that it is that of
/// the wall at the plane; then the viscosity of Morris et al. 1997 integrates to minus twice this. A negative
/// `of_wall` stands for the viscosity of the particle.
#[inline(always)]
pub fn plane_drag<R: Real>(
    p: &Parameters,
    slip: vec3<R>,
    normal: vec3<R>,
    height: R,
    surface: R,
    of_wall: R,
    viscosity: R,
) -> vec3<R> {
    let mu = select(of_wall, viscosity, less(of_wall, real(0.0)));
    let along = slip - normal * dot3(slip, normal);
    return along * (mu * surface * div(height, height * height + p.softening));
}

/// Returns `sum d W1 n (n . g)`, the part of `T g` that is not `gamma g`.
#[inline(always)]
pub fn lever_product<R: Real>(beyond: Beyond<R>, g: vec3<R>) -> vec3<R> {
    let d = beyond.lever;
    let o = beyond.lever_mixed;
    let x = dot3(vec3(d.x, o.x, o.y), g);
    let y = dot3(vec3(o.x, d.y, o.z), g);
    return vec3(x, y, dot3(vec3(o.y, o.z, d.z), g));
}

/// Returns the acceleration by the pressure beyond the walls, m/s2: `2 P_a W1 n / rho_a - d W1 n (n . g)` (with the
/// symmetric forms). It is to be [`completed`] together with that by the neighbours: then a fluid at rest stays at
/// rest, since of its weight the neighbours carry the part that lies in front. `own` is the pressure with which the
/// particle enters its own pressure force, and g the acceleration of the fluid at rest.
#[inline(always)]
pub fn wall_push<R: Real>(m: &Model, p: &Parameters, a: Local<R>, own: R, beyond: Beyond<R>, g: vec3<R>) -> vec3<R> {
    let of_gravity = lever_product(beyond, g);
    if m.pressure_force == DIFFERENCE {
        return of_gravity * real(-1.0);
    }
    let over_density = inverse_density(m, p, a);
    if m.pressure_force == CANONICAL {
        return beyond.surface * (a.pressure * over_density) - of_gravity;
    }
    if m.pressure_force == MUELLER || m.pressure_force == MUELLER_ADAPTED {
        return beyond.surface * ((a.pressure + own) * 0.5 * over_density) - of_gravity;
    }
    return beyond.surface * ((a.pressure + own) * over_density) - of_gravity;
}

/// Returns the acceleration by the friction of the walls, m/s2.
#[inline(always)]
pub fn wall_rub<R: Real>(m: &Model, p: &Parameters, a: Local<R>, beyond: Beyond<R>) -> vec3<R> {
    return beyond.drag * (inverse_density(m, p, a) * -2.0);
}

/// Returns what the space beyond the walls adds to the gradient of the density deviation before it is renormalised,
/// `T g / c^2`, 1/m.
#[inline(always)]
pub fn deviation_beyond<R: Real>(a: Local<R>, beyond: Beyond<R>, g: vec3<R>) -> vec3<R> {
    let one: R = real(1.0);
    return (lever_product(beyond, g) + g * beyond.gamma) * div(one, a.speed_of_sound * a.speed_of_sound);
}

/// Returns the rate of the density deviation by the walls, `(1 + e) (v_w - v_a) . n W1`, 1/s. It is to be [`completed`]
/// together with that by the neighbours: then a flow that is linear in space has its exact divergence.
#[inline(always)]
pub fn rate_by_walls<R: Real>(deviation: R, beyond: Beyond<R>) -> R {
    return (deviation + 1.0) * beyond.approach;
}

/// Returns a sum over the neighbours and the walls, completed by the part of the kernel that lies beyond the walls:
/// what is there is as in front (Ferrand et al. 2013).
#[inline(always)]
pub fn completed<R: Real>(sum: R, gamma: R) -> R {
    let one: R = real(1.0);
    return div(sum, one - gamma);
}

/// Returns an acceleration by the neighbours and the walls, [`completed`].
#[inline(always)]
pub fn completed3<R: Real>(sum: vec3<R>, gamma: R) -> vec3<R> {
    let one: R = real(1.0);
    return sum * div(one, one - gamma);
}

/// Returns a sum over neighbours that is completed at most to twice its value, as beside a plane: the diffusion of density,
/// which would be unstable where a few particles lie close together in a corner.
#[inline(always)]
pub fn completed_twice_at_most<R: Real>(sum: R, gamma: R) -> R {
    let one: R = real(1.0);
    return div(sum, larger(one - gamma, real(0.5)));
}
