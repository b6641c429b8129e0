//! What a neighbour adds to the sums that density, near pressure and volumes come from.
use super::context::Setup;
use crate::arithmetic::real::{Real, real};
use crate::terms::density::{number_density_neighbour, summed_neighbour};
use crate::terms::near::{DOUBLE_DENSITY, near_density_neighbour};

/// What a neighbour of this mass adds to the sums of density, of the near density and of the number density; the last is 0.
#[inline(always)]
pub(crate) fn of_neighbour<R: Real>(setup: &Setup<'_>, mass: R, q2: R, scale: R) -> [R; 4] {
    beside(setup, summed_neighbour(setup.model, setup.tables, mass, q2, scale), mass, q2, scale)
}

/// The same where what it adds to the first of them is known.
#[inline(always)]
pub(crate) fn beside<R: Real>(setup: &Setup<'_>, sum: R, mass: R, q2: R, scale: R) -> [R; 4] {
    let (m, t) = (setup.model, setup.tables);
    let none = real(0.0);
    let near = if m.near_pressure == DOUBLE_DENSITY { near_density_neighbour(m, mass, q2, scale) } else { none };
    let number = if m.has_number_density_volume == 1 { number_density_neighbour(m, t, q2, scale) } else { none };
    [sum, near, number, none]
}
