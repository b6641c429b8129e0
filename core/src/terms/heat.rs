//! Thermal energy (Roy: `du_a/dt = 1/2 sum m_b (P_a / rho_a^2 + P_b / rho_b^2 + Pi_ab) v_ab . grad W`; Gourlay: what viscosity
//! dissipates): half of the work that pressures and viscosity of a pair take from its motion, in whatever form. Taken with the
//! velocities at the step, it is exactly what the two half kicks around it cost, so the sum of energies is kept to the order
//! of the integrator. (But for exchanges of velocity that were cut down to a limit,
//! for tensions, whose energy is in the surface, and for lengths of springs that gave way.)
use super::exchange::*;
use super::geometry::*;
use super::neighbour::*;
use super::pair::*;
use super::viscosity::*;
use crate::arithmetic::real::*;
use crate::layout::{Model, Parameters, StepUniform, Tables};

/// Share of a pair's loss that heats `a`: half, and all of it where `b` is a wall, which keeps no account.
#[inline(always)]
pub fn heat_share<R: Real>(wall_b: R) -> R {
    return select(real(0.5), real(1.0), less(real(0.0), wall_b));
}

/// Heating of `a` by `b`, W/m3; `v_ab` with the velocities at the step.
#[inline(always)]
pub fn heat_neighbour<R: Real>(m: &Model, p: &Parameters, t: &Tables, a: Local<R>, b: Local<R>, v_ab: vec3<R>) -> R {
    let x_ab = separation(m, p, a.position, b.position);
    let scale = pair_scale(m, a.support, b.support);
    let q = root(squared_ratio(m, p, x_ab, scale));
    let near = push_of_near_pressure(m, p, a, b, q, scale);
    let push = push_of_pressure(m, p, t, a, b, q, scale) + near;
    let work = dot3(x_ab, v_ab) * along_pair(p, push, q, scale);
    if m.viscosity == NO_VISCOSITY {
        return -(work * heat_share(b.wall));
    }
    if m.viscosity == VELOCITY_EXCHANGE {
        return -(work * heat_share(b.wall));
    }
    let loss = dot3(drag_of_pair(m, p, t, a, b, x_ab, q, scale), v_ab) * p.heat_gain;
    return -((work + loss) * heat_share(b.wall));
}

/// Heating of `a` by an exchange of velocity with `b`, J/kg before the limit of the step.
#[inline(always)]
pub fn exchange_heat<R: Real>(m: &Model, p: &Parameters, a: Local<R>, b: Local<R>, v_ab: vec3<R>) -> R {
    return -(dot3(exchange_neighbour(m, p, a, b), v_ab) * heat_share(b.wall) * p.heat_gain);
}

/// Rate of thermal energy, W/kg.
#[inline(always)]
pub fn heat_close<R: Real>(m: &Model, p: &Parameters, sum: R, a: Local<R>) -> R {
    return flush(sum * inverse_density(m, p, a));
}

/// Thermal energy a step later, J/kg: the mean of the rates at its two ends.
#[inline(always)]
pub fn heat_stepped<R: Real>(u: &StepUniform, energy: R, rate_before: R, rate: R) -> R {
    return flush(energy + (rate_before + rate) * u.half_time_step);
}
