//! What `tests/bare` steps, and `tests/core_stands_alone.rs` beside it.
use millpond_core::scene::{Block, Container, Dimension, Fluid, Grid, ModelChoice, Reflection, Scene};

/// A thousand particles in the corner of a box.
pub fn scene() -> Scene {
    let block = Block { corner: [0.0; 3], size: [0.5; 3], velocity: [0.0; 3], jitter: 0.02 };
    let (low, high) = ([0.0; 3], [1.0, 1.0, 0.5]);
    let reflection = Reflection::EnergyConserving;
    let container = Container { low, high, bounce: 0.5, slip: 0.9, reflection, open: [].into_iter().collect() };
    Scene {
        dimension: Dimension::Three,
        particle_spacing: 0.05,
        average_neighbours: 32.0,
        time_step: 0.001,
        gravity: [0.0, -9.81, 0.0],
        fluid: Fluid { rest_density: 1000.0, speed_of_sound: 20.0, dynamic_viscosity: 2.0, near_stiffness: None },
        blocks: [block].into_iter().collect(),
        container: Some(container),
        model: ModelChoice::default(),
        grid: Grid { cells: [8, 8, 8], ..Grid::default() },
    }
}
