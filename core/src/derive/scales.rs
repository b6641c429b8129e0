//! The lengths of a scene: the support radius and the edge of a cell; and the two scales of its fluids that all else is made of,
//! sound and mass.
use super::kernel_constants::power;
use super::lattice_sums::kernel_sum;
use crate::scene::{Dimension, Fluid, Scene};
use core::f64::consts::PI;

/// A cell is a little larger than the support, so that rounding never parts two neighbours by two cells.
const CELL_MARGIN: f64 = 1.0 + 1.0 / 1024.0;

/// The lengths of a scene.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Scales {
    /// [`support_radius`], m.
    pub(crate) support_radius: f64,
    /// Edge of a cell at least, m.
    pub(crate) least_cell: f64,
}

impl Scales {
    /// Of any scene: where its numbers are unusable, so are these.
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

/// Particles inside the support radius of the scene: the fewest that one of its fluids has (Pirovano, section 3.3).
#[must_use]
pub fn average_neighbours(scene: &Scene) -> f32 {
    let own = scene.fluids.iter().map(|fluid| fluid.average_neighbours.unwrap_or(scene.average_neighbours));
    own.fold(f32::INFINITY, f32::min)
}

/// Radius that holds `average_neighbours` particles at the initial spacing: `n = N/V 4/3 pi H^3`, in 2D `N/A pi H^2`
/// (Pirovano, section 4.1.5, corrected), m. Of several fluids the smallest one (Pirovano, section 3.3).
///
/// It follows from three fields alone, so that it can be asked for while the rest of a scene is still to be chosen, such as a
/// time step. Of a scene that was checked it is [`Derived::support_radius`](super::Derived::support_radius).
#[must_use]
pub fn support_radius(scene: &Scene) -> f64 {
    let (n, spacing) = (f64::from(average_neighbours(scene)), f64::from(scene.particle_spacing));
    match scene.dimension {
        Dimension::Two => spacing * libm::sqrt(n / PI),
        Dimension::Three => spacing * libm::cbrt(n * 3.0 / (4.0 * PI)),
    }
}

/// Speed of sound of a fluid at rest, m/s: what it names; or `sqrt(7 k / rho0)` by Hinsch's constant k of Tait's equation; or what
/// the time step allows, where the scene asks for that.
///
/// Like [`support_radius`] it can be asked for while the rest of a scene is still to be chosen.
#[must_use]
pub fn speed_of_sound(scene: &Scene, fluid: &Fluid) -> f64 {
    if let Some(stiffness) = fluid.stiffness {
        return libm::sqrt(7.0 * f64::from(stiffness) / f64::from(fluid.rest_density));
    }
    let own = f64::from(fluid.speed_of_sound);
    let Some(courant) = scene.stiffness_for_time_step else { return own };
    let fastest = scene.fluids.iter().map(|fluid| f64::from(fluid.speed_of_sound)).fold(0.0, f64::max);
    own / fastest * f64::from(courant) * support_radius(scene) / f64::from(scene.time_step)
}

/// Mass of a particle of the first fluid, kg, those of the others being as their rest densities: of the volume that it stands for
/// at the start, `rho0 spacing^d`; calibrated, what makes the density sum over the lattice the rest density.
pub(crate) fn particle_mass(scene: &Scene, scales: &Scales) -> f64 {
    let lattice =
        f64::from(scene.first_fluid().rest_density) * power(f64::from(scene.particle_spacing), scene.dimension.count());
    if scene.model.normalize_mass { lattice / kernel_sum(scene, scales.support_radius) } else { lattice }
}
