//! How a game embeds the fluid: lend memory once, advance the fluid in each frame, draw the particles.
//!
//! `cargo run --release -p millpond-core --example embed`
use millpond_core::glam::Vec3;
use millpond_core::scene::{Block, Container, Dimension, Fluid, Grid, Scene};
use millpond_core::{Serial, Solver, Storage};

/// Room for 4096 particles in 32 x 32 x 1 cells. In a real game: a `static`, or a field of the world.
type Pool = Storage<4096, 1024>;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let water = Fluid { speed_of_sound: 20.0, ..Fluid::default() };
    let block = Block { size: Vec3::new(0.6, 0.8, 0.0), ..Block::default() };
    let mut scene = Scene::of(Dimension::Two, 0.02, 0.0004, water, block);
    scene.gravity = Vec3::new(0.0, -9.81, 0.0);
    scene.container = Some(Container::closed([0.0; 3], [1.6, 1.2, 0.0]));
    scene.grid = Grid { cells: [32, 32, 1], ..Grid::default() };
    let mut pool = Pool::boxed();
    let mut fluid = Solver::new(&scene, pool.lend())?;

    // a frame of a game; a step that is refused leaves the fluid as it was, so the game goes on
    for frame in 0..60 {
        if let Err(refused) = fluid.advance(1.0 / 60.0, 100, &Serial) {
            eprintln!("{refused}");
        }
        if frame % 12 == 0 {
            draw(&fluid);
        }
    }
    println!("after {:.2} s: hash {:016x}", fluid.time(), fluid.hash());
    Ok(())
}

/// The fluid in letters: a game would copy `fluid.state().position` into a vertex buffer, as it is.
fn draw(fluid: &Solver<'_>) {
    let mut rows = [[b' '; 64]; 12];
    for particle in fluid.particles() {
        let (x, y) = ((particle.position.x * 40.0) as usize, (particle.position.y * 10.0) as usize);
        if let Some(place) = rows.get_mut(11 - y.min(11)).and_then(|row| row.get_mut(x)) {
            *place = if particle.velocity.length() > 1.0 { b'~' } else { b'o' };
        }
    }
    println!("t = {:.2} s", fluid.time());
    for row in rows {
        println!("|{}|", String::from_utf8_lossy(&row));
    }
}
