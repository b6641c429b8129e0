//! Promise: what compares states sees a single value that is off by one unit in the last place, wherever it is.
use millpond::compare::{Difference, Paths, PerQuantity, compare, difference, ulp_distance};
use millpond::fluid::Snapshot;
use millpond::memory::Heap;
use millpond::span::Span;
use millpond_core::{Serial, Solver};

mod support;

/// A moving fluid.
fn state() -> Snapshot {
    let scene = support::scaled("dam-break", 300).file.scene;
    let mut heap = Heap::of(&scene.check().expect("a scene"));
    let mut solver = Solver::new(&scene, heap.lend()).expect("a scene");
    (0..20).for_each(|_| solver.step(&Serial).expect("a step"));
    Snapshot::of_cpu(&solver)
}

#[test]
fn a_state_equals_itself() {
    assert_eq!(difference(&state(), &state()), None);
}

#[test]
fn one_ulp_in_any_value_is_seen() {
    let want = state();
    let last = want.position.len() - 1;
    for id in [0, 17, last] {
        for axis in 0..3 {
            let mut moved = want.clone();
            moved.position[id][axis] = moved.position[id][axis].next_up();
            let found = difference(&want, &moved).expect("a difference");
            assert_eq!(found.max_ulp, PerQuantity { position: 1, velocity: 0 });
            assert!(found.max_abs.position > 0.0 && found.first.contains(&format!("particle {id}:")), "{found:?}");
            assert_ne!(want.hash(), moved.hash());

            let mut pushed = want.clone();
            pushed.velocity[id][axis] = pushed.velocity[id][axis].next_down();
            let found = difference(&want, &pushed).expect("a difference");
            assert_eq!(found.max_ulp, PerQuantity { position: 0, velocity: 1 });
            assert_ne!(want.hash(), pushed.hash());
        }
    }
}

#[test]
fn swapped_missing_and_broken_particles_are_seen() {
    let want = state();
    let mut swapped = want.clone();
    swapped.position.swap(3, 4);
    assert!(difference(&want, &swapped).is_some());

    let mut fewer = want.clone();
    fewer.position.pop();
    fewer.velocity.pop();
    assert!(difference(&want, &fewer).is_some());

    let mut broken = want.clone();
    broken.velocity[5][1] = f32::NAN;
    let Difference { max_abs, .. } = difference(&want, &broken).expect("a difference");
    assert!(max_abs.velocity.is_nan(), "NaN wins");

    let mut signed = want.clone();
    signed.velocity[5][2] = 0.0;
    let mut negative = signed.clone();
    negative.velocity[5][2] = -0.0;
    assert!(difference(&signed, &negative).is_some(), "bits are compared, not values");
}

#[test]
fn ulps_count_floats() {
    assert_eq!(ulp_distance(1.0, 1.0), 0);
    assert_eq!(ulp_distance(1.0, 1.0 + f32::EPSILON), 1);
    assert_eq!(ulp_distance(-0.0, 0.0), 1);
    assert_eq!(ulp_distance(-f32::from_bits(1), f32::from_bits(1)), 3);
    assert_eq!(ulp_distance(f32::MIN, f32::MAX), u32::MAX - (1 << 24));
}

#[test]
fn compare_tells_of_one_ulp_in_one_step() {
    let named = support::scaled("dam-break-2d", 200);
    let paths = Paths { cpu: true, threads: 2, devices: Vec::new() };
    let clean = compare(&named, Span::Steps(8), &paths, &mut |_, _| ()).expect("a comparison");
    assert!(clean.kept() && clean.pairs.iter().all(|p| p.bit_equal));

    let mut meddle = |step: u64, state: &mut Snapshot| {
        if step == 5 {
            state.velocity[7][1] = state.velocity[7][1].next_up();
        }
    };
    let told = compare(&named, Span::Steps(8), &paths, &mut meddle).expect("a comparison");
    assert!(!told.kept());
    let [meddled, others @ ..] = &told.pairs[..] else { panic!("no pairs") };
    assert_eq!((meddled.bit_equal, meddled.first_divergent_step, meddled.max_ulp.velocity), (false, Some(5), 1));
    assert!(others.iter().all(|p| p.bit_equal) && !others.is_empty());
}
