//! The viscosity kernel (Mueller et al. 2003, eq. 22; Pirovano, eq. 2.46, corrected), constructed so that its Laplacian
//! is proportional to `1 - q` and never negative. In 3D `w = -q^3 / 2 + q^2 + 1 / (2 q) - 1`, with the constant 15 / (2
//! pi). In 2D `w = q^2 / 4 - q^3 / 9 - ln q / 6 - 5 / 36`, with the constant 40 / pi; the sources do not give this
//! form, it is derived here (see `docs/errata.md`). The value at q = 0 is infinite, so only the slope and the Laplacian
//! are used in a step.
use super::{if_inside, inside};
use crate::arithmetic::real::*;
use crate::layout::Model;

/// Slope: `3 q^2 / 2 - 2 q + 1 / (2 q^2)` in 3D, `q^2 / 3 - q / 2 + 1 / (6 q)` in 2D.
#[inline(always)]
pub fn viscosity_slope<R: Real>(m: &Model, q: R) -> R {
    let one: R = real(1.0);
    // At q = 0 the slope is infinite, but a particle is not its own neighbour.
    let inverse = select(real(0.0), div(one, q), less(real(0.0), q));
    if m.is_3d == 0 {
        return if_inside(q, (q * 2.0 - 3.0) * q * 0.16666667 + inverse * 0.16666667);
    }
    return if_inside(q, (q * 1.5 - 2.0) * q + inverse * inverse * 0.5);
}

/// Laplacian: `6 (1 - q)` in 3D, `1 - q` in 2D.
#[inline(always)]
pub fn viscosity_laplacian<R: Real>(m: &Model, q: R) -> R {
    if m.is_3d == 0 {
        return inside(q);
    }
    return inside(q) * 6.0;
}
