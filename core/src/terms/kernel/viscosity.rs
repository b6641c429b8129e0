//! The viscosity kernel: Mueller et al. 2003, eq. 22 (Pirovano eq. 2.46, corrected), made so that its Laplacian is `1 - q` and
//! never negative. `w = -q^3 / 2 + q^2 + 1 / (2 q) - 1` in 3D, constant 15 / (2 pi); in 2D (derived: see the errata)
//! `w = q^2 / 4 - q^3 / 9 - ln q / 6 - 5 / 36`, constant 40 / pi. Its value at 0 is infinite, so only slope and Laplacian are
//! stepped.
use super::{if_inside, inside};
use crate::arithmetic::real::*;
use crate::layout::Model;

/// `3 q^2 / 2 - 2 q + 1 / (2 q^2)`, in 2D `q^2 / 3 - q / 2 + 1 / (6 q)`.
#[inline(always)]
pub fn viscosity_slope<R: Real>(m: &Model, q: R) -> R {
    let one: R = real(1.0);
    // a particle is no neighbour of itself
    let inverse = select(real(0.0), div(one, q), less(real(0.0), q));
    if m.is_3d == 0 {
        return if_inside(q, (q * 2.0 - 3.0) * q * 0.16666667 + inverse * 0.16666667);
    }
    return if_inside(q, (q * 1.5 - 2.0) * q + inverse * inverse * 0.5);
}

/// Its Laplacian: `6 (1 - q)`, in 2D `1 - q`.
#[inline(always)]
pub fn viscosity_laplacian<R: Real>(m: &Model, q: R) -> R {
    if m.is_3d == 0 {
        return inside(q);
    }
    return inside(q) * 6.0;
}
