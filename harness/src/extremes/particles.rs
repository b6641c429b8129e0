//! Unusual particles: none, one, several at the same position, far ones, ones with values that are not finite, too many
//! for a cell.
use super::settings::CELLS;
use super::{Case, End, Measure, built_in};
use crate::failure::Failure;
use glam::Vec3;
use millpond_core::Quantity;
use millpond_core::scene::{GridStructure, InitialParticle, NearPressure, Scene};
use millpond_core::{Axis, SceneError, StepError};

/// Number of steps of a free fall of 0.1 s.
const FALL: u32 = 100;

/// Number of particles along each edge of a square of particles that share a cell (case X9 of the validation
/// catalogue).
const CROWD: u16 = 100;

/// Returns the cases.
///
/// # Errors
/// A built-in scene that cannot be read.
pub fn cases() -> Result<Vec<Case>, Failure> {
    let mut open = built_in("thesis-cube", 200)?;
    open.grid.cells = CELLS;
    open.gravity = Vec3::new(0.0, -9.81, 0.0);
    let mut cases = few(&open);
    cases.extend(coincident(&open));
    cases.extend(far(&open));
    cases.extend(no_numbers(&open));
    cases.extend(crowded(&open));
    Ok(cases)
}

fn at(x: f32) -> InitialParticle {
    InitialParticle::at([x, 0.0, 0.0], [0.0; 3])
}

fn few(scene: &Scene) -> Vec<Case> {
    let mut empty = scene.clone();
    empty.blocks.clear();
    vec![
        Case::of_scene("a scene without a block", empty, 3, End::Runs(Measure::Finite)),
        Case::of_places("no particle", scene, Vec::new(), 3, End::Runs(Measure::Finite)),
        Case::of_places("one particle", scene, vec![at(0.1)], FALL, End::Runs(Measure::Falls)),
    ]
}

fn coincident(scene: &Scene) -> Vec<Case> {
    let many = |count: usize| vec![at(0.1); count];
    // in f32 the square of 1e-30 m is 0, and that of 1e-20 m is denormal, with few digits left
    let apart = |distance: f32| vec![at(-0.5 * distance), at(0.5 * distance)];
    let mut light = scene.clone();
    light.gravity = Vec3::ZERO;
    let slow = |v: f32| InitialParticle::at([0.0, 1.0, 0.0], [v, -v, 0.0]);
    vec![
        Case::of_places("two coincident particles", scene, many(2), FALL, End::Runs(Measure::Falls)),
        Case::of_places("1000 coincident particles", scene, many(1000), 3, End::Runs(Measure::Falls)),
        Case::of_places("two particles 1e-30 m apart", scene, apart(1e-30), FALL, End::Runs(Measure::Falls)),
        Case::of_places("two particles 1e-20 m apart", scene, apart(1e-20), FALL, End::Runs(Measure::Subsonic)),
        Case::of_places("two particles 1e-10 m apart", scene, apart(1e-10), FALL, End::Runs(Measure::Subsonic)),
        Case::of_places("a denormal velocity", &light, vec![slow(1e-40)], 3, End::Runs(Measure::Rests)),
        Case::of_places("a velocity of -0", &light, vec![slow(-0.0)], 3, End::Runs(Measure::Rests)),
    ]
}

fn far(scene: &Scene) -> Vec<Case> {
    let beside = |x: f32| vec![at(0.1), at(x)];
    let fast = |v: f32| vec![at(0.1), InitialParticle::at([0.0; 3], [0.0, v, 0.0])];
    let start = End::Refused(|error| {
        matches!(error, SceneError::FirstStep(StepError::OutOfRange { particle: 1, axis: Axis::X, step: 1 }))
    });
    let first = End::Stopped(|error| matches!(error, StepError::OutOfRange { particle: 1, axis: Axis::Y, step: 1 }));
    let fourth = End::Stopped(|error| matches!(error, StepError::OutOfRange { particle: 1, axis: Axis::Y, step: 4 }));
    vec![
        Case::of_places("a particle 1e5 m away", scene, beside(1e5), FALL, End::Runs(Measure::Falls)),
        Case::of_places("a particle 1e5 m away, warned of", scene, beside(1e5), 1, End::Runs(Measure::Warned)),
        Case::of_places("a particle 1e6 m away", scene, beside(1e6), 1, start),
        Case::of_places("a particle 1e9 m away", scene, beside(1e9), 1, start),
        Case::of_places("a particle -1e30 m away", scene, beside(-1e30), 1, start),
        Case::of_places("a velocity of 1e8 m/s", scene, fast(1e8), 10, fourth),
        Case::of_places("a velocity of 1e30 m/s", scene, fast(1e30), 1, first),
        Case::of_places("a velocity of 3e38 m/s", scene, fast(3e38), 1, first),
    ]
}

fn no_numbers(scene: &Scene) -> Vec<Case> {
    let position =
        End::Refused(|e| matches!(e, SceneError::ParticleNotFinite { particle: 1, quantity: Quantity::Position }));
    let velocity =
        End::Refused(|e| matches!(e, SceneError::ParticleNotFinite { particle: 1, quantity: Quantity::Velocity }));
    let density =
        End::Refused(|e| matches!(e, SceneError::ParticleNotFinite { particle: 1, quantity: Quantity::Density }));
    let mass = End::Refused(|e| matches!(e, SceneError::NotPositive { field, .. } if *field == "mass of a particle"));
    // with the hydrostatic start the particles have masses of their own
    let mut weighed = scene.clone();
    weighed.model.initialize_hydrostatic = true;
    let mut cases = Vec::new();
    for bad in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
        let mut case = |what: &str, place: InitialParticle, end| {
            let name = format!("a {what} of {bad}");
            cases.push(Case::of_places(name, &weighed, vec![at(0.1), place, at(0.2)], 1, end));
        };
        case("position", InitialParticle { position: Vec3::new(0.0, bad, 0.0), ..at(0.0) }, position);
        case("velocity", InitialParticle { velocity: Vec3::new(0.0, 0.0, bad), ..at(0.0) }, velocity);
        case("density", InitialParticle { deviation: bad, ..at(0.0) }, density);
        case("pressure", InitialParticle { pressure: bad, ..at(0.0) }, density);
        case("mass", InitialParticle { mass: bad, ..at(0.0) }, mass);
    }
    cases.push(Case::of_places("a mass of 0", &weighed, vec![InitialParticle { mass: 0.0, ..at(0.0) }], 1, mass));
    cases
}

/// Returns cases with many particles in one cell of a grid that wraps around. They are too far from each other to
/// interact.
fn crowded(scene: &Scene) -> Vec<Case> {
    let mut small = scene.clone();
    small.grid.cells = [3, 3, 3];
    let inverse_cell = small.check().map_or(0.0, |small| small.derived().parameters.inverse_cell[0]);
    let cell = 1.0 / inverse_cell;
    // centres of cells that are three cells apart and wrap to the same cell of the grid
    let along = |i: u16| cell * (0.5 + 3.0 * f32::from(i));
    let square = (0..CROWD).flat_map(|j| (0..CROWD).map(move |i| [i, j]));
    // close to y = 0, so that f32 resolves the first step of the fall
    let square = square.map(|[i, j]| InitialParticle::at([along(i), 0.001 * cell, along(j)], [0.0; 3]));
    let crowd: Vec<InitialParticle> = square.collect();
    let mut lists = small.clone();
    lists.grid.structure = GridStructure::CellLists { places: 16 };
    let full = End::Refused(|error| {
        let full = StepError::CellFull { cell: 0, count: 10_000, capacity: 16, step: 1 };
        *error == SceneError::FirstStep(full)
    });

    // three particles are at rest in a cell of three places, and a fourth flies into it
    let mut three = scene.clone();
    three.gravity = Vec3::ZERO;
    three.model.near_pressure = NearPressure::Off;
    three.grid.structure = GridStructure::CellLists { places: 3 };
    let resting =
        [[0.01, 0.01, 0.01], [0.05, 0.01, 0.05], [0.01, 0.01, 0.08]].map(|x| InitialParticle::at(x, [0.0; 3]));
    let mut flight = resting.to_vec();
    flight.push(InitialParticle::at([0.05, 0.185, 0.05], [0.0, -20.0, 0.0]));
    let fourth = End::Stopped(|error| matches!(error, StepError::CellFull { cell: 0, count: 4, capacity: 3, .. }));
    let mut sorted = three.clone();
    sorted.grid.structure = GridStructure::IndexSort;
    vec![
        Case::of_places("10^4 particles in a cell", &small, crowd.clone(), 1, End::Runs(Measure::Falls)),
        Case::of_places("10^4 particles in a cell of 16 places", &lists, crowd, 1, full),
        Case::of_places("a particle flies into a full cell", &three, flight.clone(), 20, fourth),
        Case::of_places("a particle flies in, index sort", &sorted, flight, 20, End::Runs(Measure::Finite)),
    ]
}
