//! Promise: a layer of air forms around exposed liquid, with no two of its particles too close to each other, and air
//! particles that have lost the liquid become inactive. Spawn requests that find no inactive air particle are counted.
//! All this has the same bits on the scalar path, in SIMD lanes, on two threads and with every term left in. A scene
//! without air uses no memory for it.
//!
//! `gpu/tests/air_is_the_same.rs` checks that a device creates the same air.
use millpond_core::scene::{Dimension, InitialParticle, Scene};
use millpond_core::{
    AirReport, Array, OwnedMemory, Particle, Pass, Plan, Requirements, SceneError, Serial, Simd, Solver,
};

mod support;
use support::air::{SPACING, both, drop, scenes};
use support::{Threads, Words, checked};

/// Returns the active particles of the layer of air.
fn coat(solver: &Solver<'_>) -> Vec<Particle> {
    solver.particles().filter(|particle| particle.fluid == 1 && !particle.is_inactive && !particle.is_wall).collect()
}

#[test]
fn a_bare_drop_is_coated_and_stays_so() {
    for scene in both() {
        let scene = checked(&scene);
        let derived = scene.derived();
        let mut heap = OwnedMemory::of(&scene);
        let mut solver = Solver::new(&scene, heap.lend()).expect("a scene");
        assert_eq!(solver.air(), AirReport { active: 0, refused: 0 }, "none at the start, when time stands still");
        solver.step(&Serial).expect("a step");
        // in the first step each particle of a face requests one air particle; where faces meet there are fewer
        let face = if scene.dimension == Dimension::Two { 4 * 6 } else { 6 * 36 };
        let first = solver.air();
        println!("{:?}: {first:?}", scene.dimension);
        assert!((face / 2..=face + 24).contains(&(first.active as usize)), "{first:?} of {face}");
        let mut before: Vec<Particle> = solver.particles().collect();
        for _ in 0..100 {
            solver.step(&Serial).expect("a step");
            let now: Vec<Particle> = solver.particles().collect();
            let there: Vec<&Particle> = now.iter().filter(|particle| !particle.is_inactive).collect();
            for born in there.iter().filter(|a| before[a.id as usize].is_inactive) {
                let others = there.iter().filter(|b| b.id != born.id);
                let nearest = others.map(|b| b.position.distance(born.position)).fold(f32::INFINITY, f32::min);
                assert!(nearest > 0.749 * SPACING, "made in the way of others: {} spacings", nearest / SPACING);
                let water = now[..derived.fluid_particles].iter();
                let parent = water.map(|b| (b.position.distance(born.position) / SPACING - 1.0).abs());
                assert!(parent.fold(f32::INFINITY, f32::min) < 1e-3, "made a spacing from its parent");
            }
            before = now;
        }
        let air = coat(&solver);
        println!("{:?}: {:?}", scene.dimension, solver.air());
        assert_eq!(air.len(), solver.air().active as usize);
        assert_eq!(solver.air().refused, 0, "there was room for all");
        assert!(air.len() >= first.active as usize / 2, "{} are left", air.len());
        assert_eq!(solver.particles().len(), derived.particles());
    }
}

#[test]
fn air_without_liquid_vanishes() {
    for scene in both() {
        let scene = checked(&scene);
        let (count, water) = (scene.derived().particles(), scene.derived().fluid_particles);
        let mut all: Vec<InitialParticle> = scene.initial_particles().collect();
        let lost = water + 7;
        all[lost] = InitialParticle::of_fluid(
            1,
            if scene.dimension == Dimension::Two { [1.9, 1.9, 0.0] } else { [1.9; 3] },
            [0.0; 3],
        );
        let mut heap = OwnedMemory::of(&scene);
        let plan = Plan::of(&scene);
        let mut solver = Solver::with_particles(&scene, plan, count, all.clone(), heap.lend()).expect("a scene");
        assert_eq!(solver.air().active, 1);
        solver.step(&Serial).expect("a step");
        assert!(solver.particles().nth(lost).is_some_and(|particle| particle.is_inactive), "it is gone");
        // its id is available again only from the next step on, so the particles that are spawned in this step skip it
        let ids: Vec<u32> = coat(&solver).iter().map(|particle| particle.id).collect();
        assert!(ids.iter().all(|&id| id as usize != lost) && ids.contains(&(lost as u32 + 1)));

        // an id that is reserved for air must belong to an air particle
        all[lost].material = 0;
        let refused = Solver::with_particles(&scene, plan, count, all, heap.lend()).err();
        assert_eq!(refused, Some(SceneError::UnplannedParticle { particle: lost as u32 }));
    }
}

#[test]
fn births_that_find_nobody_are_counted() {
    for capacity in [1, 5] {
        let scene = drop(Dimension::Two, capacity);
        let mut heap = OwnedMemory::of(&scene.check().expect("a scene"));
        let mut solver = Solver::new(&scene, heap.lend()).expect("a scene");
        let mut before = 0;
        for _ in 0..5 {
            solver.step(&Serial).expect("a step");
            let AirReport { active, refused } = solver.air();
            assert!(active <= capacity && refused >= before + 10, "each step asks again: {active}, {refused}");
            before = refused;
        }
    }
}

#[test]
fn a_scene_without_air_has_no_bytes_for_it() {
    let mut scene = drop(Dimension::Two, 100);
    let with = Requirements::of(&checked(&scene));
    scene.air = None;
    let scene = checked(&scene);
    let without = Requirements::of(&scene);
    for array in [Array::total_colour_gradient, Array::spawn_requested] {
        assert_eq!(without.bytes_of(array), 0, "{}", array.name());
        assert!(with.bytes_of(array) > 0, "{}", array.name());
    }
    let counts = |of: Requirements| (of.counts.cells, of.counts.particles);
    assert_eq!(counts(with), (counts(without).0 + 1, counts(without).1 + 100));
    let plan = Plan::of(&scene);
    assert!(plan.passes().all(|pass| ![Pass::Exposure, Pass::SpawnRequests, Pass::Spawn].contains(&pass)));
    assert!(plan.left_out().iter().any(|left_out| left_out.what == "air"));
}

const STEPS: u32 = 60;

fn by_cpu(scene: &Scene, simd: Simd, threads: usize) -> (Words, AirReport, u64) {
    let mut heap = OwnedMemory::of(&scene.check().expect("a scene"));
    let mut solver = Solver::new(scene, heap.lend()).expect("a scene").at_level(simd);
    (0..STEPS).for_each(|_| solver.step(&Threads(threads)).expect("a step"));
    (Words::of_cpu(&solver), solver.air(), solver.hash())
}

fn by_everything(scene: &Scene) -> u64 {
    let scene = checked(scene);
    let plan = Plan::everything(&scene);
    let mut heap = OwnedMemory::with(&Requirements::by_plan(&scene, &plan));
    let (count, places) = (scene.derived().particles(), scene.initial_particles());
    let mut solver = Solver::with_particles(&scene, plan, count, places, heap.lend()).expect("a scene");
    (0..STEPS).for_each(|_| solver.step(&Serial).expect("a step"));
    solver.hash()
}

#[test]
fn the_same_bits_everywhere() {
    for base in both() {
        let mut with_air = 0;
        for (name, scene) in scenes(&base) {
            let what = format!("{name}, {:?}", scene.dimension);
            let want = by_cpu(&scene, Simd::Scalar, 1);
            println!("{what}: {:?}", want.1);
            with_air += usize::from(want.1.active > 0);
            assert!(by_cpu(&scene, Simd::detect(), 2) == want, "{what}: lanes on two threads");
            for simd in Simd::available().skip(1) {
                assert!(by_cpu(&scene, simd, 1) == want, "{what}: lanes, {simd:?}");
            }
            assert_eq!(by_everything(&scene), want.2, "{what}: with every term left in");
        }
        // in the scene whose air vanishes, there may be no active air particle at the end
        assert!(with_air + 1 >= scenes(&base).len(), "no air tests nothing");
    }
}
