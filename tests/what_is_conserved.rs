//! Promise: what a choice conserves, it conserves. Forms in which pairs act on each other alike keep momentum, to the
//! rounding of single precision; with thermal energy kept account of, the sum of all energies strays with the square of
//! the time step; an even motion of everything changes nothing.
use millpond::memory::Heap;
use millpond_core::guided::particle_mass;
use millpond_core::scene::{
    Block, DensityForm, Dimension, Evaluation, Fluid, Grid, Kernel, ModelChoice, NearPressure, Periodic, PressureForce,
    Scene, Viscosity,
};
use millpond_core::{Serial, Solver};

/// A jittered drop that collides with another, by itself in space.
fn collision(model: ModelChoice) -> Scene {
    let fluid = Fluid { dynamic_viscosity: 3.0, speed_of_sound: 15.0, ..Fluid::default() };
    let block = Block { size: [0.3, 0.4, 0.2], velocity: [1.0, 0.2, 0.0], jitter: 0.3, ..Block::default() };
    let mut scene = Scene::of(Dimension::Three, 0.05, 0.0005, fluid, block);
    let other = Block { corner: [0.33, 0.1, 0.05], velocity: [-1.0, 0.0, 0.1], ..block };
    let _ = scene.blocks.push(other);
    scene.model = model;
    scene.grid = Grid { cells: [8, 8, 8], ..Grid::default() };
    scene
}

fn momentum(scene: &Scene, solver: &Solver<'_>) -> [f64; 3] {
    let mass = particle_mass(scene);
    let sum = |axis: usize| solver.particles().map(|p| mass * f64::from(p.velocity[axis])).sum();
    [sum(0), sum(1), sum(2)]
}

#[test]
fn momentum_by_every_form_whose_pairs_act_alike() {
    let symmetric = [PressureForce::Mueller, PressureForce::Monaghan, PressureForce::NumberDensity];
    for pressure_force in symmetric {
        for viscosity in [Viscosity::Mueller, Viscosity::Morris, Viscosity::Artificial, Viscosity::Dotted] {
            for near_pressure in [NearPressure::Off, NearPressure::Thesis, NearPressure::Article] {
                let on_numbers = pressure_force == PressureForce::NumberDensity;
                let density = if on_numbers { DensityForm::NumberDensity } else { DensityForm::Summation };
                let viscosity_kernel = Kernel::CubicSpline;
                let model = ModelChoice {
                    pressure_force,
                    viscosity,
                    near_pressure,
                    density,
                    viscosity_kernel,
                    ..ModelChoice::default()
                };
                let scene = collision(model);
                let mut heap = Heap::of(&scene);
                let mut solver = Solver::new(&scene, heap.lend()).expect("a scene");
                let before = momentum(&scene, &solver);
                (0..100).for_each(|_| solver.step(&Serial).expect("a step"));
                let after = momentum(&scene, &solver);
                // 384 particles of 0.125 kg at 1 m/s: 48 kg m/s pass between them. Each force is rounded once a pair and
                // once a sum, 6e-8 of itself, at random: 100 steps leave some 1e-6 of what was passed.
                let strayed = (0..3).map(|i| (after[i] - before[i]).abs()).fold(0.0, f64::max);
                assert!(strayed < 48.0 * 3e-6, "{pressure_force:?} {viscosity:?} {near_pressure:?}: {strayed} kg m/s");
            }
        }
    }
}

#[test]
fn energy_to_the_order_of_the_integrator() {
    for viscosity in
        [Viscosity::Mueller, Viscosity::Morris, Viscosity::Artificial, Viscosity::Dotted, Viscosity::Exchange]
    {
        let model = ModelChoice {
            thermal_energy: true,
            viscosity,
            density_kernel: Kernel::WendlandC2,
            pressure_kernel: Kernel::WendlandC2,
            viscosity_kernel: Kernel::WendlandC2,
            pressure_force: PressureForce::Monaghan,
            ..ModelChoice::default()
        };
        let strayed = |refinement: u16| {
            let mut scene = collision(model);
            scene.gravity = [0.0, -9.81, 0.0];
            scene.time_step = 0.0008 / f32::from(refinement);
            // a share a step: the same a second
            scene.fluid.velocity_exchange = 0.04 / f32::from(refinement);
            let mut heap = Heap::of(&scene);
            let mut solver = Solver::new(&scene, heap.lend()).expect("a scene");
            let total = |solver: &Solver<'_>| {
                let e = solver.energies();
                e.kinetic + e.internal + e.potential
            };
            let before = total(&solver);
            let kinetic = solver.energies().kinetic;
            (0..100 * refinement).for_each(|_| solver.step(&Serial).expect("a step"));
            (total(&solver) - before).abs() / kinetic
        };
        let (coarse, fine) = (strayed(1), strayed(4));
        // second order is 16 times less, but for the terms after it and the rounding of single precision
        assert!(coarse < 5e-2 && fine < coarse / 8.0, "{viscosity:?}: {coarse:e}, by a fourth of the step {fine:e}");
    }
}

#[test]
fn an_even_motion_of_everything_is_no_motion() {
    // a full periodic box drifts by whole spacings; nothing may act
    let block = Block { size: [0.4, 0.4, 0.0], velocity: [1.0, -0.5, 0.0], ..Block::default() };
    let water = Fluid { dynamic_viscosity: 1.0, xsph: 0.5, ..Fluid::default() };
    let mut scene = Scene::of(Dimension::Two, 0.025, 0.001, water, block);
    scene.average_neighbours = 20.0;
    scene.periodic = Some(Periodic { low: [0.0; 3], high: [0.4, 0.4, 0.0], axes: [true, true, false] });
    for evaluation in [Evaluation::Direct, Evaluation::Table] {
        scene.model = ModelChoice { evaluation, ..ModelChoice::modern() };
        let mut heap = Heap::of(&scene);
        let mut solver = Solver::new(&scene, heap.lend()).expect("a scene");
        (0..200).for_each(|_| solver.step(&Serial).expect("a step"));
        let off = |p: millpond_core::solver::Particle| (p.velocity.x - 1.0).abs().max((p.velocity.y + 0.5).abs());
        let largest = solver.particles().map(off).fold(0.0, f32::max);
        // a lattice at rest has a pressure of its own, some 100 Pa, whose gradient is what rounding makes of 0
        assert!(largest < 1e-4, "{evaluation:?}: {largest} m/s");
        assert!(solver.particles().all(|p| (0.0..=0.4).contains(&p.position.x)), "inside the domain");
    }
}
