//! Promise: a scene gives the same bits on the scalar path, at every SIMD level, on 1, 2 and 3 threads, with both grid
//! structures and other grid sizes, and with and without neighbour lists. The best SIMD level on two threads is
//! compared for 500 steps, all other paths for 125.
//!
//! The hash after every step is compared, so that a failure names the first step that differs.
use millpond_core::scene::{GridStructure, Scene};
use millpond_core::{OwnedMemory, Plan, Requirements, Simd, Solver};

mod support;
use support::{Threads, dam_break, dam_break_2d, thesis_cube};

fn hashes(scene: &Scene, plan: &Plan, simd: Simd, threads: usize, list: bool, steps: usize) -> Vec<u64> {
    let scene = support::checked(scene);
    let mut heap = OwnedMemory::with(&Requirements::by_plan(&scene, plan));
    let memory = heap.lend().with_neighbour_words(if list { usize::MAX } else { 0 });
    let (count, places) = (scene.derived().particles(), scene.initial_particles());
    let solver = Solver::with_particles(&scene, *plan, count, places, memory).expect("a scene");
    let mut solver = solver.at_level(simd);
    (0..steps)
        .map(|_| {
            solver.step(&Threads(threads)).expect("a step");
            solver.hash()
        })
        .collect()
}

/// Asserts equality and names the first step that differs.
fn same(what: &str, want: &[u64], got: &[u64]) {
    let first = want.iter().zip(got).position(|(a, b)| a != b);
    assert_eq!((first.map(|i| i + 1), want.len()), (None, got.len()), "first differing step of: {what}");
}

fn check(scene: &Scene, steps: usize) {
    let plan = Plan::of(&support::checked(scene));
    let want = hashes(scene, &plan, Simd::Scalar, 1, true, steps);
    assert_ne!(want[0], want[steps - 1], "a fluid that does not move tests nothing");
    // paths that differ would differ soon, so only one path is followed to the end
    let few = steps / 4;
    let start = &want[..few];
    assert_ne!(start[0], start[few - 1], "nor does one that does not move so far");
    for simd in Simd::available().skip(1) {
        same(&format!("lanes, {simd:?}"), start, &hashes(scene, &plan, simd, 1, true, few));
    }
    same("lanes, 2 threads", &want, &hashes(scene, &plan, Simd::detect(), 2, true, steps));
    same("lanes, 3 threads", start, &hashes(scene, &plan, Simd::detect(), 3, true, few));
    same("no neighbour lists", start, &hashes(scene, &plan, Simd::detect(), 1, false, few));
    let mut other = scene.clone();
    other.grid.structure = GridStructure::CellLists { places: 64 };
    same("cell lists", start, &hashes(&other, &Plan::of(&support::checked(&other)), Simd::detect(), 2, true, few));
    other.grid.structure = GridStructure::IndexSort;
    other.grid.cells = other.grid.cells.map(|n| if n == 1 { 1 } else { 5 });
    same("a grid that wraps", start, &hashes(&other, &plan, Simd::detect(), 2, true, few));
}

#[test]
fn for_500_steps_of_a_dam_break() {
    check(&dam_break(0.523), 500);
}

#[test]
fn for_500_steps_of_the_thesis_cube() {
    check(&thesis_cube(0.5), 500);
}

#[test]
fn for_500_steps_in_the_plane() {
    check(&dam_break_2d(0.5), 500);
}

#[test]
fn with_every_term_that_the_plan_leaves_out() {
    let check = |name: &str, scene: &Scene| {
        let known = support::checked(scene);
        let [plan, everything] = [Plan::of(&known), Plan::everything(&known)];
        assert_ne!(plan, everything, "{name} leaves something out");
        let want = hashes(scene, &plan, Simd::detect(), 1, true, 100);
        same(name, &want, &hashes(scene, &everything, Simd::detect(), 1, true, 100));
    };
    check("dam break", &dam_break(0.3625));
    check("thesis cube", &thesis_cube(0.5));
    check("in the plane", &dam_break_2d(0.56));
}
