//! Promise: choices that do not go together are refused by name before the first step, and only those.
use millpond_core::scene::{
    Adaptive, Air, Block, Correction, DensityForm, Dimension, EquationOfState, Evaluation, Face, FieldLattice, Fluid,
    GridStructure, Integrator, Iteration, Kernel, ModelChoice, NearPressure, Periodic, Plasticity, PressureForce,
    Scene, SupportRange, SurfaceTension, Viscosity, Wall, WallShape,
};
use millpond_core::{Axis, SceneError, Solver};

fn scene(change: impl FnOnce(&mut Scene)) -> Result<(), SceneError> {
    let block = Block { size: [0.4, 0.4, 0.4], ..Block::default() };
    let mut scene = Scene::of(Dimension::Three, 0.05, 0.001, Fluid::default(), block);
    scene.gravity = [0.0, -9.81, 0.0];
    change(&mut scene);
    scene.check().map(|_| ())
}

/// Asserts that the two are refused, named so.
fn refused(choice: &str, other: &str, change: impl FnOnce(&mut Scene)) {
    match scene(change) {
        Err(SceneError::NotTogether { choice: a, other: b, why }) => {
            assert!(a.contains(choice) && b.contains(other) && why.len() > 10, "{a} and {b}: {why}");
        }
        result => panic!("{choice} and {other}: {result:?}"),
    }
}

#[test]
fn by_name() {
    assert_eq!(scene(|_| ()), Ok(()));
    refused("density_kernel Viscosity", "density", |s| s.model.density_kernel = Kernel::Viscosity);
    refused("variable_support", "tables", |s| {
        s.model.evaluation = Evaluation::Table;
        s.model.variable_support = Some(SupportRange { smallest: 0.9, largest: 1.1 });
    });
    refused("tables", "infinite", |s| {
        (s.model.evaluation, s.model.viscosity) = (Evaluation::SquaredTable, Viscosity::Morris);
    });
    refused("tables", "infinite", |s| {
        (s.model.evaluation, s.model.viscosity_kernel) = (Evaluation::Table, Kernel::Spiky);
    });
    refused("pressure_force NumberDensity", "density", |s| s.model.pressure_force = PressureForce::NumberDensity);
    refused("PressureCorrection", "pressure_force", |s| {
        s.model.equation_of_state = EquationOfState::PressureCorrection;
    });
    refused("thermal_energy", "pressure_force", |s| {
        (s.model.thermal_energy, s.model.pressure_force) = (true, PressureForce::Difference);
    });
    refused("hydrostatic_start", "IdealGas", |s| {
        (s.model.hydrostatic_start, s.model.equation_of_state) = (true, EquationOfState::IdealGas);
    });
    refused("hydrostatic_start", "NumberDensity", |s| {
        (s.model.hydrostatic_start, s.model.density) = (true, DensityForm::NumberDensity);
    });
    refused("hydrostatic_start", "gravity", |s| {
        s.model.hydrostatic_start = true;
        s.gravity = [0.0; 3];
    });
    let air = |s: &mut Scene| {
        let _ = s.other_fluids.push(Fluid::default());
        s.air = Some(Air { fluid: 1, capacity: 10, threshold: 0.5, minimum_density: 0.5 });
    };
    assert_eq!(scene(air), Ok(()));
    refused("air.fluid 0", "air", |s| {
        air(s);
        s.air = s.air.map(|air| Air { fluid: 0, ..air });
    });
    refused("air", "CellLists", |s| {
        air(s);
        s.grid.structure = GridStructure::CellLists { places: 8 };
    });
    refused("air", "average_neighbours", |s| {
        air(s);
        s.average_neighbours = 20.0;
    });
    refused("ambient_density", "gravity", |s| {
        s.ambient_density = 1.2;
        s.gravity = [0.0; 3];
    });
    refused("pressure_force Difference", "Mirrored", |s| {
        s.model.pressure_force = PressureForce::Difference;
        let shape = WallShape::Plane { face: Face::Floor, low: [0.0; 3], high: [1.0, 0.0, 1.0] };
        s.walls = [Wall::still(shape)].into_iter().collect();
    });
    refused("hydrostatic_start", "ambient", |s| {
        (s.model.hydrostatic_start, s.ambient_density) = (true, 1000.0);
    });
    refused("fluid.stiffness", "Tait", |s| {
        s.fluid.stiffness = Some(1000.0);
        s.model.equation_of_state = EquationOfState::Desbrun;
    });
    refused("equation_of_state", "PressureCorrection", |s| {
        s.fluid.equation_of_state = Some(EquationOfState::PressureCorrection);
        s.model.pressure_force = PressureForce::Monaghan;
    });
    refused("other_fluids.alpha", "first", |s| {
        let _ = s.other_fluids.push(Fluid { alpha: 0.5, ..Fluid::default() });
    });
    refused("viscosity MuellerAdapted", "not adapted", |s| s.model.viscosity = Viscosity::MuellerAdapted);
    refused("surface_tension", "Off", |s| s.fluid.surface_tension = 1.0);
    refused("surface_tension Curvature", "edge", |s| {
        (s.model.surface_tension, s.model.density_kernel) = (SurfaceTension::Curvature, Kernel::Spiky);
    });
    refused("elasticity", "elastic_stiffness", |s| s.elasticity.break_at = Some(0.1));
    refused("near_stiffness", "Off", |s| {
        s.fluid.near_stiffness = Some(1.0);
        s.model.near_pressure = NearPressure::Off;
    });
}

#[test]
fn integrators_by_name() {
    use Integrator::*;
    let changing = |integrator: Integrator| {
        move |s: &mut Scene| (s.adaptive, s.model.integrator) = (Some(Adaptive::default()), integrator)
    };
    for &integrator in Integrator::ALL {
        if integrator.allows_changing_steps() {
            assert_eq!(scene(changing(integrator)), Ok(()));
        } else {
            refused("adaptive", "integrator", changing(integrator));
        }
        let again = |s: &mut Scene| (s.model.integrator, s.model.reevaluate) = (integrator, true);
        if matches!(integrator, Euler | SemiImplicitEuler | Clavet | PositionCorrectedBeeman) {
            refused("reevaluate", "integrator", again);
        } else {
            assert_eq!(scene(again), Ok(()));
        }
        let corrected = |s: &mut Scene| {
            (s.model.integrator, s.model.pressure_force) = (integrator, PressureForce::Monaghan);
            s.model.equation_of_state = EquationOfState::PressureCorrection;
        };
        if matches!(integrator, ModifiedVelocityVerlet | SemiImplicitEuler) {
            assert_eq!(scene(corrected), Ok(()));
        } else {
            refused("PressureCorrection", "integrator", corrected);
        }
    }
    refused("reevaluate", "PressureCorrection", |s| {
        (s.model.reevaluate, s.model.pressure_force) = (true, PressureForce::Monaghan);
        s.model.equation_of_state = EquationOfState::PressureCorrection;
    });
    let exchanges: [fn(&mut Scene); 2] =
        [|s| s.model.viscosity = Viscosity::Exchange, |s| s.fluid.radial_exchange = 0.1];
    for exchange in exchanges {
        refused("adaptive", "exchanges", |s| {
            s.adaptive = Some(Adaptive::default());
            exchange(s);
        });
    }
    refused("adaptive", "no criterion", |s| {
        let idle = Adaptive { speed: None, acceleration: None, sound: None, viscosity: None, ..Adaptive::default() };
        s.adaptive = Some(idle);
    });
    refused("stiffness_for_time_step", "adaptive", |s| {
        (s.stiffness_for_time_step, s.adaptive) = (Some(0.2), Some(Adaptive::default()));
    });
    refused("stiffness_for_time_step", "fluid.stiffness", |s| {
        (s.stiffness_for_time_step, s.fluid.stiffness) = (Some(0.2), Some(1000.0));
    });
    refused("stiffness_for_time_step", "PressureCorrection", |s| {
        (s.stiffness_for_time_step, s.model.pressure_force) = (Some(0.2), PressureForce::Monaghan);
        s.model.equation_of_state = EquationOfState::PressureCorrection;
    });
    for &integrator in Integrator::ALL {
        let with_air = |s: &mut Scene| {
            let _ = s.other_fluids.push(Fluid::default());
            s.air = Some(Air { fluid: 1, capacity: 10, threshold: 0.5, minimum_density: 0.5 });
            s.model.integrator = integrator;
        };
        if matches!(integrator, Verlet | Beeman | VelocityCorrectedBeeman | PositionCorrectedBeeman) {
            refused("air", "integrator", with_air);
        } else {
            assert_eq!(scene(with_air), Ok(()));
        }
    }
}

#[test]
fn a_literal_iteration_that_cannot_converge() {
    let literal = |speed_of_sound: f32| {
        scene(|s| {
            s.fluid.speed_of_sound = speed_of_sound;
            s.model.equation_of_state = EquationOfState::PressureCorrection;
            s.model.pressure_force = PressureForce::Monaghan;
            s.model.correction.iteration = Iteration::Literal;
        })
    };
    // 1.5 spacings of 0.05 m in 1 ms are 75 m/s
    assert_eq!(literal(74.9), Ok(()));
    assert!(matches!(literal(75.1), Err(SceneError::CannotConverge { most: 1.5, spacings }) if spacings > 1.5));
}

#[test]
fn bounds() {
    for (smallest, largest, field) in [(0.4, 1.1, "smallest"), (0.9, 2.5, "largest"), (f32::NAN, 1.1, "smallest")] {
        let result = scene(|s| s.model.variable_support = Some(SupportRange { smallest, largest }));
        assert!(matches!(result, Err(SceneError::OutOfBounds { field: f, .. }) if f.ends_with(field)), "{result:?}");
    }
    for iterations in [0, Correction::MOST + 1] {
        let result = scene(|s| s.model.correction.iterations = iterations);
        let (field, value) = ("model.correction.iterations", iterations as f32);
        assert_eq!(result, Err(SceneError::OutOfBounds { field, value, least: 1.0, most: 200.0 }));
    }
    let result = scene(|s| s.fluid.elastic_stiffness = 1e38);
    assert_eq!(result, Err(SceneError::OutOfScale { field: "fluid.elastic_stiffness", value: 1e38 }));
    let result = scene(|s| s.blocks[0].fluid = 1);
    assert_eq!(result, Err(SceneError::NoSuchFluid { field: "blocks.fluid", fluid: 1, fluids: 1 }));
    let result = scene(|s| {
        let _ = s.other_fluids.push(Fluid { rest_density: -1.0, ..Fluid::default() });
    });
    assert_eq!(result, Err(SceneError::NotPositive { field: "other_fluids.rest_density", value: -1.0 }));
    let plasticity = Some(Plasticity { rate: 2000.0, yield_strain: 0.1 });
    let result = scene(|s| (s.fluid.elastic_stiffness, s.elasticity.plasticity) = (10.0, plasticity));
    assert!(matches!(result, Err(SceneError::OutOfBounds { field: "elasticity.plasticity.rate", .. })), "{result:?}");
    let result = scene(|s| s.field = Some(FieldLattice { low: [0.0; 3], spacing: 0.1, counts: [4, 1, 4] }));
    assert_eq!(result, Err(SceneError::TooFewNodes { axis: Axis::Y, nodes: 1 }));
    let axes = [false, true, false];
    let result = scene(|s| s.periodic = Some(Periodic { low: [0.0; 3], high: [1.0, 0.0, 1.0], axes }));
    assert_eq!(result, Err(SceneError::EmptyDomain { axis: Axis::Y, low: 0.0, high: 0.0 }));
    let result = scene(|s| {
        s.blocks[0].size[1] = 0.2;
        s.periodic = Some(Periodic { low: [0.0; 3], high: [1.0, 0.2, 1.0], axes });
    });
    assert_eq!(result, Err(SceneError::TooFewCells { axis: Axis::Y, cells: 2 }));
    let result = scene(|s| {
        (s.blocks[0].size[1], s.average_neighbours) = (0.5, 8.0);
        s.periodic = Some(Periodic { low: [0.0; 3], high: [0.0, 0.4, 0.0], axes });
    });
    let by = 0.5f32 - 0.4;
    assert_eq!(result, Err(SceneError::LapsItself { what: "blocks", index: 0, axis: Axis::Y, by }));
    let plane = |face, high: [f32; 3]| Wall::still(WallShape::Plane { face, low: [0.0; 3], high });
    let result = scene(|s| s.walls = [plane(Face::Floor, [1.0, 0.5, 1.0])].into_iter().collect());
    assert_eq!(result, Err(SceneError::WallExtent { wall: 0, axis: Axis::Y, size: 0.5 }));
    let result = scene(|s| s.walls = [plane(Face::Floor, [1e30, 0.0, 1.0])].into_iter().collect());
    assert!(matches!(result, Err(SceneError::WallExtent { wall: 0, axis: Axis::X, .. })), "{result:?}");
    let advancing = Wall { velocity: [1.0, -2.0, 0.0], ..plane(Face::Floor, [1.0, 0.0, 1.0]) };
    let result = scene(|s| s.walls = [advancing].into_iter().collect());
    assert_eq!(result, Err(SceneError::WallAdvances { wall: 0, axis: Axis::Y, velocity: -2.0 }));
    assert_eq!(scene(|s| s.walls = [plane(Face::Floor, [1.0, 0.0, 1.0])].into_iter().collect()), Ok(()));
}

#[test]
fn the_modern_choice_is_one() {
    assert_eq!(scene(|s| s.model = ModelChoice::modern()), Ok(()));
}

#[test]
fn springs_that_do_not_fit() {
    let block = Block { size: [0.2, 0.1, 0.0], ..Block::default() };
    let jelly = Fluid { elastic_stiffness: 10.0, ..Fluid::default() };
    let mut scene = Scene::of(Dimension::Two, 0.05, 0.001, jelly, block);
    let solver = |scene: &Scene| {
        let mut heap = millpond_core::OwnedMemory::of(&scene.check()?);
        Solver::new(scene, heap.lend()).map(|solver| solver.springs().count())
    };
    // 4 x 2 particles: 4 + 6 along the sides of the squares, 6 across them
    assert_eq!(solver(&scene), Ok(16));
    scene.elasticity.capacity = Some(15);
    let refused = SceneError::CapacityExceeded { what: "springs (elasticity.capacity)", needed: 16, capacity: 15 };
    assert_eq!(solver(&scene), Err(refused));
}
