//! Promise: what lies beyond a plane is known to 1e-6; a fluid under pressure pushes on each wall of a closed box with
//! its pressure, and keeps its momentum between opposite walls; and a wall that slides drags the fluid along.
use millpond_core::backend::derive::kernel_constants::{integral, value};
use millpond_core::backend::derive::plane_integrals::{gamma, gamma_of_rows, surface};
use millpond_core::backend::terms::beyond::{
    DENSITY_GAMMA, DENSITY_SURFACE, PRESSURE_GAMMA, PRESSURE_SURFACE, interpolated_smoothly,
};
use millpond_core::glam::Vec3;
use millpond_core::scene::{
    Block, Container, DensityForm, Dimension, Face, Fluid, Formulation, Grid, InitialParticle, Kernel, NearPressure,
    PlaneModel, PressureForce, Scene, Sliding, SurfaceTension, Viscosity, Wind,
};
use millpond_core::{Array, OwnedMemory, Plan, SceneError, Serial, Solver};

#[path = "support/forms.rs"]
#[allow(dead_code, unreachable_pub, reason = "each test uses its part")]
mod forms;
use forms::wendland;

/// Returns a box of half a metre, full of fluid, with walls in closed form.
fn full_box(dimension: Dimension, model: Formulation) -> Scene {
    let z = if dimension == Dimension::Three { 0.5 } else { 0.0 };
    let size = Vec3::new(0.5, 0.5, z);
    let fluid = Fluid { speed_of_sound: 10.0, dynamic_viscosity: 1.0, ..Fluid::default() };
    let mut scene = Scene::of(dimension, 0.05, 0.0005, fluid, Block { size, ..Block::default() });
    scene.container = Some(Container::closed([0.0; 3], [0.5, 0.5, 0.5]));
    scene.model = Formulation { density: DensityForm::Continuity, normalize_mass: true, ..model };
    scene.grid = Grid { cells: [8, 8, 8], ..Grid::default() };
    scene
}

/// Returns by how much the part of the kernel beyond two planes at right angles, at the distances `s` H, differs from
/// the product of the parts beyond each of them.
fn corner_error(kernel: Kernel, d: usize, s: [f64; 2]) -> f64 {
    // beyond both planes, in slices parallel to the second
    let both = integral(&|x| {
        let u = s[0] + (1.0 - s[0]) * x;
        (1.0 - s[0]) * slice_beyond(kernel, d, u, s[1])
    });
    let parts = s.map(|s| gamma(kernel, d, s));
    (both - parts[0] * parts[1]).abs()
}

/// Returns the integral of the kernel over that part of the plane at the distance `u` H that lies beyond a second plane
/// at right angles to it, at the distance `s` H; times H.
fn slice_beyond(kernel: Kernel, d: usize, u: f64, s: f64) -> f64 {
    let radius = (1.0 - u * u).max(0.0).sqrt();
    if s >= radius {
        return 0.0;
    }
    let line = |x: f64| {
        let t = s + (radius - s) * x;
        let q = |z: f64| (u * u + t * t + z * z).sqrt().min(1.0);
        let depth = (radius * radius - t * t).max(0.0).sqrt();
        if d == 2 { value(kernel, q(0.0)) } else { 2.0 * depth * integral(&|z| value(kernel, q(depth * z))) }
    };
    kernel.normalisation(d) * (radius - s) * integral(&line)
}

#[test]
fn what_lies_beyond_is_known_to_a_millionth() {
    for dimension in [Dimension::Two, Dimension::Three] {
        let d = dimension.count();
        for &kernel in Kernel::ALL.iter().filter(|kernel| kernel.has_value()) {
            let kernels = Formulation { density_kernel: kernel, pressure_kernel: kernel, ..wendland() };
            let scene = full_box(dimension, kernels);
            let checked = scene.check().expect("a scene");
            let row = f64::from(scene.particle_spacing) / checked.derived().support_radius;
            let mut heap = OwnedMemory::of(&checked);
            let solver = Solver::new(&scene, heap.lend()).expect("a scene");
            let tables: Vec<f32> =
                solver.words(Array::kernel_tables).iter().map(|&word| f32::from_bits(word)).collect();
            for i in 0..997 {
                let s = (f64::from(i) + 0.3) / 997.0;
                let known = [
                    (DENSITY_GAMMA, gamma_of_rows(kernel, d, s, row)),
                    (DENSITY_SURFACE, surface(kernel, d, s)),
                    (PRESSURE_GAMMA, gamma(kernel, d, s)),
                    (PRESSURE_SURFACE, surface(kernel, d, s)),
                ];
                for (table, exact) in known {
                    let found = f64::from(interpolated_smoothly(&tables[..], table, s as f32));
                    let name = format!("{kernel:?} in {d}D, table {table} at {s}: {found} for {exact}");
                    // the Gaussian is cut off at 1e-4 of its value, and its integral over a plane ends there like a
                    // root
                    let limit = if kernel == Kernel::Gaussian && s > 0.99 { 2e-6 } else { 1e-6 };
                    // beside the interpolation, f32 rounds s and the terms of the cubic
                    assert!((found - exact).abs() < limit * exact.max(1.0) + 4e-7, "{name}");
                }
            }
            // the definitions: half of a kernel lies beyond a plane through its centre, and W1 is the slope of gamma
            assert!((gamma(kernel, d, 0.0) - 0.5).abs() < 1e-6, "{kernel:?} in {d}D: {}", gamma(kernel, d, 0.0));
            for s in [0.1, 0.35, 0.8] {
                let slope = (gamma(kernel, d, s - 1e-4) - gamma(kernel, d, s + 1e-4)) / 2e-4;
                assert!((slope - surface(kernel, d, s)).abs() < 1e-5, "{kernel:?} in {d}D at {s}");
            }
        }
        // documented at `container.model`
        let worst = [0.05, 0.1, 0.16, 0.25, 0.4].map(|s| corner_error(Kernel::WendlandC2, d, [s, s]));
        assert!(worst.iter().all(|error| *error < 0.02), "{worst:?}");
    }
}

#[test]
fn pressure_pushes_on_every_face() {
    for dimension in [Dimension::Two, Dimension::Three] {
        for pressure_force in [PressureForce::Monaghan, PressureForce::DensityWeighted, PressureForce::MonaghanAdapted]
        {
            let mut scene = full_box(dimension, Formulation { pressure_force, ..wendland() });
            // with 32 neighbours in 3D two rows are all that a particle sees on a side, and sums over them are rough
            scene.average_neighbours = Some(if dimension == Dimension::Three { 80.0 } else { 32.0 });
            // the first row moves by 0.01 spacings until the forces on it balance
            scene.wind = Some(Wind { velocity: Vec3::ZERO, drag: 40.0 });
            let checked = scene.check().expect("a scene");
            let squeezed = |place: InitialParticle| InitialParticle { deviation: 0.01, ..place };
            let places: Vec<InitialParticle> = checked.initial_particles().map(squeezed).collect();
            let mut heap = OwnedMemory::of(&checked);
            let plan = Plan::of(&checked);
            let mut solver =
                Solver::with_particles(&checked, plan, places.len(), places, heap.lend()).expect("a start");
            (0..600).for_each(|_| solver.step(&Serial).expect("a step"));
            let pressure =
                solver.particles().map(|p| f64::from(p.pressure)).sum::<f64>() / solver.particles().count() as f64;
            // the fluid that is thought to go on beyond the other faces carries its part of the pressure itself
            let row = 0.05 / checked.derived().support_radius;
            let beyond: f64 =
                (0..10).map(|k| gamma(Kernel::WendlandC2, dimension.count(), (k as f64 + 0.5) * row)).sum();
            let width = 0.5 - 2.0 * beyond * 0.05;
            let area = if dimension == Dimension::Three { width * width } else { width };
            let neighbours = solver.neighbours();
            for face in &Face::ALL[..2 * dimension.count()] {
                let force = f64::from(neighbours.force_on_face(*face)[face.axis()]);
                let outwards = if face.is_high() { force } else { -force };
                let off = outwards / (pressure * area) - 1.0;
                // the error of sums over rows on this lattice (0.4 % inside), and of the product in the edges, of which
                // a face has four in 3D
                let most = if dimension == Dimension::Three { 0.04 } else { 0.02 };
                assert!(off.abs() < most, "{dimension:?} {pressure_force:?} {face:?}: off by {off}");
            }
        }
    }
}

#[test]
fn what_the_fluid_loses_the_faces_feel() {
    for pressure_force in [PressureForce::Mueller, PressureForce::Monaghan, PressureForce::DensityWeighted] {
        let mut scene = full_box(Dimension::Two, Formulation { pressure_force, ..wendland() });
        (scene.blocks[0].jitter, scene.blocks[0].velocity) = (0.3, Vec3::new(0.5, -1.0, 0.0));
        // the forces are those of the state: viscosity would see the velocities in the middle of the step
        scene.fluids[0].dynamic_viscosity = 0.0;
        let mut heap = OwnedMemory::of(&scene.check().expect("a scene"));
        let mut solver = Solver::new(&scene, heap.lend()).expect("a scene");
        (0..20).for_each(|_| solver.step(&Serial).expect("a step"));
        let mass = solver.particles().next().expect("a particle").mass;
        let acceleration = |a: &[f32; 4]| Vec3::new(a[0], a[1], a[2]);
        let lost: Vec3 = solver.state().acceleration.iter().map(acceleration).sum::<Vec3>() * -mass;
        let neighbours = solver.neighbours();
        let felt: Vec3 = Face::ALL.iter().map(|face| neighbours.force_on_face(*face)).sum();
        let largest = Face::ALL.iter().map(|face| neighbours.force_on_face(*face).length()).fold(0.0, f32::max);
        // the rounding of 100 particles
        assert!((felt - lost).length() < 1e-5 * largest, "{pressure_force:?}: {felt} N felt, {lost} N lost");
    }
}

#[test]
fn a_sliding_face_drags_the_fluid_along() {
    for viscosity in [Viscosity::Morris, Viscosity::MonaghanGingold, Viscosity::Artificial] {
        let mut scene = full_box(Dimension::Two, Formulation { viscosity, ..wendland() });
        let belt = Sliding { face: Face::Floor, velocity: Vec3::new(1.0, 0.0, 0.0) };
        scene.container.iter_mut().for_each(|container| container.sliding = [belt].into_iter().collect());
        let mut heap = OwnedMemory::of(&scene.check().expect("a scene"));
        let mut solver = Solver::new(&scene, heap.lend()).expect("a scene");
        (0..100).for_each(|_| solver.step(&Serial).expect("a step"));
        let along = |is_low: bool| {
            let row = |p: &millpond_core::Particle| (p.position.y < 0.05) == is_low;
            solver.particles().filter(row).map(|p| f64::from(p.velocity.x)).fold(0.0, f64::max)
        };
        let (low, high) = (along(true), along(false));
        // artificial viscosity has no friction at walls in closed form
        let is_dragged = viscosity != Viscosity::Artificial;
        let as_promised = if is_dragged { low > 0.01 && high < low } else { low < 1e-3 };
        assert!(as_promised, "{viscosity:?}: {low} m/s at the floor, {high} m/s above");
    }
}

fn container(scene: &mut Scene) -> &mut Container {
    scene.container.as_mut().expect("a container")
}

#[test]
fn what_they_cannot_do_is_refused_by_name() {
    let refused = |sentence: &str, change: &dyn Fn(&mut Scene)| {
        let mut scene = full_box(Dimension::Two, wendland());
        assert_eq!(scene.check().map(|_| ()), Ok(()));
        change(&mut scene);
        assert_eq!(scene.check().expect_err(sentence).to_string(), sentence);
    };
    refused(
        "container.model ClosedForm conflicts with model.near_pressure: near pressure would miss the walls; set \
         near_pressure Off, and use shifting if particles pair, or use model Penalty",
        &|s| s.model.near_pressure = NearPressure::DensityProportional,
    );
    refused(
        "container.model ClosedForm conflicts with model.internal_energy: the work of the walls is not divided between \
         the fluid and its continuation beyond them; use walls of particles, or model Penalty",
        &|s| s.model.internal_energy = true,
    );
    refused(
        "container.model ClosedForm conflicts with model.surface_tension Curvature: the Laplacian of the colour would \
         miss the walls; use NormalCurvature, or model Penalty",
        &|s| s.model.surface_tension = SurfaceTension::Curvature,
    );
    refused(
        "container.model ClosedForm conflicts with model.pressure_kernel Viscosity: it is infinite at distance 0; use \
         another pressure_kernel, or model Penalty",
        &|s| s.model.pressure_kernel = Kernel::Viscosity,
    );
    for change in [(|c: &mut Container| c.dynamic_viscosity = Some(1.0)) as fn(&mut Container), |c| {
        c.sliding = [Sliding { face: Face::Floor, velocity: Vec3::X }].into_iter().collect();
    }] {
        let mut scene = full_box(Dimension::Two, wendland());
        container(&mut scene).model = PlaneModel::Penalty;
        change(container(&mut scene));
        let told = scene.check().expect_err("unused").to_string();
        assert!(
            told.ends_with("conflicts with container.model Penalty: penalty planes have no friction; use ClosedForm"),
            "{told}"
        );
    }
    refused(
        "container.sliding[0].velocity conflicts with the normal of its face: a face slides along itself; set the \
         component along the normal to 0",
        &|s| container(s).sliding = [Sliding { face: Face::Floor, velocity: Vec3::Y }].into_iter().collect(),
    );
    refused(
        "container.sliding[0].face conflicts with a face without a plane: it is open, or its axis is periodic; omit it",
        &|s| {
            container(s).open = [Face::Ceiling].into_iter().collect();
            container(s).sliding = [Sliding { face: Face::Ceiling, velocity: Vec3::X }].into_iter().collect();
        },
    );
    refused(
        "container.sliding[1].face conflicts with another item of container.sliding with the same face: a face has one \
         velocity; omit one of them",
        &|s| {
            let belt = Sliding { face: Face::Floor, velocity: Vec3::X };
            container(s).sliding = [belt, belt].into_iter().collect();
        },
    );
    let mut narrow = full_box(Dimension::Two, wendland());
    (narrow.container, narrow.blocks[0].size) = (None, Vec3::new(0.2, 0.5, 0.0));
    let sides = Container::closed([0.0; 3], [0.2, 0.5, 0.0]);
    narrow.container = Some(Container { model: PlaneModel::ClosedForm, ..sides });
    let told = narrow.check().expect_err("too narrow");
    assert!(matches!(told, SceneError::NarrowContainer { .. }), "{told:?}");
    let told = told.to_string();
    let start = "container is 0.2 m wide along x, but with container.model ClosedForm it must be at least 0.319";
    assert!(told.starts_with(start) && told.contains("two support radii; make it wider"), "{told}");
}
