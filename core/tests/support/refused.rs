//! Fluids whose next step is refused after some good ones; for CPU and device alike.
use super::{checked, thesis_cube};
use millpond_core::scene::{GridStructure, InitialParticle, Kernel, NearPressure, Scene};
use millpond_core::{Axis, Quantity, StepError};

/// A fluid, and the refusal that it must come to.
pub struct Refused {
    /// What it shows.
    pub name: &'static str,
    /// Its scene.
    pub scene: Scene,
    /// Its particles.
    pub places: Vec<InitialParticle>,
    /// Steps that are good.
    pub good: u64,
    /// What the next one is refused by.
    pub error: StepError,
}

/// Particles at these places with these velocities.
pub fn places(at: &[([f32; 3], [f32; 3])]) -> Vec<InitialParticle> {
    at.iter().map(|&(position, velocity)| InitialParticle::at(position, velocity)).collect()
}

/// One of each error of a step.
pub fn all() -> [Refused; 3] {
    [beyond_the_grids_range(), more_particles_than_places(), not_finite_any_more()]
}

fn beyond_the_grids_range() -> Refused {
    // at 1e8 m/s for 1 ms a step the third step passes 2^22 cells of 0.0931 m, or 390 km, for particles 2 and 3
    let places = places(&[
        ([0.0; 3], [0.0; 3]),
        ([1.0, 0.0, 0.0], [0.0, -1e8, 0.0]),
        ([2.0, 0.0, 0.0], [0.0, 1.9e8, 0.0]),
        ([3.0, 0.0, 0.0], [0.0, 1.93e8, 1.93e8]),
    ]);
    let error = StepError::OutOfRange { particle: 2, axis: Axis::Y, step: 3 };
    Refused { name: "out of range", scene: thesis_cube(0.8), places, good: 2, error }
}

fn more_particles_than_places() -> Refused {
    let mut scene = thesis_cube(0.8);
    scene.model.near_pressure = NearPressure::Off;
    scene.grid.structure = GridStructure::CellLists { places: 3 };
    // three rest in cell (0, 0, 0) of 32 x 32 x 32, a fourth flies in from above: at 0.02 m a step it enters at the 5th
    let places = places(&[
        ([0.01, 0.01, 0.01], [0.0; 3]),
        ([0.05, 0.01, 0.05], [0.0; 3]),
        ([0.01, 0.01, 0.08], [0.0; 3]),
        ([0.05, 0.185, 0.05], [0.0, -20.0, 0.0]),
    ]);
    let error = StepError::CellFull { cell: 0, count: 4, capacity: 3, step: 5 };
    Refused { name: "cell full", scene, places, good: 4, error }
}

fn not_finite_any_more() -> Refused {
    // so stiff a fluid that the first pair to meet overflows; apart, nothing acts. Both overflow: the smaller id is named
    let mut scene = thesis_cube(0.8);
    scene.fluids[0].speed_of_sound = 1e18;
    (scene.model.near_pressure, scene.model.pressure_kernel) = (NearPressure::Off, Kernel::CubicSpline);
    // particle 0 stands in the cell of particle 1, out of everyone's reach, and must not be drawn in by a lane beside it
    let at = [[4.945, 0.0, 0.0], [5.025, 0.06, 0.06], [5.125, 0.06, 0.06]];
    let inverse_cell = checked(&scene).derived().parameters.inverse_cell[0];
    let cell = |x: [f32; 3]| x.map(|x| (x * inverse_cell).floor());
    assert_eq!(cell(at[0]), cell(at[1]));
    let places = places(&[(at[0], [0.0; 3]), (at[1], [0.0; 3]), (at[2], [-50.0, 0.0, 0.0])]);
    let error = StepError::NotFinite { particle: 1, quantity: Quantity::Velocity, step: 1 };
    Refused { name: "not finite", scene, places, good: 0, error }
}
