//! Density, as the deviation `rho / rho0 - 1` from the rest density. In a stiff fluid the deviation is small, and
//! stored by itself it keeps all digits.
use super::pair::*;
use super::table::*;
use super::wall::*;
use crate::arithmetic::real::*;
use crate::layout::{Model, Parameters, StepUniform, Tables};

/// Summation (Pirovano, eq. 2.10).
pub const SUMMATION: u32 = 0;
/// Continuity equation (Pirovano, eq. 2.12).
pub const CONTINUITY: u32 = 1;
/// Number density (Gourlay; Pirovano, eq. 3.1).
pub const NUMBER_DENSITY: u32 = 2;
/// Summation adapted to density contrasts (Solenthaler and Pajarola 2008; Pirovano, eq. 3.5).
pub const SUMMATION_ADAPTED: u32 = 3;
/// Continuity equation adapted to density contrasts (Pirovano, section 4.1.2, corrected).
pub const CONTINUITY_ADAPTED: u32 = 4;

/// Returns whether the density is integrated in time from its rate.
#[inline(always)]
pub fn is_stepped(m: &Model) -> bool {
    return m.density == CONTINUITY || m.density == CONTINUITY_ADAPTED;
}

/// Returns whether each neighbour is weighted with its own mass. Otherwise the mass of the receiving particle applies.
#[inline(always)]
pub fn counts_masses(m: &Model) -> bool {
    return weighs(m) && (m.density == SUMMATION || m.density == CONTINUITY);
}

/// Returns the contribution of a neighbour to `n_a = sum W_ab` (Gourlay). A number density ignores particle masses.
#[inline(always)]
pub fn number_density_neighbour<R: Real>(m: &Model, t: &Tables, q2: R, scale: R) -> R {
    return value_scaled(m, density_kernel(m, t, q2), scale);
}

/// Returns the contribution of a neighbour to `rho_a = sum m_b W_ab` (Pirovano, eq. 2.10), or to the density sum that
/// the scene chooses instead. `w` is W_ab.
#[inline(always)]
pub fn density_neighbour<R: Real>(m: &Model, w: R, mass_b: R) -> R {
    if counts_masses(m) {
        return w * mass_b;
    }
    return w;
}

/// Returns whether the density of wall particles is a sum although that of the fluid is integrated in time. A wall does
/// not move with the fluid, and the error of a rate would add up without end.
#[inline(always)]
pub fn sums_walls(m: &Model) -> bool {
    return m.wall_particles == DYNAMIC && is_stepped(m);
}

/// Returns the slope of the kernel in the continuity equation.
#[inline(always)]
pub fn continuity_slope<R: Real>(m: &Model, t: &Tables, q: R, scale: R) -> R {
    return slope_scaled(m, pressure_slope(m, t, q), scale);
}

/// Returns the contribution of a neighbour to `d (rho_a / rho0) / dt = sum m_b / rho0 (v_a - v_b) . grad W_ab`
/// (Pirovano, eq. 2.12), 1/s, where `approach` is `x_ab . v_ab`. The kernel constant and the mass are applied to the
/// whole sum.
#[inline(always)]
pub fn continuity_neighbour<R: Real>(m: &Model, approach: R, mass_b: R, q: R, slope: R, scale: R) -> R {
    // x_ab / r = x_ab / (q H_ab)
    return density_neighbour(m, over_distance(-(approach * slope * scale), q), mass_b);
}

/// Converts a sum to a share of the particle's own rest density. A sum over neighbour masses is relative to the scene's
/// first fluid, so it is divided by `rest`, the particle's rest density over that of the first fluid. A sum adapted to
/// density contrasts only counts neighbours, and each counts with the particle's own mass, `m_a sum W` (Pirovano,
/// eq. 3.5).
#[inline(always)]
pub fn of_own_density<R: Real>(m: &Model, sum: R, mass: R, rest: R) -> R {
    if counts_masses(m) {
        if m.is_multi_fluid == 0 {
            return sum;
        }
        return div(sum, rest);
    }
    if m.has_variable_mass == 0 {
        return sum;
    }
    return sum * mass;
}

/// Returns the density deviation that follows from a sum over W. A number density deviates from that of the lattice.
#[inline(always)]
pub fn deviation_of_sum<R: Real>(m: &Model, p: &Parameters, sum: R, mass: R, rest: R) -> R {
    return of_own_density(m, sum * p.density_constant, mass, rest) - 1.0;
}

/// Returns the rate of the density deviation, 1/s.
#[inline(always)]
pub fn deviation_rate<R: Real>(m: &Model, p: &Parameters, sum: R, mass: R, rest: R) -> R {
    return of_own_density(m, sum * p.continuity_constant, mass, rest);
}

/// Returns the density deviation at the end of the step. `rate` is evaluated at the positions in the middle of the
/// step.
#[inline(always)]
pub fn deviation_stepped<R: Real>(u: &StepUniform, deviation: R, rate: R) -> R {
    return flush(deviation + rate * u.time_step);
}

/// Returns the volume by the number density, `V_a = 1 / delta_a` (Solenthaler and Pajarola 2008), m3 (m2 in 2D). A
/// wall particle that follows the fluid keeps `volume`, that at rest.
#[inline(always)]
pub fn volume_by_number<R: Real>(m: &Model, p: &Parameters, volume: R, sum: R, wall: R) -> R {
    let rest: R = real(p.rest_volume);
    // The sum is 0 for a wall particle whose neighbours are not counted.
    let counted = div(rest, larger(sum * p.density_constant, real(0.000001)));
    return wall_following(m, volume, counted, wall);
}

/// Returns the volume `V_a = m_a / rho_a` of a particle, m3 (m2 in 2D).
#[inline(always)]
pub fn volume_close<R: Real>(p: &Parameters, mass: R, deviation: R) -> R {
    return div(mass * p.rest_volume, deviation + 1.0);
}
