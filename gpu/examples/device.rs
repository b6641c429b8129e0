//! Steps the same fluid on a device and on the CPU, and checks that both have the same bits.
//!
//! `cargo run --release -p millpond-gpu --example device`
use millpond_core::glam::Vec3;
use millpond_core::scene::{Block, Dimension, Fluid, Scene};
use millpond_core::{Serial, Solver, Storage};
use millpond_gpu::{Gpu, GpuSolver, Mode};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let gpu = match Gpu::open(None, Mode::Strict) {
        Ok(gpu) => gpu,
        Err(error) => {
            println!("nothing to show here: {error}");
            return Ok(());
        }
    };
    let fluid = Fluid { dynamic_viscosity: 10.0, ..Fluid::default() };
    let block = Block { size: Vec3::splat(0.8), jitter: 0.1, ..Block::default() };
    let scene = Scene { average_neighbours: Some(27.0), ..Scene::of(Dimension::Three, 0.05, 0.001, fluid, block) };
    let mut storage: Box<Storage<4096, 32768>> = Storage::boxed();
    let mut on_cpu = Solver::new(&scene, storage.lend())?;
    let mut on_gpu = GpuSolver::new(&gpu, &on_cpu)?;
    println!("{}", gpu.name());
    for _ in 0..5 {
        on_gpu.step(20)?;
        for _ in 0..20 {
            on_cpu.step(&Serial)?;
        }
        let (cpu, gpu) = (on_cpu.hash(), on_gpu.read()?.hash());
        println!("step {}: cpu {cpu:016x}, gpu {gpu:016x}", on_cpu.steps());
        assert_eq!(cpu, gpu, "strict mode promises the same bits");
    }
    Ok(())
}
