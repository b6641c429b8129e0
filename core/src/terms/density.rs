//! Density, as its deviation `rho / rho0 - 1` from rest: in a stiff fluid that is where the digits are.
use super::geometry::*;
use super::pair::*;
use super::table::*;
use crate::arithmetic::real::*;
use crate::layout::{Model, Parameters, Tables};

/// S0 eq. 2.10.
pub const SUMMATION: u32 = 0;
/// S0 eq. 2.12.
pub const CONTINUITY: u32 = 1;
/// S4; S0 eq. 3.1.
pub const NUMBER_DENSITY: u32 = 2;

/// What a neighbour adds to `rho_a = sum m_b W_ab` (S0 eq. 2.10).
#[inline(always)]
pub fn density_neighbour<R: Real>(m: &Model, t: &Tables, mass_b: R, q2: R, scale: R) -> R {
    let w = value_scaled(m, density_kernel(m, t, q2), scale);
    if m.masses == 0 {
        return w;
    }
    return w * mass_b;
}

/// What a neighbour adds to `n_a = sum W_ab` (S4): a particle counts, whatever its mass.
#[inline(always)]
pub fn number_density_neighbour<R: Real>(m: &Model, t: &Tables, q2: R, scale: R) -> R {
    return value_scaled(m, density_kernel(m, t, q2), scale);
}

/// The chosen sum.
#[inline(always)]
pub fn summed_neighbour<R: Real>(m: &Model, t: &Tables, mass_b: R, q2: R, scale: R) -> R {
    if m.density == NUMBER_DENSITY {
        return number_density_neighbour(m, t, q2, scale);
    }
    return density_neighbour(m, t, mass_b, q2, scale);
}

/// What a neighbour adds to `d (rho_a / rho0) / dt = sum m_b / rho0 (v_a - v_b) . grad W_ab` (S0 eq. 2.12), 1/s. Kernel
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
    if m.masses == 0 {
        return rate;
    }
    return rate * mass_b;
}

/// The deviation that a sum over W closes to; also of a number density from that of the lattice.
#[inline(always)]
pub fn deviation_of_sum<R: Real>(p: &Parameters, sum: R) -> R {
    return sum * p.density_constant - 1.0;
}

/// The deviation a step later, the rate being taken where the particles were in the middle of it.
#[inline(always)]
pub fn deviation_stepped<R: Real>(p: &Parameters, deviation: R, sum: R) -> R {
    return flush(deviation + sum * p.continuity_constant * p.time_step);
}

/// Volume `V_a = m_a / rho_a` that a particle stands for, m3 (m2 in 2D).
#[inline(always)]
pub fn volume_close<R: Real>(p: &Parameters, mass: R, deviation: R) -> R {
    return div(mass * p.rest_volume, deviation + 1.0);
}
