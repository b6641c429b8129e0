//! Warnings about a scene that ran: choices known to give bad results, and violated limits of the time step.
use crate::energy::{GROWTH_LIMIT, driven_by};
use crate::state_summary::StateSummary;
use millpond_core::Checked;
use millpond_core::backend::derive::kernel_constants::slope;
use millpond_core::backend::derive::{FluidConstants, average_neighbours, support_radius};
use millpond_core::backend::report::Courant;
use millpond_core::backend::validate::MOST_SPACINGS_AWAY;
use millpond_core::scene::{
    DensityForm, Dimension, Fluid, Kernel, Motion, NearPressure, PlaneModel, Scene, SurfaceTension,
};
use std::f64::consts::PI;

/// Largest sum of the Courant numbers of sound and of the fastest particle, on the support radius. Above it explicit
/// integration misses interactions between particles (Monaghan 1992).
const COURANT_LIMIT: f64 = 0.4;

/// Limit of the time step by viscosity, as a multiple of `H^2 / nu`, where H is the support radius. Morris et al. 1997
/// use 0.125 on half of the support radius, which is the cautious default of an adaptive step; this limit is twice
/// that.
const DIFFUSION_LIMIT: f64 = 0.0625;

/// Limit of the time step by surface tension, as a multiple of `sqrt(rho h^3 / (2 pi sigma))`, where h is half of the
/// support radius (Brackbill et al. 1992).
const CAPILLARY_LIMIT: f64 = 0.25;

/// Largest product of the time step and the angular frequency of a particle on all of its springs. At 2 the motion is
/// unstable.
const SPRING_LIMIT: f64 = 1.0;

/// Mean compression, as a share of the rest density, above which the user is warned.
const COMPRESSION_LIMIT: f64 = 0.03;

/// Kinematic viscosity over the support radius times the speed of sound, below which a density sum boils at walls in
/// closed form. A lid-driven cavity boils at 1e-3 and is calm at 1e-2.
const BOILING: f64 = 0.01;

/// Returns all warnings about a state, and about a run in which `births_refused` spawn requests found no inactive air
/// particle.
#[must_use]
pub fn warnings(scene: &Checked<'_>, state: &StateSummary, births_refused: u64) -> Vec<String> {
    let time_step = state.time_step;
    let mut warnings = Vec::new();
    warnings.extend(courant(state.courant));
    warnings.extend(diffusion(state.courant));
    warnings.extend(resolution(scene, state.farthest));
    warnings.extend(scene.fluids.iter().find_map(|fluid| capillary(scene, fluid, time_step)));
    warnings.extend(scene.derived().fluids.iter().find_map(|fluid| springs(scene, fluid, time_step)));
    if scene.model.near_pressure != NearPressure::Off && !scene.model.negative_pressure {
        warnings.push("near pressure without model.negative_pressure makes the liquid expand like a gas".into());
    }
    if scene.acceleration_field.is_some() {
        warnings.push(
            "the values of acceleration_field come from a calling program: without one, the field is 0 here".into(),
        );
    }
    if births_refused > 0 {
        warnings.push("air.capacity was too small to cover all of the free surface with air: increase it".into());
    }
    warnings.extend(pairing(scene));
    warnings.extend(boiling(scene, state.courant));
    let compression = state.density_error.mean;
    if compression > COMPRESSION_LIMIT {
        let percent = compression * 100.0;
        warnings.push(format!(
            "the fluid is compressed by {percent:.1} % on average: increase speed_of_sound, and shorten time_step in \
             proportion"
        ));
    }
    warnings
}

/// Returns a warning if the energy of an undriven fluid grew between two states. Returns `None` for scenes with
/// springs, surface tension, air, an acceleration field or solids that move, whose energy is not fully accounted for.
#[must_use]
pub fn gained(scene: &Scene, first: &StateSummary, last: &StateSummary) -> Option<String> {
    let stores = |fluid: &Fluid| fluid.elastic_stiffness > 0.0 || fluid.surface_tension > 0.0;
    let moves = scene.solids.iter().any(|solid| solid.motion != Motion::Still);
    let fields = scene.acceleration_field.is_some() || scene.air.is_some() || moves;
    if fields || scene.fluids.iter().any(stores) || driven_by(scene).is_some() {
        return None;
    }
    let share = (last.mechanical - first.mechanical) / first.to_spend;
    (share > GROWTH_LIMIT).then(|| {
        let percent = share * 100.0;
        format!(
            "the fluid gained energy, {percent:.0} % of its available energy, so the run is unstable: try a \
             smaller time_step"
        )
    })
}

fn courant(Courant { speed, sound, .. }: Courant) -> Option<String> {
    let courant = sound + speed;
    (courant > COURANT_LIMIT).then(|| {
        format!(
            "Courant number {courant:.2} is larger than {COURANT_LIMIT}: use a smaller time_step, or set \
             adaptive"
        )
    })
}

/// Warns if the time step exceeds the stability limit of explicit viscosity.
fn diffusion(Courant { viscosity, .. }: Courant) -> Option<String> {
    (viscosity > DIFFUSION_LIMIT).then(|| {
        format!(
            "viscosity needs a time_step {:.1} times smaller: explicit viscosity is unstable above its limit and \
             reverses velocities (Morris et al. 1997)",
            viscosity / DIFFUSION_LIMIT
        )
    })
}

/// Warns if a particle is so far from the origin that f32 has too few digits for distances between neighbours.
fn resolution(scene: &Scene, farthest: f64) -> Option<String> {
    let most = f64::from(MOST_SPACINGS_AWAY) * f64::from(scene.particle_spacing);
    (farthest > most).then(|| {
        let step = (farthest as f32).next_up() - farthest as f32;
        format!("a particle is {farthest:.1e} m from the origin, where f32 resolves positions only to {step:.1e} m")
    })
}

/// Warns if a density sum makes the fluid boil at walls in closed form: without a kinematic viscosity of about a
/// hundredth of the support radius times the speed of sound it feeds on the error of the sum beside them.
fn boiling(scene: &Scene, Courant { viscosity, sound, .. }: Courant) -> Option<String> {
    let is_sum = !matches!(scene.model.density, DensityForm::Continuity | DensityForm::ContinuityAdapted);
    let closed = scene.container.as_ref().is_some_and(|container| container.model == PlaneModel::ClosedForm);
    (is_sum && closed && viscosity < BOILING * sound).then(|| {
        format!(
            "model.density {} boils at walls in closed form if the fluid has little viscosity: use Continuity with \
             density_diffusion Hydrostatic, walls of particles, or more viscosity",
            scene.model.density.name()
        )
    })
}

/// Warns if the time step is too long for capillary waves.
fn capillary(scene: &Scene, fluid: &Fluid, time_step: f64) -> Option<String> {
    let curved = matches!(scene.model.surface_tension, SurfaceTension::Curvature | SurfaceTension::NormalCurvature);
    let sigma = f64::from(fluid.surface_tension);
    if !curved || sigma == 0.0 {
        return None;
    }
    let h = support_radius(scene) / 2.0;
    let most = CAPILLARY_LIMIT * (f64::from(fluid.rest_density) * h.powi(3) / (2.0 * PI * sigma)).sqrt();
    (time_step > most)
        .then(|| format!("surface tension needs a time_step of at most {most:.1e} s (Brackbill et al. 1992)"))
}

/// Warns if the time step is too long for a particle on all of its springs.
fn springs(scene: &Checked<'_>, fluid: &FluidConstants, time_step: f64) -> Option<String> {
    // spring_pull is half of the stiffness over the mass, and of all springs only one in as many as there are axes
    // counts along a direction
    let ends = scene.derived().springs_of_particle as f64 / scene.dimension.count() as f64;
    let omega = (fluid.spring_pull * ends).sqrt();
    (omega * time_step > SPRING_LIMIT)
        .then(|| format!("elasticity needs a time_step of at most {:.1e} s", SPRING_LIMIT / omega))
}

/// Returns the number of neighbours, the particle itself included, above which a kernel lets particles pair; `None` for
/// kernels that never do.
///
/// The limits of the cubic spline are about 55 neighbours in 3D (Dehnen and Aly 2012) and 27 in 2D. What matters is the
/// distance at which the slope of the kernel is steepest: two particles that are closer than that repel each other less
/// the closer they get. The limits of other kernels are scaled from those of the cubic spline by that distance.
/// Particles never pair with the Wendland kernels, whose Fourier transforms are positive, or with kernels that have a
/// cusp at zero distance.
fn most_neighbours(kernel: Kernel, dimension: Dimension) -> Option<f64> {
    if kernel.is_cusped() || matches!(kernel, Kernel::WendlandC2 | Kernel::WendlandC4) {
        return None;
    }
    let d = dimension.count();
    let steepest = |kernel: Kernel| {
        let places = (1..1000).map(|i| f64::from(i) / 1000.0);
        places.max_by(|a, b| slope(kernel, d, *a).total_cmp(&slope(kernel, d, *b))).unwrap_or(1.0)
    };
    let of_spline = if dimension == Dimension::Two { 27.0 } else { 55.0 };
    Some(of_spline * (steepest(Kernel::CubicSpline) / steepest(kernel)).powi(d as i32))
}

/// Warns if the pressure kernel lets particles pair at this number of neighbours and no near pressure keeps them apart.
fn pairing(scene: &Scene) -> Option<String> {
    let kernel = scene.model.pressure_kernel;
    let most = most_neighbours(kernel, scene.dimension)?;
    let apart = scene.model.near_pressure != NearPressure::Off;
    (f64::from(average_neighbours(scene)) > most + 0.5 && !apart).then(|| {
        format!(
            "with {kernel:?} particles form pairs above about {most:.0} neighbours, and average_neighbours is {}: use \
             a Wendland kernel, fewer neighbours or near pressure",
            average_neighbours(scene)
        )
    })
}
