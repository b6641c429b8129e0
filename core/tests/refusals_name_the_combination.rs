//! Promise: choices that do not go together are refused by name before the first step, and only those.
//!
//! The sentences stand here word for word: a host shows them to those who write scenes.
use millpond_core::SceneError;
use millpond_core::glam::Vec3;
use millpond_core::scene::{
    AdaptiveTimeStep, Air, DensityForm, EquationOfState, Evaluation, Face, Fluid, Formulation, GridStructure,
    Integrator, Iteration, Kernel, NearPressure, PressureForce, PressureSolver, Scene, SupportRange, SurfaceTension,
    Traversal, Viscosity, Wall, WallShape,
};

#[path = "support/judged.rs"]
mod judged;
use judged::judged as scene;

/// Asserts that it is refused by this sentence.
fn refused(sentence: &str, change: impl FnOnce(&mut Scene)) {
    let told = scene(change).expect_err(sentence);
    assert!(matches!(told, SceneError::NotTogether { .. }), "{told:?}");
    assert_eq!(told.to_string(), sentence);
}

/// A second fluid that makes a coat of air.
fn air(s: &mut Scene) {
    let _ = s.fluids.push(Fluid::default());
    s.air = Some(Air { fluid: 1, capacity: 10, threshold: 0.5, minimum_density: 0.5 });
}

#[test]
fn formulas_by_name() {
    assert_eq!(scene(|_| ()), Ok(()));
    refused(
        "model.density_kernel Viscosity does not go with any density: its value at no distance, and so a \
         particle's own share, is infinite",
        |s| s.model.density_kernel = Kernel::Viscosity,
    );
    refused(
        "model.variable_support does not go with model.evaluation from tables: a table is made for one \
         support (Pirovano, section 4.2.3)",
        |s| {
            s.model.evaluation = Evaluation::Table;
            s.model.variable_support = Some(SupportRange { smallest: 0.9, largest: 1.1 });
        },
    );
    refused(
        "model.evaluation from tables does not go with a kernel whose slope or Laplacian is infinite at \
         no distance: no table ends there",
        |s| {
            (s.model.evaluation, s.model.viscosity) = (Evaluation::SquaredTable, Viscosity::Morris);
        },
    );
    refused(
        "model.evaluation from tables does not go with a kernel whose slope or Laplacian is infinite at \
         no distance: no table ends there",
        |s| {
            (s.model.evaluation, s.model.viscosity_kernel) = (Evaluation::Table, Kernel::Spiky);
        },
    );
    refused(
        "model.pressure_force NumberDensity does not go with a model.density other than NumberDensity: it \
         is the gradient on that density",
        |s| s.model.pressure_force = PressureForce::NumberDensity,
    );
    refused(
        "model.pressure_solver PressureCorrection does not go with a canonical model.pressure_force, \
         one of Mueller's or one on Gourlay's number density: its iteration takes the whole gradient (Pirovano, \
         section 3.2.2)",
        |s| {
            s.model.pressure_solver = PressureSolver::PressureCorrection;
        },
    );
    refused(
        "model.internal_energy does not go with a canonical or difference model.pressure_force: its pairs \
         do not act on each other alike, so their work is nobody's",
        |s| {
            (s.model.internal_energy, s.model.pressure_force) = (true, PressureForce::Difference);
        },
    );
}

#[test]
fn starts_and_surroundings_by_name() {
    refused(
        "model.initialize_hydrostatic does not go with an equation_of_state IdealGas: a gas has no surface to \
         measure depth from",
        |s| {
            (s.model.initialize_hydrostatic, s.model.equation_of_state) = (true, EquationOfState::IdealGas);
        },
    );
    refused(
        "model.initialize_hydrostatic does not go with model.density NumberDensity: masses that differ change \
         no number",
        |s| {
            (s.model.initialize_hydrostatic, s.model.density) = (true, DensityForm::NumberDensity);
        },
    );
    refused("model.initialize_hydrostatic does not go with no gravity: there is no weight to hold", |s| {
        s.model.initialize_hydrostatic = true;
        s.gravity = Vec3::ZERO;
    });
    assert_eq!(scene(air), Ok(()));
    refused(
        "air.fluid 0 does not go with a coat of air: the first fluid is the liquid: a scene's constants \
         are of it",
        |s| {
            air(s);
            s.air = s.air.map(|air| Air { fluid: 0, ..air });
        },
    );
    refused(
        "air does not go with a grid.structure CellLists: all air that is not there lies in one cell, \
         which would need a place for each",
        |s| {
            air(s);
            s.grid.structure = GridStructure::CellLists { places: 8 };
        },
    );
    refused(
        "air does not go with so few average_neighbours: a support must reach 1.75 spacings, so that two \
         that are made never meet",
        |s| {
            air(s);
            s.average_neighbours = 20.0;
        },
    );
    refused("ambient_density does not go with no gravity: nothing would be buoyant", |s| {
        s.ambient_density = 1.2;
        s.gravity = Vec3::ZERO;
    });
    refused(
        "model.pressure_force Difference does not go with model.wall_pressure Mirrored: a mirrored \
         pressure makes no difference, so nothing would hold the fluid",
        |s| {
            s.model.pressure_force = PressureForce::Difference;
            let shape = WallShape::Plane { face: Face::Floor, low: Vec3::ZERO, high: Vec3::new(1.0, 0.0, 1.0) };
            s.walls = [Wall::still(shape)].into_iter().collect();
        },
    );
    refused(
        "model.initialize_hydrostatic does not go with an ambient_density as large as the fluid's: its surface \
         would be at the other end",
        |s| {
            (s.model.initialize_hydrostatic, s.ambient_density) = (true, 1000.0);
        },
    );
}

#[test]
fn properties_of_fluids_by_name() {
    refused(
        "fluids[0].stiffness does not go with an equation_of_state other than Tait: it is the constant of \
         that equation",
        |s| {
            s.fluids[0].stiffness = Some(1000.0);
            s.model.equation_of_state = EquationOfState::Linear;
        },
    );
    refused(
        "fluids[0].stiffness does not go with model.pressure_solver PressureCorrection: nothing would use it",
        |s| {
            s.fluids[0].stiffness = Some(1000.0);
            s.model.pressure_solver = PressureSolver::PressureCorrection;
            s.model.pressure_force = PressureForce::Monaghan;
        },
    );
    refused(
        "fluids[0].equation_of_state does not go with model.pressure_solver PressureCorrection: pressure is \
         iterated for all fluids, so that nothing would use it",
        |s| {
            s.fluids[0].equation_of_state = Some(EquationOfState::Tait);
            s.model.pressure_solver = PressureSolver::PressureCorrection;
            s.model.pressure_force = PressureForce::Monaghan;
        },
    );
    refused(
        "fluids[1].stiffness does not go with an equation_of_state other than Tait: it is the constant of \
         that equation",
        |s| {
            let _ = s.fluids.push(Fluid {
                stiffness: Some(1000.0),
                equation_of_state: Some(EquationOfState::Linear),
                ..Fluid::default()
            });
        },
    );
    refused(
        "model.viscosity MuellerAdapted does not go with a model.density and a model.pressure_force that \
         are not adapted: no number density is there for it",
        |s| s.model.viscosity = Viscosity::MuellerAdapted,
    );
    refused("fluids[0].surface_tension does not go with model.surface_tension Off: nothing would use it", |s| {
        s.fluids[0].surface_tension = 1.0;
    });
    refused(
        "model.surface_tension Curvature does not go with a model.density_kernel with an edge at no \
         distance: its Laplacian is infinite there",
        |s| {
            (s.model.surface_tension, s.model.density_kernel) = (SurfaceTension::Curvature, Kernel::Spiky);
        },
    );
    refused("elasticity does not go with an elastic_stiffness of 0 in every fluid: nothing would use it", |s| {
        s.elasticity.break_at = Some(0.1);
    });
    refused("fluids[0].near_stiffness does not go with model.near_pressure Off: nothing would use it", |s| {
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
                "adaptive does not go with a model.integrator Verlet or one of Beeman's: what it remembers of the \
         step before is of a step of the same length",
                changing(integrator),
            );
        }
        let again = |s: &mut Scene| (s.model.integrator, s.model.reevaluate) = (integrator, true);
        if matches!(integrator, Euler | SemiImplicitEuler) {
            refused(
                "model.reevaluate does not go with one of Euler's for model.integrator: forces are evaluated with \
         the velocity at the end of the step already",
                again,
            );
        } else if matches!(integrator, Clavet | PositionCorrectedBeeman) {
            refused(
                "model.reevaluate does not go with a model.integrator Clavet or PositionCorrectedBeeman: it moves \
         particles after the forces, so that neighbours would have to be found again",
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
                "model.pressure_solver PressureCorrection does not go with a model.integrator other than \
         ModifiedVelocityVerlet or SemiImplicitEuler: pressure is iterated for the velocity that these \
         drift with",
                corrected,
            );
        }
    }
    refused(
        "model.reevaluate does not go with model.pressure_solver PressureCorrection: the pressure was \
         iterated for the forces without it",
        |s| {
            (s.model.reevaluate, s.model.pressure_force) = (true, PressureForce::Monaghan);
            s.model.pressure_solver = PressureSolver::PressureCorrection;
        },
    );
    let exchanges: [fn(&mut Scene); 2] =
        [|s| s.model.viscosity = Viscosity::VelocityExchange, |s| s.model.radial_exchange = 0.1];
    for exchange in exchanges {
        refused(
            "adaptive does not go with exchanges of velocity: their shares are of a step, so that with its \
         length the viscosity would change",
            |s| {
                s.adaptive = Some(AdaptiveTimeStep::default());
                exchange(s);
            },
        );
    }
    refused("adaptive does not go with no criterion: there is nothing for the time step to follow", |s| {
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
        "stiffness_for_time_step does not go with adaptive: either the stiffness follows from the time \
         step or the time step from the stiffness",
        |s| {
            (s.stiffness_for_time_step, s.adaptive) = (Some(0.2), Some(AdaptiveTimeStep::default()));
        },
    );
    refused("stiffness_for_time_step does not go with fluids[0].stiffness: it already says how stiff", |s| {
        (s.stiffness_for_time_step, s.fluids[0].stiffness) = (Some(0.2), Some(1000.0));
    });
    refused(
        "stiffness_for_time_step does not go with model.pressure_solver PressureCorrection: sound that \
         is iterated for does not limit the time step",
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
            let _ = s.fluids.push(Fluid::default());
            s.air = Some(Air { fluid: 1, capacity: 10, threshold: 0.5, minimum_density: 0.5 });
            s.model.integrator = integrator;
        };
        if matches!(integrator, Verlet | Beeman | VelocityCorrectedBeeman | PositionCorrectedBeeman) {
            refused(
                "air does not go with a model.integrator Verlet or one of Beeman's: air that has just been made \
         has no step before to remember",
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
    // 1.5 spacings of 0.05 m in 1 ms are 75 m/s
    assert_eq!(literal(74.9), Ok(()));
    assert!(matches!(literal(75.1), Err(SceneError::CannotConverge { most: 1.5, spacings }) if spacings > 1.5));
}

#[test]
fn the_modern_choice_is_one() {
    assert_eq!(scene(|s| s.model = Formulation::modern()), Ok(()));
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
    let alike = "it takes what a pair adds to one particle from what it adds to the other, which here differ";
    let once = "it computes each pair once, and this takes another look at all of a particle's neighbours";
    let refused = |other: &str, why: &str, change: &dyn Fn(&mut Scene)| {
        refused(&format!("grid.traversal HalfStencil does not go with {other}: {why}"), |s| {
            half(s);
            change(s);
        });
    };
    for force in [PressureForce::Canonical, PressureForce::Difference] {
        refused("a canonical or difference model.pressure_force", alike, &|s| s.model.pressure_force = force);
    }
    refused("walls of particles", alike, &|s| {
        let shape = WallShape::Plane { face: Face::Floor, low: Vec3::ZERO, high: Vec3::new(1.0, 0.0, 1.0) };
        s.walls = [Wall::still(shape)].into_iter().collect();
    });
    refused("model.initialize_hydrostatic and a model.surface_tension between pairs", alike, &|s| {
        s.model.initialize_hydrostatic = true;
        (s.model.surface_tension, s.fluids[0].surface_tension) = (SurfaceTension::GradientSum, 1.0);
    });
    refused("model.variable_support", "it searches by one support for all", &|s| {
        s.model.variable_support = Some(SupportRange { smallest: 0.9, largest: 1.1 });
    });
    for density in [DensityForm::Continuity, DensityForm::ContinuityAdapted] {
        let why = "it sums what follows from distances, and this needs velocities";
        refused("a model.density that is stepped", why, &|s| s.model.density = density);
    }
    refused("model.pressure_solver PressureCorrection", once, &|s| {
        s.model.pressure_solver = PressureSolver::PressureCorrection;
        (s.model.pressure_force, s.fluids[0].speed_of_sound) = (PressureForce::Monaghan, 1.0);
    });
    for tension in [SurfaceTension::Curvature, SurfaceTension::NormalCurvature] {
        refused("a model.surface_tension by curvature", once, &|s| {
            (s.model.surface_tension, s.model.density_kernel) = (tension, Kernel::WendlandC2);
        });
    }
    refused("model.surface_normals", once, &|s| s.model.surface_normals = true);
    refused("model.internal_energy", once, &|s| s.model.internal_energy = true);
    refused("model.viscosity Exchange", once, &|s| s.model.viscosity = Viscosity::VelocityExchange);
    refused("model.radial_exchange", once, &|s| s.model.radial_exchange = 0.1);
    refused("model.xsph", once, &|s| s.model.xsph = 0.1);
    refused("air", once, &air);
}
