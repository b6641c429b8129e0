//! Choices of kernel, density, pressure, viscosity and surface tension.
use super::Add;
use super::scenes::{pulled, second_fluid, walls};
use crate::support::forms::several_fluids;
use millpond_core::scene::{
    Correction, DensityDiffusion, DensityForm, EquationOfState, Evaluation, Formulation, Iteration, Kernel,
    NearPressure, PressureForce, PressureSolver, Scene, Shifting, SupportRange, SurfaceTension, Viscosity,
    WallPressure,
};

pub fn kernels_and_pressure(add: Add<'_>) {
    for &kernel in Kernel::ALL {
        if kernel.has_value() {
            add(format!("density_kernel {kernel:?}"), &|s| s.model.density_kernel = kernel);
        }
        add(format!("pressure_kernel {kernel:?}"), &|s| s.model.pressure_kernel = kernel);
        for viscosity in [Viscosity::Mueller, Viscosity::Morris] {
            add(format!("viscosity_kernel {kernel:?} {viscosity:?}"), &|s| {
                (s.model.viscosity_kernel, s.model.viscosity) = (kernel, viscosity);
            });
        }
    }
    for evaluation in [Evaluation::Table, Evaluation::SquaredTable] {
        add(format!("evaluation {evaluation:?}"), &|s| s.model.evaluation = evaluation);
    }
    for &density in DensityForm::ALL {
        add(format!("density {density:?}"), &|s| s.model.density = density);
        add(format!("density {density:?}, calibrated"), &|s| {
            (s.model.density, s.model.normalize_mass) = (density, true);
        });
    }
    for diffusion in [DensityDiffusion::Plain, DensityDiffusion::Hydrostatic, DensityDiffusion::Renormalised] {
        for density in [DensityForm::Continuity, DensityForm::ContinuityAdapted] {
            add(format!("{density:?}, diffusion {diffusion:?}"), &|s| {
                (s.model.density, s.model.density_diffusion, s.model.diffusion) = (density, diffusion, 0.2);
            });
        }
        add(format!("diffusion {diffusion:?}, walls, two fluids"), &|s| {
            (s.model.density, s.model.density_diffusion) = (DensityForm::Continuity, diffusion);
            s.model.wall_pressure = WallPressure::Extrapolated;
            walls(s);
            second_fluid(s);
        });
    }
    for &force in PressureForce::ALL {
        for &density in DensityForm::ALL {
            if force == PressureForce::NumberDensity && density != DensityForm::NumberDensity {
                continue;
            }
            add(format!("{density:?} with {force:?}, one fluid"), &|s| {
                (s.model.density, s.model.pressure_force) = (density, force);
            });
            add(format!("{density:?} with {force:?}, two fluids"), &|s| {
                (s.model.density, s.model.pressure_force) = (density, force);
                second_fluid(s);
            });
        }
        add(format!("pressure_force {force:?}, masses that differ"), &|s| {
            s.model.pressure_force = force;
            s.model.initialize_hydrostatic = force != PressureForce::NumberDensity;
            s.model.density =
                if s.model.initialize_hydrostatic { DensityForm::Continuity } else { DensityForm::NumberDensity };
        });
    }
    for &state in EquationOfState::ALL {
        for negative_pressure in [true, false] {
            add(format!("equation_of_state {state:?}, negative_pressure {negative_pressure}"), &|s| {
                (s.model.equation_of_state, s.model.negative_pressure) = (state, negative_pressure);
                s.model.pressure_force = PressureForce::Monaghan;
            });
        }
    }
    for exponent in 1..7 {
        add(format!("tait_exponent {exponent}"), &|s| {
            (s.model.tait_exponent, s.model.viscosity) = (exponent, Viscosity::Artificial);
        });
        add(format!("tait_exponent {exponent}, walls"), &|s| {
            (s.model.tait_exponent, s.model.wall_pressure) = (exponent, WallPressure::Extrapolated);
            walls(s);
        });
    }
    for &force in PressureForce::ALL {
        if !matches!(force, PressureForce::Canonical | PressureForce::Difference | PressureForce::NumberDensity) {
            add(format!("tensile_control, pressure_force {force:?}"), &|s| {
                (s.model.tensile_control, s.model.pressure_force) = (true, force);
            });
        }
    }
    add("stiffness".into(), &|s| s.fluids[0].stiffness = Some(2000.0));
    for force in [PressureForce::Monaghan, PressureForce::Difference] {
        for (iteration, tolerance) in
            [(Iteration::Relaxed, 1e-4), (Iteration::Relaxed, 0.5), (Iteration::Literal, 1e-3)]
        {
            add(format!("correction {iteration:?} {force:?} to {tolerance}"), &|s| {
                s.model.pressure_solver = PressureSolver::PressureCorrection;
                (s.model.pressure_force, s.model.negative_pressure) = (force, false);
                s.model.correction = Correction { iteration, iterations: 5, tolerance };
            });
        }
    }
    for &near in NearPressure::ALL {
        add(format!("near_pressure {near:?}"), &|s| s.model.near_pressure = near);
    }
}

pub fn shifting(add: Add<'_>) {
    for (shifting, shifting_speed) in
        [(Shifting::Fickian, None), (Shifting::Fickian, Some(2.0)), (Shifting::TransportVelocity, None)]
    {
        let chosen = move |s: &mut Scene| {
            (s.model.shifting, s.model.shifting_speed, s.model.shifting_coefficient) = (shifting, shifting_speed, 0.7);
        };
        let name = format!("shifting {shifting:?} {shifting_speed:?}");
        add(name.clone(), &chosen);
        for &wall in WallPressure::ALL {
            add(format!("{name}, walls {wall:?}, two fluids, XSPH"), &|s| {
                chosen(s);
                (s.model.wall_pressure, s.model.xsph) = (wall, 0.1);
                walls(s);
                second_fluid(s);
            });
        }
        add(format!("{name}, tensile control, supports that vary"), &|s| {
            chosen(s);
            (s.model.tensile_control, s.model.density) = (true, DensityForm::Continuity);
            s.model.variable_support = Some(SupportRange { smallest: 0.7, largest: 1.3 });
        });
    }
    add("shift_across_interfaces".into(), &|s| {
        (s.model.shifting, s.model.shift_across_interfaces) = (Shifting::Fickian, true);
        second_fluid(s);
    });
}

pub fn viscosity_and_tension(add: Add<'_>) {
    for &viscosity in Viscosity::ALL {
        add(format!("viscosity {viscosity:?}"), &|s| {
            s.model.viscosity = viscosity;
            s.model.density = DensityForm::SummationAdapted;
            s.model.velocity_exchange = 0.1;
        });
        for &wall in WallPressure::ALL {
            add(format!("viscosity {viscosity:?}, walls {wall:?}"), &|s| {
                (s.model.viscosity, s.model.wall_pressure) = (viscosity, wall);
                s.model.density = DensityForm::NumberDensity;
                s.model.velocity_exchange = 0.1;
                walls(s);
            });
            add(format!("viscosity {viscosity:?}, walls {wall:?}, two fluids"), &|s| {
                s.model = Formulation { viscosity, wall_pressure: wall, ..several_fluids() };
                s.model.velocity_exchange = 0.1;
                walls(s);
                second_fluid(s);
            });
        }
        add(format!("heat of {viscosity:?}"), &|s| {
            (s.model.viscosity, s.model.internal_energy) = (viscosity, true);
            s.model.density = DensityForm::SummationAdapted;
            (s.model.velocity_exchange, s.model.heat_gain, s.fluids[0].internal_energy) = (0.9, 0.7, 1.0);
        });
    }
    for &tension in SurfaceTension::ALL {
        for &density in DensityForm::ALL {
            add(format!("surface_tension {tension:?} with {density:?}"), &|s| {
                (s.model.surface_tension, s.model.density) = (tension, density);
                pulled(s);
            });
        }
        add(format!("surface_tension {tension:?}, two fluids"), &|s| {
            s.model = Formulation { surface_tension: tension, ..several_fluids() };
            second_fluid(s);
            pulled(s);
        });
        add(format!("surface_tension {tension:?}, corrected pressure and supports that vary"), &|s| {
            s.model.surface_tension = tension;
            s.model.pressure_solver = PressureSolver::PressureCorrection;
            s.model.pressure_force = PressureForce::MonaghanAdapted;
            s.model.variable_support = Some(SupportRange { smallest: 0.7, largest: 1.3 });
            walls(s);
            pulled(s);
        });
    }
}
