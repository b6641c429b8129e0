//! Unusual scenes: extreme time steps, supports, viscosities and speeds of sound, empty fluids, and positions at which
//! f32 has too few digits.
use super::{Case, End, Measure, built_in};
use crate::failure::Failure;
use glam::Vec3;
use millpond_core::backend::derive::support_radius;
use millpond_core::scene::{Container, GridStructure, PlaneModel, Scene, Viscosity, Wall, WallShape};
use millpond_core::{Axis, SceneError, StepError};

/// Number of particles of a case.
const PARTICLES: u64 = 200;

/// Number of cells. There are fewer than usual, because the grid wraps anyway and a software GPU visits each cell in
/// turn.
pub(super) const CELLS: [u32; 3] = [8, 8, 8];

/// Number of steps, enough for an unstable scene to become visibly so.
const STEPS: u32 = 120;

/// Returns the cases.
///
/// # Errors
/// A built-in scene that cannot be read.
pub fn cases() -> Result<Vec<Case>, Failure> {
    // jitter and density sums other than 1 would store energy in the pressure at the start, and release it later
    let mut dam = built_in("dam-break-2d", PARTICLES)?;
    dam.grid.cells = CELLS;
    dam.model.normalize_mass = true;
    dam.blocks.iter_mut().for_each(|block| block.jitter = 0.0);
    let mut cube = built_in("thesis-cube", PARTICLES)?;
    cube.grid.cells = CELLS;
    cube.time_step *= 10.0;
    let mut cases = time_steps(&dam);
    cases.push(Case::of_scene("a cube in steps 10 times too large", cube, STEPS, End::Either(Measure::Honest)));
    cases.extend(supports(&dam));
    cases.extend(viscosities(&dam));
    cases.extend(sound(&dam));
    cases.extend(nothing(&dam));
    cases.extend(distances(&dam));
    Ok(cases)
}

fn changed(scene: &Scene, change: impl FnOnce(&mut Scene)) -> Scene {
    let mut scene = scene.clone();
    change(&mut scene);
    scene
}

fn time_steps(dam: &Scene) -> Vec<Case> {
    let with = |time_step: f32| changed(dam, |s| s.time_step = time_step);
    let not_positive = End::Refused(|e| matches!(e, SceneError::NotPositive { field, .. } if *field == "time_step"));
    let scale = End::Refused(|e| matches!(e, SceneError::OutOfScale { field, .. } if *field == "time_step"));
    vec![
        Case::of_scene("a time step of 0", with(0.0), 1, not_positive),
        Case::of_scene("a time step of -0.001 s", with(-1e-3), 1, not_positive),
        Case::of_scene("a time step of 1e-30 s", with(1e-30), 10, End::Runs(Measure::Stays)),
        Case::of_scene("a time step of 1e-40 s", with(1e-40), 1, scale),
        Case::of_scene(
            "a time step 10 times too large",
            with(10.0 * dam.time_step),
            STEPS,
            End::Either(Measure::Honest),
        ),
        Case::of_scene(
            "a time step 1000 times too large",
            with(1000.0 * dam.time_step),
            STEPS,
            End::Either(Measure::Honest),
        ),
    ]
}

fn supports(dam: &Scene) -> Vec<Case> {
    // a tenth of a neighbour on average, and below a support radius that is ten times larger
    let alone = changed(dam, |s| {
        s.average_neighbours = Some(0.1);
        s.model.normalize_mass = false;
        s.container = None;
    });
    let wide = changed(dam, |s| s.average_neighbours = Some(3200.0));
    // it would reach over both walls in closed form
    let wide = changed(&wide, |s| {
        s.model.normalize_mass = false;
        if let Some(container) = &mut s.container {
            container.model = PlaneModel::Penalty;
        }
    });
    let lists = changed(&wide, |s| s.grid.structure = GridStructure::CellLists { places: 16 });
    let full = End::Refused(
        |e| matches!(e, SceneError::FirstStep(StepError::CellFull { count, capacity: 16, step: 1, .. }) if *count > 16),
    );
    vec![
        Case::of_scene("a support radius below the spacing", alone.clone(), 100, End::Runs(Measure::Falls)),
        Case::of_scene("the same support radius, warned of", alone, 1, End::Runs(Measure::Warned)),
        Case::of_scene("a support radius 10 times too large", wide, 10, End::Either(Measure::Honest)),
        Case::of_scene("this support radius, cells of 16 places", lists, 10, full),
    ]
}

fn viscosities(dam: &Scene) -> Vec<Case> {
    let none = changed(dam, |s| s.fluids[0].dynamic_viscosity = 0.0);
    let mut cases = vec![Case::of_scene("no viscosity", none, STEPS, End::Either(Measure::Honest))];
    for viscosity in [Viscosity::Mueller, Viscosity::Morris, Viscosity::MonaghanGingold] {
        for mu in [1e3, 1e9] {
            let scene = changed(dam, |s| {
                s.model.viscosity = viscosity;
                s.fluids[0].dynamic_viscosity = mu;
                // without jitter the block falls as a whole, and there are no velocity differences
                s.blocks.iter_mut().for_each(|block| block.jitter = 0.1);
            });
            let name = format!("a viscosity of {mu:e} Pa s, {}", viscosity.name());
            cases.push(Case::of_scene(name, scene, STEPS, End::Either(Measure::Honest)));
        }
    }
    let artificial = changed(dam, |s| {
        s.model.viscosity = Viscosity::Artificial;
        s.model.alpha = 1e6;
    });
    cases.push(Case::of_scene("an artificial viscosity of alpha 1e6", artificial, STEPS, End::Either(Measure::Honest)));
    cases
}

fn sound(dam: &Scene) -> Vec<Case> {
    let with = |speed: f32, time_step: f32| {
        changed(dam, |s| {
            s.fluids[0].speed_of_sound = speed;
            s.time_step = time_step;
        })
    };
    // case X1 of the validation catalogue: a quarter of the time that sound takes through half of the support radius
    let fitting = 0.25 * support_radius(dam) as f32 / 2.0 / 1500.0;
    // case X4: a block that hits a wall at the speed of its own sound
    let mach_1 = changed(&with(50.0, 5e-5), |s| {
        for block in &mut s.blocks {
            block.corner[1] += 0.01;
            block.velocity = Vec3::new(0.0, -50.0, 0.0);
        }
    });
    vec![
        Case::of_scene(
            "1500 m/s with Tait in steps of 1e-3 s",
            with(1500.0, 1e-3),
            STEPS,
            End::Either(Measure::Honest),
        ),
        Case::of_scene(
            "1500 m/s with Tait in steps that fit",
            with(1500.0, fitting),
            3 * STEPS,
            End::Runs(Measure::Contained),
        ),
        Case::of_scene("a block hits a wall at Mach 1", mach_1, STEPS, End::Runs(Measure::Contained)),
    ]
}

/// Returns cases of empty or weightless fluids, and of walls without a fluid.
fn nothing(dam: &Scene) -> Vec<Case> {
    let flat = changed(dam, |s| s.blocks.iter_mut().for_each(|block| block.size[1] = 0.0));
    let thin = changed(dam, |s| s.blocks.iter_mut().for_each(|block| block.size[1] = 0.4 * s.particle_spacing));
    let weightless = changed(dam, |s| s.fluids[0].rest_density = 0.0);
    let walls = changed(dam, |s| {
        s.blocks.clear();
        s.container = None;
        let shape = WallShape::Box { low: Vec3::ZERO, high: Vec3::new(0.5, 0.5, 0.0), open: [].into_iter().collect() };
        s.walls = [Wall::still(shape)].into_iter().collect();
    });
    let size = End::Refused(|e| matches!(e, SceneError::NotPositive { field, .. } if *field == "blocks[0].size"));
    let empty = End::Refused(|e| matches!(e, SceneError::EmptyBlock { block: 0, axis: Axis::Y, .. }));
    let density =
        End::Refused(|e| matches!(e, SceneError::NotPositive { field, .. } if *field == "fluids[0].rest_density"));
    vec![
        Case::of_scene("a block of no height", flat, 1, size),
        Case::of_scene("a block thinner than half a spacing", thin, 1, empty),
        Case::of_scene("a fluid of no density", weightless, 1, density),
        Case::of_scene("walls and no fluid", walls, 10, End::Runs(Measure::Stays)),
    ]
}

/// Returns cases of a block far from the origin (case X8 of the validation catalogue).
fn distances(dam: &Scene) -> Vec<Case> {
    let away = |x: f32| {
        changed(dam, |s| {
            s.blocks.iter_mut().for_each(|block| block.corner[0] += x);
            if let Some(Container { low, high, .. }) = &mut s.container {
                low[0] += x;
                high[0] += x;
            }
        })
    };
    let refused = End::Refused(|e| matches!(e, SceneError::OutOfBounds { field, .. } if *field == "blocks[0].corner"));
    vec![
        Case::of_scene("a block 1e3 m away", away(1e3), STEPS, End::Runs(Measure::Contained)),
        Case::of_scene("a block 1e4 m away", away(1e4), STEPS, refused),
        Case::of_scene("a block -1e6 m away", away(-1e6), STEPS, refused),
        Case::of_scene("a block 1e9 m away", away(1e9), STEPS, refused),
        Case::of_scene(
            "a container that reaches to 1e30 m",
            changed(dam, |s| {
                if let Some(Container { high, .. }) = &mut s.container {
                    high[0] = 1e30;
                }
            }),
            10,
            End::Either(Measure::Finite),
        ),
    ]
}
