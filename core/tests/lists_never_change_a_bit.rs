//! Promise: the amount of memory for neighbour lists affects the run time but never a bit, at any SIMD level. The
//! cases: memory that is used up at the start, halfway, or after some groups (of four particles); windows of slots that
//! run out; more candidates or neighbours than a list can hold, also beside walls; and groups with fewer than four
//! particles. Each test checks that its case really occurs.
use millpond_core::backend::ListReport;
use millpond_core::glam::Vec3;
use millpond_core::scene::{Block, Dimension, Face, Fluid, InitialParticle, Scene, Wall, WallPressure, WallShape};
use millpond_core::{LIST_WORDS, Memory, OwnedMemory, Plan, Requirements, Simd, Solver, Storage};

mod support;
use support::{Threads, dam_break, dam_break_2d, start, with_a_crowd};

/// Returns the hash of all state after some steps from the particles `places`, and how full the lists then are.
fn run(
    scene: &Scene,
    places: &[InitialParticle],
    simd: Simd,
    threads: usize,
    words: usize,
    steps: usize,
) -> (u64, ListReport) {
    let scene = support::checked(scene);
    let requirements = Requirements::of(&scene).for_particles(places.len());
    let mut heap = OwnedMemory::with(&requirements);
    let memory = heap.lend().with_neighbour_words(words);
    let solver = Solver::with_particles(&scene, Plan::of(&scene), places.len(), places.iter().copied(), memory);
    let mut solver = solver.expect("a scene").at_level(simd);
    (0..steps).for_each(|_| solver.step(&Threads(threads)).expect("a step"));
    let lists = solver.lists().expect("nothing else was asked");
    (solver.full_hash(), lists)
}

/// Asserts that none of several memory sizes, at any SIMD level, changes the bits of the scalar path with all of the
/// memory. Returns how full the lists are with all of the memory.
fn check(what: &str, scene: &Scene, places: &[InitialParticle], steps: usize) -> ListReport {
    let all = places.len() * LIST_WORDS;
    let (want, lists) = run(scene, places, Simd::Scalar, 1, usize::MAX, steps);
    for simd in Simd::available() {
        for (words, threads) in [(usize::MAX, 3), (0, 1), (all / 5, 1), (all / 3, 2), (all / 2, 3)] {
            let (got, found) = run(scene, places, simd, threads, words, steps);
            assert_eq!(got, want, "{what}, {} particles, {simd:?}, {words} words", places.len());
            assert!(words > 0 || found.listed == 0, "{what}: without memory nothing is listed");
        }
    }
    lists
}

#[test]
fn whatever_of_them_fits() {
    for scene in [dam_break(0.3), dam_break_2d(0.3)] {
        let places = start(&scene);
        let lists = check("lists that are full", &scene, &places, 20);
        assert_eq!(lists.listed, lists.groups, "with all of the memory");
        let (_, some) = run(&scene, &places, Simd::detect(), 1, places.len() * LIST_WORDS / 3, 20);
        assert!(some.listed > 0 && some.listed < some.groups, "with a third of it: {some:?}");
    }
}

#[test]
fn all_of_them_fit_whatever_number_of_neighbours_a_scene_asks_for() {
    let block = Block { size: Vec3::splat(0.5), jitter: 0.3, ..Block::default() };
    let mut scene = Scene::of(Dimension::Three, 0.05, 1e-4, Fluid::default(), block);
    let is_full = |memory: Memory<'_>, scene: &Scene| {
        let solver = Solver::new(scene, memory).expect("a scene");
        let lists = solver.lists().expect("made for the first accelerations");
        assert_eq!(lists.listed, lists.groups, "{:?} neighbours", scene.average_neighbours);
    };
    // a storage has room for the default number
    let mut storage: Box<Storage<1000, 32768>> = Storage::boxed();
    is_full(storage.lend(), &scene);
    for neighbours in [None, Some(20.0), Some(100.0), Some(180.0)] {
        scene.average_neighbours = neighbours;
        is_full(OwnedMemory::of(&support::checked(&scene)).lend(), &scene);
    }
}

#[test]
fn with_one_to_nine_particles() {
    let scene = dam_break(0.3);
    for count in 1..=9 {
        let lists = check("groups that are not full", &scene, &start(&scene)[..count], 20);
        assert_eq!((lists.groups, lists.listed), (count.div_ceil(4), count.div_ceil(4)));
    }
}

#[test]
fn with_hundreds_and_thousands_in_a_cell() {
    // a step so short that no particle leaves the crowd
    let scene = Scene { time_step: 1e-12, ..dam_break(0.3) };
    // 400: more neighbours than are listed for a particle; 1100: more candidates than are tested at once
    for crowd in [400, 1100] {
        let lists = check("a crowd", &scene, &with_a_crowd(&scene, start(&scene), crowd), 1);
        let unlisted = lists.groups - lists.listed;
        assert!(lists.listed > 0 && unlisted >= crowd / 4, "{crowd}: {lists:?}");
    }
}

#[test]
fn with_a_crowd_beside_a_mirroring_wall() {
    let mut scene = Scene { time_step: 1e-12, container: None, ..dam_break_2d(0.3) };
    scene.model.wall_pressure = WallPressure::Mirrored;
    let shape = WallShape::Plane { face: Face::Floor, low: Vec3::new(-0.5, 0.0, 0.0), high: Vec3::new(1.5, 0.0, 0.0) };
    scene.add_wall(Wall::still(shape)).expect("room for a wall");
    let lists = check("a crowd at a wall", &scene, &with_a_crowd(&scene, start(&scene), 1100), 1);
    assert!(lists.listed > 0 && lists.listed < lists.groups, "{lists:?}");
}

#[test]
fn with_more_rows_than_there_are_windows() {
    // the eight windows of 8192 slots run out several times
    let scene = dam_break(2.0);
    let places = start(&scene);
    assert!(places.len() > 150_000, "{} particles", places.len());
    let (want, _) = run(&scene, &places, Simd::Scalar, 1, 0, 1);
    for simd in Simd::available() {
        let (got, lists) = run(&scene, &places, simd, 1, usize::MAX, 1);
        assert_eq!(got, want, "{simd:?}");
        // only groups that lie across a change of windows are not listed
        assert!(lists.listed < lists.groups && lists.groups - lists.listed < 100, "{simd:?}: {lists:?}");
    }
}

macro_rules! golden {
    ($($name:literal),*) => {
        [$(($name, include_str!(concat!("golden/", $name, ".ron")))),*]
    };
}

#[test]
fn with_walls_air_springs_periodic_axes_and_changing_supports() {
    let all = golden![
        "everything",
        "air-and-curvature",
        "corrected-pressure",
        "two-fluids-periodic",
        "adaptive-dynamic-walls",
        "stepped-density-verlet",
        "beeman-exchange"
    ];
    for (name, text) in all {
        let scene: Scene = ron::from_str(text).expect("a scene in RON");
        let hash = |simd, words: usize| {
            let checked = support::checked(&scene);
            let mut heap = OwnedMemory::of(&checked);
            let solver = Solver::new(&scene, heap.lend().with_neighbour_words(words)).expect("a scene");
            let mut solver = solver.at_level(simd);
            (0..5).for_each(|_| solver.step(&Threads(1)).expect("a step"));
            let lists = solver.lists().expect("nothing else was asked");
            assert!(lists.pairs <= lists.places && lists.listed <= lists.groups, "{name}: {lists:?}");
            (solver.full_hash(), solver.slots().len())
        };
        let (want, particles) = hash(Simd::Scalar, usize::MAX);
        for simd in Simd::available() {
            for words in [usize::MAX, particles * LIST_WORDS / 3, 0] {
                assert_eq!(hash(simd, words).0, want, "{name}, {simd:?}, {words} words");
            }
        }
    }
}
