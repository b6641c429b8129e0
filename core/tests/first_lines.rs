//! Promise: the first lines of code that a user reads, in the README and in the examples, compile and run as printed.
//!
//! `stack_is_small.rs` runs them once more without optimisation, on a stack of 1 MiB.
use millpond_core::backend::layout::f32x4;
use millpond_core::glam::Vec3;
use millpond_core::scene::{Block, Dimension, Fluid, Scene};
use millpond_core::{Serial, Solver, Storage};
use std::error::Error;

/// Returns the lines of code between two lines of a text, without comments.
fn code<'t>(text: &'t str, from: &str, to: &str) -> Vec<&'t str> {
    let lines = text.lines().skip_while(|line| !line.contains(from)).skip(1).take_while(|line| !line.contains(to));
    lines.map(|line| line.split("//").next().unwrap_or_default().trim()).filter(|line| !line.is_empty()).collect()
}

/// Asserts that this file contains these lines.
fn stand_here(lines: &[&str]) {
    let here = include_str!("first_lines.rs");
    for line in lines {
        assert!(here.lines().any(|own| own.trim() == *line), "not tried here: {line}");
    }
}

#[test]
fn of_the_readme() -> Result<(), Box<dyn Error>> {
    let lines = code(include_str!("../../README.md"), "```rust", "```");
    assert!(lines.len() >= 4, "{lines:?}");
    stand_here(&lines);

    let scene = Scene::of(
        Dimension::Three,
        0.05,
        0.001,
        Fluid::default(),
        Block { size: Vec3::new(0.8, 0.8, 0.8), jitter: 0.1, ..Block::default() },
    );
    let before = Block::default().velocity;
    let upload = |places: &[f32x4]| assert_eq!(places.len(), 4096);
    let mut storage: Box<Storage<4096, 32768>> = Storage::boxed();
    let mut solver = Solver::new(&scene, storage.lend())?;
    solver.step(&Serial)?;
    upload(solver.state().position);
    assert!(solver.particles().any(|particle| particle.velocity != before), "it moves");
    Ok(())
}

#[test]
fn of_the_example_of_a_device_but_for_the_device() -> Result<(), Box<dyn Error>> {
    let lines = code(include_str!("../../gpu/examples/device.rs"), "let fluid =", "let mut on_gpu");
    assert_eq!(lines.len(), 4, "{lines:?}");
    stand_here(&lines);

    let fluid = Fluid { dynamic_viscosity: 10.0, ..Fluid::default() };
    let block = Block { size: Vec3::splat(0.8), jitter: 0.1, ..Block::default() };
    let scene = Scene { average_neighbours: 27.0, ..Scene::of(Dimension::Three, 0.05, 0.001, fluid, block) };
    let mut storage: Box<Storage<4096, 32768>> = Storage::boxed();
    let mut on_cpu = Solver::new(&scene, storage.lend())?;
    on_cpu.step(&Serial)?;
    assert_eq!(on_cpu.steps(), 1);
    Ok(())
}
