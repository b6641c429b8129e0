//! Every number of a scene set to an invalid or extreme value: NaN, infinite or 1e30.
use super::settings::CELLS;
use super::{Case, End, Measure, built_in};
use crate::failure::Failure;
use glam::Vec3;
use millpond_core::scene::{
    AccelerationField, AdaptiveTimeStep, Air, Container, Course, Drain, Emitter, Face, Fluid, Formulation,
    GridStructure, Motion, NearPressure, Opening, Periodic, PlaneModel, Plasticity, Scene, Shape, Shifting, Sliding,
    Solid, SolidModel, SupportRange, SurfaceTension, Wall, WallShape, Wind,
};

/// Number of particles of a case, and number of steps if it starts.
const PARTICLES: u64 = 50;
const STEPS: u32 = 3;

/// Returns a number of a scene. The part of the scene that it belongs to is added if it is missing.
type Number = fn(&mut Scene) -> Option<&mut f32>;

/// The numbers, by the names that errors give them. Where two numbers share a name, this is the one that is checked
/// first.
const NUMBERS: &[(&str, Number)] = &[
    ("particle_spacing", |s| Some(&mut s.particle_spacing)),
    ("average_neighbours", |s| Some(s.average_neighbours.get_or_insert(32.0))),
    ("time_step", |s| Some(&mut s.time_step)),
    ("gravity", |s| s.gravity.as_mut().get_mut(1)),
    ("ambient_density", |s| Some(&mut s.ambient_density)),
    ("wind.velocity", |s| wind(s).velocity.as_mut().first_mut()),
    ("wind.drag", |s| Some(&mut wind(s).drag)),
    ("acceleration_field.low", |s| field(s).low.as_mut().first_mut()),
    ("acceleration_field.spacing", |s| Some(&mut field(s).spacing)),
    ("fluids[0].rest_density", |s| Some(&mut s.fluids[0].rest_density)),
    ("fluids[0].speed_of_sound", |s| Some(&mut s.fluids[0].speed_of_sound)),
    ("fluids[0].average_neighbours", |s| Some(s.fluids[0].average_neighbours.get_or_insert(20.0))),
    ("fluids[0].stiffness", |s| Some(s.fluids[0].stiffness.get_or_insert(1000.0))),
    ("fluids[0].dynamic_viscosity", |s| Some(&mut s.fluids[0].dynamic_viscosity)),
    ("fluids[0].surface_tension", |s| Some(&mut pulled(s).surface_tension)),
    ("fluids[0].elastic_stiffness", |s| Some(&mut s.fluids[0].elastic_stiffness)),
    ("model.alpha", |s| Some(&mut s.model.alpha)),
    ("model.beta", |s| Some(&mut s.model.beta)),
    ("model.velocity_exchange", |s| Some(&mut s.model.velocity_exchange)),
    ("model.radial_exchange", |s| Some(&mut s.model.radial_exchange)),
    ("model.xsph", |s| Some(&mut s.model.xsph)),
    ("model.shifting_coefficient", |s| Some(&mut shifted(s).shifting_coefficient)),
    ("model.shifting_speed", |s| Some(shifted(s).shifting_speed.get_or_insert(1.0))),
    ("fluids[0].near_stiffness", |s| Some(s.fluids[0].near_stiffness.get_or_insert(1.0))),
    ("model.heat_gain", |s| Some(&mut s.model.heat_gain)),
    ("model.wall_rigidity", |s| Some(&mut s.model.wall_rigidity)),
    ("fluids[0].internal_energy", |s| Some(&mut heated(s).internal_energy)),
    ("fluids[0].colour", |s| s.fluids[0].colour.get_or_insert([0.0; 3]).first_mut()),
    ("fluids[1].rest_density", |s| Some(&mut other(s)?.rest_density)),
    ("fluids[1].speed_of_sound", |s| Some(&mut other(s)?.speed_of_sound)),
    ("blocks[0].corner", |s| s.blocks.first_mut()?.corner.as_mut().first_mut()),
    ("blocks[0].size", |s| s.blocks.first_mut()?.size.as_mut().first_mut()),
    ("blocks[0].velocity", |s| s.blocks.first_mut()?.velocity.as_mut().first_mut()),
    ("blocks[0].jitter", |s| Some(&mut s.blocks.first_mut()?.jitter)),
    ("blocks[0].dynamic_viscosity", |s| Some(s.blocks.first_mut()?.dynamic_viscosity.get_or_insert(1.0))),
    ("container.low", |s| s.container.as_mut()?.low.as_mut().get_mut(1)),
    ("container.high", |s| s.container.as_mut()?.high.as_mut().get_mut(1)),
    ("container.restitution", |s| Some(&mut s.container.as_mut()?.restitution)),
    ("container.slip", |s| Some(&mut s.container.as_mut()?.slip)),
    ("container.dynamic_viscosity", |s| Some(enclosing(s)?.dynamic_viscosity.get_or_insert(1.0))),
    ("container.sliding[0].velocity", |s| {
        let container = enclosing(s)?;
        container.sliding = [Sliding { face: Face::Floor, velocity: Vec3::ZERO }].into_iter().collect();
        container.sliding[0].velocity.as_mut().first_mut()
    }),
    ("walls[0].low", |s| Some(&mut wall(s)?.0[0])),
    ("walls[0].high", |s| Some(&mut wall(s)?.1[0])),
    ("walls[0].velocity", |s| walled(s)?.velocity.as_mut().first_mut()),
    ("walls[0].dynamic_viscosity", |s| Some(walled(s)?.dynamic_viscosity.get_or_insert(1.0))),
    ("periodic.low", |s| periodic(s).low.as_mut().first_mut()),
    ("periodic.high", |s| periodic(s).high.as_mut().first_mut()),
    ("elasticity.reach", |s| Some(&mut elastic(s).reach)),
    ("elasticity.plasticity.rate", |s| Some(&mut plastic(s).rate)),
    ("elasticity.plasticity.yield_strain", |s| Some(&mut plastic(s).yield_strain)),
    ("elasticity.break_at", |s| Some(elastic(s).break_at.get_or_insert(1.0))),
    ("air.threshold", |s| Some(&mut air(s)?.threshold)),
    ("air.minimum_density", |s| Some(&mut air(s)?.minimum_density)),
    ("emitters[0].position", |s| emitter(s)?.position.as_mut().first_mut()),
    ("emitters[0].direction", |s| emitter(s)?.direction.as_mut().first_mut()),
    ("emitters[0].speed", |s| Some(&mut emitter(s)?.speed)),
    ("emitters[0].opening", |s| match &mut emitter(s)?.opening {
        Opening::Square(width) | Opening::Circle(width) => Some(width),
    }),
    ("emitters[0].spread_degrees", |s| Some(&mut emitter(s)?.spread_degrees)),
    ("emitters[0].start", |s| Some(&mut emitter(s)?.start)),
    ("emitters[0].duration", |s| Some(emitter(s)?.duration.get_or_insert(1.0))),
    ("emitters[0].life", |s| Some(emitter(s)?.life.get_or_insert(1.0))),
    ("drains[0].low", |s| Some(&mut drained(s)?.0[0])),
    ("drains[0].high", |s| Some(&mut drained(s)?.1[0])),
    ("drains[0].centre", |s| Some(&mut ball(s)?.0[0])),
    ("drains[0].radius", |s| Some(ball(s)?.1)),
    ("solids[0].position", |s| solid(s)?.position.as_mut().first_mut()),
    ("solids[0].rotation", |s| Some(&mut solid(s)?.rotation.w)),
    ("solids[0].turned", |s| Some(&mut solid(s)?.turned.z)),
    ("solids[0].restitution", |s| Some(&mut solid(s)?.restitution)),
    ("solids[0].slip", |s| Some(&mut solid(s)?.slip)),
    ("solids[0].dynamic_viscosity", |s| Some(solid(s)?.dynamic_viscosity.get_or_insert(1.0))),
    ("solids[0].repulsion", |s| Some(&mut repelling(s)?.repulsion)),
    ("solids[0].shape.radius", |s| match &mut solid(s)?.shape {
        Shape::Ball { radius } => Some(radius),
        _ => None,
    }),
    ("solids[0].motion.velocity", |s| course(s)?.velocity.as_mut().first_mut()),
    ("solids[0].motion.amplitude", |s| course(s)?.amplitude.as_mut().first_mut()),
    ("solids[0].motion.frequency", |s| Some(&mut course(s)?.frequency)),
    ("solids[0].motion.phase", |s| Some(&mut course(s)?.phase)),
    ("solids[0].motion.axis", |s| Some(&mut course(s)?.axis.z)),
    ("solids[0].motion.turns_per_second", |s| Some(&mut course(s)?.turns_per_second)),
    ("solids[0].motion.rocking_degrees", |s| Some(&mut course(s)?.rocking_degrees)),
    ("model.surface_threshold", |s| Some(&mut s.model.surface_threshold)),
    ("model.correction.tolerance", |s| Some(&mut s.model.correction.tolerance)),
    ("adaptive.speed", |s| adaptive(s).speed.as_mut()),
    ("adaptive.acceleration", |s| adaptive(s).acceleration.as_mut()),
    ("adaptive.sound", |s| adaptive(s).sound.as_mut()),
    ("adaptive.viscosity", |s| adaptive(s).viscosity.as_mut()),
    ("adaptive.smallest", |s| Some(&mut adaptive(s).smallest)),
    ("adaptive.largest", |s| Some(&mut adaptive(s).largest)),
    ("adaptive.max_growth", |s| Some(&mut adaptive(s).max_growth)),
    ("adaptive.reject_ratio", |s| Some(adaptive(s).reject_ratio.get_or_insert(1.0))),
    ("stiffness_for_time_step", |s| Some(s.stiffness_for_time_step.get_or_insert(0.2))),
    ("model.variable_support.smallest", |s| Some(&mut range(s).smallest)),
    ("model.variable_support.largest", |s| Some(&mut range(s).largest)),
];

/// For a value of 1e30, an error may name another quantity that is derived from the number. These are the only such
/// quantities.
const DERIVED: &[(&str, &str)] = &[
    // their number
    ("blocks[0].size", "particles"),
    // the extent of a wall
    ("walls[0].low", "walls"),
    ("walls[0].high", "walls"),
    // as many cells as fit between low and high
    ("periodic.high", "grid.cells"),
    // it must not be smaller than the smallest step
    ("adaptive.smallest", "adaptive.largest"),
    // the speed of sound is derived from it
    ("stiffness_for_time_step", "fluids[0].speed_of_sound"),
];

/// Returns the cases. A value that is not finite must be rejected with an error that names the number. With 1e30 the
/// scene runs, or the error names the number or a quantity derived from it.
///
/// # Errors
/// A built-in scene that cannot be read.
pub fn cases() -> Result<Vec<Case>, Failure> {
    let mut scene = built_in("dam-break-2d", PARTICLES)?;
    scene.grid.cells = CELLS;
    let mut cases = Vec::new();
    for &(name, number) in NUMBERS {
        let derived = DERIVED.iter().find(|(of, _)| *of == name).map_or(name, |(_, derived)| derived);
        for value in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, 1e30] {
            let mut scene = scene.clone();
            *number(&mut scene).ok_or_else(|| Failure::Call(format!("extremes: no {name} to change")))? = value;
            let large = value.is_finite();
            let end = if large { End::Naming([name, derived], Measure::Finite) } else { End::NotANumber(name) };
            cases.push(Case::of_scene(format!("{name} {value:e}"), scene, STEPS, end));
        }
    }
    Ok(cases)
}

fn wind(scene: &mut Scene) -> &mut Wind {
    scene.wind.get_or_insert(Wind { velocity: Vec3::new(1.0, 0.0, 0.0), drag: 1.0 })
}

fn field(scene: &mut Scene) -> &mut AccelerationField {
    scene.acceleration_field.get_or_insert(AccelerationField { low: Vec3::ZERO, spacing: 1.0, counts: [4, 4, 1] })
}

fn pulled(scene: &mut Scene) -> &mut Fluid {
    scene.model.surface_tension = SurfaceTension::NormalCurvature;
    &mut scene.fluids[0]
}

fn heated(scene: &mut Scene) -> &mut Fluid {
    scene.model.internal_energy = true;
    &mut scene.fluids[0]
}

/// Makes the container a wall in closed form.
fn enclosing(scene: &mut Scene) -> Option<&mut Container> {
    scene.model.near_pressure = NearPressure::Off;
    let container = scene.container.as_mut()?;
    container.model = PlaneModel::ClosedForm;
    Some(container)
}

fn shifted(scene: &mut Scene) -> &mut Formulation {
    scene.model.shifting = Shifting::Fickian;
    &mut scene.model
}

fn other(scene: &mut Scene) -> Option<&mut Fluid> {
    let number = scene.add_fluid(Fluid::default()).ok()?;
    scene.fluids.get_mut(number as usize)
}

fn walled(scene: &mut Scene) -> Option<&mut Wall> {
    let shape = WallShape::Box { low: Vec3::ZERO, high: Vec3::new(0.5, 0.5, 0.0), open: [].into_iter().collect() };
    scene.add_wall(Wall::still(shape)).ok()?;
    scene.walls.last_mut()
}

/// Returns the low and the high corner of a wall.
fn wall(scene: &mut Scene) -> Option<(&mut Vec3, &mut Vec3)> {
    let (WallShape::Plane { low, high, .. } | WallShape::Box { low, high, .. }) = &mut walled(scene)?.shape;
    Some((low, high))
}

fn periodic(scene: &mut Scene) -> &mut Periodic {
    scene.periodic.get_or_insert(Periodic {
        low: Vec3::ZERO,
        high: Vec3::new(4.0, 3.0, 0.0),
        axes: [true, false, false],
    })
}

fn elastic(scene: &mut Scene) -> &mut millpond_core::scene::Elasticity {
    scene.fluids[0].elastic_stiffness = 1000.0;
    &mut scene.elasticity
}

fn plastic(scene: &mut Scene) -> &mut Plasticity {
    elastic(scene).plasticity.get_or_insert(Plasticity { rate: 1.0, yield_strain: 0.1 })
}

fn emitter(scene: &mut Scene) -> Option<&mut Emitter> {
    if scene.emitters.is_empty() {
        let middle = scene.container.as_ref().map_or(Vec3::ZERO, |container| (container.low + container.high) / 2.0);
        let emitter = Emitter::jet(middle, Vec3::NEG_Y, 1.0, Opening::Square(scene.particle_spacing));
        scene.spare_particles = 10;
        scene.emitters = [emitter].into_iter().collect();
        indexed(scene);
    }
    scene.emitters.first_mut()
}

fn drained(scene: &mut Scene) -> Option<(&mut Vec3, &mut Vec3)> {
    if scene.drains.is_empty() {
        scene.drains = [Drain::Box { low: Vec3::splat(-2.0), high: Vec3::splat(-1.0) }].into_iter().collect();
        indexed(scene);
    }
    match scene.drains.first_mut()? {
        Drain::Box { low, high } => Some((low, high)),
        Drain::Ball { .. } => None,
    }
}

fn ball(scene: &mut Scene) -> Option<(&mut Vec3, &mut f32)> {
    if scene.drains.is_empty() {
        scene.drains = [Drain::Ball { centre: Vec3::new(-2.0, -2.0, 0.0), radius: 0.1 }].into_iter().collect();
        indexed(scene);
    }
    match scene.drains.first_mut()? {
        Drain::Ball { centre, radius } => Some((centre, radius)),
        Drain::Box { .. } => None,
    }
}

/// Adds a ball in closed form beside the container, which swings.
fn solid(scene: &mut Scene) -> Option<&mut Solid> {
    if scene.solids.is_empty() {
        let radius = 100.0 * scene.particle_spacing;
        let course = Course { amplitude: Vec3::new(0.1, 0.0, 0.0), frequency: 1.0, ..Course::default() };
        let ball = Solid::still(Shape::Ball { radius }, [-1.1 * radius, 0.0, 0.0]);
        scene.add_solid(Solid { motion: Motion::Prescribed(course), ..ball }).ok()?;
    }
    scene.solids.first_mut()
}

fn repelling(scene: &mut Scene) -> Option<&mut Solid> {
    let solid = solid(scene)?;
    solid.model = SolidModel::Repulsion;
    Some(solid)
}

fn course(scene: &mut Scene) -> Option<&mut Course> {
    match &mut solid(scene)?.motion {
        Motion::Prescribed(course) => Some(course),
        Motion::Still | Motion::Driven => None,
    }
}

/// Particles that come and go need the index sort.
fn indexed(scene: &mut Scene) {
    scene.grid.structure = GridStructure::IndexSort;
}

fn air(scene: &mut Scene) -> Option<&mut Air> {
    other(scene)?;
    Some(scene.air.get_or_insert(Air { fluid: 1, capacity: 20, threshold: 0.3, minimum_density: 0.1 }))
}

fn adaptive(scene: &mut Scene) -> &mut AdaptiveTimeStep {
    scene.adaptive.get_or_insert_default()
}

fn range(scene: &mut Scene) -> &mut SupportRange {
    scene.model.variable_support.get_or_insert(SupportRange { smallest: 0.8, largest: 1.2 })
}
