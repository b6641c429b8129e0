//! Wall particles that take their pressure and velocity from the fluid around them (Adami, Hu and Adams 2012).
use super::correction::*;
use super::external::*;
use super::geometry::*;
use super::pair::*;
use super::state::*;
use super::table::*;
use super::viscosity::*;
use super::wall::*;
use crate::arithmetic::real::*;
use crate::layout::{Model, Parameters, StepUniform, Tables};

/// Returns whether viscosity sees a velocity of walls that is extrapolated from the fluid. Artificial viscosity, and
/// the exchange of velocities if it is the viscosity, see the wall's own.
#[inline(always)]
pub fn extrapolates_velocity(m: &Model) -> bool {
    if m.wall_particles != EXTRAPOLATED {
        return false;
    }
    return has_friction(m);
}

/// Returns the weight W of a neighbour in the means that a wall particle takes over the fluid around it; 0 for another
/// wall particle.
#[inline(always)]
pub fn wall_weight<R: Real>(m: &Model, p: &Parameters, t: &Tables, a: Local<R>, b: Local<R>) -> R {
    let scale = pair_scale(m, a.support, b.support);
    let q2 = squared_ratio(m, p, separation(m, p, a.position, b.position), scale);
    let w = value_scaled(m, density_kernel(m, t, q2), scale);
    return select(w, real(0.0), less(real(0.0), b.wall));
}

/// Returns the pressure that the fluid at a neighbour would have at the wall particle, times the weight of the
/// neighbour: `(P_b + rho_b g . x_ab) W` (Adami et al. 2012, eq. 27, for a wall without acceleration). `field` is the
/// acceleration field supplied by the caller at the wall particle, m/s2.
#[inline(always)]
pub fn wall_pressure_neighbour<R: Real>(
    m: &Model,
    p: &Parameters,
    u: &StepUniform,
    a: Local<R>,
    b: Local<R>,
    field: vec3<R>,
    w: R,
) -> R {
    let g = weight(m, p, u, density_ratio(m, b.deviation, b.rest_ratio)) + field;
    let x_ab = separation(m, p, a.position, b.position);
    return (b.pressure + local_density(m, p, b) * dot3(g, x_ab)) * w;
}

/// Returns a mean from the sum of weighted values and the sum of the weights. It is 0 where there is no fluid, or where
/// it only touches the edge of the support.
#[inline(always)]
pub fn wall_mean<R: Real>(sum: R, weights: R) -> R {
    let least: R = real(0.000000000001);
    return select(real(0.0), div(sum, larger(weights, least)), less(least, weights));
}

/// Returns the pressure of a wall particle, Pa: the mean over the fluid, not negative where the scene does not allow
/// negative pressure.
#[inline(always)]
pub fn wall_pressure<R: Real>(m: &Model, sum: R, weights: R) -> R {
    return flush(pressure_close(m, wall_mean(sum, weights)));
}

/// Returns the velocity of a wall particle as viscosity sees it, `2 v_w - v`, with the mean velocity v of the fluid
/// (Adami et al. 2012, eq. 23): halfway between the wall particle and the fluid it is the velocity of the wall.
#[inline(always)]
pub fn wall_velocity<R: Real>(velocity: vec3<R>, sum: vec3<R>, weights: R) -> vec3<R> {
    let mean = vec3(wall_mean(sum.x, weights), wall_mean(sum.y, weights), wall_mean(sum.z, weights));
    return flush3(velocity * real(2.0) - mean);
}

/// Returns the density deviation of a wall particle at its pressure; 0 where pressure does not follow from density.
#[inline(always)]
pub fn wall_deviation<R: Real>(m: &Model, p: &Parameters, pressure: R, stiffness: R, equation: R) -> R {
    if m.pressure_solver == PRESSURE_CORRECTION {
        return real(0.0);
    }
    return deviation_of_state(m, p, pressure, stiffness, equation);
}
