//! Promise: the first lines of code that a user reads, in the README and in the examples, compile and run as printed.
//!
//! `stack_is_small.rs` runs them once more without optimisation, on a stack of 1 MiB.
use millpond_core::glam::Vec3;
use millpond_core::scene::{Block, Container, Dimension, Fluid, Scene};
use millpond_core::{OwnedMemory, Serial, Solver, Storage};
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
fn of_the_readme_and_of_the_crate() -> Result<(), Box<dyn Error>> {
    let [readme, page] = [include_str!("../../README.md"), include_str!("../src/lib.rs")];
    let lines = code(readme, "```rust", "```");
    assert!(lines.len() >= 19, "{lines:?}");
    let page: Vec<&str> = page.lines().filter_map(|line| line.strip_prefix("//!")).map(str::trim_start).collect();
    assert_eq!(code(&page.join("\n"), "```", "```"), lines, "the first page of the crate, whose lines are a doctest");
    // one frame instead of sixty, since `stack_is_small.rs` runs this unoptimised
    stand_here(&code(readme, "fn main()", "for frame"));

    let water = Fluid { speed_of_sound: 20.0, ..Fluid::default() };
    let column = Block { size: Vec3::splat(0.8), ..Block::default() };
    let mut scene = Scene::of(Dimension::Three, 0.05, 0.001, water, column);
    scene.gravity = Vec3::new(0.0, -9.81, 0.0);
    scene.container = Some(Container::closed(Vec3::ZERO, Vec3::new(2.0, 2.0, 0.8)));
    scene.time_step = scene.check()?.recommended_time_step();
    let mut memory = OwnedMemory::of(&scene.check()?);
    let mut pond = Solver::new(&scene, memory.lend())?;
    let advance = pond.advance(1.0 / 60.0, 50, &Serial)?;
    assert!(advance.steps > 10 && pond.fluid_positions().count() == 4096, "{advance:?}");
    Ok(())
}

#[test]
fn of_the_example_of_a_device_but_for_the_device() -> Result<(), Box<dyn Error>> {
    let lines = code(include_str!("../../gpu/examples/device.rs"), "let fluid =", "let mut on_gpu");
    assert_eq!(lines.len(), 4, "{lines:?}");
    stand_here(&lines);

    let fluid = Fluid { dynamic_viscosity: 10.0, ..Fluid::default() };
    let block = Block { size: Vec3::splat(0.8), jitter: 0.1, ..Block::default() };
    let scene = Scene { average_neighbours: Some(27.0), ..Scene::of(Dimension::Three, 0.05, 0.001, fluid, block) };
    let mut storage: Box<Storage<4096, 32768>> = Storage::boxed();
    let mut on_cpu = Solver::new(&scene, storage.lend())?;
    on_cpu.step(&Serial)?;
    assert_eq!(on_cpu.steps(), 1);
    Ok(())
}
