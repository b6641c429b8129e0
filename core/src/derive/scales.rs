//! The lengths of a scene, support radius and cell size; and the two scales of its fluids from which everything else is
//! derived, speed of sound and particle mass.
use super::kernel_constants::power;
use super::lattice_sums::kernel_sum;
use crate::scene::{Dimension, Fluid, Scene};
use core::f64::consts::PI;

/// Cell size over support radius. Cells are a little larger than the support, so that rounding never puts two
/// neighbours two cells apart.
const CELL_MARGIN: f64 = 1.0 + 1.0 / 1024.0;

/// The lengths of a scene.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Scales {
    /// [`support_radius`], m.
    pub(crate) support_radius: f64,
    /// Smallest edge of a cell, m.
    pub(crate) least_cell: f64,
}

impl Scales {
    /// The lengths of any scene. If the numbers of the scene are invalid, so are the lengths.
    pub(crate) fn of(scene: &Scene) -> Scales {
        let support_radius = support_radius(scene);
        let largest = scene.model.variable_support.map_or(1.0, |range| f64::from(range.largest));
        Scales { support_radius, least_cell: support_radius * largest * CELL_MARGIN }
    }

    /// Support radius in particle spacings.
    pub(crate) fn spacings(&self, scene: &Scene) -> f64 {
        self.support_radius / f64::from(scene.particle_spacing)
    }
}

/// Average number of particles inside the support radius of the scene: the smallest that one of its fluids has
/// (Pirovano, section 3.3).
#[must_use]
pub fn average_neighbours(scene: &Scene) -> f32 {
    let by_number = || scene.average_neighbours.unwrap_or(scene.dimension.average_neighbours());
    let of_scene = scene.smoothing_ratio.map_or_else(by_number, |ratio| neighbours_within(scene.dimension, ratio));
    let own = scene.fluids.iter().map(|fluid| fluid.average_neighbours.unwrap_or(of_scene));
    own.fold(f32::INFINITY, f32::min)
}

/// Average number of particles inside a support radius of `2 h`, where `ratio` is h over the particle spacing.
pub(crate) fn neighbours_within(dimension: Dimension, ratio: f32) -> f32 {
    let spacings = 2.0 * f64::from(ratio);
    (match dimension {
        Dimension::Two => PI * spacings * spacings,
        Dimension::Three => 4.0 / 3.0 * PI * spacings * spacings * spacings,
    }) as f32
}

/// Support radius, m: the radius that holds `average_neighbours` particles at the initial spacing,
/// `n = N/V 4/3 pi H^3`, in 2D `N/A pi H^2` (Pirovano, section 4.1.5, corrected). With several fluids it is the
/// smallest of their radii (Pirovano, section 3.3).
///
/// It depends only on the dimension, the particle spacing and the numbers of neighbours, so it can be computed while
/// other fields of a scene, such as the time step, are still to be chosen. For a checked scene it is
/// [`Derived::support_radius`](super::Derived::support_radius).
#[must_use]
pub fn support_radius(scene: &Scene) -> f64 {
    let (n, spacing) = (f64::from(average_neighbours(scene)), f64::from(scene.particle_spacing));
    match scene.dimension {
        Dimension::Two => spacing * libm::sqrt(n / PI),
        Dimension::Three => spacing * libm::cbrt(n * 3.0 / (4.0 * PI)),
    }
}

/// Speed of sound of a fluid at rest, m/s: the fluid's own; or `sqrt(gamma k / rho0)` if the fluid sets Hinsch's
/// constant k of Tait's equation; or what the time step allows, if the scene sets `stiffness_for_time_step`.
///
/// Like [`support_radius`] it can be computed while other fields of a scene are still to be chosen.
#[must_use]
pub fn speed_of_sound(scene: &Scene, fluid: &Fluid) -> f64 {
    if let Some(stiffness) = fluid.stiffness {
        return libm::sqrt(f64::from(scene.model.tait_exponent) * f64::from(stiffness) / f64::from(fluid.rest_density));
    }
    let own = f64::from(fluid.speed_of_sound);
    let Some(courant) = scene.stiffness_for_time_step else { return own };
    let fastest = scene.fluids.iter().map(|fluid| f64::from(fluid.speed_of_sound)).fold(0.0, f64::max);
    own / fastest * f64::from(courant) * support_radius(scene) / f64::from(scene.time_step)
}

/// Mass of a particle of the first fluid at rest, kg; masses in other fluids are in proportion to their rest densities.
/// It is the mass of the volume per particle at the start, `rho0 spacing^d`; or, with `normalize_mass`, the mass for
/// which the density sum over the lattice is the rest density.
pub(crate) fn particle_mass(scene: &Scene, scales: &Scales) -> f64 {
    let lattice =
        f64::from(scene.first_fluid().rest_density) * power(f64::from(scene.particle_spacing), scene.dimension.count());
    if scene.model.normalize_mass { lattice / kernel_sum(scene, scales.support_radius) } else { lattice }
}
