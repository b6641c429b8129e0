//! The contribution of a neighbour to the sums from which density, near pressure and volume follow.
use super::context::Setup;
use crate::arithmetic::real::{Real, real};
use crate::terms::density::{density_neighbour, number_density_neighbour, sums_walls};
use crate::terms::near::{DOUBLE_DENSITY, near_density_neighbour};

/// Returns the contributions of a neighbour with this mass to the sums of density, near density, number density, and
/// of the density of wall particles.
#[inline(always)]
pub(crate) fn of_neighbour<R: Real>(setup: &Setup<'_>, mass: R, q2: R, scale: R) -> [R; 4] {
    let w = number_density_neighbour(setup.model, setup.tables, q2, scale);
    parts(setup, density_neighbour(setup.model, w, mass), w, mass, q2, scale)
}

/// Returns the same four numbers as [`of_neighbour`], with the first one given as `sum`.
#[inline(always)]
pub(crate) fn beside<R: Real>(setup: &Setup<'_>, sum: R, mass: R, q2: R, scale: R) -> [R; 4] {
    let (m, t) = (setup.model, setup.tables);
    let takes_w = m.has_number_density_volume == 1 || sums_walls(m);
    let w = if takes_w { number_density_neighbour(m, t, q2, scale) } else { real(0.0) };
    parts(setup, sum, w, mass, q2, scale)
}

#[inline(always)]
fn parts<R: Real>(setup: &Setup<'_>, sum: R, w: R, mass: R, q2: R, scale: R) -> [R; 4] {
    let (m, none) = (setup.model, real(0.0));
    let near = if m.near_pressure == DOUBLE_DENSITY { near_density_neighbour(m, mass, q2, scale) } else { none };
    let number = if m.has_number_density_volume == 1 { w } else { none };
    let of_wall = if sums_walls(m) { density_neighbour(m, w, mass) } else { none };
    [sum, near, number, of_wall]
}
