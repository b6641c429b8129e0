//! Density, as its deviation `rho / rho0 - 1` from rest: in a stiff fluid that is where the digits are.
use super::geometry::*;
use super::pair::*;
use super::table::*;
use super::wall::*;
use crate::arithmetic::real::*;
use crate::layout::{Model, Parameters, StepUniform, Tables};

/// Pirovano eq. 2.10.
pub const SUMMATION: u32 = 0;
/// Pirovano eq. 2.12.
pub const CONTINUITY: u32 = 1;
/// Gourlay; Pirovano eq. 3.1.
pub const NUMBER_DENSITY: u32 = 2;
/// Solenthaler and Pajarola 2008 (Pirovano eq. 3.5).
pub const SUMMATION_ADAPTED: u32 = 3;
/// Pirovano, section 4.1.2, corrected.
pub const CONTINUITY_ADAPTED: u32 = 4;

/// Is density stepped?
#[inline(always)]
pub fn is_stepped(m: &Model) -> bool {
    return m.density == CONTINUITY || m.density == CONTINUITY_ADAPTED;
}

/// Does each neighbour count by its own mass? Else by that of the particle it is a neighbour of.
#[inline(always)]
pub fn counts_masses(m: &Model) -> bool {
    return weighs(m) && (m.density == SUMMATION || m.density == CONTINUITY);
}

/// What a neighbour adds to `rho_a = sum m_b W_ab` (Pirovano eq. 2.10).
#[inline(always)]
pub fn density_neighbour<R: Real>(m: &Model, t: &Tables, mass_b: R, q2: R, scale: R) -> R {
    let w = value_scaled(m, density_kernel(m, t, q2), scale);
    if weighs(m) {
        return w * mass_b;
    }
    return w;
}

/// What a neighbour adds to `n_a = sum W_ab` (Gourlay): a particle counts, whatever its mass.
#[inline(always)]
pub fn number_density_neighbour<R: Real>(m: &Model, t: &Tables, q2: R, scale: R) -> R {
    return value_scaled(m, density_kernel(m, t, q2), scale);
}

/// The chosen sum.
#[inline(always)]
pub fn summed_neighbour<R: Real>(m: &Model, t: &Tables, mass_b: R, q2: R, scale: R) -> R {
    if m.density == SUMMATION {
        return density_neighbour(m, t, mass_b, q2, scale);
    }
    return number_density_neighbour(m, t, q2, scale);
}

/// What a neighbour adds to `d (rho_a / rho0) / dt = sum m_b / rho0 (v_a - v_b) . grad W_ab` (Pirovano eq. 2.12), 1/s. Kernel
/// constant and mass close the sum.
#[inline(always)]
pub fn continuity_neighbour<R: Real>(
    m: &Model,
    p: &Parameters,
    t: &Tables,
    x_ab: vec3<R>,
    v_ab: vec3<R>,
    mass_b: R,
    scale: R,
) -> R {
    let q = root(squared_ratio(m, p, x_ab, scale));
    let slope = slope_scaled(m, pressure_slope(m, t, q), scale);
    // x_ab / r = x_ab / (q H_ab)
    let rate = over_distance(-(dot3(x_ab, v_ab) * slope * scale), q);
    if counts_masses(m) {
        return rate * mass_b;
    }
    return rate;
}

/// From masses of the scene's first fluid to a share of a particle's own rest density: a sum over neighbours' masses has
/// that one below the line; adapted to contrasts of density, the sum only counted, and each counts with the particle's own
/// mass, `m_a sum W` (Pirovano eq. 3.5).
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

/// The deviation that a sum over W closes to; also of a number density from that of the lattice.
#[inline(always)]
pub fn deviation_of_sum<R: Real>(m: &Model, p: &Parameters, sum: R, mass: R, rest: R) -> R {
    return of_own_density(m, sum * p.density_constant, mass, rest) - 1.0;
}

/// Rate of the deviation, 1/s.
#[inline(always)]
pub fn deviation_rate<R: Real>(m: &Model, p: &Parameters, sum: R, mass: R, rest: R) -> R {
    return of_own_density(m, sum * p.continuity_constant, mass, rest);
}

/// The deviation a step later, the rate being taken where the particles were in the middle of it.
#[inline(always)]
pub fn deviation_stepped<R: Real>(u: &StepUniform, deviation: R, rate: R) -> R {
    return flush(deviation + rate * u.time_step);
}

/// Volume `V_a = 1 / delta_a` by the number density (Solenthaler and Pajarola 2008), m3 (m2 in 2D); a mirroring wall's is that
/// of rest.
#[inline(always)]
pub fn volume_by_number<R: Real>(m: &Model, p: &Parameters, volume: R, sum: R, wall: R) -> R {
    let rest: R = real(p.rest_volume);
    // a wall that nobody counted for has an empty sum
    let counted = div(rest, larger(sum * p.density_constant, real(0.000001)));
    return wall_mirrored(m, volume, counted, wall);
}

/// Volume `V_a = m_a / rho_a` that a particle stands for, m3 (m2 in 2D).
#[inline(always)]
pub fn volume_close<R: Real>(p: &Parameters, mass: R, deviation: R) -> R {
    return div(mass * p.rest_volume, deviation + 1.0);
}
