//! What a user should know of a scene that ran: choices that are known to end badly, and limits of the time step.
use crate::energy::{GROWTH_LIMIT, driven_by};
use crate::state_summary::StateSummary;
use millpond_core::Checked;
use millpond_core::backend::derive::kernel_constants::slope;
use millpond_core::backend::derive::{FluidConstants, average_neighbours, support_radius};
use millpond_core::backend::report::Courant;
use millpond_core::backend::validate::MOST_SPACINGS_AWAY;
use millpond_core::scene::{Dimension, Fluid, Kernel, NearPressure, Scene, SurfaceTension};
use std::f64::consts::PI;

/// Largest share of its support that sound and the fastest particle together may cross in a step: past it explicit
/// integration loses pairs it should have felt (Monaghan 1992).
const COURANT_LIMIT: f64 = 0.4;

/// Share of `H^2 / nu` that a step may last: twice the 0.125 of Morris et al. 1997 on half of the support, which is the
/// careful choice of an adaptive step.
const DIFFUSION_LIMIT: f64 = 0.0625;

/// Share of `sqrt(rho h^3 / (2 pi sigma))` that a step may last, h being half of the support (Brackbill et al. 1992).
const CAPILLARY_LIMIT: f64 = 0.25;

/// Largest product of a step and the frequency of a particle on all of its springs: at 2 it is thrown off.
const SPRING_LIMIT: f64 = 1.0;

/// Compression, in the mean, from which on a fluid is not what it was meant to be.
const COMPRESSION_LIMIT: f64 = 0.03;

/// All that there is to say of a state, and of a run in which so many births of air found no particle.
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
        warnings
            .push("near pressure without suction has nothing to balance it: this liquid will expand like a gas".into());
    }
    if scene.acceleration_field.is_some() {
        warnings.push(
            "the scene's field is its host's to fill, and this program fills none: it acts as if it were 0".into(),
        );
    }
    if births_refused > 0 {
        warnings.push("a bare surface found no air left to be made: a larger air.capacity covers all of it".into());
    }
    warnings.extend(pairing(scene));
    let compression = state.density_error.mean;
    if compression > COMPRESSION_LIMIT {
        let percent = compression * 100.0;
        warnings.push(format!(
            "the fluid is compressed by {percent:.1} % on average: a larger speed_of_sound holds better"
        ));
    }
    warnings
}

/// Did what nothing drives gain energy between these two states? Where springs or surfaces store some, nobody can say.
#[must_use]
pub fn gained(scene: &Scene, first: &StateSummary, last: &StateSummary) -> Option<String> {
    let stores = |fluid: &Fluid| fluid.elastic_stiffness > 0.0 || fluid.surface_tension > 0.0;
    let fields = scene.acceleration_field.is_some() || scene.air.is_some();
    if fields || scene.fluids.iter().any(stores) || driven_by(scene).is_some() {
        return None;
    }
    let share = (last.mechanical - first.mechanical) / first.to_spend;
    (share > GROWTH_LIMIT).then(|| {
        let percent = share * 100.0;
        format!("the fluid gained energy, {percent:.0} % of what it had to spend: the run is unstable; try a smaller time_step")
    })
}

fn courant(Courant { speed, sound, .. }: Courant) -> Option<String> {
    let courant = sound + speed;
    (courant > COURANT_LIMIT).then(|| {
        format!(
            "Courant number {courant:.2} is larger than {COURANT_LIMIT}: a smaller time_step or speed_of_sound is safer, \
             and adaptive finds one"
        )
    })
}

/// Does viscosity reach further in a step than the neighbours it acts on?
fn diffusion(Courant { viscosity, .. }: Courant) -> Option<String> {
    (viscosity > DIFFUSION_LIMIT).then(|| {
        format!(
            "viscosity needs a time_step {:.1} times smaller: explicit diffusion turns velocities round (Morris et al. 1997)",
            viscosity / DIFFUSION_LIMIT
        )
    })
}

/// Is a particle where f32 has too few digits for what happens between it and others?
fn resolution(scene: &Scene, farthest: f64) -> Option<String> {
    let most = f64::from(MOST_SPACINGS_AWAY) * f64::from(scene.particle_spacing);
    (farthest > most).then(|| {
        let step = (farthest as f32).next_up() - farthest as f32;
        format!("a particle is {farthest:.1e} m from the origin, where it can only move by steps of {step:.1e} m")
    })
}

/// Does a step last longer than the waves of the surface allow?
fn capillary(scene: &Scene, fluid: &Fluid, time_step: f64) -> Option<String> {
    let curved = matches!(scene.model.surface_tension, SurfaceTension::Curvature | SurfaceTension::NormalCurvature);
    let sigma = f64::from(fluid.surface_tension);
    if !curved || sigma == 0.0 {
        return None;
    }
    let h = support_radius(scene) / 2.0;
    let most = CAPILLARY_LIMIT * (f64::from(fluid.rest_density) * h.powi(3) / (2.0 * PI * sigma)).sqrt();
    (time_step > most)
        .then(|| format!("waves of the surface need a time_step of at most {most:.1e} s (Brackbill et al. 1992)"))
}

/// Does a step last longer than a particle on all of its springs allows?
fn springs(scene: &Checked<'_>, fluid: &FluidConstants, time_step: f64) -> Option<String> {
    // each of them pulls with half of its stiffness, and those along a direction are a share of all
    let ends = scene.derived().springs_of_particle as f64 / scene.dimension.count() as f64;
    let omega = (fluid.spring_pull * ends).sqrt();
    (omega * time_step > SPRING_LIMIT)
        .then(|| format!("springs need a time_step of at most {:.1e} s", SPRING_LIMIT / omega))
}

/// Neighbours, itself counted, from which on a kernel lets particles pair; none where it never does.
///
/// The cubic spline does from about 55 on in space (Dehnen and Aly 2012), 27 in the plane. What decides is how far out its
/// slope is steepest: two particles nearer than that push each other less the nearer they come. Other kernels are held
/// against it by that distance. Wendland's, whose Fourier transforms are positive, and those with an edge never pair.
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

/// Do the pressure kernel and the neighbours invite pairing, with nothing to keep particles apart?
fn pairing(scene: &Scene) -> Option<String> {
    let kernel = scene.model.pressure_kernel;
    let most = most_neighbours(kernel, scene.dimension)?;
    let apart = scene.model.near_pressure != NearPressure::Off;
    (f64::from(average_neighbours(scene)) > most + 0.5 && !apart).then(|| {
        format!(
            "{kernel:?} lets particles pair from about {most:.0} neighbours on, and average_neighbours is {}: a Wendland \
             kernel, fewer neighbours or near pressure keep them apart",
            average_neighbours(scene)
        )
    })
}
