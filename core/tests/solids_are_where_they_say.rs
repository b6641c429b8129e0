//! Promise: the distance from a solid is exact and changes no faster than the position, a solid moves on its course or as
//! the host says, it is saved and restored, and a solid that cannot be is refused by name.

use core::f32::consts::TAU;
use millpond_core::backend::terms::motion::sine_of_turns;
use millpond_core::glam::{Quat, Vec2, Vec3};
use millpond_core::scene::{
    Block, Container, Course, Dimension, Emitter, Fluid, Motion, Opening, Periodic, Scene, Shape, Solid, SolidModel,
};
use millpond_core::{OwnedMemory, Serial, SolidError, SolidState, Solver};

/// Returns a small block of fluid far away from a solid.
fn scene(dimension: Dimension, solid: Solid) -> Scene {
    let block = Block { corner: Vec3::new(-8.0, 0.0, 0.0), size: Vec3::splat(0.2), ..Block::default() };
    let mut scene = Scene::of(dimension, 0.05, 0.001, Fluid::default(), block);
    scene.solids = [Solid { model: SolidModel::Penalty, ..solid }].into_iter().collect();
    scene
}

fn with_solver<T>(scene: &Scene, f: impl FnOnce(&mut Solver<'_>) -> T) -> T {
    let mut heap = OwnedMemory::of(&scene.check().expect("a scene"));
    f(&mut Solver::new(scene, heap.lend()).expect("a scene"))
}

/// Points in a cube around the origin, in no order.
fn points(dimension: Dimension) -> Vec<Vec3> {
    let unit = |i: u32, prime: u32| (i * prime % 1009) as f32 / 1009.0 * 3.0 - 1.5;
    let flat = dimension == Dimension::Two;
    (0..400).map(|i| Vec3::new(unit(i, 523), unit(i, 659), if flat { 0.0 } else { unit(i, 811) })).collect()
}

#[test]
fn distances_are_exact() {
    let corners = [(-0.5, -0.4), (0.6, -0.5), (0.1, 0.0), (0.4, 0.7), (-0.3, 0.5)].map(Vec2::from);
    let (two, three) = (Dimension::Two, Dimension::Three);
    let shapes = [
        (two, Shape::Ball { radius: 0.7 }),
        (two, Shape::Box { size: Vec3::new(0.8, 1.2, 0.0) }),
        (two, Shape::Capsule { radius: 0.3, length: 0.8 }),
        (two, Shape::Polygon { corners: corners.into_iter().collect() }),
        (three, Shape::Plane),
        (three, Shape::Ball { radius: 0.7 }),
        (three, Shape::Box { size: Vec3::new(0.8, 1.2, 0.6) }),
        (three, Shape::Cylinder { radius: 0.5, height: 0.9 }),
        (three, Shape::Capsule { radius: 0.3, length: 0.8 }),
    ];
    for (dimension, shape) in shapes {
        let turned = if dimension == two { Vec3::new(0.0, 0.0, 35.0) } else { Vec3::new(20.0, -50.0, 35.0) };
        let solid = Solid { turned, ..Solid::still(shape.clone(), [0.1, -0.2, 0.0]) };
        let hollow = Solid { hollow: shape != Shape::Plane, ..solid.clone() };
        let mut inside = scene(dimension, hollow);
        if shape != Shape::Plane {
            inside.blocks[0] =
                Block { corner: Vec3::new(0.08, -0.22, 0.0), size: Vec3::splat(0.05), ..inside.blocks[0] };
        }
        let of_hollow = with_solver(&inside, |solver| {
            points(dimension)
                .into_iter()
                .map(|x| solver.distance_from_solid(0, x).expect("a solid"))
                .collect::<Vec<_>>()
        });
        with_solver(&scene(dimension, solid), |solver| {
            let distance = |x: Vec3| solver.distance_from_solid(0, x).expect("a solid");
            let all = points(dimension);
            let mut followed = 0;
            for (i, (&x, inside_out)) in all.iter().zip(of_hollow).enumerate() {
                let d = distance(x);
                if shape != Shape::Plane {
                    assert_eq!(inside_out, -d, "{shape:?}: a hollow one is the other way around");
                }
                // no faster than the position: rounding of coordinates of about 1
                let y = all[(i * 7 + 1) % all.len()];
                assert!((distance(y) - d).abs() <= x.distance(y) + 1e-6, "{shape:?} at {x}");
                // and as fast, away from the surface: a step along the gradient of the length of the distance, outside
                // of which the nearest point is the only one, leads to the surface
                let h = 1e-3;
                let slope = |axis: Vec3| (distance(x + axis * h) - distance(x - axis * h)) / (2.0 * h);
                let along_z = if dimension == two { 0.0 } else { slope(Vec3::Z) };
                let gradient = Vec3::new(slope(Vec3::X), slope(Vec3::Y), along_z);
                if d > 0.0 && (gradient.length() - 1.0).abs() < 1e-2 {
                    followed += 1;
                    let at = distance(x - gradient.normalize() * d);
                    assert!(at.abs() < 2e-3, "{shape:?} at {x}: {d} m away, but {at} m are left");
                }
            }
            assert!(followed > 100, "{shape:?}: {followed}");
        });
    }
}

#[test]
fn the_sine_of_a_course_is_accurate() {
    let worst = (-40_000..=40_000)
        .map(|i| i as f32 / 10_000.0)
        .map(|turns| (f64::from(sine_of_turns::<f32>(turns)) - (f64::from(turns) * core::f64::consts::TAU).sin()).abs())
        .fold(0.0, f64::max);
    assert!(worst < 2e-7, "{worst}");
}

#[test]
fn a_solid_follows_its_course() {
    let course = Course {
        velocity: Vec3::new(0.5, 0.0, 0.1),
        amplitude: Vec3::new(0.0, 0.2, 0.0),
        frequency: 2.0,
        phase: 0.25,
        axis: Vec3::new(0.0, 2.0, 0.0),
        turns_per_second: 0.5,
        rocking_degrees: 10.0,
    };
    let start = Vec3::new(1.0, 2.0, 3.0);
    let solid = Solid { motion: Motion::Prescribed(course), ..Solid::still(Shape::Ball { radius: 0.3 }, start) };
    with_solver(&scene(Dimension::Three, solid), |solver| {
        let mut before = solver.solid(0).expect("a solid");
        for _ in 0..700 {
            solver.step(&Serial).expect("a step");
            let now = solver.solid(0).expect("a solid");
            let t = solver.time() as f32;
            let swing = (TAU * (2.0 * t + 0.25)).sin();
            let position = start + course.velocity * t + course.amplitude * swing;
            assert!(now.position.distance(position) < 2e-6, "{} for {position}", now.position);
            let turned = Quat::from_rotation_y(TAU * 0.5 * t + 10f32.to_radians() * swing);
            assert!(now.rotation.dot(turned).abs() > 1.0 - 1e-6, "{} for {turned}", now.rotation);
            // velocities are those of the motion, to second order in the step
            let moved = (now.position - before.position) / 0.001;
            assert!(moved.distance((now.velocity + before.velocity) * 0.5) < 3e-3, "{moved} for {}", now.velocity);
            before = now;
        }
    });
}

#[test]
fn the_host_moves_a_solid_that_it_drives() {
    let solid = Solid { motion: Motion::Driven, ..Solid::still(Shape::Ball { radius: 0.3 }, [1.0, 0.0, 0.0]) };
    let mut scene = scene(Dimension::Three, solid);
    scene.add_solid(Solid::still(Shape::Ball { radius: 0.5 }, [3.0, 0.0, 0.0])).expect("room");
    with_solver(&scene, |solver| {
        let state = solver.solid(0).expect("a solid");
        let to = SolidState { velocity: Vec3::X, angular_velocity: Vec3::new(0.0, 0.0, 2.0), ..state };
        solver.move_solid(0, to).expect("it is driven");
        (0..500).for_each(|_| solver.step(&Serial).expect("a step"));
        let now = solver.solid(0).expect("a solid");
        // 500 roundings of a number above 1
        assert!(now.position.distance(Vec3::new(1.5, 0.0, 0.0)) < 3e-5, "{}", now.position);
        // a step turns by 2 atan(omega dt / 2), so in all by 1 rad less 1 / 12 of the square of 0.002
        assert!(now.rotation.dot(Quat::from_rotation_z(1.0)) > 1.0 - 1e-6, "{}", now.rotation);
        let hash = solver.full_hash();
        assert_eq!(solver.move_solid(1, state), Err(SolidError::NotDriven { solid: 1 }));
        assert_eq!(solver.move_solid(2, state), Err(SolidError::NoSuchSolid { solid: 2, solids: 2 }));
        let ill = SolidState { velocity: Vec3::new(f32::NAN, 0.0, 0.0), ..state };
        assert_eq!(solver.move_solid(0, ill), Err(SolidError::NotFinite));
        let long = SolidState { rotation: Quat::from_xyzw(0.0, 0.0, 0.0, 2.0), ..state };
        assert_eq!(solver.move_solid(0, long), Err(SolidError::NotARotation { length: 2.0 }));
        assert_eq!(solver.full_hash(), hash, "the fluid stayed as it was");
    });
}

#[test]
fn solids_are_saved_and_restored() {
    let course = Course { amplitude: Vec3::new(0.1, 0.0, 0.0), frequency: 3.0, ..Course::default() };
    let solid = Solid {
        model: SolidModel::Particles,
        motion: Motion::Prescribed(course),
        ..Solid::still(Shape::Box { size: Vec3::splat(0.2) }, [0.5, 0.0, 0.0])
    };
    let mut scene = scene(Dimension::Two, solid.clone());
    scene.solids = [solid].into_iter().collect();
    scene.blocks[0].corner = Vec3::new(0.1, -0.1, 0.0);
    let [mut one, mut other] = [(); 2].map(|()| OwnedMemory::of(&scene.check().expect("a scene")));
    let mut first = Solver::new(&scene, one.lend()).expect("a scene");
    let mut second = Solver::new(&scene, other.lend()).expect("a scene");
    (0..20).for_each(|_| first.step(&Serial).expect("a step"));
    let mut bytes = vec![0; first.saved_bytes()];
    first.save(&mut bytes).expect("room");
    second.restore(&bytes).expect("the same scene");
    for _ in 0..20 {
        first.step(&Serial).expect("a step");
        second.step(&Serial).expect("a step");
        assert_eq!(first.full_hash(), second.full_hash());
    }
}

#[test]
fn what_cannot_be_is_refused_by_name() {
    let ball = || Solid::still(Shape::Ball { radius: 0.5 }, [0.0; 3]);
    let told = |dimension, solid: Solid, change: &dyn Fn(&mut Scene)| {
        let mut scene = scene(dimension, solid);
        change(&mut scene);
        scene.check().map(|_| ()).expect_err("refused").to_string()
    };
    let (two, three) = (Dimension::Two, Dimension::Three);
    let clockwise = [(0.0, 0.0), (0.0, 1.0), (1.0, 0.0)].map(Vec2::from).into_iter().collect();
    let crossing = [(0.0, 0.0), (2.0, 1.0), (2.0, 0.0), (0.0, 1.5)].map(Vec2::from).into_iter().collect();
    let closed = |s: &mut Scene| s.solids[0].model = SolidModel::ClosedForm;
    let nothing = |_: &mut Scene| ();
    for (sentence, heard) in [
        (
            "solids[0].shape.radius is 0, but must be larger",
            told(three, Solid::still(Shape::Ball { radius: 0.0 }, [0.0; 3]), &nothing),
        ),
        (
            "the normals would lead into the solid",
            told(two, Solid::still(Shape::Polygon { corners: clockwise }, [0.0; 3]), &nothing),
        ),
        ("sides that cross", told(two, Solid::still(Shape::Polygon { corners: crossing }, [0.0; 3]), &nothing)),
        (
            "shape Cylinder conflicts with dimension Two",
            told(two, Solid::still(Shape::Cylinder { radius: 0.5, height: 0.5 }, [0.0; 3]), &nothing),
        ),
        (
            "a plane has no end",
            told(three, Solid::still(Shape::Plane, [0.0, -9.0, 0.0]), &|s| s.solids[0].model = SolidModel::Particles),
        ),
        (
            "solids[0].shape.radius (with model ClosedForm) is 0.1",
            told(three, Solid::still(Shape::Ball { radius: 0.1 }, [0.0; 3]), &closed),
        ),
        (
            "fluid particles start inside of solids[0]; move the solid or the blocks",
            told(three, Solid { position: Vec3::new(-8.0, 0.0, 0.0), ..ball() }, &nothing),
        ),
        (
            "a part of the opening lies inside of the solid",
            told(three, ball(), &|s| {
                s.emitters = [Emitter::jet([0.0; 3], Vec3::X, 1.0, Opening::Square(0.1))].into_iter().collect();
                s.spare_particles = 100;
            }),
        ),
        (
            "a plane must be parallel to every periodic axis",
            told(
                two,
                Solid { turned: Vec3::new(0.0, 0.0, 5.0), ..Solid::still(Shape::Plane, [0.0, -9.0, 0.0]) },
                &|s| {
                    let (low, high) = (Vec3::splat(-9.0), Vec3::splat(9.0));
                    s.periodic = Some(Periodic { low, high, axes: [true, false, false] });
                },
            ),
        ),
        ("dimension is 2D", told(two, Solid { turned: Vec3::new(10.0, 0.0, 0.0), ..ball() }, &nothing)),
        (
            "without a frequency nothing oscillates",
            told(
                three,
                Solid { motion: Motion::Prescribed(Course { amplitude: Vec3::X, ..Course::default() }), ..ball() },
                &nothing,
            ),
        ),
        (
            "solids[0].rotation (its length) is 2",
            told(three, Solid { rotation: Quat::from_xyzw(0.0, 0.0, 0.0, 2.0), ..ball() }, &nothing),
        ),
        (
            "model.near_pressure",
            told(three, ball(), &|s| {
                closed(s);
                s.container = Some(Container::closed([-9.0; 3], [9.0; 3]));
                s.model.near_pressure = millpond_core::scene::NearPressure::DoubleDensity;
            }),
        ),
    ] {
        assert!(heard.contains(sentence), "{heard:?} for {sentence:?}");
    }
}
