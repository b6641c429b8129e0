//! Promise: the half stencil computes what the full one does, but for the order of its sums: densities and accelerations agree to the
//! rounding of such sums, and what it adds to one particle of a pair it takes from the other. Its bits are its own, and the same at
//! every level, on any number of threads, with either structure of the grid, and however many particles a cell holds.
use millpond_core::scene::{Dimension, GridStructure, InitialParticle, PressureForce, Scene, Traversal};
use millpond_core::{OwnedMemory, Plan, Requirements, Serial, Simd, Solver};

mod support;
use support::{Threads, dam_break, dam_break_2d, thesis_cube};

fn half(scene: &Scene) -> Scene {
    let mut half = scene.clone();
    half.grid.traversal = Traversal::HalfStencil;
    half
}

/// Hash of all state after some steps.
fn hash(scene: &Scene, places: &[InitialParticle], simd: Simd, threads: usize, steps: usize) -> u64 {
    let scene = support::checked(scene);
    let mut heap = OwnedMemory::with(&Requirements::of(&scene).for_particles(places.len()));
    let plan = Plan::of(&scene);
    let solver = Solver::with_particles(&scene, plan, places.len(), places.iter().copied(), heap.lend());
    let mut solver = solver.expect("a scene").at_level(simd);
    (0..steps).for_each(|_| solver.step(&Threads(threads)).expect("a step"));
    assert_eq!(solver.lists(), None, "it makes no lists");
    solver.full_hash()
}

fn check(what: &str, scene: &Scene, places: &[InitialParticle], steps: usize) {
    let scene = half(scene);
    let want = hash(&scene, places, Simd::Scalar, 1, steps);
    let paths = Simd::available().skip(1).map(|simd| (simd, 1)).chain([(Simd::detect(), 2), (Simd::detect(), 3)]);
    for (simd, threads) in paths {
        assert_eq!(hash(&scene, places, simd, threads, steps), want, "{what}: {simd:?}, {threads} threads");
    }
    let mut lists = scene.clone();
    lists.grid.structure = GridStructure::CellLists { places: 2048 };
    assert_eq!(hash(&lists, places, Simd::detect(), 2, steps), want, "{what}: cell lists");
}

fn start(scene: &Scene) -> Vec<InitialParticle> {
    support::checked(scene).initial_particles().collect()
}

#[test]
fn its_bits_are_the_same_on_every_path() {
    for (what, scene) in [("dam break", dam_break(0.4)), ("cube", thesis_cube(0.5)), ("plane", dam_break_2d(0.5))] {
        check(what, &scene, &start(&scene), 40);
    }
    // as few planes as there can be, an odd and an even number of them: they wrap, and the last one looks at the first
    for count in [3, 4, 5] {
        let mut scene = dam_break(0.4);
        scene.grid.cells = [count; 3];
        check("a small grid", &scene, &start(&scene), 20);
    }
    // one, and none beside it
    let scene = dam_break(0.4);
    check("one particle", &scene, &start(&scene)[..1], 20);
}

#[test]
fn its_bits_are_the_same_in_a_crowd() {
    // more neighbours than fit at once, and more candidates
    for crowd in [600, 1100] {
        let scene = Scene { time_step: 1e-12, ..dam_break(0.3) };
        let mut places = start(&scene);
        let first = places[0];
        places.extend((0..crowd).map(|i| {
            let offset = |n: usize| (i * n % 97) as f32 / 97.0 * 0.5 * scene.particle_spacing;
            let [x, y, z] = first.position;
            InitialParticle { position: [x + offset(7), y + offset(11), z + offset(13)], ..first }
        }));
        check("a crowd", &scene, &places, 1);
    }
}

/// Densities and accelerations of the particles, by id, before the first step.
fn evaluated(scene: &Scene) -> Vec<([f64; 3], f64)> {
    let mut heap = OwnedMemory::of(&support::checked(scene));
    let solver = Solver::new(scene, heap.lend()).expect("a scene");
    let state = solver.state();
    let of = |slot: usize| (state.acceleration[slot], state.density_pressure[slot][0]);
    let slots = solver.slots().iter().map(|&slot| of(slot as usize));
    slots.map(|([x, y, z, _], deviation)| ([x, y, z].map(f64::from), f64::from(deviation))).collect()
}

#[test]
fn it_computes_what_the_full_stencil_does() {
    for mut scene in [dam_break(0.4), dam_break_2d(0.5)] {
        scene.blocks[0].jitter = 0.3;
        for force in [PressureForce::Mueller, PressureForce::Monaghan] {
            scene.model.pressure_force = force;
            let (full, half) = (evaluated(&scene), evaluated(&half(&scene)));
            let largest = full.iter().flat_map(|(a, _)| a.map(f64::abs)).fold(0.0, f64::max);
            let mut differ = 0;
            for ((a, rho), (b, rho_half)) in full.iter().zip(&half) {
                // each sum is rounded once a neighbour, of which none has more than 60: 60 * 2^-24 of what is summed
                assert!((rho - rho_half).abs() < 4e-6 * (1.0 + rho.abs()), "{rho} and {rho_half}");
                // pressure follows the density by a power of 7, times a speed of sound that is large
                for (x, y) in a.iter().zip(b) {
                    assert!((x - y).abs() < 2e-4 * largest, "{force:?}: {a:?} and {b:?}, of {largest}");
                }
                differ += u32::from(a != b);
            }
            assert!(differ > 0, "in another order some sums end in other digits");
        }
    }
}

#[test]
fn what_it_adds_to_one_it_takes_from_the_other() {
    // by itself in space, so that nothing but pairs acts
    let mut scene = half(&dam_break(0.4));
    (scene.gravity, scene.container) = ([0.0; 3], None);
    scene.blocks[0].jitter = 0.3;
    assert_eq!(scene.dimension, Dimension::Three);
    let mut heap = OwnedMemory::of(&support::checked(&scene));
    let mut solver = Solver::new(&scene, heap.lend()).expect("a scene");
    (0..100).for_each(|_| solver.step(&Serial).expect("a step"));
    let speeds: Vec<[f64; 3]> = solver.particles().map(|p| p.velocity.to_array().map(f64::from)).collect();
    for axis in 0..3 {
        let sum: f64 = speeds.iter().map(|v| v[axis]).sum();
        let passed: f64 = speeds.iter().map(|v| v[axis].abs()).sum();
        assert!(passed > 1.0, "it moves");
        // rounded once a pair and once a sum, at random, 100 times
        assert!(sum.abs() < 3e-6 * passed, "{sum} of {passed} along axis {axis}");
    }
}
