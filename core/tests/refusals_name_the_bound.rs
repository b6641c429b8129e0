//! Promise: a number out of bounds is rejected with an error that names the field, its value and the bound; a number
//! within its bounds is accepted.
use millpond_core::glam::Vec3;
use millpond_core::scene::{
    AccelerationField, Block, Correction, Dimension, Face, Fluid, Formulation, Periodic, Plasticity, Recipe, Scene,
    SupportRange, Wall, WallShape,
};
use millpond_core::{Axis, Field, SceneError, Solver};

#[path = "support/judged.rs"]
mod judged;
use judged::judged as scene;

#[test]
fn numbers_out_of_bounds() {
    for (smallest, largest, field) in [(0.4, 1.1, "smallest"), (0.9, 2.5, "largest"), (f32::NAN, 1.1, "smallest")] {
        let result = scene(|s| s.model.variable_support = Some(SupportRange { smallest, largest }));
        assert!(
            matches!(result, Err(SceneError::OutOfBounds { field: f, .. }) if f.to_string().ends_with(field)),
            "{result:?}"
        );
    }
    for iterations in [0, Correction::MOST + 1] {
        let result = scene(|s| s.model.correction.iterations = iterations);
        let (field, value) = ("model.correction.iterations", iterations as f32);
        assert_eq!(result, Err(SceneError::OutOfBounds { field: field.into(), value, least: 1.0, most: 200.0 }));
    }
    let result = scene(|s| s.fluids[0].elastic_stiffness = 1e38);
    assert_eq!(
        result,
        Err(SceneError::OutOfScale { field: Field::of_item("fluids.elastic_stiffness", 0), value: 1e38 })
    );
    let result = scene(|s| s.blocks[0].fluid = 1);
    assert_eq!(result, Err(SceneError::NoSuchFluid { field: Field::of_item("blocks.fluid", 0), fluid: 1, fluids: 1 }));
    let result = scene(|s| {
        s.add_fluid(Fluid { rest_density: -1.0, ..Fluid::default() }).expect("room for a fluid");
    });
    assert_eq!(result, Err(SceneError::NotPositive { field: Field::of_item("fluids.rest_density", 1), value: -1.0 }));
    let plasticity = Some(Plasticity { rate: 2000.0, yield_strain: 0.1 });
    let result = scene(|s| (s.fluids[0].elastic_stiffness, s.elasticity.plasticity) = (10.0, plasticity));
    assert!(
        matches!(result, Err(SceneError::OutOfBounds { field, .. }) if field == "elasticity.plasticity.rate"),
        "{result:?}"
    );
    let result =
        scene(|s| s.acceleration_field = Some(AccelerationField { low: Vec3::ZERO, spacing: 0.1, counts: [4, 1, 4] }));
    assert_eq!(result, Err(SceneError::TooFewPoints { axis: Axis::Y, points: 1 }));
    let axes = [false, true, false];
    let result = scene(|s| s.periodic = Some(Periodic { low: Vec3::ZERO, high: Vec3::new(1.0, 0.0, 1.0), axes }));
    assert_eq!(result, Err(SceneError::EmptyDomain { axis: Axis::Y, low: 0.0, high: 0.0 }));
    let result = scene(|s| {
        s.blocks[0].size[1] = 0.2;
        s.periodic = Some(Periodic { low: Vec3::ZERO, high: Vec3::new(1.0, 0.2, 1.0), axes });
    });
    assert_eq!(result, Err(SceneError::TooFewCells { axis: Axis::Y, cells: 2 }));
    let result = scene(|s| {
        (s.blocks[0].size[1], s.average_neighbours) = (0.5, Some(8.0));
        s.periodic = Some(Periodic { low: Vec3::ZERO, high: Vec3::new(0.0, 0.4, 0.0), axes });
    });
    let by = 0.5f32 - 0.4;
    assert_eq!(result, Err(SceneError::LapsItself { what: "blocks", index: 0, axis: Axis::Y, by }));
    let plane = |face, high: [f32; 3]| Wall::still(WallShape::Plane { face, low: Vec3::ZERO, high: high.into() });
    let result = scene(|s| s.walls = [plane(Face::Floor, [1.0, 0.5, 1.0])].into_iter().collect());
    assert_eq!(result, Err(SceneError::WallExtent { wall: 0, axis: Axis::Y, size: 0.5 }));
    let result = scene(|s| s.walls = [plane(Face::Floor, [1e30, 0.0, 1.0])].into_iter().collect());
    assert!(matches!(result, Err(SceneError::WallExtent { wall: 0, axis: Axis::X, .. })), "{result:?}");
    let advancing = Wall { velocity: Vec3::new(1.0, -2.0, 0.0), ..plane(Face::Floor, [1.0, 0.0, 1.0]) };
    let result = scene(|s| s.walls = [advancing].into_iter().collect());
    assert_eq!(result, Err(SceneError::WallAdvances { wall: 0, axis: Axis::Y, velocity: -2.0 }));
    assert_eq!(scene(|s| s.walls = [plane(Face::Floor, [1.0, 0.0, 1.0])].into_iter().collect()), Ok(()));
}

#[test]
fn springs_that_do_not_fit() {
    let block = Block { size: Vec3::new(0.2, 0.1, 0.0), ..Block::default() };
    let jelly = Fluid { elastic_stiffness: 10.0, ..Fluid::default() };
    let mut scene = Scene::of(Dimension::Two, 0.05, 0.001, jelly, block);
    scene.model = Formulation::of(Recipe::Pirovano);
    let solver = |scene: &Scene| {
        let mut heap = millpond_core::OwnedMemory::of(&scene.check()?);
        Solver::new(scene, heap.lend()).map(|solver| solver.springs().count())
    };
    // 4 x 2 particles have 4 + 6 springs along the edges of the squares and 6 along their diagonals
    assert_eq!(solver(&scene), Ok(16));
    scene.elasticity.capacity = Some(15);
    let refused = SceneError::CapacityExceeded { what: "springs (elasticity.capacity)", needed: 16, capacity: 15 };
    assert_eq!(solver(&scene), Err(refused));
}
