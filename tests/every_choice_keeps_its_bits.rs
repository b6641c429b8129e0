//! Promise: every choice that a scene can make gives the same bits on the scalar path, in lanes, on two threads, and on a
//! device in strict mode (without one, that its WGSL is valid); and no choice is left out: the list is made from the choices themselves, one of them at a time
//! against the defaults.
use millpond::compare::difference;
use millpond::pool::Pool;
use millpond::snapshot::Snapshot;
use millpond_core::OwnedMemory;
use millpond_core::layout::f32x4;
use millpond_core::scene::{
    Adaptive, Air, Block, Container, Correction, DensityForm, Dimension, Elasticity, EquationOfState, Evaluation,
    FieldLattice, Fluid, Grid, GridStructure, Integrator, Iteration, Kernel, ModelChoice, NearPressure, Periodic,
    Plasticity, PressureForce, PressureSolver, Reflection, Scene, SupportRange, SurfaceTension, Viscosity, Wall,
    WallPressure, WallShape, Wind,
};
use millpond_core::{Plan, Simd, Solver};
use millpond_gpu::program::{Words, program};
use millpond_gpu::strict::validate;
use millpond_gpu::{Gpu, GpuSolver, Mode};

mod support;
use support::{checked, device};

/// A scene that has something of everything to act on: two blocks that collide over a floor, with gravity.
fn base(dimension: Dimension) -> Scene {
    let fluid = Fluid { dynamic_viscosity: 2.0, ..Fluid::default() };
    let depth = if dimension == Dimension::Three { 0.2 } else { 0.0 };
    let block = Block { corner: [0.1, 0.05, 0.1], size: [0.3, 0.4, depth], jitter: 0.3, ..Block::default() };
    let mut scene = Scene::of(dimension, 0.05, 0.001, fluid, block);
    let velocity = [-1.0, 0.5, 0.0];
    let other = Block { corner: [0.42, 0.05, 0.1], size: [0.2, 0.3, depth], velocity, ..block };
    let _ = scene.blocks.push(other);
    scene.gravity = [1.0, -9.81, 0.0];
    scene.average_neighbours = if dimension == Dimension::Three { 30.0 } else { 18.0 };
    scene.grid = Grid { cells: [8, 8, 4], structure: GridStructure::IndexSort };
    scene.container = Some(Container { slip: 0.5, bounce: 0.3, ..Container::closed([0.0; 3], [0.8, 0.8, 0.4]) });
    scene
}

fn named(what: &str, base: &Scene, change: impl FnOnce(&mut Scene)) -> (String, Scene) {
    let mut scene = base.clone();
    change(&mut scene);
    (what.to_owned(), scene)
}

/// Every choice, one at a time.
#[allow(clippy::too_many_lines, reason = "one list, of everything")]
fn choices(base: &Scene) -> Vec<(String, Scene)> {
    let mut all = vec![named("defaults", base, |_| ())];
    let mut add = |what: String, change: &dyn Fn(&mut Scene)| all.push(named(&what, base, change));
    for &kernel in Kernel::ALL {
        if kernel.has_value() {
            add(format!("density_kernel {kernel:?}"), &|s| s.model.density_kernel = kernel);
        }
        add(format!("pressure_kernel {kernel:?}"), &|s| s.model.pressure_kernel = kernel);
        for viscosity in [Viscosity::Mueller, Viscosity::Morris] {
            add(format!("viscosity_kernel {kernel:?} {viscosity:?}"), &|s| {
                (s.model.viscosity_kernel, s.model.viscosity) = (kernel, viscosity);
            });
        }
    }
    for evaluation in [Evaluation::Table, Evaluation::SquaredTable] {
        add(format!("evaluation {evaluation:?}"), &|s| s.model.evaluation = evaluation);
    }
    for &density in DensityForm::ALL {
        add(format!("density {density:?}"), &|s| s.model.density = density);
        add(format!("density {density:?}, calibrated"), &|s| {
            (s.model.density, s.model.calibrated_mass) = (density, true);
        });
    }
    for &force in PressureForce::ALL {
        for &density in DensityForm::ALL {
            if force == PressureForce::NumberDensity && density != DensityForm::NumberDensity {
                continue;
            }
            add(format!("{density:?} with {force:?}, one fluid"), &|s| {
                (s.model.density, s.model.pressure_force) = (density, force);
            });
            add(format!("{density:?} with {force:?}, two fluids"), &|s| {
                (s.model.density, s.model.pressure_force) = (density, force);
                second_fluid(s);
            });
        }
        add(format!("pressure_force {force:?}, masses that differ"), &|s| {
            s.model.pressure_force = force;
            s.model.hydrostatic_start = force != PressureForce::NumberDensity;
            s.model.density =
                if s.model.hydrostatic_start { DensityForm::Continuity } else { DensityForm::NumberDensity };
        });
    }
    for &state in EquationOfState::ALL {
        for suction in [true, false] {
            add(format!("equation_of_state {state:?}, suction {suction}"), &|s| {
                (s.model.equation_of_state, s.model.suction) = (state, suction);
                s.model.pressure_force = PressureForce::Monaghan;
            });
        }
    }
    add("stiffness".into(), &|s| s.fluid.stiffness = Some(2000.0));
    for force in [PressureForce::Monaghan, PressureForce::Difference] {
        for (iteration, tolerance) in
            [(Iteration::Relaxed, 1e-4), (Iteration::Relaxed, 0.5), (Iteration::Literal, 1e-3)]
        {
            add(format!("correction {iteration:?} {force:?} to {tolerance}"), &|s| {
                s.model.pressure_solver = PressureSolver::PressureCorrection;
                (s.model.pressure_force, s.model.suction) = (force, false);
                s.model.correction = Correction { iteration, iterations: 5, tolerance };
            });
        }
    }
    for &near in NearPressure::ALL {
        add(format!("near_pressure {near:?}"), &|s| s.model.near_pressure = near);
    }
    for &viscosity in Viscosity::ALL {
        add(format!("viscosity {viscosity:?}"), &|s| {
            s.model.viscosity = viscosity;
            s.model.density = DensityForm::SummationAdapted;
            s.fluid.velocity_exchange = 0.1;
        });
        for &wall in WallPressure::ALL {
            add(format!("viscosity {viscosity:?}, walls {wall:?}"), &|s| {
                (s.model.viscosity, s.model.wall_pressure) = (viscosity, wall);
                s.model.density = DensityForm::NumberDensity;
                s.fluid.velocity_exchange = 0.1;
                walls(s);
            });
            add(format!("viscosity {viscosity:?}, walls {wall:?}, two fluids"), &|s| {
                s.model = ModelChoice { viscosity, wall_pressure: wall, ..ModelChoice::multiphase() };
                s.fluid.velocity_exchange = 0.1;
                walls(s);
                second_fluid(s);
            });
        }
        add(format!("heat of {viscosity:?}"), &|s| {
            (s.model.viscosity, s.model.thermal_energy) = (viscosity, true);
            s.model.density = DensityForm::SummationAdapted;
            (s.fluid.velocity_exchange, s.fluid.heat_gain, s.fluid.thermal_energy) = (0.9, 0.7, 1.0);
        });
    }
    for &tension in SurfaceTension::ALL {
        for &density in DensityForm::ALL {
            add(format!("surface_tension {tension:?} with {density:?}"), &|s| {
                (s.model.surface_tension, s.model.density) = (tension, density);
                pulled(s);
            });
        }
        add(format!("surface_tension {tension:?}, two fluids"), &|s| {
            s.model = ModelChoice { surface_tension: tension, ..ModelChoice::multiphase() };
            second_fluid(s);
            pulled(s);
        });
        add(format!("surface_tension {tension:?}, corrected pressure and supports that vary"), &|s| {
            s.model.surface_tension = tension;
            s.model.pressure_solver = PressureSolver::PressureCorrection;
            s.model.pressure_force = PressureForce::MonaghanAdapted;
            s.model.variable_support = Some(SupportRange { smallest: 0.7, largest: 1.3 });
            walls(s);
            pulled(s);
        });
    }
    for &integrator in Integrator::ALL {
        add(format!("integrator {integrator:?}"), &|s| s.model.integrator = integrator);
        add(format!("integrator {integrator:?} with heat, XSPH, walls of particles, across a periodic side"), &|s| {
            s.model = ModelChoice { integrator, thermal_energy: true, viscosity: Viscosity::Artificial, ..s.model };
            s.model.density = DensityForm::Continuity;
            s.fluid.xsph = 0.3;
            s.container = None;
            s.periodic = Some(Periodic { low: [0.0; 3], high: [0.8, 0.6, 0.6], axes: [true, false, false] });
            walls(s);
        });
        if again(integrator) {
            add(format!("integrator {integrator:?}, evaluated again"), &|s| {
                (s.model.integrator, s.model.reevaluate) = (integrator, true);
            });
            add(format!("integrator {integrator:?}, evaluated again with springs and tension"), &|s| {
                s.model = ModelChoice { integrator, reevaluate: true, ..ModelChoice::multiphase() };
                s.model.surface_tension = SurfaceTension::NormalCurvature;
                (s.fluid.elastic_stiffness, s.fluid.xsph, s.model.thermal_energy) = (500.0, 0.1, true);
                s.elasticity.plasticity = Some(Plasticity { rate: 20.0, yield_strain: 0.01 });
                pulled(s);
            });
        }
        if integrator.allows_changing_steps() {
            add(format!("integrator {integrator:?}, adaptive"), &|s| {
                s.model.integrator = integrator;
                s.adaptive = Some(Adaptive { growth: 1.3, ..Adaptive::default() });
            });
            add(format!("integrator {integrator:?}, adaptive, and made again"), &|s| {
                s.model.integrator = integrator;
                // too long a first step, and a criterion that tightens as the blocks meet
                s.time_step = 0.004;
                let redo_above = Some(1.01);
                s.adaptive = Some(Adaptive { speed: None, sound: None, redo_above, ..Adaptive::default() });
            });
        }
    }
    add("adaptive, of two fluids in supports that vary, with corrected pressure".into(), &|s| {
        second_fluid(s);
        s.model.variable_support = Some(SupportRange { smallest: 0.7, largest: 1.3 });
        s.model.pressure_solver = PressureSolver::PressureCorrection;
        s.model.pressure_force = PressureForce::MonaghanAdapted;
        s.adaptive = Some(Adaptive { redo_above: Some(1.0), ..Adaptive::default() });
    });
    add("adaptive, held at its shortest step".into(), &|s| {
        s.adaptive = Some(Adaptive { smallest: 0.0009, redo_above: Some(1.0), ..Adaptive::default() });
    });
    add("adaptive with air".into(), &|s| {
        s.model = ModelChoice::multiphase();
        second_fluid(s);
        s.blocks[1].fluid = 0;
        s.air = Some(Air { fluid: 1, capacity: 60, threshold: 0.5, minimum_density: 0.6 });
        s.adaptive = Some(Adaptive { redo_above: Some(1.0), ..Adaptive::default() });
    });
    add("stiffness_for_time_step".into(), &|s| s.stiffness_for_time_step = Some(0.2));
    add("normals alone".into(), &|s| s.model.surface_normals = true);
    for &near in NearPressure::ALL {
        for density in [DensityForm::Summation, DensityForm::SummationAdapted] {
            add(format!("near_pressure {near:?}, {density:?} of two fluids"), &|s| {
                (s.model.near_pressure, s.model.density) = (near, density);
                second_fluid(s);
            });
        }
    }
    for &state in EquationOfState::ALL {
        add(format!("equation_of_state {state:?} for two fluids"), &|s| {
            (s.model.equation_of_state, s.model.pressure_force) = (state, PressureForce::MonaghanAdapted);
            second_fluid(s);
        });
        add(format!("equation_of_state {state:?} for the second fluid alone"), &|s| {
            s.model.viscosity = Viscosity::Artificial;
            second_fluid(s);
            s.other_fluids[0].equation_of_state = Some(state);
        });
    }
    add("pressure_solver PressureCorrection for two fluids".into(), &|s| {
        s.model.pressure_solver = PressureSolver::PressureCorrection;
        s.model.pressure_force = PressureForce::MonaghanAdapted;
        second_fluid(s);
    });
    add("two fluids with everything that mixes them".into(), &|s| {
        second_fluid(s);
        s.model.thermal_energy = true;
        s.model.evaluation = Evaluation::Table;
        (s.fluid.xsph, s.fluid.radial_exchange, s.ambient_density) = (0.4, 0.3, 20.0);
        s.blocks[1].dynamic_viscosity = Some(0.1);
    });
    for (name, tension, wall) in [
        ("air", SurfaceTension::Off, false),
        ("air and tension", SurfaceTension::NormalCurvature, false),
        ("air and walls of particles", SurfaceTension::Off, true),
    ] {
        add(name.into(), &|s| {
            s.model = ModelChoice { surface_tension: tension, ..ModelChoice::multiphase() };
            second_fluid(s);
            s.blocks[1].fluid = 0;
            s.air = Some(Air { fluid: 1, capacity: 60, threshold: 0.5, minimum_density: 0.6 });
            if wall {
                walls(s);
            }
            pulled(s);
        });
    }
    add("a fluid of smaller support".into(), &|s| {
        second_fluid(s);
        s.other_fluids[0].average_neighbours = Some(12.0);
    });
    let plasticity = Some(Plasticity { rate: 20.0, yield_strain: 0.01 });
    for (name, plasticity, break_at) in
        [("springs", None, None), ("plastic springs", plasticity, None), ("brittle springs", plasticity, Some(0.02))]
    {
        add(name.into(), &|s| {
            s.fluid.elastic_stiffness = 2000.0;
            s.elasticity = Elasticity { reach: 1.8, plasticity, break_at, ..Elasticity::default() };
        });
        add(format!("{name} of one of two fluids, across a periodic side"), &|s| {
            second_fluid(s);
            walls(s);
            s.model.pressure_solver = PressureSolver::PressureCorrection;
            s.model.pressure_force = PressureForce::Monaghan;
            s.other_fluids[0].elastic_stiffness = 500.0;
            s.elasticity = Elasticity { reach: 1.8, plasticity, break_at, ..Elasticity::default() };
            s.container = None;
            s.periodic = Some(Periodic { low: [0.0; 3], high: [0.8, 0.6, 0.6], axes: [true, false, false] });
            s.blocks[1].corner[0] = 0.6;
        });
    }
    add("two viscosities".into(), &|s| s.blocks[1].dynamic_viscosity = Some(20.0));
    add("radial_exchange".into(), &|s| s.fluid.radial_exchange = 0.8);
    add("xsph".into(), &|s| s.fluid.xsph = 0.5);
    add("variable_support".into(), &|s| {
        s.model.variable_support = Some(SupportRange { smallest: 0.7, largest: 1.3 });
    });
    add("ambient_density".into(), &|s| s.ambient_density = 400.0);
    add("wind".into(), &|s| s.wind = Some(Wind { velocity: [3.0, 1.0, 0.0], drag: 4.0 }));
    add("field".into(), &|s| {
        s.field = Some(FieldLattice { low: [0.1, 0.1, 0.05], spacing: 0.13, counts: [4, 3, 3] });
    });
    add("falls".into(), &falls);
    add("no walls".into(), &|s| {
        falls(s);
        s.container = None;
    });
    add("open face".into(), &|s| {
        falls(s);
        s.container.iter_mut().for_each(|c| c.open = [millpond_core::scene::Face::Floor].into_iter().collect());
    });
    add("full reflection".into(), &|s| {
        falls(s);
        s.container.iter_mut().for_each(|c| c.reflection = Reflection::Full);
    });
    add("cell lists".into(), &|s| s.grid.structure = GridStructure::CellLists { places: 64 });
    for axes in [[true, false, false], [false, true, false], [true, true, true]] {
        add(format!("periodic {axes:?}"), &|s| {
            falls(s);
            s.container = None;
            s.periodic = Some(Periodic { low: [0.05, 0.0, 0.0], high: [0.65, 0.6, 0.6], axes });
        });
    }
    add("everything at once".into(), &|s| {
        s.container = None;
        s.periodic = Some(Periodic { low: [0.0; 3], high: [0.8, 0.0, 0.7], axes: [true, false, true] });
        walls(s);
        s.model = ModelChoice {
            density: DensityForm::Continuity,
            hydrostatic_start: true,
            pressure_solver: PressureSolver::PressureCorrection,
            pressure_force: PressureForce::Monaghan,
            near_pressure: NearPressure::Article,
            viscosity: Viscosity::Artificial,
            thermal_energy: true,
            variable_support: Some(SupportRange { smallest: 0.8, largest: 1.2 }),
            wall_pressure: WallPressure::QuasiFluid,
            ..s.model
        };
        (s.fluid.xsph, s.fluid.radial_exchange, s.ambient_density) = (0.2, 0.1, 10.0);
        s.wind = Some(Wind { velocity: [1.0, 0.0, 0.0], drag: 1.0 });
        s.field = Some(FieldLattice { low: [0.0; 3], spacing: 0.3, counts: [3, 3, 3] });
        s.blocks[0].dynamic_viscosity = Some(0.5);
        second_fluid(s);
        s.model.surface_tension = SurfaceTension::NormalCurvature;
        pulled(s);
        s.fluid.elastic_stiffness = 100.0;
        s.elasticity.break_at = Some(0.1);
    });
    all
}

/// Does evaluating its forces again make a difference that its places do not undo?
fn again(integrator: Integrator) -> bool {
    use Integrator::*;
    !matches!(integrator, Euler | SemiImplicitEuler | Clavet | PositionCorrectedBeeman)
}

/// Lets the first block meet the floor and the left wall at once.
fn falls(s: &mut Scene) {
    (s.blocks[0].corner, s.blocks[0].velocity) = ([0.0, 0.0, 0.1], [-5.0, -5.0, 0.0]);
}

/// Makes the second block one of another fluid, lighter and stiffer.
fn second_fluid(s: &mut Scene) {
    let light = Fluid { rest_density: 700.0, speed_of_sound: 12.0, dynamic_viscosity: 5.0, ..Fluid::default() };
    let _ = s.other_fluids.push(light);
    s.blocks[1].fluid = 1;
}

/// Gives every fluid some tension, where the scene has a model of it.
fn pulled(s: &mut Scene) {
    let tension = match s.model.surface_tension {
        SurfaceTension::Off => 0.0,
        SurfaceTension::Curvature | SurfaceTension::NormalCurvature => 5.0,
        SurfaceTension::Attraction | SurfaceTension::GradientSum => 2.0,
    };
    std::iter::once(&mut s.fluid).chain(&mut s.other_fluids).for_each(|fluid| fluid.surface_tension = tension);
}

/// A box open above, whose floor slides.
fn walls(s: &mut Scene) {
    use millpond_core::scene::Face;
    let (low, high) = ([0.0; 3], [0.8, 0.6, 0.4]);
    let shape = WallShape::Box { low, high, open: [Face::Ceiling].into_iter().collect() };
    let velocity = [0.5, 0.0, 0.0];
    s.walls = [Wall { velocity, dynamic_viscosity: Some(1.0), ..Wall::still(shape) }].into_iter().collect();
}

/// Some field, of a shape that no symmetry hides.
fn field(scene: &Scene) -> Vec<f32x4> {
    (0..checked(scene).derived().field_counts[3])
        .map(|i| [i as f32 * 0.7, 3.0 - (i * i) as f32 * 0.1, (i % 3) as f32, 0.0])
        .collect()
}

/// And another one, later.
fn other_field(scene: &Scene) -> Vec<f32x4> {
    field(scene).into_iter().map(|[x, y, z, w]| [y, -x, z, w]).collect()
}

const STEPS: u32 = 8;

fn saved(solver: &Solver<'_>) -> Vec<u8> {
    let mut bytes = vec![0; solver.saved_bytes()];
    solver.save(&mut bytes).expect("room");
    bytes
}

/// All steps in lanes, but saved in the middle and gone on with by another solver.
fn with_a_break(scene: &Scene) -> Snapshot {
    let memory = || OwnedMemory::of(&scene.check().expect("a scene"));
    let (mut first, mut second) = (memory(), memory());
    let pool = Pool::new(1).expect("a thread");
    let mut solver = Solver::new(scene, first.lend()).expect("a scene");
    solver.set_field(&field(scene)).expect("a field");
    (0..STEPS / 2).for_each(|_| solver.step(&pool).expect("a step"));
    let mut other = Solver::new(scene, second.lend()).expect("a scene");
    other.restore(&saved(&solver)).expect("bytes of this scene");
    assert!(saved(&other) == saved(&solver), "bytes that were read are written again");
    other.set_field(&other_field(scene)).expect("a field");
    (STEPS / 2..STEPS).for_each(|_| other.step(&pool).expect("a step"));
    Snapshot::of_cpu(&other)
}

/// All steps, the second half in another field.
fn half_and_half(scene: &Scene, solver: &mut Solver<'_>, pool: &Pool) {
    (0..STEPS / 2).for_each(|_| solver.step(pool).expect("a step"));
    solver.set_field(&other_field(scene)).expect("a field");
    (STEPS / 2..STEPS).for_each(|_| solver.step(pool).expect("a step"));
}

fn by_cpu(
    scene: &Scene,
    simd: Simd,
    threads: usize,
    heap: &mut OwnedMemory,
    gpu: Option<&Gpu>,
) -> [Option<Snapshot>; 2] {
    let mut solver = Solver::new(scene, heap.lend()).expect("a scene").at_level(simd);
    solver.set_field(&field(scene)).expect("a field");
    let on_device = gpu.map(|gpu| {
        let mut fluid = GpuSolver::new(gpu, &solver).expect("a device that takes it");
        fluid.step(STEPS / 2).expect("steps on the device");
        fluid.set_field(&other_field(scene)).expect("a field");
        fluid.step(STEPS - STEPS / 2).expect("steps on the device");
        let reports = (
            fluid.correction().expect("a report"),
            fluid.time_report().expect("a report"),
            fluid.save().expect("bytes"),
        );
        (Snapshot::of_gpu(&fluid).expect("a state"), reports)
    });
    let pool = Pool::new(threads).expect("threads");
    half_and_half(scene, &mut solver, &pool);
    if let Some((_, reports)) = &on_device {
        let (correction, time, bytes) = reports;
        assert_eq!((correction, time), (&solver.correction(), &solver.time_report()), "pressure, and the time step");
        assert!(*bytes == saved(&solver), "the bytes of the two backends");
    }
    [Some(Snapshot::of_cpu(&solver)), on_device.map(|(state, _)| state)]
}

/// What differs in any bit of any array of the state, in words.
fn differs(want: &Snapshot, got: Option<&Snapshot>) -> Option<String> {
    difference(want, got.expect("a state")).map(|found| found.first)
}

/// The scene in the plainest words: choices that theory says are the same become one. All others must make a difference.
fn plainest(scene: &Scene) -> Scene {
    use DensityForm as D;
    use PressureForce as P;
    let mut s = scene.clone();
    let m = &mut s.model;
    let one_mass = s.other_fluids.is_empty() && !m.hydrostatic_start;
    if !m.hydrostatic_start {
        // a number density times the own mass is the adapted sum
        m.density = if m.density == D::SummationAdapted { D::NumberDensity } else { m.density };
    }
    if !matches!(m.density, D::Summation | D::Continuity) {
        // on a density that counts numbers a volume is one over it in any form
        m.pressure_force = match m.pressure_force {
            P::MuellerAdapted => P::Mueller,
            P::MonaghanAdapted | P::NumberDensity => P::Monaghan,
            other => other,
        };
        m.viscosity = if m.viscosity == Viscosity::MuellerAdapted { Viscosity::Mueller } else { m.viscosity };
    }
    if one_mass {
        // where all particles weigh the same, numbers are masses
        m.density = match m.density {
            D::NumberDensity => D::Summation,
            D::ContinuityAdapted => D::Continuity,
            other => other,
        };
        if m.density == D::Summation {
            m.pressure_force = match m.pressure_force {
                P::MuellerAdapted => P::Mueller,
                P::MonaghanAdapted => P::Monaghan,
                other => other,
            };
        }
    }
    // a gas has no negative pressure
    m.suction |= m.equation_of_state == EquationOfState::IdealGas;
    if m.viscosity != Viscosity::Exchange {
        s.fluid.velocity_exchange = 0.0;
    }
    s
}

fn check(dimension: Dimension) {
    let gpu = device("every_choice_keeps_its_bits", Mode::Strict);
    let base = base(dimension);
    let mut seen: Vec<(String, Scene, Snapshot)> = Vec::new();
    for (name, scene) in choices(&base) {
        let heap = || OwnedMemory::of(&scene.check().expect("a scene"));
        let [want, on_device] = by_cpu(&scene, Simd::Scalar, 1, &mut heap(), gpu.as_ref());
        let want = want.expect("a state");
        let fastest = want.velocity().iter().flat_map(|v| &v[..3]).fold(0.0f32, |all, v| all.max(v.abs()));
        assert!(fastest.is_finite() && fastest < 100.0, "{name}: a scene that explodes tests little");
        let [lanes, _] = by_cpu(&scene, Simd::detect(), 2, &mut heap(), None);
        assert_eq!(differs(&want, lanes.as_ref()), None, "{name}: lanes on two threads");
        let [base_lanes, _] = by_cpu(&scene, Simd::Base, 1, &mut heap(), None);
        assert_eq!(differs(&want, base_lanes.as_ref()), None, "{name}: base lanes");
        assert_eq!(differs(&want, Some(&with_a_break(&scene))), None, "{name}: saved and gone on with");
        let known = checked(&scene);
        let plan = Plan::of(&known);
        if gpu.is_none() {
            for pass in plan.passes() {
                let read = validate(&program(pass, &plan.model, Words::Native));
                assert!(read.is_ok(), "{name}, {}: {:?}", pass.name(), read.err());
            }
        } else {
            assert_eq!(differs(&want, on_device.as_ref()), None, "{name}: on the device");
        }
        // by its plan and by everything, the same
        let mut heap = OwnedMemory::with(&millpond_core::Requirements::by_plan(&known, &Plan::everything(&known)));
        let (count, places) = (known.derived().particles(), known.initial_particles());
        let plan = Plan::everything(&known);
        let mut whole = Solver::with_particles(&known, plan, count, places, heap.lend()).expect("a scene");
        whole.set_field(&field(&scene)).expect("a field");
        let pool = Pool::new(1).expect("a thread");
        half_and_half(&scene, &mut whole, &pool);
        assert_eq!(whole.hash(), want.hash(), "{name}: with every term left in");
        seen.push((name, scene, want));
    }
    // a choice that changed nothing would be tested by nothing
    let mut alike = Vec::new();
    for (i, (name, scene, state)) in seen.iter().enumerate() {
        let same = seen[..i]
            .iter()
            .find(|(_, other, known)| plainest(other) != plainest(scene) && difference(known, state).is_none());
        alike.extend(same.map(|(known, ..)| format!("{name} | {known}")));
    }
    // where particles are looked up never changes a bit
    assert_eq!(alike, ["cell lists | defaults"]);
}

#[test]
fn in_space() {
    check(Dimension::Three);
}

#[test]
fn in_the_plane() {
    check(Dimension::Two);
}
