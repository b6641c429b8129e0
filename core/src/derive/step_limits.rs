//! The criteria that limit a time step.
use super::fluid::FluidConstants;
use super::scales::Scales;
use crate::scene::{AdaptiveTimeStep, Block, Fluid, Scene, Viscosity};

/// Largest kinematic viscosity of a scene, m2/s. For a pair it is the mean viscosity, or that of the wall, over the
/// smaller rest density, since the lighter of two particles is accelerated more. For the artificial viscosity it is
/// `alpha h c / (2 (d + 2))` (Monaghan 1992), with the support radius for h, and for both together their sum. It is 0
/// for velocity exchange, which does not limit the time step.
pub(super) fn kinematic_viscosity(scene: &Scene, scales: &Scales, fluids: &[FluidConstants]) -> f64 {
    let largest = |all: &mut dyn Iterator<Item = f64>| all.fold(0.0, f64::max);
    let artificial = || {
        let sound = largest(&mut fluids.iter().map(|fluid| fluid.speed_of_sound));
        let directions = 2.0 * (scene.dimension.count() as f64 + 2.0);
        f64::from(scene.model.alpha) * scales.support_radius * sound / directions
    };
    let of_fluids = || {
        let of = |viscosity: f32, fluid: &Fluid| [viscosity, fluid.rest_density].map(f64::from);
        let own = |block: &Block| Some(of(block.dynamic_viscosity?, scene.fluid_of(block.fluid)));
        let fluids = || scene.fluids.iter().map(|fluid| of(fluid.dynamic_viscosity, fluid));
        let all = || fluids().chain(scene.blocks.iter().filter_map(own));
        let pairs = all()
            .flat_map(|[mu_a, rho_a]| all().map(move |[mu_b, rho_b]| 0.5 * (mu_a + mu_b) / f64::min(rho_a, rho_b)));
        let lightest = scene.fluids.iter().map(|fluid| f64::from(fluid.rest_density)).fold(f64::INFINITY, f64::min);
        let walls = scene.walls.iter().filter_map(|wall| wall.dynamic_viscosity);
        let planes = scene.container.iter().filter_map(|container| container.dynamic_viscosity);
        let solids = scene.solids.iter().filter_map(|solid| solid.dynamic_viscosity);
        largest(&mut pairs.chain(walls.chain(planes).chain(solids).map(|viscosity| f64::from(viscosity) / lightest)))
    };
    match scene.model.viscosity {
        Viscosity::VelocityExchange => 0.0,
        Viscosity::Artificial => artificial(),
        Viscosity::MorrisAndArtificial => artificial() + of_fluids(),
        _ => of_fluids(),
    }
}

/// The constants of the criteria that limit a time step.
pub(super) struct StepLimits {
    /// Distance that the fastest particle may travel in a step, m.
    pub(super) speed: f32,
    /// `C^2 H` of the criterion by acceleration, m.
    pub(super) acceleration: f32,
    /// Distance that sound may travel in a step, m.
    pub(super) sound: f32,
    /// Time step that viscosity allows, s.
    pub(super) viscosity: f32,
}

impl StepLimits {
    /// A distance and a time so large that nothing is limited.
    const NO_LIMIT: f64 = 1e30;

    /// The limits of a scene whose largest kinematic viscosity is `viscosity`, m2/s.
    pub(super) fn of(scene: &Scene, adaptive: &AdaptiveTimeStep, scales: &Scales, viscosity: f64) -> StepLimits {
        let support = scales.support_radius;
        let reach = |courant: Option<f32>| courant.map_or(StepLimits::NO_LIMIT, |courant| f64::from(courant) * support);
        // with a pressure solver the speed of sound does not limit the time step
        let iterated = scene.corrects_pressure();
        let by_viscosity = adaptive.viscosity.filter(|_| viscosity > 0.0);
        let step =
            by_viscosity.map_or(StepLimits::NO_LIMIT, |courant| f64::from(courant) * support * support / viscosity);
        StepLimits {
            speed: reach(adaptive.speed) as f32,
            // C sqrt(H / a) is the square root of C^2 H / a
            acceleration: reach(adaptive.acceleration.map(|courant| courant * courant)) as f32,
            sound: reach(adaptive.sound.filter(|_| !iterated)) as f32,
            viscosity: step.min(StepLimits::NO_LIMIT) as f32,
        }
    }
}
