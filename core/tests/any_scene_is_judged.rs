//! Promise: any scene, with any numbers in it, is either rejected with an error message or accepted, and the check
//! never panics. An accepted scene reports how much memory it needs. A call with the wrong number of items returns an
//! error that says so. (`tests/extremes_end_well.rs` tests that the errors name the fields.)
use millpond_core::glam::Vec3;
use millpond_core::scene::{
    AccelerationField, Air, Block, BlockShape, Container, Dimension, Elasticity, Emitter, Fluid, Formulation, Grid,
    Opening, Periodic, PlaneModel, Recipe, Scene, SupportRange, Wall, WallShape,
};
use millpond_core::{Axis, Plan, Requirements, SceneError, Solver, StepError, Storage};

/// Invalid and extreme numbers.
const HOSTILE: [f32; 10] = [f32::NAN, f32::INFINITY, f32::MIN, f32::MAX, -1.0, 0.0, 1e-45, 1e-38, 1e9, 1e30];

type Change = fn(&mut Scene, f32);

/// Changes of every number from which a length, a count or a number of iterations is derived.
const CHANGES: [Change; 20] = [
    |s, x| s.particle_spacing = x,
    |s, x| s.average_neighbours = Some(x),
    |s, x| s.fluids[0].average_neighbours = Some(x),
    |s, x| s.time_step = x,
    |s, x| s.fluids[0].rest_density = x,
    |s, x| s.fluids[0].speed_of_sound = x,
    |s, x| s.fluids[0].elastic_stiffness = x,
    |s, x| s.blocks.iter_mut().for_each(|block| block.size = Vec3::splat(x)),
    |s, x| s.blocks.iter_mut().for_each(|block| block.corner = Vec3::splat(x)),
    |s, x| s.blocks.iter_mut().for_each(|block| block.jitter = x),
    |s, _| s.blocks.iter_mut().for_each(|block| block.shape = BlockShape::Ball),
    |s, x| s.blocks.iter_mut().for_each(|block| block.fluid = x as u32),
    |s, x| s.elasticity = Elasticity { reach: x, capacity: Some(x as u32), ..s.elasticity },
    |s, x| s.periodic = Some(Periodic { low: Vec3::ZERO, high: Vec3::splat(x), axes: [true; 3] }),
    |s, x| s.model.variable_support = Some(SupportRange { smallest: 1.0, largest: x }),
    |s, x| s.acceleration_field = Some(AccelerationField { low: Vec3::ZERO, spacing: 1.0, counts: [x as u32; 3] }),
    |s, x| s.grid.cells = [x as u32; 3],
    |s, x| s.air = Some(Air { fluid: 1, capacity: x as u32, threshold: 1.0, minimum_density: 0.5 }),
    |s, x| {
        s.emitters = [Emitter::jet(Vec3::splat(x), Vec3::X, x, Opening::Circle(x))].into_iter().collect();
        s.spare_particles = x as u32;
    },
    |s, x| {
        let shape = WallShape::Box { low: Vec3::ZERO, high: Vec3::splat(x), open: [].into_iter().collect() };
        s.walls = [Wall::still(shape)].into_iter().collect();
    },
];

fn scene(dimension: Dimension) -> Scene {
    let jelly = Fluid { elastic_stiffness: 10.0, ..Fluid::default() };
    let block = Block { size: Vec3::splat(0.3), ..Block::default() };
    let mut scene = Scene::of(dimension, 0.05, 0.001, jelly, block);
    scene.model = Formulation::of(Recipe::Pirovano);
    scene.fluids.extend([Fluid::default()]);
    scene.blocks = [block, block].into_iter().collect();
    scene.container = Some(Container { model: PlaneModel::Penalty, ..Container::closed([0.0; 3], [1.0; 3]) });
    scene.model.normalize_mass = true;
    scene.grid = Grid { cells: [8; 3], ..Grid::default() };
    scene
}

/// Returns the memory that the scene needs, in bytes, or the error message.
fn judged(scene: &Scene) -> Result<usize, String> {
    let checked = scene.check().map_err(|error| error.to_string())?;
    let everything = Requirements::by_plan(&checked, &Plan::everything(&checked)).bytes();
    Ok(everything.max(Requirements::of(&checked).bytes()))
}

#[test]
fn with_any_numbers_in_it() {
    let (mut refused, mut accepted) = (0, 0);
    for dimension in [Dimension::Two, Dimension::Three] {
        for (first, second) in CHANGES.iter().flat_map(|first| CHANGES.iter().map(move |second| (first, second))) {
            for x in HOSTILE {
                let mut scene = scene(dimension);
                first(&mut scene, x);
                second(&mut scene, x);
                match judged(&scene) {
                    Ok(bytes) => accepted += usize::from(bytes > 0),
                    Err(words) => refused += usize::from(words.len() > 10),
                }
            }
        }
    }
    assert_eq!(refused + accepted, 2 * CHANGES.len() * CHANGES.len() * HOSTILE.len());
    assert!(accepted > 0 && refused > accepted, "{accepted} accepted, {refused} refused");
}

#[test]
fn errors_say_what_is_wrong() {
    let scene = scene(Dimension::Two);
    let scene = scene.check().expect("a scene");
    let mut storage: Box<Storage<100, 64>> = Storage::boxed();
    let nobody = Solver::with_particles(&scene, Plan::of(&scene), 2, [], storage.lend()).err();
    // springs need an arena, which a storage alone does not have
    assert!(matches!(nobody, Some(SceneError::CapacityExceeded { .. })), "{nobody:?}");
    let error = SceneError::WrongLength { call: "set_acceleration_field", what: "points", given: 5, expected: 8 };
    assert_eq!(error.to_string(), "`set_acceleration_field` got 5 points, expected 8");
    let error = SceneError::EmptyBlock { block: 0, axis: Axis::Z, size: 0.1 };
    assert_eq!(error.to_string(), "blocks[0].size is 0.1 m along z, but must be at least half a particle_spacing");
    let error = StepError::OutOfRange { particle: 3, axis: Axis::Y, step: 7 };
    assert_eq!(
        error.to_string(),
        "step 7: particle 3 is more than 2^22 cells away from the origin along y; the fluid may have become unstable \
         (use a smaller time_step) or fallen out of the scene"
    );
}
