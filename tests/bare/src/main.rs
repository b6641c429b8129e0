//! Steps a dam break in static memory with nothing but core, and prints the state hash.
#![no_std]
#![no_main]

use core::ffi::{c_char, c_int, c_void};
use millpond_core::scene::{Block, Container, Dimension, Fluid, Grid, ModelChoice, Reflection, Scene};
use millpond_core::{Serial, Solver, Storage};

static mut STORAGE: Storage<1000, 512> = Storage::new();

#[link(name = "c")]
unsafe extern "C" {
    fn write(file: c_int, bytes: *const c_void, count: usize) -> isize;
    fn abort() -> !;
}

#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    // SAFETY: ends the process.
    unsafe { abort() }
}

/// A thousand particles in the corner of a box; `tests/core_stands_alone.rs` steps the same.
fn scene() -> Scene {
    let block = Block { corner: [0.0; 3], size: [0.5; 3], velocity: [0.0; 3], jitter: 0.02 };
    let (low, high) = ([0.0; 3], [1.0, 1.0, 0.5]);
    let reflection = Reflection::EnergyConserving;
    let container = Container { low, high, bounce: 0.5, slip: 0.9, reflection, open: Default::default() };
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

#[unsafe(no_mangle)]
extern "C" fn main(_: c_int, _: *const *const c_char) -> c_int {
    // SAFETY: main runs once, so this is the only reference.
    let storage = unsafe { &mut *(&raw mut STORAGE) };
    let Ok(mut solver) = Solver::new(&scene(), storage.lend()) else { return 2 };
    for _ in 0..200 {
        if solver.step(&Serial).is_err() {
            return 3;
        }
    }
    let hash = solver.hash();
    let digits: [u8; 16] = core::array::from_fn(|i| b"0123456789abcdef"[(hash >> (60 - 4 * i)) as usize & 15]);
    // SAFETY: the pointer and the length are those of one array.
    let written = unsafe { write(1, digits.as_ptr().cast(), digits.len()) };
    c_int::from(written != 16)
}
