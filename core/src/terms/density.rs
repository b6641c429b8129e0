//! Density.
use super::kernel::*;
use crate::arithmetic::real::*;
use crate::layout::{Model, Parameters};

/// What a neighbour at q^2 adds to the sum of kernel values.
#[inline(always)]
pub fn density_neighbour<R: Real>(m: &Model, q2: R) -> R {
    return kernel_w(m.density_kernel, q2);
}

/// Density summation `rho_a = sum m_b W_ab` (S0 eq. 2.10): mass and kernel constant close the sum, kg/m3.
#[inline(always)]
pub fn density_close<R: Real>(p: &Parameters, sum: R) -> R {
    return sum * p.density_constant;
}

/// Volume `V_a = m_a / rho_a` that a particle stands for, m3 (m2 in 2D).
#[inline(always)]
pub fn volume_close<R: Real>(p: &Parameters, density: R) -> R {
    return div(real(p.particle_mass), density);
}
