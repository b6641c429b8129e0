//! Shifting: particles move with a velocity in addition to their own that keeps them evenly distributed.
use super::geometry::*;
use super::kernel::*;
use super::neighbour::*;
use super::pair::*;
use super::renormalisation::*;
use super::table::*;
use super::wall::*;
use crate::arithmetic::real::*;
use crate::layout::{Model, Parameters, StepUniform, Tables};

/// No shifting.
pub const NO_SHIFTING: u32 = 0;
/// Diffusion of particles (Lind et al. 2012; Sun et al. 2017).
pub const FICKIAN: u32 = 1;
/// Transport velocity by a background pressure (Adami et al. 2013).
pub const TRANSPORT_VELOCITY: u32 = 2;

/// Returns whether particles move with a velocity in addition to their own (XSPH, shifting).
#[inline(always)]
pub fn drifts(m: &Model) -> bool {
    return m.has_xsph == 1 || m.shifting != NO_SHIFTING;
}

/// Returns `(W / W(dx))^4` of a pair, where dx is the particle spacing (Monaghan 2000).
#[inline(always)]
pub fn closeness<R: Real>(m: &Model, p: &Parameters, t: &Tables, a: Local<R>, b: Local<R>, x_ab: vec3<R>) -> R {
    let q2 = squared_ratio(m, p, x_ab, pair_scale(m, a.support, b.support));
    let ratio = density_kernel(m, t, q2) * p.inverse_kernel_at_spacing;
    let ratio2 = ratio * ratio;
    return ratio2 * ratio2;
}

/// Returns the contribution of a neighbour to the gradient of the concentration of particles,
/// `sum V_b (1 + 0.2 (W / W(dx))^4) grad W`, 1/m (Lind et al. 2012). The second term keeps pairs apart.
#[inline(always)]
pub fn concentration_gradient<R: Real>(m: &Model, p: &Parameters, t: &Tables, a: Local<R>, b: Local<R>) -> vec3<R> {
    let x_ab = separation(m, p, a.position, b.position);
    let weight = closeness(m, p, t, a, b, x_ab) * 0.2 + 1.0;
    return x_ab * -(volume_gradient(m, p, t, a, b, x_ab, weight * neighbour_volume(m, a, b)));
}

/// Returns the part of a neighbour's contribution to [`concentration_gradient`] by which its second term exceeds that
/// of a neighbour at the distance of the spacing.
#[inline(always)]
pub fn close_repulsion<R: Real>(m: &Model, p: &Parameters, t: &Tables, a: Local<R>, b: Local<R>) -> vec3<R> {
    let x_ab = separation(m, p, a.position, b.position);
    let weight = larger(closeness(m, p, t, a, b, x_ab) - 1.0, real(0.0)) * 0.2;
    return x_ab * -(volume_gradient(m, p, t, a, b, x_ab, weight * neighbour_volume(m, a, b)));
}

/// Returns the contribution of a neighbour to the square of the speed with which neighbours approach or leave,
/// `sum V (v_ab . x_ab / r)^2 W`, before the constant of the kernel, (m/s)^2.
#[inline(always)]
pub fn approach_squared<R: Real>(m: &Model, p: &Parameters, t: &Tables, a: Local<R>, b: Local<R>) -> R {
    let x_ab = separation(m, p, a.position, b.position);
    let scale = pair_scale(m, a.support, b.support);
    let q2 = squared_ratio(m, p, x_ab, scale);
    let w = value_scaled(m, density_kernel(m, t, q2), scale);
    let approach = dot3(a.velocity - b.velocity, x_ab);
    let r2 = length2(x_ab);
    let square = select(real(0.0), div(approach * approach, r2), less(real(0.0), r2));
    return if_inside(q2, select(square * w, real(0.0), less(real(0.0), b.wall)));
}

/// Returns the contribution of a neighbour to the gradient of lambda, `sum V_b (lambda_b - lambda_a) grad W`, 1/m. It
/// points into the fluid. Wall particles have no lambda.
#[inline(always)]
pub fn lambda_gradient<R: Real>(
    m: &Model,
    p: &Parameters,
    t: &Tables,
    a: Local<R>,
    b: Local<R>,
    lambda_a: R,
    lambda_b: R,
) -> vec3<R> {
    let x_ab = separation(m, p, a.position, b.position);
    let weight = gradient_weight(m, p, t, a, b, x_ab) * (lambda_a - lambda_b);
    return x_ab * select(weight, real(0.0), less(real(0.0), b.wall));
}

/// Returns the speed U of the shifting, m/s: that of the scene, or about the largest speed with which neighbours
/// approach or leave, which is taken to be twice the root mean square. Then a fluid that does not deform is not
/// shifted, however fast it moves.
#[inline(always)]
pub fn shifting_speed<R: Real>(m: &Model, p: &Parameters, approach2: R) -> R {
    if m.has_shifting_speed == 1 {
        return real(p.shifting_speed);
    }
    return root(approach2 * p.density_constant) * 2.0;
}

/// Returns the velocity with which a particle is shifted, m/s: `-C H U grad c`, with the coefficient C, the support
/// radius H, the speed U, and the gradient of the concentration c (Sun et al. 2017). In a step a particle is shifted by
/// a tenth of the spacing at most.
///
/// At a free surface the part along the `normal` is left out, but for that of pairs closer than the spacing, so that
/// rows can give way to each other where the surface is compressed.
#[inline(always)]
pub fn fickian_velocity<R: Real>(
    m: &Model,
    p: &Parameters,
    u: &StepUniform,
    concentration: vec3<R>,
    repulsion: vec3<R>,
    approach2: R,
    lambda: R,
    normal: vec3<R>,
) -> vec3<R> {
    let nothing: R = real(0.0);
    let one: R = real(1.0);
    let rate = -(shifting_speed(m, p, approach2) * p.shifting);
    let wanted = (concentration - repulsion) * rate;
    let length = root(length2(normal));
    let unit = normal * select(nothing, div(one, larger(length, real(0.000001))), less(real(0.000001), length));
    let held = unit * (dot3(wanted, unit) * (one - inside_share(lambda)));
    let near_surface = wanted - held + repulsion * rate;
    let inside = concentration * rate;
    let is_near = less(inside_share(lambda), one);
    let x = select(inside.x, near_surface.x, is_near);
    let y = select(inside.y, near_surface.y, is_near);
    return limited_shift(p, u, vec3(x, y, select(inside.z, near_surface.z, is_near)));
}

/// Returns the velocity with which a background pressure `P = C rho0 c0^2` would move a particle within a step,
/// `-dt / 2 P / m_a sum (V_a^2 + V_b^2) grad W` (Adami et al. 2013, eq. 13 and 14), m/s.
#[inline(always)]
pub fn transport_velocity<R: Real>(m: &Model, p: &Parameters, u: &StepUniform, a: Local<R>, sum: vec3<R>) -> vec3<R> {
    let pressure = a.speed_of_sound * a.speed_of_sound * a.rest_ratio * p.rest_density * p.shifting;
    return limited_shift(p, u, sum * -(pressure * inverse_density(m, p, a) * u.half_time_step));
}

/// Returns the contribution of a neighbour to `sum (V_a + V_b^2 / V_a) grad W`, 1/m.
#[inline(always)]
pub fn background_gradient<R: Real>(m: &Model, p: &Parameters, t: &Tables, a: Local<R>, b: Local<R>) -> vec3<R> {
    let x_ab = separation(m, p, a.position, b.position);
    let volume_b = neighbour_volume(m, a, b);
    let volumes = a.volume + volume_b * div(volume_b, a.volume);
    return x_ab * -(volume_gradient(m, p, t, a, b, x_ab, volumes));
}

/// Returns a velocity, made shorter if it would move a particle by more than a tenth of the spacing in a step.
#[inline(always)]
pub fn limited_shift<R: Real>(p: &Parameters, u: &StepUniform, velocity: vec3<R>) -> vec3<R> {
    let most: R = real(p.shift_limit_length * u.inverse_time_step);
    let speed = root(length2(velocity));
    return velocity * div(most, larger(speed, most));
}

/// Returns the pressure with which a particle enters its own pressure force, Pa. Inside the fluid a negative pressure
/// changes its sign, so that pairs exchange `P_b - P_a` and do not attract each other (Sun et al. 2018). Inside is
/// where lambda is above 0.9, between its values in the second row and further inside (see [`inside_share`]).
#[inline(always)]
pub fn pressure_without_tension<R: Real>(pressure: R, lambda: R) -> R {
    let is_inside = less(real(0.9), lambda);
    return select(pressure, abs(pressure), is_inside);
}
