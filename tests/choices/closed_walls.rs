//! Choices of walls in closed form, and of everything that they take part in.
use super::Add;
use super::scenes::{closed, falls, pulled, second_fluid, walls};
use crate::support::forms::several_fluids;
use millpond_core::glam::Vec3;
use millpond_core::scene::{
    AccelerationField, Air, DensityDiffusion, DensityForm, Formulation, Kernel, PressureForce, PressureSolver,
    Shifting, SupportRange, SurfaceTension, Viscosity, WallPressure,
};

pub fn closed_walls(add: Add<'_>) {
    for &density in DensityForm::ALL {
        add(format!("closed walls, {density:?}"), &|s| {
            closed(s);
            falls(s);
            s.model.density = density;
        });
    }
    for &force in PressureForce::ALL {
        if force != PressureForce::NumberDensity {
            add(format!("closed walls, pressure_force {force:?}"), &|s| {
                closed(s);
                s.model.pressure_force = force;
            });
        }
    }
    for &viscosity in Viscosity::ALL {
        add(format!("closed walls, viscosity {viscosity:?}, two fluids"), &|s| {
            closed(s);
            s.model = Formulation { viscosity, near_pressure: s.model.near_pressure, ..several_fluids() };
            s.model.velocity_exchange = 0.1;
            second_fluid(s);
        });
    }
    for kernel in [Kernel::WendlandC4, Kernel::CubicSpline] {
        add(format!("closed walls, kernels {kernel:?}"), &|s| {
            closed(s);
            (s.model.density_kernel, s.model.pressure_kernel) = (kernel, kernel);
        });
    }
    for shifting in [Shifting::Fickian, Shifting::TransportVelocity] {
        add(format!("closed walls, shifting {shifting:?}, tensile control, renormalised diffusion"), &|s| {
            closed(s);
            (s.model.shifting, s.model.tensile_control) = (shifting, true);
            (s.model.density, s.model.pressure_force) = (DensityForm::Continuity, PressureForce::Monaghan);
            s.model.density_diffusion = DensityDiffusion::Renormalised;
        });
    }
    add("closed walls, corrected pressure, an acceleration field, supports that vary".into(), &|s| {
        closed(s);
        s.model.pressure_solver = PressureSolver::PressureCorrection;
        s.model.pressure_force = PressureForce::MonaghanAdapted;
        s.model.variable_support = Some(SupportRange { smallest: 0.7, largest: 1.3 });
        s.acceleration_field = Some(AccelerationField { low: Vec3::ZERO, spacing: 0.3, counts: [3, 3, 3] });
    });
    add("closed walls, walls of particles, surface tension".into(), &|s| {
        closed(s);
        walls(s);
        (s.model.surface_tension, s.model.wall_pressure) =
            (SurfaceTension::NormalCurvature, WallPressure::Extrapolated);
        pulled(s);
    });
    add("closed walls and air".into(), &|s| {
        s.model = several_fluids();
        closed(s);
        second_fluid(s);
        s.blocks[1].fluid = 0;
        s.air = Some(Air { fluid: 1, capacity: 60, threshold: 0.5, minimum_density: 0.6 });
    });
}
