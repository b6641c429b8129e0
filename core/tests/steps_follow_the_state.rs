//! Promise: an adaptive time step is as long as its criteria allow for the state and grows no faster than its limit. A
//! step that was too long is made again where the scene asks for that, and counted where it cannot be short enough.
//! Integrators have their order of accuracy from the first step on. (`gpu/tests/clocks_agree.rs` checks that a device's
//! clock agrees.)
use approx::assert_relative_eq;
use millpond_core::OwnedMemory;
use millpond_core::backend::derive::{speed_of_sound, support_radius};
use millpond_core::scene::{AdaptiveTimeStep, Fluid, GridStructure, InitialParticle, Integrator, Scene};
use millpond_core::{Array, Plan, Requirements, Serial, Solver, StepError, TimeReport};

mod support;
use support::falling::{falling, impact};
use support::{Words, checked};

/// Returns the time step that the criteria allow, computed once more in f64.
fn wanted(scene: &Scene, solver: &Solver<'_>) -> f64 {
    let adaptive = scene.adaptive.expect("an adaptive step");
    let state = solver.state();
    let length = |v: &[f32; 4]| v[..3].iter().map(|x| f64::from(*x).powi(2)).sum::<f64>().sqrt();
    let speed = state.velocity.iter().map(length).fold(0.0, f64::max);
    let acceleration = state.acceleration.iter().map(length).fold(0.0, f64::max);
    let densest = state.density_pressure.iter().map(|d| 1.0 + f64::from(d[0])).fold(0.0, f64::max);
    let sound = f64::from(scene.fluids[0].speed_of_sound) * densest.powi(3);
    let support = support_radius(scene);
    let nu = f64::from(scene.fluids[0].dynamic_viscosity / scene.fluids[0].rest_density);
    let limits = [
        adaptive.speed.map(|c| f64::from(c) * support / speed),
        adaptive.acceleration.map(|c| f64::from(c) * (support / acceleration).sqrt()),
        adaptive.sound.map(|c| f64::from(c) * support / sound),
        adaptive.viscosity.map(|c| f64::from(c) * support * support / nu),
    ];
    limits.into_iter().flatten().fold(f64::INFINITY, f64::min)
}

#[test]
fn each_step_is_what_its_criteria_ask_for() {
    for scene in [falling(), impact()] {
        let adaptive = scene.adaptive.expect("an adaptive step");
        let mut heap = OwnedMemory::of(&scene.check().expect("a scene"));
        let mut solver = Solver::new(&scene, heap.lend()).expect("a scene");
        let mut sum = 0.0;
        let mut lengths = Vec::new();
        for _ in 0..300 {
            let before = solver.time_report();
            solver.step(&Serial).expect("a step");
            let after = solver.time_report();
            // about a dozen f32 roundings
            assert_relative_eq!(f64::from(after.wanted), wanted(&scene, &solver), max_relative = 1e-6);
            let limit = (after.time_step * adaptive.max_growth).min(adaptive.largest);
            assert_eq!(after.next, after.wanted.min(limit).max(adaptive.smallest));
            assert!(
                after.rejected_steps > before.rejected_steps || after.time_step == before.next,
                "{before:?}, {after:?}"
            );
            sum += f64::from(after.time_step);
            lengths.push(after.time_step);
            // the clock keeps the rounding error of its f32 time, about 2^-24 of the time, in a second f32, which loses
            // 2^-24 of it per step
            assert_relative_eq!(solver.time(), sum, max_relative = 300.0 * 2f64.powi(-48));
        }
        lengths.sort_by(f32::total_cmp);
        assert!(lengths[299] > 1.2 * lengths[0], "a step that never changes tests little");
    }
}

#[test]
fn the_first_step_obeys_too() {
    let mut scene = falling();
    scene.time_step = 0.01;
    let mut heap = OwnedMemory::of(&scene.check().expect("a scene"));
    let solver = Solver::new(&scene, heap.lend()).expect("a scene");
    assert_relative_eq!(f64::from(solver.time_report().next), wanted(&scene, &solver), max_relative = 1e-6);
}

#[test]
fn a_step_that_was_too_long_is_made_again() {
    let scene = impact();
    let run = |scene: &Scene| {
        let mut heap = OwnedMemory::of(&scene.check().expect("a scene"));
        let mut solver = Solver::new(scene, heap.lend()).expect("a scene");
        let mut too_long = 0;
        for _ in 0..300 {
            solver.step(&Serial).expect("a step");
            let clock = solver.time_report();
            too_long += u32::from(clock.time_step > clock.wanted);
        }
        (too_long, solver.time_report())
    };
    let (too_long, clock) = run(&scene);
    assert!(clock.rejected_steps > 10 && clock.clamped_steps == 0, "{clock:?}");
    assert_eq!(too_long, 0, "a step that counts keeps the condition");
    let mut lax = scene;
    lax.adaptive = lax.adaptive.map(|adaptive| AdaptiveTimeStep { reject_ratio: None, ..adaptive });
    let (too_long, clock) = run(&lax);
    assert!(too_long > 0 && clock.rejected_steps == 0, "without that choice {too_long} steps were too long");
}

#[test]
fn a_step_that_cannot_be_short_enough_is_counted() {
    let mut scene = falling();
    scene.adaptive =
        scene.adaptive.map(|adaptive| AdaptiveTimeStep { smallest: 1e-3, reject_ratio: Some(1.0), ..adaptive });
    let mut heap = OwnedMemory::of(&scene.check().expect("a scene"));
    let mut solver = Solver::new(&scene, heap.lend()).expect("a scene");
    (0..20).for_each(|_| solver.step(&Serial).expect("a step"));
    let TimeReport { time_step, clamped_steps: held, rejected_steps, .. } = solver.time_report();
    assert_eq!((time_step, held, rejected_steps), (1e-3, 20, 0));
}

#[test]
fn a_refused_step_leaves_the_clock_alone() {
    let mut undone = 0;
    // from as many places as the fullest cell needs at the start upwards: some steps are undone before one is refused
    for places in 12..18 {
        let mut scene = impact();
        scene.grid.structure = GridStructure::CellLists { places };
        let mut heap = OwnedMemory::of(&scene.check().expect("a scene"));
        let mut solver = Solver::new(&scene, heap.lend()).expect("a scene");
        let (before, refused) = loop {
            let before = Words::of_cpu(&solver);
            if let Err(error) = solver.step(&Serial) {
                break (before, error);
            }
            assert!(solver.steps() < 1000, "no cell was ever full");
        };
        assert!(matches!(refused, StepError::CellFull { capacity, .. } if capacity == places), "{refused}");
        assert!(Words::of_cpu(&solver) == before);
        undone += before.clock.rejected_steps;
    }
    assert!(undone > 0, "steps that are made again");
}

#[test]
fn the_lighter_of_two_fluids_is_moved_the_more() {
    let mut scene = falling();
    scene.fluids[0].dynamic_viscosity = 100.0;
    assert_relative_eq!(checked(&scene).derived().kinematic_viscosity, 0.1);
    scene.add_fluid(Fluid { rest_density: 1.0, dynamic_viscosity: 0.0, ..Fluid::default() }).expect("room for a fluid");
    // at the interface the mean of 100 and 0 Pa s acts on 1 kg/m3
    assert_relative_eq!(checked(&scene).derived().kinematic_viscosity, 50.0);
}

#[test]
fn stiffness_follows_a_wanted_step() {
    let mut scene = falling();
    (scene.adaptive, scene.stiffness_for_time_step, scene.time_step) = (None, Some(0.2), 5e-4);
    scene.add_fluid(Fluid { speed_of_sound: 5.0, ..Fluid::default() }).expect("room for a fluid");
    let fastest = 0.2 * support_radius(&scene) / 5e-4;
    assert_relative_eq!(speed_of_sound(&scene, &scene.fluids[0]), fastest, max_relative = 1e-6);
    assert_relative_eq!(speed_of_sound(&scene, &scene.fluids[1]), fastest / 4.0, max_relative = 1e-6);
    let mut heap = OwnedMemory::of(&scene.check().expect("a scene"));
    let solver = Solver::new(&scene, heap.lend()).expect("a scene");
    assert_relative_eq!(solver.courant(scene.time_step).sound, 0.2, max_relative = 0.02);
}

#[test]
fn a_thrown_particle_keeps_to_its_parabola() {
    const STEPS: u32 = 64;
    for &integrator in Integrator::ALL {
        let mut scene = falling();
        scene.adaptive = None;
        scene.container = None;
        scene.model.integrator = integrator;
        scene.time_step = 1.0 / 64.0;
        let mut heap = OwnedMemory::with(&Requirements::of(&checked(&scene)).for_particles(1));
        let thrown = [InitialParticle::at([0.25, 0.5, 0.0], [0.5, 2.0, 0.0])];
        let scene = checked(&scene);
        let plan = Plan::of(&scene);
        let mut solver = Solver::with_particles(&scene, plan, 1, thrown, heap.lend()).expect("a scene");
        (0..STEPS).for_each(|_| solver.step(&Serial).expect("a step"));
        let particle = solver.particles().next().expect("a particle");
        let (g, dt) = (-9.81, f64::from(scene.time_step));
        let t = f64::from(STEPS) * dt;
        // an integrator of order 1 is half a step ahead or behind, and the height is off by half of g dt t; from order
        // 2 on the height is exact
        let ahead = match integrator {
            Integrator::Euler => -0.5,
            Integrator::SemiImplicitEuler | Integrator::Clavet => 0.5,
            _ => 0.0,
        };
        let height = 0.5 + 2.0 * t + 0.5 * g * t * t + ahead * g * dt * t;
        // 64 sums of numbers up to 3, each off by half a unit in the last place of f32
        let near = |a: f32, b: f64| assert_relative_eq!(f64::from(a), b, epsilon = 64.0 * 1.2e-7);
        near(particle.position.y, height);
        near(particle.velocity.y, 2.0 + g * t);
        near(particle.position.x, 0.25 + 0.5 * t);
    }
}

#[test]
fn only_what_remembers_has_memory_for_it() {
    use Integrator::*;
    let has = |needs: &Requirements, array| needs.bytes_of(array) > 0;
    for &integrator in Integrator::ALL {
        let mut scene = falling();
        scene.adaptive = None;
        scene.model.integrator = integrator;
        let needs = Requirements::of(&checked(&scene));
        let history = matches!(integrator, Verlet | Beeman | VelocityCorrectedBeeman | PositionCorrectedBeeman);
        assert_eq!(has(&needs, Array::history), history, "{integrator:?}");
        assert_eq!(
            has(&needs, Array::start_acceleration),
            history || matches!(integrator, VelocityVerlet | Leapfrog),
            "{integrator:?}"
        );
        assert!(!has(&needs, Array::end_velocity));
        scene.model.xsph = 0.1;
        assert!(has(&Requirements::of(&checked(&scene)), Array::end_velocity));
    }
}
