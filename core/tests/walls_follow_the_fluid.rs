//! Promise: walls of particles that are extrapolated continue the pressure of the fluid into the wall, push the fluid
//! as hard as the fluid pushes them, and never change their density on their own. Diffusion of density conserves mass
//! pair by pair.
use approx::assert_relative_eq;
use millpond_core::backend::layout::Model;
use millpond_core::backend::terms::diffusion::diffusion_neighbour;
use millpond_core::backend::terms::state::{deviation_of_state, pressure_of_state, sound_of_state};
use millpond_core::glam::Vec3;
use millpond_core::scene::{
    Block, DensityDiffusion, DensityForm, Dimension, EquationOfState, Face, Fluid, Formulation, Scene, Wall,
    WallPressure, WallShape,
};
use millpond_core::{OwnedMemory, Plan, Serial, Solver};

#[path = "support/forms.rs"]
#[allow(dead_code, unreachable_pub, reason = "each test uses its part")]
mod forms;
use forms::wendland;

const SPACING: f32 = 0.05;
const DEPTH: f32 = 0.5;
const GRAVITY: f32 = 10.0;
const DENSITY: f32 = 1000.0;

/// Returns a tank of water at rest on a lattice, with the density that its weight requires.
fn tank(wall_pressure: WallPressure) -> Scene {
    let water = Fluid { rest_density: DENSITY, speed_of_sound: 40.0, ..Fluid::default() };
    let block = Block { size: Vec3::new(1.0, DEPTH, 0.0), ..Block::default() };
    let mut scene = Scene::of(Dimension::Two, SPACING, 1e-4, water, block);
    scene.gravity = Vec3::new(0.0, -GRAVITY, 0.0);
    let inside = WallShape::Box {
        low: Vec3::ZERO,
        high: Vec3::new(1.0, DEPTH, 0.0),
        open: [Face::Ceiling].into_iter().collect(),
    };
    scene.add_wall(Wall::still(inside)).expect("room for a wall");
    scene.model = Formulation {
        density: DensityForm::Continuity,
        density_diffusion: DensityDiffusion::Hydrostatic,
        initialize_hydrostatic: true,
        normalize_mass: true,
        wall_pressure,
        ..wendland()
    };
    scene
}

fn start<'m>(scene: &Scene, heap: &'m mut OwnedMemory) -> Solver<'m> {
    Solver::new(scene, heap.lend()).expect("a scene")
}

fn heap(scene: &Scene) -> OwnedMemory {
    OwnedMemory::of(&scene.check().expect("a scene"))
}

#[test]
fn the_pressure_of_the_fluid_is_continued_into_the_wall() {
    let scene = tank(WallPressure::Extrapolated);
    let mut heap = heap(&scene);
    let mut solver = start(&scene, &mut heap);
    let floor = DENSITY * GRAVITY * DEPTH;
    let hydrostatic = |y: f32| DENSITY * GRAVITY * (DEPTH - y);
    // the compression at the floor, g H / c^2, is 0.3 %, and makes the pressure that much steeper
    let tolerance = 0.005 * floor;
    let mut seen = 0;
    for particle in solver.particles().filter(|p| p.is_wall && p.position.y < 0.9 * DEPTH && p.pressure != 0.0) {
        seen += 1;
        let off = (particle.pressure - hydrostatic(particle.position.y)).abs();
        assert!(off < tolerance, "{} Pa off at {}", off, particle.position);
    }
    assert!(seen > 60, "{seen}: the rows of walls beside the water");
    let mut probe = |y: f32| solver.neighbours().sample(Vec3::new(0.0, y, 0.0)).map(|sample| sample.pressure);
    for y in [0.0, 0.11, 0.3] {
        assert!((probe(y).expect("water there") - hydrostatic(y)).abs() < tolerance, "at {y}");
    }
    assert_eq!(probe(5.0), None);
}

#[test]
fn the_wall_is_pushed_as_hard_as_it_pushes() {
    for wall in [WallPressure::Extrapolated, WallPressure::Dynamic] {
        let mut scene = tank(wall);
        // particles that move, with viscosity and without order
        scene.blocks[0].jitter = 0.2;
        scene.blocks[0].velocity = Vec3::new(0.5, -0.2, 0.0);
        scene.fluids[0].dynamic_viscosity = 5.0;
        let mut heap = heap(&scene);
        let mut solver = start(&scene, &mut heap);
        // the acceleration at the start belongs to the present positions
        let mut change = [0.0f64; 3];
        for (slot, particle) in solver.particles().enumerate().filter(|(_, p)| !p.is_wall) {
            let slot = solver.slots()[slot] as usize;
            let acceleration = Vec3::from_slice(&solver.state().acceleration[slot][..3]) - scene.gravity;
            for (sum, part) in change.iter_mut().zip(acceleration.to_array()) {
                *sum += f64::from(particle.mass) * f64::from(part);
            }
        }
        let force = solver.neighbours().force_on_wall(0);
        let weight = DENSITY * GRAVITY * DEPTH;
        assert!(force.length() > 0.1 * weight, "{wall:?}: a wall that feels nothing tests nothing");
        for axis in 0..3 {
            // sums over some 2000 pairs in f32
            let off = (change[axis] + f64::from(force[axis])).abs();
            assert!(off < 1e-5 * f64::from(weight), "{wall:?}, axis {axis}: {} N and {} N", change[axis], force[axis]);
        }
        for none in [1, 7, 1000, usize::MAX] {
            assert_eq!(solver.neighbours().force_on_wall(none), Vec3::ZERO, "no such wall");
        }
    }
}

#[test]
fn a_lid_that_slides_over_a_wall_leaves_its_density_alone() {
    for wall in [WallPressure::Extrapolated, WallPressure::Dynamic] {
        let mut scene = tank(wall);
        scene.gravity = Vec3::ZERO;
        scene.model.initialize_hydrostatic = false;
        let over = WallShape::Plane {
            face: Face::Ceiling,
            low: Vec3::new(-0.2, DEPTH, 0.0),
            high: Vec3::new(1.2, DEPTH, 0.0),
        };
        let lid = Wall { velocity: Vec3::new(2.0, 0.0, 0.0), dynamic_viscosity: Some(0.0), ..Wall::still(over) };
        scene.add_wall(lid).expect("room for a wall");
        let mut heap = heap(&scene);
        let mut solver = start(&scene, &mut heap);
        let walls = |solver: &Solver<'_>| -> Vec<f32> {
            solver.particles().filter(|p| p.is_wall).map(|p| p.density / DENSITY).collect()
        };
        let before = walls(&solver);
        (0..1000).for_each(|_| solver.step(&Serial).expect("a step"));
        // the lid has moved four spacings, so its particles stand as they did; in between, and where the fluid moves,
        // the sum over the neighbours changes by less than a tenth. A density that is stepped doubles
        for (before, after) in before.iter().zip(walls(&solver)) {
            assert!((after - before).abs() < 0.1, "{wall:?}: {before} became {after}");
        }
    }
}

#[test]
fn density_follows_from_pressure_as_pressure_from_density() {
    let tait = (1..=7).map(|exponent| (EquationOfState::Tait, exponent));
    for (equation, exponent) in tait.chain([(EquationOfState::Linear, 7), (EquationOfState::IdealGas, 7)]) {
        let mut scene = tank(WallPressure::Extrapolated);
        scene.model.initialize_hydrostatic = false;
        (scene.model.equation_of_state, scene.model.tait_exponent) = (equation, exponent);
        let checked = scene.check().expect("a scene");
        let model: Model = Plan::of(&checked).model;
        let p = &checked.derived().parameters;
        let number = equation as u32 as f32;
        for i in 0..=200 {
            let deviation = -0.4 + 1.9 * i as f32 / 200.0;
            let pressure: f32 = pressure_of_state(&model, deviation, 5e5, number);
            let back = deviation_of_state(&model, p, pressure, 5e5, number);
            // both directions are rounded; near the rest density a pressure has as many digits as the deviation
            assert_relative_eq!(back, deviation, epsilon = 3e-7, max_relative = 2e-6);
            // c^2 = dP / d rho, with c0 = 1 and B = 1 / gamma; the difference of two pressures has four digits
            if equation == EquationOfState::Tait {
                let at = |e: f32| f64::from(pressure_of_state::<f32>(&model, e, 1.0 / exponent as f32, number));
                let slope = (at(deviation + 0.002) - at(deviation - 0.002)) / 0.004;
                let sound = f64::from(sound_of_state::<f32>(&model, deviation, 1.0, number));
                assert_relative_eq!(sound * sound, slope, max_relative = 1e-3);
            }
        }
        for tiny in [1e-6f32, -1e-6] {
            let pressure: f32 = pressure_of_state(&model, tiny, 5e5, number);
            if equation != EquationOfState::IdealGas {
                assert_relative_eq!(deviation_of_state(&model, p, pressure, 5e5, number), tiny, max_relative = 1e-5);
            }
        }
        let least: f32 = deviation_of_state(&model, p, -1e9, 5e5, number);
        assert!((-0.501..-0.499).contains(&least), "{equation:?} {exponent}: {least}, no volume without end");
    }
}

#[test]
fn what_one_particle_gains_by_diffusion_the_other_loses() {
    let scene = tank(WallPressure::Extrapolated);
    let checked = scene.check().expect("a scene");
    let (model, derived) = (Plan::of(&checked).model, checked.derived());
    for (q, slope, difference) in [(0.1, 0.3, 1e-3f32), (0.5, 0.02, -2e-4), (0.9, 1e-3, 0.03)] {
        let gain = |difference: f32, mass_b: f32| -> f32 {
            diffusion_neighbour(&model, &derived.parameters, difference, 40.0, mass_b, q, slope, 1.0)
        };
        let (of_a, of_b) = (gain(difference, 1.25) * 0.8, gain(-difference, 0.8) * 1.25);
        assert!(of_a.abs() > 0.0 && of_a.signum() == difference.signum(), "towards the denser particle");
        assert_relative_eq!(of_a, -of_b, max_relative = 3e-7);
    }
}
