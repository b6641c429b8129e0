//! Promise: settings that cannot be combined are rejected before the first step, with an error that names both, and no
//! other combinations are rejected.
//!
//! The messages are compared word by word, because programs show them to the authors of scenes.
use millpond_core::SceneError;
use millpond_core::glam::Vec3;
use millpond_core::scene::{
    AdaptiveTimeStep, Air, DensityForm, EquationOfState, Evaluation, Face, Fluid, Formulation, GridStructure,
    Integrator, Iteration, Kernel, NearPressure, PressureForce, PressureSolver, Recipe, Scene, SupportRange,
    SurfaceTension, Traversal, Viscosity, Wall, WallShape,
};

#[path = "support/combination.rs"]
mod combination;
#[path = "support/judged.rs"]
mod judged;
use combination::refused;
use judged::judged as scene;

/// Adds a second fluid and a layer of air made of it.
fn air(s: &mut Scene) {
    s.add_fluid(Fluid::default()).expect("room for a fluid");
    s.air = Some(Air { fluid: 1, capacity: 10, threshold: 0.5, minimum_density: 0.5 });
}

#[test]
fn formulas_by_name() {
    assert_eq!(scene(|_| ()), Ok(()));
    refused(
        "model.density_kernel Viscosity conflicts with any model.density: it is infinite at distance 0, so a \
         particle's contribution to its own density would be infinite; use another density_kernel",
        |s| s.model.density_kernel = Kernel::Viscosity,
    );
    refused(
        "model.variable_support conflicts with model.evaluation Table or SquaredTable: a table is computed for one \
         support radius (Pirovano, section 4.2.3); use model.evaluation Direct",
        |s| {
            s.model.evaluation = Evaluation::Table;
            s.model.variable_support = Some(SupportRange { smallest: 0.9, largest: 1.1 });
        },
    );
    refused(
        "model.evaluation Table or SquaredTable conflicts with a kernel whose slope or Laplacian is infinite at \
         distance 0: a table cannot store an infinite value; use model.evaluation Direct, or another pressure_kernel \
         or viscosity_kernel",
        |s| {
            (s.model.evaluation, s.model.viscosity) = (Evaluation::SquaredTable, Viscosity::Morris);
        },
    );
    refused(
        "model.evaluation Table or SquaredTable conflicts with a kernel whose slope or Laplacian is infinite at \
         distance 0: a table cannot store an infinite value; use model.evaluation Direct, or another pressure_kernel \
         or viscosity_kernel",
        |s| {
            (s.model.evaluation, s.model.viscosity_kernel) = (Evaluation::Table, Kernel::Spiky);
        },
    );
    refused(
        "model.pressure_force NumberDensity conflicts with a model.density other than NumberDensity: this gradient is \
         derived for the number density; use model.density NumberDensity, or another pressure_force",
        |s| s.model.pressure_force = PressureForce::NumberDensity,
    );
    refused(
        "model.pressure_solver PressureCorrection conflicts with model.pressure_force Mueller, MuellerAdapted, \
         Canonical or NumberDensity: its iteration is derived for other forms of the whole gradient (Pirovano, \
         section 3.2.2); use Monaghan, MonaghanAdapted, DensityWeighted or Difference",
        |s| {
            s.model.pressure_solver = PressureSolver::PressureCorrection;
        },
    );
    refused(
        "model.internal_energy conflicts with model.pressure_force Canonical or Difference: their pair forces are not \
         equal and opposite, so the work they do cannot be assigned to either particle; use another pressure_force",
        |s| {
            (s.model.internal_energy, s.model.pressure_force) = (true, PressureForce::Difference);
        },
    );
}

#[test]
fn starts_and_surroundings_by_name() {
    refused(
        "model.initialize_hydrostatic conflicts with equation_of_state IdealGas: a gas has no free surface from which \
         to measure depth; use another equation_of_state, or turn initialize_hydrostatic off",
        |s| {
            (s.model.initialize_hydrostatic, s.model.equation_of_state) = (true, EquationOfState::IdealGas);
        },
    );
    refused(
        "model.initialize_hydrostatic conflicts with model.density NumberDensity: a number density ignores particle \
         masses, which the hydrostatic start sets; use another model.density, or turn initialize_hydrostatic off",
        |s| {
            (s.model.initialize_hydrostatic, s.model.density) = (true, DensityForm::NumberDensity);
        },
    );
    refused("model.initialize_hydrostatic conflicts with zero gravity: there is no weight; set gravity", |s| {
        s.model.initialize_hydrostatic = true;
        s.gravity = Vec3::ZERO;
    });
    assert_eq!(scene(air), Ok(()));
    refused(
        "air.fluid 0 conflicts with a layer of air: fluid 0 must be the liquid, because the scene's constants refer \
         to it; add a fluid for the air, and set air.fluid to its number",
        |s| {
            air(s);
            s.air = s.air.map(|air| Air { fluid: 0, ..air });
        },
    );
    refused(
        "air conflicts with grid.structure CellLists: inactive air particles share one cell, which would need a place \
         for each of them; use grid.structure IndexSort",
        |s| {
            air(s);
            s.grid.structure = GridStructure::CellLists { places: 8 };
        },
    );
    refused(
        "air conflicts with such a small average_neighbours: the support radius must be at least 1.75 particle \
         spacings, so that air particles spawned in one step keep their distance; increase average_neighbours",
        |s| {
            air(s);
            s.average_neighbours = Some(20.0);
        },
    );
    refused("ambient_density conflicts with zero gravity: without gravity nothing is buoyant; set gravity", |s| {
        s.ambient_density = 1.2;
        s.gravity = Vec3::ZERO;
    });
    refused(
        "model.pressure_force Difference conflicts with model.wall_pressure Mirrored: a mirrored pressure does not \
         differ from the fluid's, so walls would not hold the fluid; use wall_pressure Dynamic, or another \
         pressure_force",
        |s| {
            s.model.pressure_force = PressureForce::Difference;
            let shape = WallShape::Plane { face: Face::Floor, low: Vec3::ZERO, high: Vec3::new(1.0, 0.0, 1.0) };
            s.walls = [Wall::still(shape)].into_iter().collect();
        },
    );
    refused(
        "model.initialize_hydrostatic conflicts with an ambient_density that is not below every rest_density: the \
         fluid would be buoyant and its hydrostatic profile inverted; lower ambient_density, or turn \
         initialize_hydrostatic off",
        |s| {
            (s.model.initialize_hydrostatic, s.ambient_density) = (true, 1000.0);
        },
    );
}

#[test]
fn properties_of_fluids_by_name() {
    refused(
        "fluids[0].stiffness conflicts with an equation_of_state other than Tait: it is the constant of Tait's \
         equation; omit it, or use equation_of_state Tait",
        |s| {
            s.fluids[0].stiffness = Some(1000.0);
            s.model.equation_of_state = EquationOfState::Linear;
        },
    );
    refused(
        "fluids[0].stiffness conflicts with model.pressure_solver PressureCorrection: it is unused, because pressure \
         is iterated; omit it",
        |s| {
            s.fluids[0].stiffness = Some(1000.0);
            s.model.pressure_solver = PressureSolver::PressureCorrection;
            s.model.pressure_force = PressureForce::Monaghan;
        },
    );
    refused(
        "fluids[0].equation_of_state conflicts with model.pressure_solver PressureCorrection: it is unused, because \
         pressure is iterated for all fluids; omit it",
        |s| {
            s.fluids[0].equation_of_state = Some(EquationOfState::Tait);
            s.model.pressure_solver = PressureSolver::PressureCorrection;
            s.model.pressure_force = PressureForce::Monaghan;
        },
    );
    refused(
        "fluids[1].stiffness conflicts with an equation_of_state other than Tait: it is the constant of Tait's \
         equation; omit it, or use equation_of_state Tait",
        |s| {
            s.add_fluid(Fluid {
                stiffness: Some(1000.0),
                equation_of_state: Some(EquationOfState::Linear),
                ..Fluid::default()
            })
            .expect("room for a fluid");
        },
    );
    refused(
        "model.viscosity MuellerAdapted conflicts with model.density Summation or Continuity without an adapted \
         model.pressure_force: it needs a number density; use model.density SummationAdapted, ContinuityAdapted or \
         NumberDensity, or model.pressure_force MuellerAdapted, MonaghanAdapted or DensityWeighted",
        |s| s.model.viscosity = Viscosity::MuellerAdapted,
    );
    refused(
        "fluids[0].surface_tension conflicts with model.surface_tension Off: choose a model, or set it to 0",
        |s| {
            s.fluids[0].surface_tension = 1.0;
        },
    );
    refused(
        "model.surface_tension Curvature conflicts with a model.density_kernel with a cusp at distance 0: the \
         kernel's Laplacian is infinite there; use a smooth density_kernel such as WendlandC2, or \
         model.surface_tension NormalCurvature",
        |s| {
            (s.model.surface_tension, s.model.density_kernel) = (SurfaceTension::Curvature, Kernel::Spiky);
        },
    );
    refused("elasticity conflicts with an elastic_stiffness of 0 in every fluid: it is unused; omit it", |s| {
        s.elasticity.break_at = Some(0.1);
    });
    refused("fluids[0].near_stiffness conflicts with model.near_pressure Off: it is unused; omit it", |s| {
        s.fluids[0].near_stiffness = Some(1.0);
        s.model.near_pressure = NearPressure::Off;
    });
}

#[test]
fn integrators_by_name() {
    use Integrator::*;
    let changing = |integrator: Integrator| {
        move |s: &mut Scene| (s.adaptive, s.model.integrator) = (Some(AdaptiveTimeStep::default()), integrator)
    };
    for &integrator in Integrator::ALL {
        if integrator.allows_changing_steps() {
            assert_eq!(scene(changing(integrator)), Ok(()));
        } else {
            refused(
                "adaptive conflicts with model.integrator Verlet or any variant of Beeman: their history of the last \
                 step assumes steps of equal length; use another integrator, such as ModifiedVelocityVerlet",
                changing(integrator),
            );
        }
        let again = |s: &mut Scene| (s.model.integrator, s.model.reevaluate) = (integrator, true);
        if matches!(integrator, Euler | SemiImplicitEuler) {
            refused(
                "model.reevaluate conflicts with model.integrator Euler or SemiImplicitEuler: these already evaluate \
                 forces with the velocity at the end of the step; turn reevaluate off",
                again,
            );
        } else if matches!(integrator, Clavet | PositionCorrectedBeeman) {
            refused(
                "model.reevaluate conflicts with model.integrator Clavet or PositionCorrectedBeeman: these move \
                 particles after the forces, so neighbours would have to be found again; turn reevaluate off, or use \
                 another integrator",
                again,
            );
        } else {
            assert_eq!(scene(again), Ok(()));
        }
        let corrected = |s: &mut Scene| {
            (s.model.integrator, s.model.pressure_force) = (integrator, PressureForce::Monaghan);
            s.model.pressure_solver = PressureSolver::PressureCorrection;
        };
        if matches!(integrator, ModifiedVelocityVerlet | SemiImplicitEuler) {
            assert_eq!(scene(corrected), Ok(()));
        } else {
            refused(
                "model.pressure_solver PressureCorrection conflicts with a model.integrator other than \
                 ModifiedVelocityVerlet or SemiImplicitEuler: pressure is iterated for the velocity with which these \
                 two move the particles; use one of them",
                corrected,
            );
        }
    }
    refused(
        "model.reevaluate conflicts with model.pressure_solver PressureCorrection: the pressure is iterated for the \
         forces of the first evaluation; turn reevaluate off",
        |s| {
            (s.model.reevaluate, s.model.pressure_force) = (true, PressureForce::Monaghan);
            s.model.pressure_solver = PressureSolver::PressureCorrection;
        },
    );
    let exchanges: [fn(&mut Scene); 2] =
        [|s| s.model.viscosity = Viscosity::VelocityExchange, |s| s.model.radial_exchange = 0.1];
    for exchange in exchanges {
        refused(
            "adaptive conflicts with model.viscosity VelocityExchange or a model.radial_exchange above 0: these \
             exchange a share of velocity per step, so the viscosity would change with the time step; use another \
             viscosity and set radial_exchange to 0",
            |s| {
                s.adaptive = Some(AdaptiveTimeStep::default());
                exchange(s);
            },
        );
    }
    refused("adaptive conflicts with all criteria off: set its speed, acceleration, sound or viscosity", |s| {
        let idle = AdaptiveTimeStep {
            speed: None,
            acceleration: None,
            sound: None,
            viscosity: None,
            ..AdaptiveTimeStep::default()
        };
        s.adaptive = Some(idle);
    });
}

#[test]
fn what_follows_from_a_time_step_by_name() {
    refused(
        "stiffness_for_time_step conflicts with adaptive: one derives the stiffness from the time step, the other the \
         time step from the stiffness; omit one of them",
        |s| {
            (s.stiffness_for_time_step, s.adaptive) = (Some(0.2), Some(AdaptiveTimeStep::default()));
        },
    );
    refused("stiffness_for_time_step conflicts with fluids[0].stiffness: omit one of the two", |s| {
        (s.stiffness_for_time_step, s.fluids[0].stiffness) = (Some(0.2), Some(1000.0));
    });
    refused(
        "stiffness_for_time_step conflicts with model.pressure_solver PressureCorrection: with a pressure solver the \
         speed of sound does not limit the time step; omit stiffness_for_time_step",
        |s| {
            (s.stiffness_for_time_step, s.model.pressure_force) = (Some(0.2), PressureForce::Monaghan);
            s.model.pressure_solver = PressureSolver::PressureCorrection;
        },
    );
}

#[test]
fn air_and_integrators_by_name() {
    use Integrator::*;
    for &integrator in Integrator::ALL {
        let with_air = |s: &mut Scene| {
            s.add_fluid(Fluid::default()).expect("room for a fluid");
            s.air = Some(Air { fluid: 1, capacity: 10, threshold: 0.5, minimum_density: 0.5 });
            s.model.integrator = integrator;
        };
        if matches!(integrator, Verlet | Beeman | VelocityCorrectedBeeman | PositionCorrectedBeeman) {
            refused(
                "air conflicts with model.integrator Verlet or any variant of Beeman: they need a history of the last \
                 step, which new air particles do not have; use another integrator, such as ModifiedVelocityVerlet",
                with_air,
            );
        } else {
            assert_eq!(scene(with_air), Ok(()));
        }
    }
}

#[test]
fn a_literal_iteration_that_cannot_converge() {
    let literal = |speed_of_sound: f32| {
        scene(|s| {
            s.fluids[0].speed_of_sound = speed_of_sound;
            s.model.pressure_solver = PressureSolver::PressureCorrection;
            s.model.pressure_force = PressureForce::Monaghan;
            s.model.correction.iteration = Iteration::Literal;
        })
    };
    // sound travels 1.5 spacings of 0.05 m in a step of 1 ms at 75 m/s
    assert_eq!(literal(74.9), Ok(()));
    assert!(matches!(literal(75.1), Err(SceneError::CannotConverge { most: 1.5, spacings }) if spacings > 1.5));
}

#[test]
fn every_recipe_goes_with_a_block_of_fluid() {
    for &recipe in Recipe::ALL {
        assert_eq!(scene(|s| s.model = Formulation::of(recipe)), Ok(()), "{recipe:?}");
    }
}

#[test]
fn what_the_half_stencil_cannot_do_by_name() {
    let half = |s: &mut Scene| s.grid.traversal = Traversal::HalfStencil;
    assert_eq!(scene(half), Ok(()));
    assert_eq!(
        scene(|s| {
            half(s);
            (s.model.surface_tension, s.fluids[0].surface_tension) = (SurfaceTension::Attraction, 1.0);
            s.model.near_pressure = NearPressure::DoubleDensity;
        }),
        Ok(())
    );
    let alike = "it derives the contribution of a pair to one particle from that to the other, which is not possible \
                 here; use FullStencil";
    let once = "it computes each pair once, and this needs another pass over all neighbours of a particle; use \
                FullStencil";
    let refused = |other: &str, why: &str, change: &dyn Fn(&mut Scene)| {
        refused(&format!("grid.traversal HalfStencil conflicts with {other}: {why}"), |s| {
            half(s);
            change(s);
        });
    };
    for force in [PressureForce::Canonical, PressureForce::Difference] {
        refused("model.pressure_force Canonical or Difference", alike, &|s| s.model.pressure_force = force);
    }
    refused("walls", alike, &|s| {
        let shape = WallShape::Plane { face: Face::Floor, low: Vec3::ZERO, high: Vec3::new(1.0, 0.0, 1.0) };
        s.walls = [Wall::still(shape)].into_iter().collect();
    });
    refused("model.initialize_hydrostatic and model.surface_tension Attraction or GradientSum", alike, &|s| {
        s.model.initialize_hydrostatic = true;
        (s.model.surface_tension, s.fluids[0].surface_tension) = (SurfaceTension::GradientSum, 1.0);
    });
    refused("model.variable_support", "it searches with one radius; use FullStencil", &|s| {
        s.model.variable_support = Some(SupportRange { smallest: 0.9, largest: 1.1 });
    });
    for density in [DensityForm::Continuity, DensityForm::ContinuityAdapted] {
        let why = "its density pass uses distances only, and these need velocities; use FullStencil";
        refused("model.density Continuity or ContinuityAdapted", why, &|s| s.model.density = density);
    }
    refused("model.pressure_solver PressureCorrection", once, &|s| {
        s.model.pressure_solver = PressureSolver::PressureCorrection;
        (s.model.pressure_force, s.fluids[0].speed_of_sound) = (PressureForce::Monaghan, 1.0);
    });
    for tension in [SurfaceTension::Curvature, SurfaceTension::NormalCurvature] {
        refused("model.surface_tension Curvature or NormalCurvature", once, &|s| {
            (s.model.surface_tension, s.model.density_kernel) = (tension, Kernel::WendlandC2);
        });
    }
    refused("model.surface_normals", once, &|s| s.model.surface_normals = true);
    refused("model.internal_energy", once, &|s| s.model.internal_energy = true);
    refused("model.viscosity VelocityExchange", once, &|s| s.model.viscosity = Viscosity::VelocityExchange);
    refused("model.radial_exchange", once, &|s| s.model.radial_exchange = 0.1);
    refused("model.xsph", once, &|s| s.model.xsph = 0.1);
    refused("air", once, &air);
}
