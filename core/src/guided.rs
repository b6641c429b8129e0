//! Guided creation (S0 section 4.1): from what a user says, everything that follows from it, in f64 and rounded once.
use crate::kernel::near_slope_constant;
use crate::lattice_sums::{gradient_squares, kernel_sum};
use crate::layout::{PLANES, Parameters, Planes, SPECIES, f32x4};
use crate::scene::{
    BLOCKS, Dimension, EquationOfState, Face, Iteration, NearPressure, PressureForce, Scene, SupportRange, Viscosity,
};
use core::f64::consts::PI;

/// A cell is a little larger than the support, so that rounding never parts two neighbours by two cells.
const CELL_MARGIN: f64 = 1.0 + 1.0 / 1024.0;

/// Near stiffness over c0^2 where a scene does not name it. Our choice: see the errata of S0 section 3.1.
const DEFAULT_NEAR_SHARE: f64 = 0.1;

/// What keeps close pairs from dividing by nothing, over H^2. The sources' 0.01 h^2 has the h whose double is the support:
/// with 0.01 H^2 the Laplacian of Morris et al. is 3 to 5 % too small on a lattice, with this at most 2 %.
const SOFTENING: f64 = 0.01 / 4.0;

/// Share of the change that would mend a lone particle's density which an iteration of pressure makes: Jacobi's method,
/// with the half that keeps it from overshooting where all particles change at once.
const RELAXATION: f64 = 0.5;

/// Share of a deviation of density that a step of corrected pressure is to mend (our choice).
const CORRECTION_SOURCE: f32 = 0.1;

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

/// Edge of a cell at least, m.
pub(crate) fn least_cell(scene: &Scene) -> f64 {
    let largest = scene.model.variable_support.map_or(1.0, |range| f64::from(range.largest));
    support_radius(scene) * largest * CELL_MARGIN
}

/// Cells along a periodic axis: as many as fit.
pub(crate) fn periodic_cells(scene: &Scene, length: f64) -> u32 {
    let cells = length / least_cell(scene);
    // more than any grid can have is refused by whoever multiplies them
    cells.min(f64::from(u32::MAX)) as u32
}

/// Mass of a particle, kg: of the volume that it stands for at the start, `rho0 spacing^d`; calibrated, what makes the
/// density sum over the lattice the rest density.
#[must_use]
pub fn particle_mass(scene: &Scene) -> f64 {
    let lattice =
        f64::from(scene.fluid.rest_density) * power(f64::from(scene.particle_spacing), scene.dimension.count());
    if scene.model.calibrated_mass { lattice / kernel_sum(scene) } else { lattice }
}

/// `x^n` by multiplication: the last bit of a library's `pow` is its own affair.
pub(crate) fn power(x: f64, n: usize) -> f64 {
    core::iter::repeat_n(x, n).product()
}

/// Near pressure over density, m2/s2; 0 where near pressure is off.
#[must_use]
pub fn near_stiffness(scene: &Scene) -> f64 {
    if scene.model.near_pressure == NearPressure::Off {
        return 0.0;
    }
    let c0 = f64::from(scene.fluid.speed_of_sound);
    scene.fluid.near_stiffness.map_or(DEFAULT_NEAR_SHARE * c0 * c0, f64::from)
}

/// Constant of the equation of state, Pa.
fn state_stiffness(scene: &Scene) -> f64 {
    let c0 = f64::from(scene.fluid.speed_of_sound);
    let bulk = f64::from(scene.fluid.rest_density) * c0 * c0;
    match scene.model.equation_of_state {
        EquationOfState::Tait => scene.fluid.stiffness.map_or(bulk / 7.0, f64::from),
        _ => bulk,
    }
}

/// What an iteration of pressure adds for a density that is off by all of itself, Pa.
///
/// A pressure at `a` accelerates its neighbours by `m P / rho^2 grad W`, which within a step thins the density at `a` by
/// `dt^2 V^2 / rho0 sum |grad W|^2` of itself for each pascal.
#[must_use]
pub fn correction_stiffness(scene: &Scene) -> f64 {
    let bulk = state_stiffness(scene);
    if scene.model.correction.iteration == Iteration::Literal {
        return bulk;
    }
    let dt = f64::from(scene.time_step);
    let thinning = dt * dt / f64::from(scene.fluid.rest_density) * gradient_squares(scene);
    RELAXATION / (thinning + f64::from(CORRECTION_SOURCE) / bulk)
}

/// Density, less the rest density, over it, and pressure in Pa, that hold the weight of the fluid above (S3 section 3.1 per
/// errata): `rho = rho0 (1 + rho0 g depth / B)^(1/7)` with Tait's equation.
#[must_use]
pub fn hydrostatic_deviation(scene: &Scene, position: [f32; 3]) -> (f64, f32) {
    let g = scene.gravity.map(f64::from);
    let along = |x: [f32; 3]| -> f64 { g.iter().zip(x).map(|(g, x)| g * f64::from(x)).sum() };
    let top = |b: &crate::scene::Block| {
        let highest = [0, 1, 2].map(|i| if g[i] < 0.0 { b.corner[i] + b.size[i] } else { b.corner[i] });
        along(highest)
    };
    let surface = scene.blocks.iter().map(top).fold(f64::INFINITY, f64::min);
    // g . x grows downwards
    // what surrounds the fluid carries its share, and Mueller's form answers a weight with twice its pressure
    let weighed = f64::from(scene.fluid.rest_density) - f64::from(scene.ambient_density);
    let answer = if scene.model.pressure_force == PressureForce::Mueller { 2.0 } else { 1.0 };
    let pressure = answer * weighed * (along(position) - surface).max(0.0);
    let stiffness = state_stiffness(scene);
    let deviation = match scene.model.equation_of_state {
        EquationOfState::Tait => libm::pow(1.0 + pressure / stiffness, 1.0 / 7.0) - 1.0,
        _ => pressure / stiffness,
    };
    (deviation, pressure as f32)
}

/// The constants of a scene that [`Scene::check`] accepts.
#[must_use]
pub fn parameters(scene: &Scene) -> Parameters {
    let (fluid, model) = (&scene.fluid, &scene.model);
    let d = scene.dimension.count();
    let support = support_radius(scene);
    let over = |n: usize| 1.0 / power(support, n);
    let mass = particle_mass(scene);
    let rest_density = f64::from(fluid.rest_density);
    let rest_volume = mass / rest_density;
    let bulk = rest_density * f64::from(fluid.speed_of_sound) * f64::from(fluid.speed_of_sound);
    let near_constant = match model.near_pressure {
        NearPressure::Article => near_slope_constant(d) / 3.0,
        _ => near_slope_constant(d),
    };
    let pressure_constant = model.pressure_kernel.normalisation(d) * over(d + 1);
    let viscosity_constant = model.viscosity_kernel.normalisation(d) * over(d + 1);
    let density_constant = model.density_kernel.normalisation(d) * over(d);
    let range = model.variable_support.unwrap_or(SupportRange { smallest: 1.0, largest: 1.0 });
    let correction = correction_stiffness(scene);
    let near = near_stiffness(scene);
    let exchanged = model.viscosity == Viscosity::Exchange;
    let [gx, gy, gz] = scene.gravity;
    let container = scene.container.as_ref();
    let wind = scene.wind.map_or([0.0; 4], |w| [w.velocity[0], w.velocity[1], w.velocity[2], w.drag]);
    let field = scene.field.map_or([0.0; 4], |f| [f.low[0], f.low[1], f.low[2], 1.0 / f.spacing]);
    let (planes, plane_count) = planes(scene);
    let Axes { cells, inverse_cell, domain_low, period, half_period, inverse_period } = axes(scene);
    Parameters {
        cells,
        inverse_cell,
        domain_low,
        period,
        half_period,
        inverse_period,
        gravity: [gx, gy, gz, 0.0],
        wind,
        field_low: field,
        field_counts: scene.field_counts(),
        planes,
        species: species(scene),
        particle_count: scene.particle_count() as u32,
        plane_count,
        inverse_support: (1.0 / support) as f32,
        inverse_support_squared: (1.0 / (support * support)) as f32,
        support: support as f32,
        softening: (SOFTENING * support * support) as f32,
        smallest_support: range.smallest,
        largest_support: range.largest,
        time_step: scene.time_step,
        half_time_step: scene.time_step * 0.5,
        inverse_time_step: (1.0 / f64::from(scene.time_step)) as f32,
        particle_mass: mass as f32,
        rest_volume: rest_volume as f32,
        rest_density: fluid.rest_density,
        speed_of_sound: fluid.speed_of_sound,
        density_constant: (rest_volume * density_constant) as f32,
        continuity_constant: (rest_volume * pressure_constant / support) as f32,
        pressure_constant: pressure_constant as f32,
        near_constant: (near_constant * over(d + 1)) as f32,
        near_pressure_at_rest: (near * rest_density) as f32,
        near_density_constant: (near * mass * near_slope_constant(d) / 3.0 * over(d)) as f32,
        viscosity_slope_constant: viscosity_constant as f32,
        viscosity_laplacian_constant: (viscosity_constant / support) as f32,
        state_stiffness: state_stiffness(scene) as f32,
        correction_stiffness: correction as f32,
        inverse_correction_stiffness: (1.0 / correction) as f32,
        compressibility: (1.0 / bulk) as f32,
        correction_source: CORRECTION_SOURCE,
        tolerance: model.correction.tolerance,
        alpha: fluid.alpha,
        beta: fluid.beta,
        dotted_factor: 2.0 * (d as f32 + 2.0),
        velocity_exchange: if exchanged { fluid.velocity_exchange } else { 0.0 },
        radial_exchange: fluid.radial_exchange,
        xsph_constant: (f64::from(fluid.xsph) * rest_volume * density_constant) as f32,
        heat_gain: fluid.heat_gain,
        ambient_ratio: scene.ambient_density / fluid.rest_density,
        bounce: container.map_or(0.0, |c| c.bounce),
        slip: container.map_or(0.0, |c| c.slip),
        pad0: 0,
    }
}

/// What each axis has of its own.
struct Axes {
    cells: [u32; 4],
    inverse_cell: f32x4,
    domain_low: f32x4,
    period: f32x4,
    half_period: f32x4,
    inverse_period: f32x4,
}

fn axes(scene: &Scene) -> Axes {
    let [x, y, z] = scene.cells();
    let inverse = (1.0 / least_cell(scene)) as f32;
    let mut axes = Axes {
        cells: [x, y, z, x.wrapping_mul(y).wrapping_mul(z)],
        inverse_cell: [inverse, inverse, inverse, 0.0],
        domain_low: [0.0; 4],
        period: [0.0; 4],
        half_period: [f32::MAX; 4],
        inverse_period: [0.0; 4],
    };
    for axis in scene.periodic_axes() {
        if let Some(periodic) = &scene.periodic {
            let length = f64::from(periodic.high[axis]) - f64::from(periodic.low[axis]);
            axes.inverse_cell[axis] = (f64::from(axes.cells[axis]) / length) as f32;
            axes.domain_low[axis] = periodic.low[axis];
            axes.period[axis] = length as f32;
            axes.half_period[axis] = (length * 0.5) as f32;
            axes.inverse_period[axis] = (1.0 / length) as f32;
        }
    }
    axes
}

/// The fluid, blocks of another viscosity, walls: viscosity, and 1 for a wall.
fn species(scene: &Scene) -> [f32x4; SPECIES] {
    let own = scene.fluid.dynamic_viscosity;
    let mut kinds = [[own, 0.0, 0.0, 0.0]; SPECIES];
    for (i, block) in scene.blocks.iter().enumerate() {
        kinds[1 + i][0] = block.dynamic_viscosity.unwrap_or(own);
    }
    for (kind, wall) in kinds[1 + BLOCKS..].iter_mut().zip(&scene.walls) {
        *kind = [wall.dynamic_viscosity.unwrap_or(own), 1.0, 0.0, 0.0];
    }
    kinds
}

/// The walls of the container: inward normals and offsets, and how many there are.
fn planes(scene: &Scene) -> (Planes, u32) {
    let mut planes = [[0.0; 4]; PLANES];
    let mut count = 0;
    if let Some(container) = &scene.container {
        let closed = |face: &&Face| scene.is_closed(container, **face);
        for face in Face::ALL.iter().filter(closed) {
            let axis = face.axis();
            let (sign, at) = if face.is_high() { (-1.0, container.high[axis]) } else { (1.0, container.low[axis]) };
            planes[count][axis] = sign;
            planes[count][3] = sign * at;
            count += 1;
        }
    }
    (planes, count as u32)
}
