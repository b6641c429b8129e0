//! Viscosity, as the factor of `v_ab` in the force density on `a`, or of `x_ab` where the force acts along the line of
//! the pair.
use super::geometry::*;
use super::pair::*;
use super::state::*;
use super::table::*;
use super::wall::*;
use crate::arithmetic::real::*;
use crate::layout::{Model, Parameters, Tables};

/// No viscosity.
pub const NO_VISCOSITY: u32 = 0;
/// Mueller et al. 2003 (Pirovano, eq. 2.24).
pub const MUELLER_VISCOSITY: u32 = LAPLACIAN_VISCOSITY;
/// Morris et al. 1997 (Pirovano, eq. 2.23, corrected).
pub const MORRIS: u32 = 2;
/// Artificial viscosity of Monaghan 1992 (Pirovano, eqs. 2.20 to 2.22, corrected).
pub const ARTIFICIAL: u32 = 3;
/// Hinsch 2024, eq. 4.5, corrected.
pub const MONAGHAN_GINGOLD: u32 = 4;
/// Velocity exchange (Gourlay): see [`exchange`](super::exchange).
pub const VELOCITY_EXCHANGE: u32 = 5;
/// Solenthaler and Pajarola 2008 (Pirovano, eq. 3.7, corrected).
pub const MUELLER_ADAPTED_VISCOSITY: u32 = ADAPTED_LAPLACIAN_VISCOSITY;
/// The sum of [`MORRIS`] and, between fluid particles, of [`ARTIFICIAL`].
pub const MORRIS_AND_ARTIFICIAL: u32 = 7;

/// Returns whether the viscosity that a fluid is given acts: in all forms but those that have coefficients of their
/// own.
#[inline(always)]
pub fn has_friction(m: &Model) -> bool {
    return m.viscosity != NO_VISCOSITY && m.viscosity != ARTIFICIAL && m.viscosity != VELOCITY_EXCHANGE;
}

/// Mueller et al. 2003, eq. 14 (Pirovano, eq. 2.24): `f_a = mu sum V_b (v_b - v_a) laplacian W`. The result is a factor
/// of `v_ab = v_a - v_b`, so its sign is negative.
///
/// In newtons, `F_a = sum (mu_a + mu_b) / 2 (v_b - v_a) / (delta_a delta_b) laplacian W` is the form adapted to density
/// contrasts (Pirovano, eq. 3.7, corrected). Divided by the particle's own volume `1 / delta_a`, it is the same
/// formula.
#[inline(always)]
pub fn viscosity_mueller<R: Real>(viscosity: R, volume_b: R, laplacian: R) -> R {
    return -(viscosity * volume_b * laplacian);
}

/// Morris et al. 1997, eq. 22: `f_a = sum V_b (mu_a + mu_b) (x_ab . grad W) / (r^2 + 0.01 h^2) v_ab` (Pirovano,
/// eq. 2.23, corrected), with the mean viscosity. Here `inverse_square` is `1 / (r^2 + 0.01 h^2)` and `x_ab . grad W`
/// is `-r slope`.
#[inline(always)]
pub fn viscosity_morris<R: Real>(viscosity: R, volume_b: R, r: R, slope: R, inverse_square: R) -> R {
    return -(viscosity * 2.0 * volume_b * slope * r * inverse_square);
}

/// Returns the factor of `grad W` in `f_a = 2 (d + 2) mu sum V_b (v_ab . x_ab) / (r^2 + 0.01 h^2) grad W` (Hinsch 2024,
/// eq. 4.5, corrected). The force acts along the line of the pair and therefore conserves angular momentum.
#[inline(always)]
pub fn viscosity_monaghan_gingold<R: Real>(
    p: &Parameters,
    viscosity: R,
    volume_b: R,
    approach: R,
    inverse_square: R,
) -> R {
    return viscosity * volume_b * approach * inverse_square * p.monaghan_gingold_factor;
}

/// Returns `rho_a m_b Pi_ab`, the factor of `-grad W`, with `Pi = (-alpha c mu + beta mu^2) / rho` and
/// `mu = H v_ab . x_ab / (r^2 + 0.01 h^2)` (Pirovano, eqs. 2.20 to 2.22, corrected). c and rho are means of the pair.
/// It acts only between particles that approach each other. `weight` is `rho_a m_b / rho`.
#[inline(always)]
pub fn viscosity_artificial<R: Real>(p: &Parameters, weight: R, sound: R, approach: R, inverse_square: R) -> R {
    let closing = smaller(approach, real(0.0));
    let mu = closing * inverse_square * p.support;
    return (mu * mu * p.beta - mu * sound * p.alpha) * weight;
}

/// Returns `rho_a m_b / ((rho_a + rho_b) / 2)`, kg.
#[inline(always)]
pub fn mean_density_weight<R: Real>(m: &Model, p: &Parameters, a: Local<R>, b: Local<R>) -> R {
    let both = (density_ratio(m, a.deviation, a.rest_ratio) + density_seen(m, a, b)) * p.rest_density;
    let mass = mass_seen(m, a.rest_ratio, b.mass, b.rest_ratio, b.wall) * p.particle_mass;
    return div(local_density(m, p, a) * mass * 2.0, both);
}

/// Returns the force density of the chosen viscosity that `b` exerts on `a`, N/m3.
#[inline(always)]
pub fn viscosity_pair<R: Real>(
    m: &Model,
    p: &Parameters,
    t: &Tables,
    a: Local<R>,
    b: Local<R>,
    x_ab: vec3<R>,
    q: R,
    scale: R,
) -> vec3<R> {
    // Behind a wall the fluid's velocity is mirrored about the wall's velocity, so that the no-slip condition holds at
    // the wall.
    let v_ab = (a.velocity - b.velocity) * (b.wall + 1.0);
    let volume_b = neighbour_volume(m, a, b);
    let viscosity = pair_viscosity(m, a, b);
    let kernel = viscous_kernel(m, t, q);
    if takes_laplacian(m) {
        let laplacian = laplacian_scaled(m, kernel, scale) * p.viscosity_laplacian_constant;
        return v_ab * viscosity_mueller(viscosity, volume_b, laplacian);
    }
    let one: R = real(1.0);
    let r2 = length2(x_ab);
    let inverse_square = div(one, r2 + p.softening);
    let slope = slope_scaled(m, kernel, scale) * p.viscosity_slope_constant;
    // in one place for two forms, since unoptimised builds give every place a part of the stack
    let friction = viscosity_morris(viscosity, volume_b, root(r2), slope, inverse_square);
    if m.viscosity == MORRIS {
        return v_ab * friction;
    }
    let approach = dot3(v_ab, x_ab);
    // grad W = -slope x_ab / r, r = q H_ab
    let fall = over_distance(slope * scale * p.inverse_support, q);
    if m.viscosity == MONAGHAN_GINGOLD {
        let along = viscosity_monaghan_gingold(p, viscosity, volume_b, approach, inverse_square);
        return x_ab * -(along * fall);
    }
    let sound_a = sound_of_state(m, a.deviation, a.speed_of_sound, a.state_equation);
    let sound_b = wall_mirrored(m, a.speed_of_sound, b.speed_of_sound, b.wall);
    let equation_b = wall_mirrored(m, a.state_equation, b.state_equation, b.wall);
    let mean_sound = (sound_a + sound_of_state(m, b.deviation, sound_b, equation_b)) * 0.5;
    let along = viscosity_artificial(p, mean_density_weight(m, p, a, b), mean_sound, approach, inverse_square);
    if m.viscosity == ARTIFICIAL {
        return x_ab * (unless_slipping(m, b, along) * fall);
    }
    return v_ab * friction + x_ab * (along * fall * (one - b.wall));
}
