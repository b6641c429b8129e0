//! Promise: emitters and the host make what they should, drains, ends of lives and the host take it away again, and the
//! ledger is exact.
use millpond_core::glam::Vec3;
use millpond_core::scene::{AdaptiveTimeStep, Block, Container, Dimension, Drain, Emitter, Fluid, Opening, Scene};
use millpond_core::{Census, NewParticle, OwnedMemory, RestoreError, Serial, Solver, SpawnError};

const SPACING: f32 = 0.05;
const SPEED: f32 = 2.0;

/// Returns a jet through empty space, far from a block of fluid.
fn jet(dimension: Dimension, opening: Opening, spares: u32) -> Scene {
    let block = Block { corner: Vec3::new(-3.0, 0.0, 0.0), size: Vec3::splat(0.2), ..Block::default() };
    let mut scene = Scene::of(dimension, SPACING, 0.001, Fluid { speed_of_sound: 30.0, ..Fluid::default() }, block);
    let direction = if dimension == Dimension::Three { Vec3::new(1.0, 2.0, -0.5) } else { Vec3::new(1.0, 2.0, 0.0) };
    scene.emitters = [Emitter::jet(Vec3::ZERO, direction, SPEED, opening)].into_iter().collect();
    scene.spare_particles = spares;
    scene.grid.cells = [32, 32, if dimension == Dimension::Three { 32 } else { 1 }];
    scene
}

/// Makes steps, and checks after each that the ledger is exact.
fn run(scene: &Scene, steps: u32, mut look: impl FnMut(&Solver<'_>)) -> Census {
    let mut heap = OwnedMemory::of(&scene.check().expect("a scene"));
    let mut solver = Solver::new(scene, heap.lend()).expect("a scene");
    let start = u64::from(solver.census().active);
    for _ in 0..steps {
        solver.step(&Serial).expect("a step");
        let Census { active, flux } = solver.census();
        assert_eq!(u64::from(active), start + flux.born - flux.removed, "{flux:?}");
        assert_eq!(solver.fluid_positions().count(), active as usize);
        look(&solver);
    }
    solver.census()
}

#[test]
fn a_jet_has_the_mass_that_flows_through_its_opening() {
    // points of a lattice: 4 x 4, those of 4 x 4 whose centres are in a circle, and a line of 4
    for (dimension, opening, points) in [
        (Dimension::Three, Opening::Square(0.2), 16),
        (Dimension::Three, Opening::Circle(0.2), 12),
        (Dimension::Two, Opening::Circle(0.2), 4),
    ] {
        let scene = jet(dimension, opening, 2000);
        // the first layer leaves at the start, and then one whenever the last has moved on by a spacing
        let steps = 260;
        let layers = 1 + (steps as f32 * 0.001 * SPEED / SPACING) as u64;
        let census = run(&scene, steps, |_| ());
        assert_eq!(census.flux.born, layers * points, "{dimension:?}, {opening:?}");
        assert_eq!((census.flux.blocked, census.flux.refused, census.flux.removed), (0, 0, 0));
    }
}

#[test]
fn layers_follow_each_other_at_the_spacing_whatever_the_time_step() {
    let mut scene = jet(Dimension::Two, Opening::Square(SPACING), 200);
    scene.time_step = 0.0007;
    scene.adaptive = Some(AdaptiveTimeStep { largest: 0.003, ..AdaptiveTimeStep::default() });
    let mut heap = OwnedMemory::of(&scene.check().expect("a scene"));
    let mut solver = Solver::new(&scene, heap.lend()).expect("a scene");
    while solver.time() < 0.6 {
        solver.step(&Serial).expect("a step");
    }
    let direction = scene.emitters[0].direction.normalize();
    let along = solver.fluid_positions().filter(|x| x.x > -1.0).map(|x| x.dot(direction));
    let mut along: Vec<f32> = along.collect();
    along.sort_unstable_by(f32::total_cmp);
    assert!(along.len() > 20);
    for pair in along.windows(2) {
        // the pressure of a jet that is one particle wide is 0, so its particles fly on undisturbed
        assert!((pair[1] - pair[0] - SPACING).abs() < 1e-4 * SPACING, "{} m", pair[1] - pair[0]);
    }
    let last = along[along.len() - 1] - solver.time() as f32 * SPEED;
    assert!(last.abs() < 1e-4 * SPACING, "the first particle is {last} m from where it should be");
}

#[test]
fn lives_end_and_ids_are_used_again_by_another_generation() {
    let mut scene = jet(Dimension::Two, Opening::Square(0.1), 12);
    scene.emitters[0].life = Some(0.1);
    let mut generations = 0;
    let census = run(&scene, 2000, |solver| {
        for id in 0..solver.slots().len() as u32 {
            generations = generations.max(solver.generation(id).expect("an id"));
        }
    });
    // two particles per layer, of which one leaves every 25 steps, and each lives for 100
    assert_eq!((census.flux.born, census.flux.removed), (162, 154), "{census:?}");
    assert_eq!((census.flux.refused, census.flux.blocked), (0, 0));
    assert!((13..=20).contains(&generations), "{generations} generations of 12 particles");
}

#[test]
fn a_drain_takes_what_comes_and_nothing_else() {
    let mut scene = jet(Dimension::Two, Opening::Square(0.1), 100);
    let direction = scene.emitters[0].direction.normalize();
    scene.drains = [Drain::Ball { centre: direction * 0.5, radius: 0.2 }].into_iter().collect();
    let census = run(&scene, 1000, |solver| {
        assert_eq!(solver.fluid_positions().filter(|x| x.x < -1.0).count(), 16, "the block");
        let within = solver.fluid_positions().any(|x| (x - direction * 0.5).length() < 0.2);
        assert!(!within, "a particle in the drain after a step");
        assert!(solver.fluid_positions().all(|x| x.dot(direction) < 0.5), "a particle behind the drain");
    });
    assert!(census.flux.removed > 50, "{census:?}");
}

#[test]
fn what_cannot_be_made_is_counted() {
    let mut scene = jet(Dimension::Two, Opening::Square(0.1), 5);
    // nine layers of two particles leave, and five are there
    let census = run(&scene, 200, |_| ());
    assert_eq!((census.flux.born, census.flux.refused), (5, 9 * 2 - 5), "{census:?}");
    // the opening is inside of a block at rest
    scene = jet(Dimension::Two, Opening::Square(0.1), 100);
    scene.emitters[0].position = Vec3::new(-2.9, 0.1, 0.0);
    scene.emitters[0].speed = 0.5;
    let census = run(&scene, 20, |_| ());
    assert_eq!((census.flux.born, census.flux.blocked), (0, 2), "{census:?}");
}

/// Returns a tank of water at rest, 0.5 m deep and 1 m wide.
fn tank(spares: u32) -> Scene {
    let block = Block { size: Vec3::new(1.0, 0.5, 0.0), ..Block::default() };
    let water = Fluid { speed_of_sound: 30.0, ..Fluid::default() };
    let mut scene = Scene::of(Dimension::Two, 0.025, 0.0002, water, block);
    scene.gravity = Vec3::new(0.0, -9.81, 0.0);
    scene.container = Some(Container::closed(Vec3::ZERO, Vec3::new(1.0, 1.0, 0.0)));
    (scene.spare_particles, scene.model.initialize_hydrostatic) = (spares, true);
    scene.grid.cells = [32, 32, 1];
    scene
}

#[test]
fn ten_thousand_spawns_into_a_tank_cause_no_outburst() {
    let scene = tank(1000);
    let mut heap = OwnedMemory::of(&scene.check().expect("a scene"));
    let mut solver = Solver::new(&scene, heap.lend()).expect("a scene");
    let mut seed = 1u32;
    let mut random = move || {
        seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (seed >> 8) as f32 / (1u32 << 24) as f32
    };
    let mut made = 0;
    for _ in 0..10_000 {
        // everywhere in the tank, and a little beyond its walls
        let position = Vec3::new(random() * 1.1 - 0.05, random() * 1.1 - 0.05, 0.0);
        let new = NewParticle { fluid: 0, position, velocity: Vec3::ZERO, life: None };
        match solver.spawn(&new) {
            Ok(id) => {
                made += 1;
                assert_eq!(solver.identify(id.index), Some(id));
            }
            Err(error) => assert!(matches!(error, SpawnError::Taken | SpawnError::BehindPlane), "{error}"),
        }
    }
    let flux = solver.census().flux;
    assert!(flux.born == made && made > 300 && flux.blocked > 4000, "{flux:?}");
    // they fall through half a metre at most
    let fastest = (2.0 * 9.81f32 * 0.5).sqrt();
    for _ in 0..1000 {
        solver.step(&Serial).expect("a step");
        let speed = solver.particles().filter(|a| !a.is_inactive).map(|a| a.velocity.length());
        assert!(speed.fold(0.0, f32::max) < fastest);
    }
}

#[test]
fn the_host_removes_a_particle_once_and_uses_its_id_again() {
    let scene = tank(1);
    let mut heap = OwnedMemory::of(&scene.check().expect("a scene"));
    let mut solver = Solver::new(&scene, heap.lend()).expect("a scene");
    let above = |x: f32| NewParticle { fluid: 0, position: Vec3::new(x, 0.8, 0.0), velocity: Vec3::X, life: Some(1.0) };
    let first = solver.spawn(&above(0.1)).expect("a free place");
    assert_eq!(solver.spawn(&above(0.5)), Err(SpawnError::NoSpare));
    solver.step(&Serial).expect("a step");
    let old = solver.identify(7).expect("a particle of the block");
    assert!(solver.remove(old) && !solver.remove(old), "once");
    let second = solver.spawn(&above(0.5)).expect("a free place");
    assert_eq!((second.index, second.generation, first.generation), (7, 1, 1));
    assert!(!solver.remove(old), "another particle has its id");
    solver.step(&Serial).expect("a step");
    let flux = solver.census().flux;
    assert_eq!((flux.born, flux.removed, flux.refused), (2, 1, 1));
    assert!(solver.remove(second) && solver.identify(7).is_none());
    // what is wrong with a request is named, and nothing is counted
    let wrong = [
        (NewParticle { fluid: 1, ..above(0.2) }, SpawnError::NoSuchFluid { fluid: 1, fluids: 1 }),
        (NewParticle { velocity: Vec3::Z, ..above(0.2) }, SpawnError::OutOfPlane),
        (NewParticle { velocity: Vec3::NAN, ..above(0.2) }, SpawnError::NotFinite),
        (above(-0.2), SpawnError::BehindPlane),
        (NewParticle { life: Some(0.0), ..above(0.2) }, SpawnError::LifeNotPositive),
    ];
    for (new, error) in wrong {
        assert_eq!(solver.spawn(&new), Err(error));
    }
    assert_eq!(solver.census().flux.born, 2);
    let mut heap = OwnedMemory::of(&tank(0).check().expect("a scene"));
    let mut solver = Solver::new(&tank(0), heap.lend()).expect("a scene");
    assert_eq!(solver.spawn(&above(0.2)), Err(SpawnError::NotPlanned));
}

#[test]
fn saved_bytes_do_not_go_to_a_scene_with_another_emitter() {
    let scene = jet(Dimension::Two, Opening::Square(0.1), 100);
    let mut other = scene.clone();
    other.emitters[0].speed *= 0.5;
    let mut heap = OwnedMemory::of(&scene.check().expect("a scene"));
    let mut solver = Solver::new(&scene, heap.lend()).expect("a scene");
    (0..30).for_each(|_| solver.step(&Serial).expect("a step"));
    let mut bytes = vec![0; solver.saved_bytes()];
    solver.save(&mut bytes).expect("room");
    let mut heap = OwnedMemory::of(&other.check().expect("a scene"));
    let mut slow = Solver::new(&other, heap.lend()).expect("a scene");
    assert_eq!(slow.restore(&bytes), Err(RestoreError::AnotherScene));
    let mut heap = OwnedMemory::of(&scene.check().expect("a scene"));
    let mut again = Solver::new(&scene, heap.lend()).expect("a scene");
    again.restore(&bytes).expect("bytes of this scene");
    for solver in [&mut solver, &mut again] {
        (0..40).for_each(|_| solver.step(&Serial).expect("a step"));
    }
    assert_eq!(solver.full_hash(), again.full_hash(), "it goes on as if it had not been saved");
}
