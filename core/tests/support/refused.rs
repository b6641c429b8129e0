//! Fluids that make some good steps and then one that is refused, for tests of the CPU and of a device.
use super::{checked, thesis_cube};
use millpond_core::scene::{GridStructure, InitialParticle, Kernel, NearPressure, Scene};
use millpond_core::{Axis, Quantity, StepError};

/// A fluid, and the error with which a step of it must be refused.
pub struct Refused {
    /// Name of the case.
    pub name: &'static str,
    /// Its scene.
    pub scene: Scene,
    /// Its particles.
    pub places: Vec<InitialParticle>,
    /// Number of steps that succeed.
    pub good: u64,
    /// The error of the next step.
    pub error: StepError,
}

/// Returns particles at these positions with these velocities.
pub fn places(at: &[([f32; 3], [f32; 3])]) -> Vec<InitialParticle> {
    at.iter().map(|&(position, velocity)| InitialParticle::at(position, velocity)).collect()
}

/// Returns one case each for a particle out of range, a full cell and a number that is not finite.
pub fn all() -> Vec<Refused> {
    vec![beyond_the_grids_range(), more_particles_than_places(), not_finite_any_more()]
}

fn beyond_the_grids_range() -> Refused {
    // in steps of 1 ms particles 2 and 3 move 190 km or more, so the third step takes them beyond the grid's range of
    // 2^22 cells of 0.0931 m, or 390 km
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
    // three particles rest in cell (0, 0, 0) of 32 x 32 x 32, and a fourth flies in from above: at 0.02 m a step it
    // enters the cell in the fifth step
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
    // the fluid is so stiff that the force of the first pair to meet overflows; particles that are apart do not
    // interact. Both particles overflow, and the error names the smaller id
    let mut scene = thesis_cube(0.8);
    scene.fluids[0].speed_of_sound = 1e18;
    (scene.model.near_pressure, scene.model.pressure_kernel) = (NearPressure::Off, Kernel::CubicSpline);
    // particle 0 lies in the cell of particle 1, but out of range of all other particles; the SIMD lane beside it must
    // not affect it
    let at = [[4.945, 0.0, 0.0], [5.025, 0.06, 0.06], [5.125, 0.06, 0.06]];
    let inverse_cell = checked(&scene).derived().parameters.inverse_cell[0];
    let cell = |x: [f32; 3]| x.map(|x| (x * inverse_cell).floor());
    assert_eq!(cell(at[0]), cell(at[1]));
    let places = places(&[(at[0], [0.0; 3]), (at[1], [0.0; 3]), (at[2], [-50.0, 0.0, 0.0])]);
    let error = StepError::NotFinite { particle: 1, quantity: Quantity::Velocity, step: 1 };
    Refused { name: "not finite", scene, places, good: 0, error }
}
