//! Promise: the half stencil computes the same as the full stencil except for the order of summation. Densities and
//! accelerations agree to the rounding of these sums for every formula that a scene can choose, and momentum changes
//! by no more than rounding. The bits differ from those of the full stencil; they are the same at every SIMD level, on
//! any number of threads, with either grid structure, and with any number of particles in a cell.
use millpond_core::glam::Vec3;
use millpond_core::scene::{
    Block, DensityForm, Dimension, Fluid, Formulation, Grid, GridStructure, InitialParticle, Kernel, NearPressure,
    Periodic, PressureForce, Recipe, Scene, Traversal, Viscosity,
};
use millpond_core::{Checked, OwnedMemory, Pass, Plan, Requirements, Serial, Simd, Solver};

mod support;
use support::{Threads, dam_break, dam_break_2d, start, thesis_cube, with_a_crowd};

fn half(scene: &Scene) -> Scene {
    let mut half = scene.clone();
    half.grid.traversal = Traversal::HalfStencil;
    half
}

/// Returns the hash of the whole state after some steps.
fn hash(scene: &Scene, places: &[InitialParticle], simd: Simd, threads: usize, steps: usize) -> u64 {
    let scene = support::checked(scene);
    let mut heap = OwnedMemory::with(&Requirements::of(&scene).for_particles(places.len()));
    let plan = Plan::of(&scene);
    let solver = Solver::with_particles(&scene, plan, places.len(), places.iter().copied(), heap.lend());
    let mut solver = solver.expect("a scene").at_level(simd);
    (0..steps).for_each(|_| solver.step(&Threads(threads)).expect("a step"));
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

#[test]
fn its_bits_are_the_same_on_every_path() {
    let whole = |what: &str, scene: &Scene| check(what, scene, &start(scene), 40);
    whole("dam break", &dam_break(0.4));
    whole("cube", &thesis_cube(0.5));
    whole("plane", &dam_break_2d(0.5));
    // the smallest numbers of planes, odd and even: planes wrap, so the last plane has the first one ahead of it
    for count in [3, 4, 5] {
        let mut scene = dam_break(0.4);
        scene.grid.cells = [count; 3];
        check("a small grid", &scene, &start(&scene), 20);
    }
    // a particle without neighbours
    let scene = dam_break(0.4);
    check("one particle", &scene, &start(&scene)[..1], 20);
}

#[test]
fn its_bits_are_the_same_in_a_crowd() {
    let scene = Scene { time_step: 1e-12, ..dam_break(0.3) };
    // more neighbours than a list can hold, and then more candidates too: in these cases the cells are searched
    // instead
    for crowd in [600, 1100] {
        let places = with_a_crowd(&scene, start(&scene), crowd);
        check("a crowd", &scene, &places, 1);
        let all = evaluated(&scene, &places, Plan::of);
        agree("a crowd", &all, &evaluated(&half(&scene), &places, Plan::of), crowd);
    }
}

/// Returns the accelerations and the deviations of density of the particles before the first step, in the order of
/// their ids.
fn evaluated(scene: &Scene, places: &[InitialParticle], plan: fn(&Checked<'_>) -> Plan) -> Vec<([f64; 3], f64)> {
    let scene = support::checked(scene);
    let plan = plan(&scene);
    assert_eq!(
        plan.passes().any(|pass| pass == Pass::Neighbours),
        plan.model.is_half_stencil == 0 && !plan.model.sums_distances()
    );
    let mut heap = OwnedMemory::with(&Requirements::by_plan(&scene, &plan).for_particles(places.len()));
    let solver = Solver::with_particles(&scene, plan, places.len(), places.iter().copied(), heap.lend());
    let solver = solver.expect("a scene");
    let state = solver.state();
    let of = |slot: usize| (state.acceleration[slot], state.density_pressure[slot][0]);
    let slots = solver.slots().iter().map(|&slot| of(slot as usize));
    slots.map(|([x, y, z, _], deviation)| ([x, y, z].map(f64::from), f64::from(deviation))).collect()
}

/// Asserts that two evaluations differ, and by no more than the rounding of their sums.
fn agree(what: &str, full: &[([f64; 3], f64)], half: &[([f64; 3], f64)], neighbours: usize) {
    // a sum is rounded once per neighbour
    let rounding = neighbours as f64 * f64::from(f32::EPSILON) / 2.0;
    let largest = full.iter().flat_map(|(a, _)| a.map(f64::abs)).fold(0.0, f64::max);
    let mut differ = 0;
    for ((a, rho), (b, rho_half)) in full.iter().zip(half) {
        assert!((rho - rho_half).abs() <= rounding * (1.0 + rho), "{what}: {rho} and {rho_half}");
        // pressure depends on the seventh power of density at most, and both particles of a pair contribute one
        for (x, y) in a.iter().zip(b) {
            assert!((x - y).abs() <= 16.0 * rounding * largest, "{what}: {a:?} and {b:?}, of {largest}");
        }
        differ += u32::from(a != b);
    }
    assert!(differ > 0, "{what}: in another order some sums end in other digits");
}

/// Two jittered blocks that collide, in a domain that is periodic along x. The second one is of another fluid if its
/// rest density is given as `light`.
fn collision(light: Option<f32>) -> Scene {
    let fluid = Fluid { dynamic_viscosity: 3.0, speed_of_sound: 15.0, ..Fluid::default() };
    let block =
        Block { size: Vec3::new(0.3, 0.4, 0.2), velocity: Vec3::new(1.0, 0.2, 0.0), jitter: 0.3, ..Block::default() };
    let mut scene = Scene::of(Dimension::Three, 0.05, 0.0005, fluid, block);
    scene.average_neighbours = Some(32.0);
    scene.model = Formulation::of(Recipe::Pirovano);
    let mut other = Block { corner: Vec3::new(0.32, 0.1, 0.05), velocity: Vec3::new(-1.0, 0.0, 0.1), ..block };
    scene.periodic = Some(Periodic { low: Vec3::ZERO, high: Vec3::new(0.7, 1.0, 1.0), axes: [true, false, false] });
    if let Some(rest_density) = light {
        let light = Fluid { rest_density, speed_of_sound: 18.0, dynamic_viscosity: 1.0, ..scene.fluids[0] };
        scene.add_fluid(light).expect("room for a fluid");
        other.fluid = 1;
    }
    scene.add_block(other).expect("room for a block");
    scene.model.near_pressure = NearPressure::DoubleDensity;
    scene.grid = Grid { cells: [8; 3], ..Grid::default() };
    scene
}

#[test]
fn it_computes_what_the_full_stencil_does() {
    let one_sided = |force: &PressureForce| matches!(force, PressureForce::Canonical | PressureForce::Difference);
    let stepped = |form: &DensityForm| matches!(form, DensityForm::Continuity | DensityForm::ContinuityAdapted);
    let mut compared = 0;
    for light in [None, Some(700.0)] {
        for &density in DensityForm::ALL.iter().filter(|form| !stepped(form)) {
            for &pressure_force in PressureForce::ALL.iter().filter(|force| !one_sided(force)) {
                for &viscosity in Viscosity::ALL.iter().filter(|form| **form != Viscosity::VelocityExchange) {
                    let mut scene = collision(light);
                    scene.model = Formulation { density, pressure_force, viscosity, ..scene.model };
                    scene.model.viscosity_kernel = Kernel::CubicSpline;
                    scene.model.alpha = 0.5;
                    let half = half(&scene);
                    if scene.check().is_err() {
                        // settings that conflict are rejected with both stencils
                        assert!(half.check().is_err());
                        continue;
                    }
                    compared += 1;
                    let what = format!("{density:?}, {pressure_force:?}, {viscosity:?}, light: {light:?}");
                    let places = start(&scene);
                    let full = evaluated(&scene, &places, Plan::of);
                    agree(&what, &full, &evaluated(&half, &places, Plan::of), 60);
                }
            }
        }
    }
    assert!(compared > 60, "{compared} scenes");
}

#[test]
fn its_plan_leaves_out_what_changes_no_bit() {
    for light in [None, Some(700.0)] {
        let scene = half(&collision(light));
        let places = start(&scene);
        let [plan, everything] = [Plan::of, Plan::everything].map(|plan| evaluated(&scene, &places, plan));
        assert_eq!(plan, everything);
    }
}

#[test]
fn momentum_strays_by_no_more_than_rounding() {
    let scene = half(&collision(None));
    let mut heap = OwnedMemory::of(&support::checked(&scene));
    let mut solver = Solver::new(&scene, heap.lend()).expect("a scene");
    let momentum = |solver: &Solver<'_>| {
        let of = |axis: usize| solver.particles().map(|p| f64::from(p.velocity[axis])).sum::<f64>();
        [of(0), of(1), of(2)]
    };
    let before = momentum(&solver);
    let passed: f64 = solver.particles().map(|p| f64::from(p.velocity.length())).sum();
    (0..100).for_each(|_| solver.step(&Serial).expect("a step"));
    for (before, after) in before.into_iter().zip(momentum(&solver)) {
        // 100 steps, each rounding once per pair and once per sum, in random directions
        assert!((before - after).abs() < 3e-6 * passed, "{before} and {after}, of {passed}");
    }
}
