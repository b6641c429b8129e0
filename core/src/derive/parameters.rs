//! The constants that every pass reads, rounded once.
use super::counts::{Counts, field_counts};
use super::domain::Axes;
use super::emission::drains;
use super::kernel_constants::{laplacian, near_slope_constant, power, value};
use super::materials::{CORRECTION_SOURCE, VISCOSITY_OF_PARTICLE};
use super::scales::Scales;
use super::solids::{pose_rows, rows};
use super::step_limits::StepLimits;
use crate::layout::{PLANES, Parameters, Planes, StepUniform};
use crate::scene::{Elasticity, FACES, Face, NearPressure, Scene, Shifting, SupportRange, Viscosity};
use bytemuck::Zeroable;
use glam::Vec3;

const _: () = assert!(PLANES == FACES, "a plane for each face of a container");

/// Softening of squared distances over H^2, which keeps close pairs from dividing by zero. In the sources it is 0.01
/// h^2 with a support radius of 2 h. With 0.01 H^2 the Laplacian of Morris et al. 1997 is 3 to 5 % too small on a
/// lattice, with this value at most 2 %.
const SOFTENING: f64 = 0.01 / 4.0;

/// Largest distance over the particle spacing that a particle is shifted in a step (our choice; Lind et al. 2012 have
/// 0.2 smoothing lengths).
const SHIFT_LIMIT: f64 = 0.1;

/// Distance over the particle spacing from the surface of a solid at which a path has come to it (our choice).
const TOUCH: f32 = 1e-4;

/// Distance over the particle spacing from all others that a new particle must have (our choice): one that is nearer is
/// pushed away at once.
pub(crate) const CLEARANCE: f32 = 0.75;

/// Distance over H at which the Laplacian of a smooth kernel is evaluated for its value at distance zero. The Laplacian
/// is an even function, so this is accurate to 1e-6.
const AT_SELF: f64 = 1e-4;

/// The constants of a scene. `counts` and the cells are those of the scene, `mass` is the mass of a particle of the
/// first fluid at rest in kg, and `kinematic_viscosity` is the largest one in m2/s.
pub(super) fn parameters(
    scene: &Scene,
    scales: &Scales,
    (counts, cells): (&Counts, [u32; 3]),
    mass: f64,
    kinematic_viscosity: f64,
) -> Parameters {
    let (fluid, model) = (scene.first_fluid(), &scene.model);
    let d = scene.dimension.count();
    let support = scales.support_radius;
    let over = |n: usize| 1.0 / power(support, n);
    let rest_density = f64::from(fluid.rest_density);
    let rest_volume = mass / rest_density;
    let near_constant = match model.near_pressure {
        NearPressure::DoubleDensity => near_slope_constant(d) / 3.0,
        _ => near_slope_constant(d),
    };
    let pressure_constant = model.pressure_kernel.normalisation(d) * over(d + 1);
    let viscosity_constant = model.viscosity_kernel.normalisation(d) * over(d + 1);
    let density_constant = model.density_kernel.normalisation(d) * over(d);
    let range = model.variable_support.unwrap_or(SupportRange { smallest: 1.0, largest: 1.0 });
    let shifted_length = match model.shifting {
        Shifting::Off => 0.0,
        Shifting::Fickian => support,
        Shifting::TransportVelocity => 1.0,
    };
    let Elasticity { plasticity, break_at, .. } = scene.elasticity;
    let exchanged = model.viscosity == Viscosity::VelocityExchange;
    let container = scene.container.as_ref();
    let field = scene.acceleration_field.map_or([0.0; 4], |f| [f.low[0], f.low[1], f.low[2], 1.0 / f.spacing]);
    let (planes, plane_velocities, plane_count) = planes(scene);
    let adaptive = scene.changing_step().unwrap_or_default();
    let limits = StepLimits::of(scene, &adaptive, scales, kinematic_viscosity);
    let Axes { cells, inverse_cell, domain_low, period, half_period, inverse_period } = Axes::of(scene, scales, cells);
    Parameters {
        cells,
        inverse_cell,
        domain_low,
        period,
        half_period,
        inverse_period,
        field_low: field,
        field_counts: field_counts(scene),
        planes,
        plane_velocities,
        particle_count: counts.all() as u32,
        plane_count,
        inverse_support: (1.0 / support) as f32,
        inverse_support_squared: (1.0 / (support * support)) as f32,
        support: support as f32,
        softening: (SOFTENING * support * support) as f32,
        smallest_support: range.smallest,
        largest_support: range.largest,
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
        breaking_stretch: break_at.map_or(f32::MAX, |stretch| 1.0 + stretch),
        correction_source: CORRECTION_SOURCE,
        tolerance: model.correction.tolerance,
        tait_exponent: model.tait_exponent as f32,
        least_tait_power: (libm::pow(0.5, f64::from(model.tait_exponent)) - 1.0) as f32,
        diffusion: (f64::from(model.diffusion) * support) as f32,
        alpha: model.alpha,
        beta: model.beta,
        monaghan_gingold_factor: 2.0 * (d as f32 + 2.0),
        velocity_exchange: if exchanged { model.velocity_exchange } else { 0.0 },
        radial_exchange: model.radial_exchange,
        xsph_constant: (f64::from(model.xsph) * rest_volume * density_constant) as f32,
        shifting: (f64::from(model.shifting_coefficient) * shifted_length) as f32,
        shifting_speed: model.shifting_speed.unwrap_or(0.0),
        shift_limit_length: (SHIFT_LIMIT * f64::from(scene.particle_spacing)) as f32,
        inverse_kernel_at_spacing: inverse_kernel_at_spacing(scene, support),
        heat_gain: model.heat_gain,
        wall_rigidity: model.wall_rigidity,
        spacing2: scene.particle_spacing * scene.particle_spacing,
        closest2: 1e-6 * scene.particle_spacing * scene.particle_spacing,
        touch: TOUCH * scene.particle_spacing,
        ambient_ratio: scene.ambient_density / fluid.rest_density,
        restitution: container.map_or(0.0, |c| c.restitution),
        slip: container.map_or(0.0, |c| c.slip),
        spacing: scene.particle_spacing,
        speed_limit_length: limits.speed,
        acceleration_limit_length: limits.acceleration,
        sound_limit_length: limits.sound,
        // without criteria a step is as long as the scene says
        viscous_time_step: if scene.adaptive.is_some() { limits.viscosity } else { scene.time_step },
        smallest_time_step: adaptive.smallest,
        largest_time_step: adaptive.largest,
        max_time_step_growth: adaptive.max_growth,
        reject_ratio: adaptive.reject_ratio.unwrap_or(0.0),
        closed_planes: if scene.has_closed_container() { plane_count } else { 0 },
        ..coming_and_going(scene, counts, support)
    }
}

/// The constants of solids, and of particles that come and go; all others are 0.
fn coming_and_going(scene: &Scene, counts: &Counts, support: f64) -> Parameters {
    let air = scene.air.as_ref();
    Parameters {
        drains: drains(scene),
        solids: rows(scene),
        solid_counts: [scene.solids.len() as u32, pose_rows(scene) as u32, 0, 0],
        clearance2: scene.particle_spacing * scene.particle_spacing * (CLEARANCE * CLEARANCE),
        air_threshold: air.map_or(0.0, |air| (f64::from(air.threshold) / support) as f32),
        air_minimum: air.map_or(0.0, |air| air.minimum_density),
        air_internal_energy: air.map_or(0.0, |air| scene.fluid_of(air.fluid).internal_energy),
        air_fluid: air.map_or(0.0, |air| air.fluid as f32),
        first_spare: counts.all().saturating_sub(counts.inactive) as u32,
        emitter_count: scene.emitters.len() as u32,
        emitter_points: counts.emitter_points as u32,
        drain_count: scene.drains.len() as u32,
        ..Zeroable::zeroed()
    }
}

/// The inverse of the density kernel at the distance of the spacing, without its constant; 0 if the kernel ends before.
fn inverse_kernel_at_spacing(scene: &Scene, support: f64) -> f32 {
    let w = value(scene.model.density_kernel, f64::from(scene.particle_spacing) / support);
    if w > 0.0 { (1.0 / w) as f32 } else { 0.0 }
}

/// The numbers of the first step, as the scene sets them.
pub(super) fn step_uniform(scene: &Scene) -> StepUniform {
    let [gx, gy, gz] = scene.gravity.to_array();
    let wind = scene.wind.map_or([0.0; 4], |w| [w.velocity[0], w.velocity[1], w.velocity[2], w.drag]);
    StepUniform { gravity: [gx, gy, gz, 0.0], wind, ..Zeroable::zeroed() }.with_time_step(scene.time_step)
}

/// The planes of the container: inward normals and offsets, velocities and viscosities, and their number.
fn planes(scene: &Scene) -> (Planes, Planes, u32) {
    let (mut planes, mut velocities) = ([[0.0; 4]; PLANES], [[0.0; 4]; PLANES]);
    let mut count = 0;
    if let Some(container) = &scene.container {
        let closed = |face: &&Face| scene.is_closed(container, **face);
        for face in Face::ALL.iter().filter(closed) {
            let axis = face.axis();
            let (sign, at) = if face.is_high() { (-1.0, container.high[axis]) } else { (1.0, container.low[axis]) };
            planes[count][axis] = sign;
            planes[count][3] = sign * at;
            let sliding = container.sliding.iter().find(|sliding| sliding.face == *face);
            let [x, y, z] = sliding.map_or(Vec3::ZERO, |sliding| sliding.velocity).to_array();
            velocities[count] = [x, y, z, container.dynamic_viscosity.unwrap_or(VISCOSITY_OF_PARTICLE)];
            count += 1;
        }
    }
    (planes, velocities, count as u32)
}
