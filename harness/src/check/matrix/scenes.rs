//! The scene against which choices are made, and features that several choices need to have an effect.
use millpond_core::glam::{Vec2, Vec3};
use millpond_core::scene::{
    Block, Container, Course, Dimension, Drain, Emitter, Face, Fluid, Formulation, Grid, Motion, NearPressure, Opening,
    PlaneModel, Recipe, Scene, Shape, Sliding, Solid, SolidModel, SurfaceTension, Wall, WallShape,
};

/// Returns a scene in which every choice has an effect: two blocks that collide above a floor, with gravity.
pub fn base(dimension: Dimension) -> Scene {
    let fluid = Fluid { dynamic_viscosity: 2.0, ..Fluid::default() };
    let depth = if dimension == Dimension::Three { 0.2 } else { 0.0 };
    let block =
        Block { corner: Vec3::new(0.1, 0.05, 0.1), size: Vec3::new(0.3, 0.4, depth), jitter: 0.3, ..Block::default() };
    let mut scene = Scene::of(dimension, 0.05, 0.001, fluid, block);
    scene.model = Formulation::of(Recipe::Pirovano);
    let velocity = Vec3::new(-1.0, 0.5, 0.0);
    let other = Block { corner: Vec3::new(0.42, 0.05, 0.1), size: Vec3::new(0.2, 0.3, depth), velocity, ..block };
    scene.blocks = [block, other].into_iter().collect();
    scene.gravity = Vec3::new(1.0, -9.81, 0.0);
    scene.average_neighbours = Some(if dimension == Dimension::Three { 30.0 } else { 18.0 });
    scene.grid = Grid { cells: [8, 8, 4], ..Grid::default() };
    let model = PlaneModel::Penalty;
    scene.container =
        Some(Container { slip: 0.5, restitution: 0.3, model, ..Container::closed([0.0; 3], [0.8, 0.8, 0.4]) });
    scene
}

/// Makes the first block hit the floor and the left wall at once.
pub fn falls(s: &mut Scene) {
    (s.blocks[0].corner, s.blocks[0].velocity) = (Vec3::new(0.0, 0.0, 0.1), Vec3::new(-5.0, -5.0, 0.0));
}

/// Turns the second block into another fluid, lighter and with a higher speed of sound.
pub fn second_fluid(s: &mut Scene) {
    let light = Fluid { rest_density: 700.0, speed_of_sound: 12.0, dynamic_viscosity: 5.0, ..Fluid::default() };
    s.fluids = [*s.fluid_of(0), light].into_iter().collect();
    s.blocks[1].fluid = 1;
}

/// Gives every fluid some surface tension, where the scene has a model of it.
pub fn pulled(s: &mut Scene) {
    let tension = match s.model.surface_tension {
        SurfaceTension::Off => 0.0,
        SurfaceTension::Curvature | SurfaceTension::NormalCurvature => 5.0,
        SurfaceTension::Attraction | SurfaceTension::GradientSum => 2.0,
    };
    s.fluids.iter_mut().for_each(|fluid| fluid.surface_tension = tension);
}

/// Makes the container a wall in closed form, whose floor slides along x.
pub fn closed(s: &mut Scene) {
    s.model.near_pressure = NearPressure::Off;
    if let Some(container) = &mut s.container {
        (container.model, container.dynamic_viscosity) = (PlaneModel::ClosedForm, Some(1.0));
        let velocity = Vec3::new(0.5, 0.0, 0.0);
        container.sliding = [Sliding { face: Face::Floor, velocity }].into_iter().collect();
    }
}

/// Adds an emitter beside the blocks, which makes a layer every 2.5 ms whose particles live for 3 ms, and a drain where
/// the blocks meet.
pub fn fed(s: &mut Scene) {
    let z = if s.dimension == Dimension::Three { 0.2 } else { 0.0 };
    let jet = Emitter::jet([0.12, 0.65, z], [1.0, -0.5, 0.0], 20.0, Opening::Circle(0.16));
    s.emitters = [Emitter { life: Some(0.003), ..jet }].into_iter().collect();
    s.drains = [Drain::Ball { centre: Vec3::new(0.4, 0.2, z), radius: 0.08 }].into_iter().collect();
    s.spare_particles = 60;
}

/// Adds walls of particles: a box that is open above and whose surfaces slide along x.
pub fn walls(s: &mut Scene) {
    let (low, high) = ([0.0; 3], [0.8, 0.6, 0.4]);
    let shape = WallShape::Box { low: low.into(), high: high.into(), open: [Face::Ceiling].into_iter().collect() };
    let velocity = Vec3::new(0.5, 0.0, 0.0);
    s.walls = [Wall { velocity, dynamic_viscosity: Some(1.0), ..Wall::still(shape) }].into_iter().collect();
}

/// Adds a solid of each shape around the blocks, within their reach: a ball, a capsule that comes down, a tilted box,
/// a cylinder (in 2D a polygon) that turns, all in a hollow box that rocks.
pub fn solids(s: &mut Scene, model: SolidModel) {
    let is_flat = s.dimension == Dimension::Two;
    let z = if is_flat { 0.0 } else { 0.2 };
    if model == SolidModel::ClosedForm {
        s.model.near_pressure = NearPressure::Off;
    }
    let corners = [(-0.12, -0.1), (0.12, -0.12), (0.0, 0.12)].map(Vec2::from).into_iter().collect();
    let other = if is_flat { Shape::Polygon { corners } } else { Shape::Cylinder { radius: 0.13, height: 0.2 } };
    let course = |course| Motion::Prescribed(course);
    let has_friction = matches!(model, SolidModel::ClosedForm | SolidModel::Particles);
    let viscosity = has_friction.then_some(1.5);
    let ball = Solid::still(Shape::Ball { radius: 0.14 }, [0.8, 0.25, z]);
    let capsule = Solid {
        turned: Vec3::new(0.0, 0.0, 80.0),
        motion: course(Course { velocity: Vec3::new(0.0, -8.0, 0.0), ..Course::default() }),
        ..Solid::still(Shape::Capsule { radius: 0.13, length: 0.1 }, [0.45, 0.66, z])
    };
    let below = Solid {
        turned: Vec3::new(0.0, 0.0, 20.0),
        ..Solid::still(Shape::Box { size: Vec3::new(0.3, 0.2, 0.3) }, [0.4, -0.16, z])
    };
    let turning = Solid {
        motion: course(Course { axis: Vec3::Z, turns_per_second: -3.0, ..Course::default() }),
        ..Solid::still(other, [0.82, 0.6, z])
    };
    let swing = Course {
        amplitude: Vec3::new(0.02, 0.01, 0.0),
        frequency: 20.0,
        phase: 0.25,
        axis: Vec3::Z,
        rocking_degrees: 2.0,
        ..Course::default()
    };
    let around = Solid {
        motion: course(swing),
        ..Solid::still(Shape::Box { size: Vec3::new(1.14, 1.3, 0.9) }, [0.4, 0.4, z]).hollow()
    };
    let sheet = Solid {
        turned: Vec3::new(0.0, 0.0, -10.0),
        ..Solid::still(Shape::Facet { length: 0.5, near: 0.6, far: 0.3 }, [0.4, 0.03, z])
    };
    let sheets = (!has_friction).then_some(sheet);
    s.solids = [ball, capsule, below, turning, around]
        .into_iter()
        .chain(sheets)
        .map(|solid| Solid { model, dynamic_viscosity: viscosity, restitution: 0.3, slip: 0.6, ..solid })
        .collect();
}
