//! Guided creation (S0 section 4.1): from what a user says, everything that follows from it, in f64 and rounded once.
use crate::kernel::{laplacian, near_slope_constant};
use crate::kinds::{corrections, species, state_stiffness, states};
use crate::lattice_sums::kernel_sum;
use crate::layout::{PLANES, Parameters, Planes, f32x4};
use crate::scene::{
    Adaptive, Block, Dimension, EquationOfState, Face, Fluid, NearPressure, PressureForce, Scene, SupportRange,
    Viscosity,
};
use core::f64::consts::PI;

/// A cell is a little larger than the support, so that rounding never parts two neighbours by two cells.
const CELL_MARGIN: f64 = 1.0 + 1.0 / 1024.0;

/// What keeps close pairs from dividing by nothing, over H^2. The sources' 0.01 h^2 has the h whose double is the support:
/// with 0.01 H^2 the Laplacian of Morris et al. is 3 to 5 % too small on a lattice, with this at most 2 %.
const SOFTENING: f64 = 0.01 / 4.0;

/// Share of a deviation of density that a step of corrected pressure is to mend (our choice).
pub(crate) const CORRECTION_SOURCE: f32 = 0.1;

/// Where a smooth kernel's Laplacian is taken for that at no distance, over H; it is even there, so this is right to 1e-6.
const AT_SELF: f64 = 1e-4;

/// Particles inside the support radius of the scene: the fewest that one of its fluids has (S0 section 3.3).
#[must_use]
pub fn average_neighbours(scene: &Scene) -> f32 {
    let own = scene.fluids().map(|fluid| fluid.average_neighbours.unwrap_or(scene.average_neighbours));
    own.fold(f32::INFINITY, f32::min)
}

/// Radius that holds `average_neighbours` particles at the initial spacing: `n = N/V 4/3 pi H^3`, in 2D `N/A pi H^2`
/// (S0 section 4.1.5 per errata), m. Of several fluids the smallest one (S0 section 3.3).
#[must_use]
pub fn support_radius(scene: &Scene) -> f64 {
    let (n, spacing) = (f64::from(average_neighbours(scene)), f64::from(scene.particle_spacing));
    match scene.dimension {
        Dimension::Two => spacing * libm::sqrt(n / PI),
        Dimension::Three => spacing * libm::cbrt(n * 3.0 / (4.0 * PI)),
    }
}

/// Speed of sound of a fluid at rest, m/s: what it names; or `sqrt(7 k / rho0)` by S1's constant k of Tait's equation; or what
/// the time step allows, where the scene asks for that.
#[must_use]
pub fn speed_of_sound(scene: &Scene, fluid: &Fluid) -> f64 {
    if let Some(stiffness) = fluid.stiffness {
        return libm::sqrt(7.0 * f64::from(stiffness) / f64::from(fluid.rest_density));
    }
    let own = f64::from(fluid.speed_of_sound);
    let Some(courant) = scene.stiffness_for_time_step else { return own };
    let fastest = scene.fluids().map(|fluid| f64::from(fluid.speed_of_sound)).fold(0.0, f64::max);
    own / fastest * f64::from(courant) * support_radius(scene) / f64::from(scene.time_step)
}

/// Largest kinematic viscosity of a scene, m2/s: of a pair the mean viscosity, or that of the wall, over the smaller rest density,
/// since the lighter of two is moved the more. Of the artificial viscosity that of Monaghan 1992, `alpha h c / (2 (d + 2))` with the
/// support for h; exchanges, which take no time step, have none.
#[must_use]
pub fn kinematic_viscosity(scene: &Scene) -> f64 {
    let largest = |all: &mut dyn Iterator<Item = f64>| all.fold(0.0, f64::max);
    match scene.model.viscosity {
        Viscosity::Exchange => 0.0,
        Viscosity::Artificial => {
            let sound = largest(&mut scene.fluids().map(|fluid| speed_of_sound(scene, fluid)));
            let directions = 2.0 * (scene.dimension.count() as f64 + 2.0);
            f64::from(scene.fluid.alpha) * support_radius(scene) * sound / directions
        }
        _ => {
            let of = |viscosity: f32, fluid: &Fluid| [viscosity, fluid.rest_density].map(f64::from);
            let own = |block: &Block| Some(of(block.dynamic_viscosity?, scene.fluid_of(block.fluid)));
            let fluids = || scene.fluids().map(|fluid| of(fluid.dynamic_viscosity, fluid));
            let all = || fluids().chain(scene.blocks.iter().filter_map(own));
            let pairs = all()
                .flat_map(|[mu_a, rho_a]| all().map(move |[mu_b, rho_b]| 0.5 * (mu_a + mu_b) / f64::min(rho_a, rho_b)));
            let lightest = scene.fluids().map(|fluid| f64::from(fluid.rest_density)).fold(f64::INFINITY, f64::min);
            let walls = scene.walls.iter().filter_map(|wall| wall.dynamic_viscosity);
            largest(&mut pairs.chain(walls.map(|viscosity| f64::from(viscosity) / lightest)))
        }
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

/// Mass of a particle of the first fluid, kg, those of the others being as their rest densities: of the volume that it stands for
/// at the start, `rho0 spacing^d`; calibrated, what makes the density sum over the lattice the rest density.
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

/// Density, less the rest density, over it, and pressure in Pa, that hold the weight of the fluid above (S3 section 3.1 per
/// errata): `rho = rho0 (1 + rho0 g depth / B)^(1/7)` with Tait's equation. Fluids lie in layers, each from the highest to the
/// lowest point of its blocks.
#[must_use]
pub fn hydrostatic_deviation(scene: &Scene, fluid: u32, position: [f32; 3]) -> (f64, f32) {
    let g = scene.gravity.map(f64::from);
    // g . x grows downwards
    let along = |x: [f64; 3]| -> f64 { g.iter().zip(x).map(|(g, x)| g * x).sum() };
    let corner = |b: &Block, highest: bool| {
        let far = |i: usize| (g[i] < 0.0) == highest;
        along([0, 1, 2].map(|i| f64::from(if far(i) { b.corner[i] + b.size[i] } else { b.corner[i] })))
    };
    let place = along(position.map(f64::from));
    let mut pressure = 0.0;
    for (number, above) in (0..).zip(scene.fluids()) {
        let blocks = || scene.blocks.iter().filter(|block| block.fluid == number);
        let top = blocks().map(|b| corner(b, true)).fold(f64::INFINITY, f64::min);
        let bottom = blocks().map(|b| corner(b, false)).fold(f64::NEG_INFINITY, f64::max);
        // a fluid is as deep as it is asked for
        let depth = if number == fluid { place } else { place.min(bottom) } - top;
        // what surrounds the fluid carries its share
        let weighed = f64::from(above.rest_density) - f64::from(scene.ambient_density);
        pressure += weighed * depth.max(0.0);
    }
    // Mueller's form answers a weight with twice its pressure
    if matches!(scene.model.pressure_force, PressureForce::Mueller | PressureForce::MuellerAdapted) {
        pressure *= 2.0;
    }
    let own = scene.fluid_of(fluid);
    let stiffness = state_stiffness(scene, own);
    let deviation = match own.equation_of_state.unwrap_or(scene.model.equation_of_state) {
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
    let near_constant = match model.near_pressure {
        NearPressure::Article => near_slope_constant(d) / 3.0,
        _ => near_slope_constant(d),
    };
    let pressure_constant = model.pressure_kernel.normalisation(d) * over(d + 1);
    let viscosity_constant = model.viscosity_kernel.normalisation(d) * over(d + 1);
    let density_constant = model.density_kernel.normalisation(d) * over(d);
    let range = model.variable_support.unwrap_or(SupportRange { smallest: 1.0, largest: 1.0 });
    let elasticity = &scene.elasticity;
    let air = scene.air.as_ref();
    let plasticity = elasticity.plasticity;
    let exchanged = model.viscosity == Viscosity::Exchange;
    let [gx, gy, gz] = scene.gravity;
    let container = scene.container.as_ref();
    let wind = scene.wind.map_or([0.0; 4], |w| [w.velocity[0], w.velocity[1], w.velocity[2], w.drag]);
    let field = scene.field.map_or([0.0; 4], |f| [f.low[0], f.low[1], f.low[2], 1.0 / f.spacing]);
    let (planes, plane_count) = planes(scene);
    let adaptive = scene.adaptive.unwrap_or_default();
    let reaches = Reaches::of(scene, &adaptive);
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
        states: states(scene),
        corrections: corrections(scene),
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
        density_constant: (rest_volume * density_constant) as f32,
        continuity_constant: (rest_volume * pressure_constant / support) as f32,
        pressure_constant: pressure_constant as f32,
        near_constant: (near_constant * over(d + 1)) as f32,
        viscosity_slope_constant: viscosity_constant as f32,
        viscosity_laplacian_constant: (viscosity_constant / support) as f32,
        colour_constant: density_constant as f32,
        colour_slope_constant: (density_constant / support) as f32,
        colour_laplacian_constant: (density_constant / (support * support)) as f32,
        colour_curvature_at_self: laplacian(model.density_kernel, d, AT_SELF) as f32,
        surface_threshold: (f64::from(model.surface_threshold) / support) as f32,
        surface_directions: d as f32 - 1.0,
        yield_strain: plasticity.map_or(0.0, |plasticity| plasticity.yield_strain),
        plastic_rate: plasticity.map_or(0.0, |plasticity| plasticity.rate),
        breaking_stretch: elasticity.break_at.map_or(f32::MAX, |stretch| 1.0 + stretch),
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
        spacing: scene.particle_spacing,
        air_threshold: air.map_or(0.0, |air| (f64::from(air.threshold) / support) as f32),
        air_minimum: air.map_or(0.0, |air| air.minimum_density),
        air_heat: air.map_or(0.0, |air| scene.fluid_of(air.fluid).thermal_energy),
        air_fluid: air.map_or(0.0, |air| air.fluid as f32),
        first_air: first_air(scene, scene.particle_count()),
        speed_reach: reaches.speed,
        acceleration_reach: reaches.acceleration,
        sound_reach: reaches.sound,
        viscous_time_step: reaches.viscosity,
        smallest_time_step: adaptive.smallest,
        largest_time_step: adaptive.largest,
        time_step_growth: adaptive.growth,
        redo_above: adaptive.redo_above.unwrap_or(0.0),
        kinematic_viscosity: kinematic_viscosity(scene) as f32,
    }
}

/// How far what limits a time step may come in one.
struct Reaches {
    /// m.
    speed: f32,
    /// m.
    acceleration: f32,
    /// m.
    sound: f32,
    /// What viscosity allows, s.
    viscosity: f32,
}

impl Reaches {
    /// So far, and such a time, that nothing is limited.
    const NO_LIMIT: f64 = 1e30;

    fn of(scene: &Scene, adaptive: &Adaptive) -> Reaches {
        let support = support_radius(scene);
        let reach = |courant: Option<f32>| courant.map_or(Reaches::NO_LIMIT, |courant| f64::from(courant) * support);
        // sound that is iterated for limits nothing
        let iterated = scene.model.equation_of_state == EquationOfState::PressureCorrection;
        let viscosity = kinematic_viscosity(scene);
        let by_viscosity = adaptive.viscosity.filter(|_| viscosity > 0.0);
        let step = by_viscosity.map_or(Reaches::NO_LIMIT, |courant| f64::from(courant) * support * support / viscosity);
        Reaches {
            speed: reach(adaptive.speed) as f32,
            // C sqrt(H / a) is the root of C^2 H / a
            acceleration: reach(adaptive.acceleration.map(|courant| courant * courant)) as f32,
            sound: reach(adaptive.sound.filter(|_| !iterated)) as f32,
            viscosity: step.min(Reaches::NO_LIMIT) as f32,
        }
    }
}

/// First id of the coat of air, of so many particles in all.
pub(crate) fn first_air(scene: &Scene, particles: usize) -> u32 {
    particles.saturating_sub(scene.air_capacity()) as u32
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
    // particles that are not there lie in a cell of their own, the last, which no stencil reaches
    let limbo = u32::from(scene.air.is_some());
    let inverse = (1.0 / least_cell(scene)) as f32;
    let mut axes = Axes {
        cells: [x, y, z, x.wrapping_mul(y).wrapping_mul(z).wrapping_add(limbo)],
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
