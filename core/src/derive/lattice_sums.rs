//! Sums over the lattice on which particles start: the value of a density sum there, and the sum of squared kernel
//! gradients that pressure correction needs.
use super::kernel_constants::{power, slope, value};
use crate::scene::{Dimension, Scene};

/// Largest support radius, in particle spacings, in scenes that need these sums; [`Scene::check`] rejects larger ones.
pub(crate) const MOST_SPACINGS: f64 = 32.0;

/// `sum spacing^d W` over the lattice: 1, apart from the discretisation error of the kernel on the lattice.
pub(crate) fn kernel_sum(scene: &Scene, support: f64) -> f64 {
    let (d, kernel) = (scene.dimension.count(), scene.model.density_kernel);
    let reach = support / f64::from(scene.particle_spacing);
    over_lattice(scene, support, &|q| value(kernel, q)) * kernel.normalisation(d) / power(reach, d)
}

/// `V^2 sum |grad W|^2` over the lattice, 1/m2, with V the volume of a particle.
pub(crate) fn gradient_squares(scene: &Scene, support: f64) -> f64 {
    let (d, kernel) = (scene.dimension.count(), scene.model.pressure_kernel);
    let reach = support / f64::from(scene.particle_spacing);
    let sum = over_lattice(scene, support, &|q| if q > 0.0 { power(slope(kernel, d, q), 2) } else { 0.0 });
    sum * power(kernel.normalisation(d) / (power(reach, d) * support), 2)
}

fn over_lattice(scene: &Scene, support: f64, f: &dyn Fn(f64) -> f64) -> f64 {
    let reach = (support / f64::from(scene.particle_spacing)).min(MOST_SPACINGS);
    let n = reach as i32 + 1;
    let layers = if scene.dimension == Dimension::Three { n } else { 0 };
    let mut sum = 0.0;
    for z in -layers..=layers {
        for y in -n..=n {
            for x in -n..=n {
                let q = libm::sqrt(f64::from(x * x + y * y + z * z)) / reach;
                if q < 1.0 {
                    sum += f(q);
                }
            }
        }
    }
    sum
}
