//! Guided creation (S0 section 4.1): from what a user says, everything that follows from it, in f64 and rounded once.
use crate::kernel::{near_slope_constant, viscosity_laplacian_constant};
use crate::layout::{PLANES, Parameters, Planes};
use crate::scene::{Dimension, EquationOfState, Face, Scene};
use core::f64::consts::PI;

/// A cell is a little larger than the support, so that rounding never parts two neighbours by two cells.
const CELL_MARGIN: f64 = 1.0 + 1.0 / 1024.0;

/// Near stiffness over c0^2 where a scene does not name it. Our choice: see the errata of S0 section 3.1.
const DEFAULT_NEAR_SHARE: f64 = 0.1;

/// Radius that holds `average_neighbours` particles at the initial spacing: `n = N/V 4/3 pi H^3`, in 2D `N/A pi H^2`
/// (S0 section 4.1.5 per errata), m.
#[must_use]
pub fn support_radius(scene: &Scene) -> f64 {
    let (n, spacing) = (f64::from(scene.average_neighbours), f64::from(scene.particle_spacing));
    match scene.dimension {
        Dimension::Two => spacing * libm::sqrt(n / PI),
        Dimension::Three => spacing * libm::cbrt(n * 3.0 / (4.0 * PI)),
    }
}

/// Mass of the volume that a particle stands for at the start, `rho0 spacing^d`, kg.
#[must_use]
pub fn particle_mass(scene: &Scene) -> f64 {
    f64::from(scene.fluid.rest_density) * power(f64::from(scene.particle_spacing), scene.dimension.count())
}

/// `x^n` by multiplication: the last bit of a library's `pow` is its own affair.
fn power(x: f64, n: usize) -> f64 {
    core::iter::repeat_n(x, n).product()
}

/// Near pressure over density, m2/s2; 0 where near pressure is off.
#[must_use]
pub fn near_stiffness(scene: &Scene) -> f64 {
    if !scene.model.near_pressure {
        return 0.0;
    }
    let c0 = f64::from(scene.fluid.speed_of_sound);
    scene.fluid.near_stiffness.map_or(DEFAULT_NEAR_SHARE * c0 * c0, f64::from)
}

/// The constants of a scene that [`Scene::check`] accepts.
#[must_use]
pub fn parameters(scene: &Scene) -> Parameters {
    let (fluid, model, d) = (&scene.fluid, &scene.model, scene.dimension);
    let support = support_radius(scene);
    let power = |n: usize| power(support, n);
    let mass = particle_mass(scene);
    let c2 = f64::from(fluid.speed_of_sound) * f64::from(fluid.speed_of_sound);
    let state_stiffness = match model.equation_of_state {
        EquationOfState::Tait => f64::from(fluid.rest_density) * c2 / 7.0,
        EquationOfState::Desbrun => c2,
    };
    let (planes, plane_count) = planes(scene);
    let [x, y, z] = scene.cells();
    let [gx, gy, gz] = scene.gravity;
    let container = scene.container.as_ref();
    Parameters {
        cells: [x, y, z, x * y * z],
        gravity: [gx, gy, gz, 0.0],
        planes,
        particle_count: scene.particle_count() as u32,
        plane_count,
        inverse_cell: (1.0 / (support * CELL_MARGIN)) as f32,
        inverse_support: (1.0 / support) as f32,
        inverse_support_squared: (1.0 / (support * support)) as f32,
        time_step: scene.time_step,
        half_time_step: scene.time_step * 0.5,
        particle_mass: mass as f32,
        density_constant: (mass * model.density_kernel.normalisation(d) / power(d.count())) as f32,
        pressure_constant: (model.pressure_kernel.normalisation(d) / power(d.count() + 1)) as f32,
        near_constant: (near_slope_constant(d) / power(d.count() + 1)) as f32,
        viscosity_constant: (viscosity_laplacian_constant(d) / power(d.count() + 2)) as f32,
        rest_density: fluid.rest_density,
        state_stiffness: state_stiffness as f32,
        near_stiffness: near_stiffness(scene) as f32,
        dynamic_viscosity: fluid.dynamic_viscosity,
        bounce: container.map_or(0.0, |c| c.bounce),
        slip: container.map_or(0.0, |c| c.slip),
        pad0: 0,
        pad1: 0,
    }
}

/// The walls of the container: inward normals and offsets, and how many there are.
fn planes(scene: &Scene) -> (Planes, u32) {
    let mut planes = [[0.0; 4]; PLANES];
    let mut count = 0;
    if let Some(container) = &scene.container {
        let faces = Face::ALL.iter().enumerate().take(2 * scene.dimension.count());
        for (i, _) in faces.filter(|(_, face)| !container.open.contains(face)) {
            let (axis, high) = (i / 2, i % 2 == 1);
            let (sign, at) = if high { (-1.0, container.high[axis]) } else { (1.0, container.low[axis]) };
            planes[count][axis] = sign;
            planes[count][3] = sign * at;
            count += 1;
        }
    }
    (planes, count as u32)
}
