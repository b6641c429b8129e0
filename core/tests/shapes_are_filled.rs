//! Promise: a ball of fluid has as many particles as it says, all of them inside of it, and the volume of a ball.
use millpond_core::glam::Vec3;
use millpond_core::scene::{Block, BlockShape, Dimension, Fluid, Scene};

const SPACING: f32 = 0.05;

fn ball(dimension: Dimension, size: Vec3) -> Scene {
    let block = Block { corner: Vec3::new(0.3, -0.2, 0.0), size, shape: BlockShape::Ball, ..Block::default() };
    Scene::of(dimension, SPACING, 0.001, Fluid::default(), block)
}

#[test]
fn its_particles_are_counted_and_lie_inside() {
    for dimension in [Dimension::Two, Dimension::Three] {
        for size in [[0.05, 0.05, 0.05], [0.1, 0.3, 0.3], [0.5, 0.5, 0.5], [0.45, 0.2, 0.7], [1.0, 0.05, 0.35]] {
            let size = Vec3::from(size);
            let scene = ball(dimension, size);
            let checked = scene.check().expect("a scene");
            let places: Vec<Vec3> = checked.initial_particles().map(|particle| particle.position).collect();
            assert_eq!(places.len(), checked.derived().particles(), "{dimension:?}, {size}");
            let middle = scene.blocks[0].corner + size / 2.0;
            for place in places {
                let mut off = (place - middle) / (size / 2.0);
                if dimension == Dimension::Two {
                    off.z = 0.0;
                }
                assert!(off.length() < 1.0 + 1e-5, "{dimension:?}, {size}: {place}");
            }
        }
    }
}

#[test]
fn its_volume_converges_to_that_of_a_ball() {
    let pi = std::f64::consts::PI;
    for (dimension, share) in [(Dimension::Two, pi / 4.0), (Dimension::Three, pi / 6.0)] {
        let scene = ball(dimension, Vec3::splat(60.0 * SPACING));
        let count = scene.check().expect("a scene").derived().fluid_particles;
        let cells = 60f64.powi(if dimension == Dimension::Two { 2 } else { 3 });
        // the lattice decides over the cells that the surface cuts, of which there are 60 in a row, or 60 times 60
        assert!((count as f64 / (share * cells) - 1.0).abs() < 0.01, "{dimension:?}: {count}");
    }
}
