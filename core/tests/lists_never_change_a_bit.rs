//! Promise: how much memory there is for neighbour lists changes time, never a bit, at any level: with lists that are full from the start,
//! from the middle on, or of some groups; with windows of slots that run out; with more candidates than are ever listed; and with groups
//! that are not full.
use millpond_core::scene::{InitialParticle, Scene};
use millpond_core::{OwnedMemory, Plan, Requirements, Serial, Simd, Solver};

mod support;
use support::{dam_break, dam_break_2d};

/// The hash of all state after some steps, of particles that stand where `places` says.
fn hash(scene: &Scene, places: &[InitialParticle], simd: Simd, words: usize, steps: usize) -> u64 {
    let scene = support::checked(scene);
    let requirements = Requirements::of(&scene).for_particles(places.len());
    let mut heap = OwnedMemory::with(&requirements);
    let memory = heap.lend().with_neighbour_words(words);
    let solver = Solver::with_particles(&scene, Plan::of(&scene), places.len(), places.iter().copied(), memory);
    let mut solver = solver.expect("a scene").at_level(simd);
    (0..steps).for_each(|_| solver.step(&Serial).expect("a step"));
    solver.full_hash()
}

/// Asserts that none of these numbers of words, at any level, changes the bits of the scalar path with all of them.
fn check(what: &str, scene: &Scene, places: &[InitialParticle], steps: usize) {
    let all = places.len() * millpond_core::LIST_WORDS;
    let want = hash(scene, places, Simd::Scalar, usize::MAX, steps);
    for simd in Simd::available() {
        for words in [usize::MAX, 0, all / 5, all / 3, all / 2] {
            let got = hash(scene, places, simd, words, steps);
            assert_eq!(got, want, "{what}, {} particles, {simd:?}, {words} words", places.len());
        }
    }
}

/// The particles that a scene starts with.
fn start(scene: &Scene) -> Vec<InitialParticle> {
    support::checked(scene).initial_particles().collect()
}

#[test]
fn whatever_of_them_fits() {
    for scene in [dam_break(0.3), dam_break_2d(0.3)] {
        check("lists that are full", &scene, &start(&scene), 20);
    }
}

#[test]
fn with_one_to_nine_particles() {
    let scene = dam_break(0.3);
    for count in 1..=9 {
        check("groups that are not full", &scene, &start(&scene)[..count], 20);
    }
}

#[test]
fn with_thousands_in_a_cell() {
    // a step so short that nobody flies out of the crowd
    let scene = Scene { time_step: 1e-12, ..dam_break(0.3) };
    let mut places = start(&scene);
    let first = places[0];
    // a crowd of eleven hundred in a cube of half a spacing, and the others around it
    let near = |i: usize| [7, 11, 13].map(|n| (i * n % 97) as f32 / 97.0 * 0.5 * scene.particle_spacing);
    places.extend((0..1100).map(|i| {
        let offset = near(i);
        let position = core::array::from_fn(|axis| first.position[axis] + offset[axis]);
        InitialParticle { position, ..first }
    }));
    check("a crowd", &scene, &places, 1);
}

#[test]
fn with_more_rows_than_there_are_windows() {
    // windows of 8192 slots, eight of them, run out several times
    let scene = dam_break(2.0);
    let places = start(&scene);
    assert!(places.len() > 150_000, "{} particles", places.len());
    let want = hash(&scene, &places, Simd::Scalar, 0, 1);
    for simd in Simd::available().skip(1) {
        assert_eq!(hash(&scene, &places, simd, usize::MAX, 1), want, "{simd:?}");
    }
}
