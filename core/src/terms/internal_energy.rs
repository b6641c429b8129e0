//! Internal energy (Roy: `du_a/dt = 1/2 sum m_b (P_a / rho_a^2 + P_b / rho_b^2 + Pi_ab) v_ab . grad W`; Gourlay: the
//! energy that viscosity dissipates). A particle receives half of the work that pressure and viscosity of a pair take
//! from its motion, whatever their form. Evaluated with the velocities at the end of the step, it is exactly the
//! kinetic energy that the half kicks before and after that time cost, so the total energy is conserved to the order of
//! the integrator. Not included are velocity exchanges that were limited, surface tension, whose energy is in the
//! surface, and plastic changes of rest lengths of springs.
use super::exchange::*;
use super::geometry::*;
use super::neighbour::*;
use super::pair::*;
use super::viscosity::*;
use crate::arithmetic::real::*;
use crate::layout::{Model, Parameters, StepUniform, Tables};

/// Returns the share of a pair's loss that heats `a`: half, or all of it where `b` is a wall particle, whose internal
/// energy is not tracked.
#[inline(always)]
pub fn dissipation_share<R: Real>(wall_b: R) -> R {
    return select(real(0.5), real(1.0), less(real(0.0), wall_b));
}

/// Returns the heating of `a` by `b`, W/m3. `v_ab` is the difference of the velocities at the end of the step.
#[inline(always)]
pub fn internal_energy_neighbour<R: Real>(
    m: &Model,
    p: &Parameters,
    t: &Tables,
    a: Local<R>,
    b: Local<R>,
    v_ab: vec3<R>,
) -> R {
    let x_ab = separation(m, p, a.position, b.position);
    let scale = pair_scale(m, a.support, b.support);
    let q = root(squared_ratio(m, p, x_ab, scale));
    let near = push_of_near_pressure(m, p, a, b, q, scale);
    let push = push_of_pressure(m, p, t, a, b, q, scale) + near;
    let work = dot3(x_ab, v_ab) * along_pair(p, push, q, scale);
    if m.viscosity == NO_VISCOSITY {
        return -(work * dissipation_share(b.wall));
    }
    if m.viscosity == VELOCITY_EXCHANGE {
        return -(work * dissipation_share(b.wall));
    }
    let loss = dot3(drag_of_pair(m, p, t, a, b, x_ab, q, scale), v_ab) * p.heat_gain;
    return -((work + loss) * dissipation_share(b.wall));
}

/// Returns the heating of `a` by a velocity exchange with `b` in a step, J/kg, before the exchange is limited.
#[inline(always)]
pub fn exchange_dissipation<R: Real>(m: &Model, p: &Parameters, a: Local<R>, b: Local<R>, v_ab: vec3<R>) -> R {
    return -(dot3(exchange_neighbour(m, p, a, b), v_ab) * dissipation_share(b.wall) * p.heat_gain);
}

/// Returns the rate of internal energy, W/kg.
#[inline(always)]
pub fn internal_energy_close<R: Real>(m: &Model, p: &Parameters, sum: R, a: Local<R>) -> R {
    return flush(sum * inverse_density(m, p, a));
}

/// Returns the internal energy at the end of the step, J/kg, using the mean of the rates at both ends of the step.
#[inline(always)]
pub fn internal_energy_stepped<R: Real>(u: &StepUniform, energy: R, rate_before: R, rate: R) -> R {
    return flush(energy + (rate_before + rate) * u.half_time_step);
}
