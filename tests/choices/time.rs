//! Choices of integrators, and of time steps that change.
use super::Add;
use super::scenes::{pulled, second_fluid, walls};
use crate::support::forms::several_fluids;
use millpond_core::glam::Vec3;
use millpond_core::scene::{
    AdaptiveTimeStep, Air, DensityForm, Formulation, Integrator, Periodic, Plasticity, PressureForce, PressureSolver,
    Recovery, SupportRange, SurfaceTension, Viscosity,
};

pub fn time(add: Add<'_>) {
    for &integrator in Integrator::ALL {
        add(format!("integrator {integrator:?}"), &|s| s.model.integrator = integrator);
        add(format!("integrator {integrator:?} with heat, XSPH, walls of particles, across a periodic side"), &|s| {
            s.model = Formulation { integrator, internal_energy: true, viscosity: Viscosity::Artificial, ..s.model };
            s.model.density = DensityForm::Continuity;
            s.model.xsph = 0.3;
            s.container = None;
            s.periodic = Some(Periodic { low: Vec3::ZERO, high: Vec3::new(0.8, 0.6, 0.6), axes: [true, false, false] });
            walls(s);
        });
        if again(integrator) {
            add(format!("integrator {integrator:?}, evaluated again"), &|s| {
                (s.model.integrator, s.model.reevaluate) = (integrator, true);
            });
            add(format!("integrator {integrator:?}, evaluated again with springs and tension"), &|s| {
                s.model = Formulation { integrator, reevaluate: true, ..several_fluids() };
                s.model.surface_tension = SurfaceTension::NormalCurvature;
                (s.fluids[0].elastic_stiffness, s.model.xsph, s.model.internal_energy) = (500.0, 0.1, true);
                s.elasticity.plasticity = Some(Plasticity { rate: 20.0, yield_strain: 0.01 });
                pulled(s);
            });
        }
        if integrator.allows_changing_steps() {
            add(format!("integrator {integrator:?}, adaptive"), &|s| {
                s.model.integrator = integrator;
                s.adaptive = Some(AdaptiveTimeStep { max_growth: 1.3, ..AdaptiveTimeStep::default() });
            });
            add(format!("integrator {integrator:?}, adaptive, and made again"), &|s| {
                s.model.integrator = integrator;
                // the first step is too long, and the criterion tightens as the blocks meet
                s.time_step = 0.004;
                let reject_ratio = Some(1.01);
                s.adaptive =
                    Some(AdaptiveTimeStep { speed: None, sound: None, reject_ratio, ..AdaptiveTimeStep::default() });
            });
        }
    }
    add("adaptive, of two fluids in supports that vary, with corrected pressure".into(), &|s| {
        second_fluid(s);
        s.model.variable_support = Some(SupportRange { smallest: 0.7, largest: 1.3 });
        s.model.pressure_solver = PressureSolver::PressureCorrection;
        s.model.pressure_force = PressureForce::MonaghanAdapted;
        s.adaptive = Some(AdaptiveTimeStep { reject_ratio: Some(1.0), ..AdaptiveTimeStep::default() });
    });
    add("steps that are shortened where they cannot be made".into(), &|s| {
        s.recovery = Recovery::ShortenStep { times: 3 };
    });
    add("adaptive, held at its shortest step".into(), &|s| {
        s.adaptive =
            Some(AdaptiveTimeStep { smallest: 0.0009, reject_ratio: Some(1.0), ..AdaptiveTimeStep::default() });
    });
    add("adaptive with air".into(), &|s| {
        s.model = several_fluids();
        second_fluid(s);
        s.blocks[1].fluid = 0;
        s.air = Some(Air { fluid: 1, capacity: 60, threshold: 0.5, minimum_density: 0.6 });
        s.adaptive = Some(AdaptiveTimeStep { reject_ratio: Some(1.0), ..AdaptiveTimeStep::default() });
    });
    add("stiffness_for_time_step".into(), &|s| s.stiffness_for_time_step = Some(0.2));
}

/// Returns whether forces may be evaluated again with this integrator: not where they already use the velocity at the
/// end of the step, nor where particles move after the forces.
fn again(integrator: Integrator) -> bool {
    use Integrator::*;
    !matches!(integrator, Euler | SemiImplicitEuler | Clavet | PositionCorrectedBeeman)
}
