//! Promise: `advance` makes the steps that fit into the time asked for, and only steps that `step` would make. It
//! carries the rest into the next call, and drops the time for which the caller allows no steps, saying so.
//! `step_until` shortens the last one or two steps to land on a time, where steps can change, and then goes on as
//! before. The clock goes on however long the fluid has run.
//!
//! `gpu/tests/time_is_advanced.rs` checks that a device makes the same steps.
use millpond_core::backend::terms::time_step::{clock_after, clock_lost};
use millpond_core::glam::Vec3;
use millpond_core::scene::{AdaptiveTimeStep, Recovery, Scene};
use millpond_core::{OwnedMemory, Serial, Solver, StepError};

mod support;
use support::dam_break_2d;
use support::falling::{falling, impact, leaving};

fn with_solver<R>(scene: &Scene, run: impl FnOnce(&mut Solver<'_>) -> R) -> R {
    let mut heap = OwnedMemory::of(&scene.check().expect("a scene"));
    run(&mut Solver::new(scene, heap.lend()).expect("a scene"))
}

/// Returns the hash of the state after this number of plain steps.
fn hash_after(scene: &Scene, steps: u64) -> u64 {
    with_solver(scene, |solver| {
        (0..steps).for_each(|_| solver.step(&Serial).expect("a step"));
        solver.full_hash()
    })
}

#[test]
fn frames_of_any_length_make_the_same_steps() {
    let scenes: [fn() -> Scene; 3] = [|| dam_break_2d(0.5), falling, impact];
    for scene in scenes {
        let scene = scene();
        // 0.2 s in frames of a game, in frames shorter than a step, and in a single frame
        for frame in [1.0 / 60.0, 1e-4, 0.2] {
            let (steps, time, hash) = with_solver(&scene, |solver| {
                let mut steps = 0;
                for _ in 0..(0.2f64 / frame).round() as u32 {
                    let advance = solver.advance(frame, 100_000, &Serial).expect("steps");
                    let next = f64::from(solver.time_report().next);
                    assert!(advance.remainder < next && advance.remainder > -1e-3 * next, "{advance:?}, {next}");
                    assert!(advance.dropped == 0.0);
                    steps += u64::from(advance.steps);
                }
                assert_eq!(steps, solver.steps());
                (steps, solver.time(), solver.full_hash())
            });
            assert!((0.2 - time).abs() < 0.01, "{time} s");
            assert_eq!(hash, hash_after(&scene, steps), "frames of {frame} s");
        }
    }
}

#[test]
fn ten_steps_of_a_600th_fit_into_a_60th() {
    let mut scene = dam_break_2d(0.5);
    scene.time_step = 1.0 / 600.0;
    scene.fluids[0].speed_of_sound = 3.0;
    with_solver(&scene, |solver| {
        for frame in 0..30 {
            let advance = solver.advance(1.0 / 60.0, 100, &Serial).expect("steps");
            assert_eq!(advance.steps, 10, "frame {frame}: rounding never makes it nine or eleven");
        }
    });
}

#[test]
fn time_beyond_the_steps_allowed_is_given_up_and_said() {
    let scene = dam_break_2d(0.5);
    let dt = f64::from(scene.time_step);
    with_solver(&scene, |solver| {
        let advance = solver.advance(10.4 * dt, 4, &Serial).expect("steps");
        assert_eq!((advance.steps, solver.steps()), (4, 4));
        assert!(
            (advance.dropped - 6.0 * dt).abs() < 1e-9 && (advance.remainder - 0.4 * dt).abs() < 1e-9,
            "{advance:?}"
        );
        // a remainder of less than a step is not dropped
        assert_eq!(solver.advance(0.7 * dt, 4, &Serial).expect("steps").steps, 1);
        assert_eq!(solver.advance(0.0, 4, &Serial).expect("no steps").steps, 0);
        // steps that the caller makes with `step` count as requested
        (0..5).for_each(|_| solver.step(&Serial).expect("a step"));
        assert_eq!(solver.advance(2.0 * dt, 9, &Serial).expect("steps").steps, 2);
    });
}

#[test]
fn a_time_is_landed_on() {
    let scene = falling();
    with_solver(&scene, |solver| {
        for frame in 1..=12 {
            let time = f64::from(frame) / 60.0;
            let advance = solver.step_until(time, 1000, &Serial).expect("steps");
            let step = f64::from(solver.time_report().time_step);
            assert!((solver.time() - time).abs() <= 1e-6 * step, "{time} s: {advance:?}");
            assert!(advance.steps > 0);
            assert_eq!(solver.step_until(time, 1000, &Serial).expect("it is there").steps, 0);
        }
    });
    // a fixed time step is not shortened
    let scene = dam_break_2d(0.5);
    let dt = f64::from(scene.time_step);
    with_solver(&scene, |solver| {
        let advance = solver.step_until(7.5 * dt, 1000, &Serial).expect("steps");
        assert_eq!(advance.steps, 7);
        assert!((advance.remainder - 0.5 * dt).abs() < 1e-9, "{advance:?}");
        assert_eq!(solver.full_hash(), hash_after(&scene, 7));
    });
}

#[test]
fn a_fluid_lands_on_every_frame_of_a_long_run_with_as_few_steps() {
    // nothing moves, so that every step is as long as it may be
    for is_adaptive in [true, false] {
        let mut scene = falling();
        scene.gravity = Vec3::ZERO;
        scene.blocks[0].velocity = Vec3::ZERO;
        scene.blocks[0].size = Vec3::new(0.025, 0.025, 0.0);
        scene.time_step = 5e-4;
        if is_adaptive {
            let none = AdaptiveTimeStep {
                speed: Some(0.15),
                sound: None,
                acceleration: None,
                viscosity: None,
                ..AdaptiveTimeStep::default()
            };
            scene.adaptive = Some(AdaptiveTimeStep { largest: 5e-4, ..none });
        } else {
            (scene.adaptive, scene.recovery) = (None, Recovery::ShortenStep { times: 3 });
        }
        with_solver(&scene, |solver| {
            for frame in 1..=1800 {
                let time = f64::from(frame) / 60.0;
                let advance = solver.step_until(time, 1000, &Serial).expect("steps");
                assert!((solver.time() - time).abs() <= 1e-9, "{time} s: {advance:?}");
                // 33.3 steps: 32 of full length and two shortened ones
                assert!((33..=36).contains(&advance.steps), "{time} s: {advance:?}");
            }
        });
    }
}

#[test]
fn the_clock_goes_on_where_a_step_is_less_than_its_last_digit() {
    // an f32 cannot tell 512 s from 512 s and 1e-5 s
    let (step, steps, mut clock, mut lost) = (1e-5f32, 200_000, 512f32, 0f32);
    assert_eq!(clock + step, clock);
    for _ in 0..steps {
        let after = clock_after::<f32>(clock, lost, step);
        (clock, lost) = (after, clock_lost::<f32>(clock, lost, step, after));
    }
    let time = f64::from(clock) + f64::from(lost);
    // the second number is rounded once a step, and is at most half of the last digit of 512, 2^-15
    let rounding = f64::from(steps) * 2f64.powi(-15 - 25);
    assert!((time - 512.0 - f64::from(steps) * f64::from(step)).abs() <= rounding, "{time} s");
}

#[test]
fn a_step_that_is_refused_on_the_way_leaves_the_next_one_as_it_was() {
    let mut scene = leaving();
    // so lenient a criterion that the first step is as long as the scene says
    let criteria = AdaptiveTimeStep { acceleration: None, sound: None, viscosity: None, ..AdaptiveTimeStep::default() };
    scene.adaptive = Some(AdaptiveTimeStep { speed: Some(1e8), ..criteria });
    with_solver(&scene, |solver| {
        let before = (solver.full_hash(), solver.time_report());
        assert_eq!(before.1.next, scene.time_step);
        solver.step_until(1.0, 100, &Serial).expect_err("it leaves the range");
        assert_eq!((solver.full_hash(), solver.time_report()), before);
        // nor does one that was shortened to land
        solver.step_until(1.9e-3, 100, &Serial).expect_err("it leaves the range");
        assert_eq!((solver.full_hash(), solver.time_report()), before);
    });
}

#[test]
fn times_that_cannot_be_are_refused() {
    with_solver(&dam_break_2d(0.5), |solver| {
        solver.step(&Serial).expect("a step");
        let before = solver.full_hash();
        for seconds in [-1.0, f64::NAN, f64::INFINITY] {
            let same =
                |error| matches!(error, Err(StepError::InvalidTime { seconds: s }) if s.to_bits() == seconds.to_bits());
            assert!(same(solver.advance(seconds, 9, &Serial)) && same(solver.step_until(seconds, 9, &Serial)));
        }
        assert!(solver.step_until(0.0, 9, &Serial).is_err(), "it has passed");
        assert_eq!((solver.full_hash(), solver.steps()), (before, 1));
    });
}
