//! Promise: the comparison of states detects a single value that is off by one unit in the last place, wherever it is.
//! A device that promises no bits may deviate by 1 % of the spacing and of the speed of sound, and by no more.
use millpond::compare::{Difference, Paths, PerQuantity, compare, difference, ulp_distance};
use millpond::run_length::RunLength;
use millpond::snapshot::Snapshot;
use millpond_core::OwnedMemory;
use millpond_core::{Array, Serial, Solver};
use millpond_gpu::Mode;

mod support;
use support::device;

/// Returns the state of a moving fluid.
fn state() -> Snapshot {
    let mut scene = support::scaled("dam-break", 300).file.scene;
    support::with_penalty_planes(&mut scene);
    (scene.model.internal_energy, scene.model.surface_normals, scene.model.xsph) = (true, true, 0.2);
    let mut heap = OwnedMemory::of(&scene.check().expect("a scene"));
    let mut solver = Solver::new(&scene, heap.lend()).expect("a scene");
    (0..20).for_each(|_| solver.step(&Serial).expect("a step"));
    Snapshot::of_cpu(&solver)
}

#[test]
fn a_state_equals_itself() {
    assert_eq!(difference(&state(), &state()), None);
}

#[test]
fn one_ulp_in_any_value_of_any_array_is_seen() {
    let want = state();
    let arrays: Vec<Array> = Array::ALL.iter().copied().filter(|&array| !want.words(array).is_empty()).collect();
    assert!(arrays.contains(&Array::internal_energy) && arrays.len() > 5, "a state of many arrays: {arrays:?}");
    for array in arrays {
        let (entry, all) = (array.words(), want.words(array).len());
        for word in [0, 1, 17 * entry + entry - 1, all - 1] {
            let mut other = want.clone();
            other.words_mut(array)[word] += 1;
            let found = difference(&want, &other).expect("a difference");
            assert_eq!(found.arrays, [array]);
            let one = |of| u32::from(array == of);
            let max_ulp = PerQuantity { position: one(Array::position), velocity: one(Array::velocity) };
            assert_eq!(found.max_ulp, max_ulp, "{found:?}");
            assert!(found.first.contains(&format!("particle {}:", word / entry)), "{found:?}");
        }
    }
}

#[test]
fn the_hash_sees_one_ulp_of_a_place_or_a_velocity() {
    let want = state();
    for array in [Array::position, Array::velocity] {
        for id in [0, 17, want.position().len() - 1] {
            for axis in 0..3 {
                let mut other = want.clone();
                other.words_mut(array)[4 * id + axis] += 1;
                assert_ne!(want.hash(), other.hash());
            }
        }
    }
}

#[test]
fn swapped_missing_and_broken_particles_are_seen() {
    let want = state();
    let mut swapped = want.clone();
    let positions = swapped.words_mut(Array::position);
    (12..16).for_each(|word| positions.swap(word, word + 4));
    assert!(difference(&want, &swapped).is_some());

    let mut fewer = want.clone();
    for array in [Array::position, Array::velocity] {
        fewer.words_mut(array).truncate(40);
    }
    assert!(difference(&want, &fewer).is_some());

    let mut broken = want.clone();
    broken.words_mut(Array::velocity)[21] = f32::NAN.to_bits();
    let Difference { max_abs, .. } = difference(&want, &broken).expect("a difference");
    assert!(max_abs.velocity.is_nan(), "NaN wins");
    broken.words_mut(Array::velocity)[25] += 1;
    let Difference { max_abs, .. } = difference(&want, &broken).expect("a difference");
    assert!(max_abs.velocity.is_nan(), "NaN wins, whatever comes after it");

    let mut signed = want.clone();
    signed.words_mut(Array::velocity)[22] = 0.0f32.to_bits();
    let mut negative = signed.clone();
    negative.words_mut(Array::velocity)[22] = (-0.0f32).to_bits();
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
    let clean = compare(&named, RunLength::Steps(8), &paths, &mut |_, _| ()).expect("a comparison");
    assert!(clean.kept() && clean.pairs.iter().all(|p| p.bit_equal));

    let mut tamper = |step: u64, state: &mut Snapshot| {
        if step == 5 {
            state.words_mut(Array::velocity)[29] += 1;
        }
    };
    let told = compare(&named, RunLength::Steps(8), &paths, &mut tamper).expect("a comparison");
    assert!(!told.kept());
    let [meddled, others @ ..] = &told.pairs[..] else { panic!("no pairs") };
    assert_eq!((meddled.bit_equal, meddled.first_divergent_step, meddled.max_ulp.velocity), (false, Some(5), 1));
    assert!(others.iter().all(|p| p.bit_equal) && !others.is_empty());
}

#[test]
fn compare_tells_of_a_plain_device_that_strays_by_more_than_one_percent() {
    // the device must be one that promises no bits; its arithmetic deviates by about 1e-6 of the spacing and of the
    // speed of sound in three steps
    for (share, kept) in [(0.99, true), (1.01, false)] {
        for array in [Array::position, Array::velocity] {
            let Some(gpu) = device("comparators_can_fail", Mode::Plain) else { return };
            let named = support::scaled("dam-break-2d", 200);
            let scene = &named.file.scene;
            let whole = if array == Array::position { scene.particle_spacing } else { scene.fluids[0].speed_of_sound };
            let by = share * 0.01 * whole;
            let mut tamper = |step: u64, state: &mut Snapshot| {
                if step == 2 {
                    let word = &mut state.words_mut(array)[4 * 29 + 1];
                    *word = (f32::from_bits(*word) + by).to_bits();
                }
            };
            let paths = Paths { cpu: false, threads: 1, devices: vec![gpu] };
            let told = compare(&named, RunLength::Steps(3), &paths, &mut tamper).expect("a comparison");
            let [pair] = &told.pairs[..] else { panic!("{} pairs", told.pairs.len()) };
            assert!(!pair.promised && !pair.bit_equal && pair.differing_arrays.contains(&array.name()), "{pair:?}");
            assert_eq!((pair.within_tolerance, told.kept()), (kept, kept), "{} by {by}: {pair:?}", array.name());
        }
    }
}
