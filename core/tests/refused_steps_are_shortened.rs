//! Promise: a scene that says so has a step that cannot be made tried again with half of its time step, as often as it
//! says, and counts it. A scene in which no step is ever refused keeps the bits that it has without; a step that fails
//! at its shortest is refused as ever, with the fluid as it was.
//!
//! That a device does the same is for `gpu/tests/refused_steps_are_shortened.rs`.
use millpond_core::scene::Recovery;
use millpond_core::{OwnedMemory, Serial, Solver, StepError};

mod support;
use support::dam_break_2d;
use support::falling::{falling, leaving};

#[test]
fn a_step_that_fails_is_made_with_half_of_its_length() {
    let mut scene = leaving();
    let mut heap = OwnedMemory::of(&scene.check().expect("a scene"));
    let refused = Solver::new(&scene, heap.lend()).expect("a scene").step(&Serial);
    assert!(matches!(refused, Err(StepError::OutOfRange { .. })), "{refused:?}");

    scene.recovery = Recovery::ShortenStep { times: 5 };
    let mut solver = Solver::new(&scene, heap.lend()).expect("a scene");
    solver.step(&Serial).expect("a shorter step");
    let clock = solver.time_report();
    assert_eq!(
        (clock.halvings, clock.time_step, clock.next),
        (1, 1e-3, 2e-3),
        "the next one has its full length again"
    );
    assert_eq!(solver.time(), f64::from(1e-3f32));
    solver.step(&Serial).expect("a much shorter step");
    // full steps cover 1.5 of the range: the first half of one 0.75 of it, then an eighth fits, then a 32nd
    assert_eq!(solver.time_report().halvings, 1 + 3);
    solver.step(&Serial).expect("the shortest step that there is");
    assert_eq!(solver.time_report().halvings, 1 + 3 + 5);
    let before = (solver.full_hash(), solver.time_report());
    let refused = solver.step(&Serial).expect_err("a 64th would fit");
    assert!(matches!(refused, StepError::OutOfRange { .. }), "{refused}");
    assert_eq!((solver.full_hash(), solver.time_report()), before, "the fluid is as it was");
    assert_eq!(solver.step(&Serial), Err(refused), "and again");
}

#[test]
fn steps_that_never_fail_keep_their_bits() {
    for scene in [dam_break_2d(0.5), falling()] {
        let hashes = [Recovery::Refuse, Recovery::ShortenStep { times: 5 }].map(|recovery| {
            let mut scene = scene.clone();
            scene.recovery = recovery;
            let mut heap = OwnedMemory::of(&scene.check().expect("a scene"));
            let mut solver = Solver::new(&scene, heap.lend()).expect("a scene");
            (0..200).for_each(|_| solver.step(&Serial).expect("a step"));
            (solver.full_hash(), (solver.time() * 1e6).round())
        });
        assert_eq!(hashes[0], hashes[1]);
    }
}
