//! Drops with a layer of air, for tests of the CPU and of a device.
use super::forms::several_fluids;
use millpond_core::glam::Vec3;
use millpond_core::scene::{
    Air, Block, Container, Dimension, Face, Fluid, Grid, Periodic, PlaneModel, PressureSolver, Scene, SupportRange,
    SurfaceTension, Wall, WallShape,
};

/// Spacing, m.
pub const SPACING: f32 = 0.05;

/// Returns a moving block of water, six particles per edge, in open space, and air with a tenth of its density and the
/// same stiffness.
pub fn drop(dimension: Dimension, capacity: u32) -> Scene {
    let water = Fluid { dynamic_viscosity: 1.0, ..Fluid::default() };
    let air = Fluid { rest_density: 100.0, speed_of_sound: 31.0, dynamic_viscosity: 0.1, ..Fluid::default() };
    let block = Block {
        corner: Vec3::splat(0.3),
        size: Vec3::splat(0.3),
        velocity: Vec3::new(1.0, 0.5, 0.0),
        ..Block::default()
    };
    let mut scene = Scene::of(dimension, SPACING, 0.0002, water, block);
    scene.add_fluid(air).expect("room for a fluid");
    scene.model = several_fluids();
    scene.grid = Grid { cells: [7, 7, 5], ..Grid::default() };
    scene.air = Some(Air { fluid: 1, capacity, threshold: 0.5, minimum_density: 0.5 });
    scene
}

/// Returns the drop in 2D and in 3D.
pub fn both() -> [Scene; 2] {
    [drop(Dimension::Two, 300), drop(Dimension::Three, 1500)]
}

/// Returns scenes that combine air with other features: surface tension, walls of both kinds, a periodic domain,
/// springs, corrected pressure, and too small a capacity.
pub fn scenes(base: &Scene) -> Vec<(&'static str, Scene)> {
    let changed = |change: &dyn Fn(&mut Scene)| {
        let mut scene = base.clone();
        change(&mut scene);
        scene
    };
    let capacity = base.inactive_at_start() as u32;
    vec![
        ("a drop", changed(&|_| ())),
        ("too little air", changed(&|s| s.air = s.air.map(|air| Air { capacity: capacity / 30, ..air }))),
        ("air that vanishes", changed(&|s| s.air = s.air.map(|air| Air { minimum_density: 0.85, ..air }))),
        (
            "tension",
            changed(&|s| {
                s.model.surface_tension = SurfaceTension::NormalCurvature;
                s.fluids[0].surface_tension = 1.0;
            }),
        ),
        (
            "a floor of planes",
            changed(&|s| {
                s.gravity = Vec3::new(0.0, -9.81, 0.0);
                s.container = Some(Container {
                    model: PlaneModel::Penalty,
                    ..Container::closed([0.28, 0.29, 0.28], [0.9, 0.9, 0.9])
                });
            }),
        ),
        (
            "a tank of particles",
            changed(&|s| {
                s.gravity = Vec3::new(0.0, -9.81, 0.0);
                let open = [Face::Ceiling].into_iter().collect();
                let shape = WallShape::Box { low: Vec3::splat(0.3), high: Vec3::splat(0.7), open };
                s.walls = [Wall::still(shape)].into_iter().collect();
            }),
        ),
        (
            "a domain that wraps around",
            changed(&|s| {
                s.periodic =
                    Some(Periodic { low: Vec3::splat(0.28), high: Vec3::splat(0.88), axes: [true, true, false] });
            }),
        ),
        (
            "heat, XSPH and springs",
            changed(&|s| {
                s.model.internal_energy = true;
                (s.model.xsph, s.fluids[0].elastic_stiffness) = (0.3, 100.0);
                s.fluids[1].internal_energy = 3.0;
            }),
        ),
        (
            "corrected pressure",
            changed(&|s| {
                s.model.pressure_solver = PressureSolver::PressureCorrection;
                s.model.variable_support = Some(SupportRange { smallest: 0.8, largest: 1.2 });
                s.model.negative_pressure = false;
            }),
        ),
    ]
}
