//! Boxes that hold the fluid, from which lost particles are counted.
use glam::Vec3;
use millpond_core::scene::{Face, Scene, WallShape};

/// A box that holds the fluid; infinite on open sides.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Bound {
    low: [f64; 3],
    high: [f64; 3],
}

impl Bound {
    fn of(scene: &Scene, low: Vec3, high: Vec3, open: &[Face]) -> Bound {
        let mut bound = Bound { low: low.to_array().map(f64::from), high: high.to_array().map(f64::from) };
        let round = |axis: usize| scene.periodic.is_some_and(|periodic| periodic.axes[axis]);
        for face in Face::ALL {
            let axis = face.axis();
            if open.contains(&face) || round(axis) || axis >= scene.dimension.count() {
                if face.is_high() { bound.high[axis] = f64::INFINITY } else { bound.low[axis] = f64::NEG_INFINITY }
            }
        }
        bound
    }

    /// Returns whether a position, m, is outside of the box by more than a margin, m.
    pub(super) fn is_outside(&self, place: [f32; 3], margin: f64) -> bool {
        (0..3).any(|axis| {
            let x = f64::from(place[axis]);
            x < self.low[axis] - margin || x > self.high[axis] + margin
        })
    }
}

/// Returns the boxes that hold the fluid of a scene: the container and hollow boxes of wall particles.
pub(super) fn bounds(scene: &Scene) -> Vec<Bound> {
    let container = scene.container.iter().map(|c| Bound::of(scene, c.low, c.high, &c.open));
    let walls = scene.walls.iter().filter_map(|wall| match &wall.shape {
        WallShape::Box { low, high, open } => Some(Bound::of(scene, *low, *high, open)),
        WallShape::Plane { .. } => None,
    });
    container.chain(walls).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scenes::{Changes, load};

    #[test]
    fn an_open_face_holds_nothing() {
        let scene = load("oil-and-water", &Changes::default()).expect("it is built in").file.scene;
        let oil = bounds(&scene);
        let inside = |place| !oil[0].is_outside(place, 0.1);
        assert!(inside([0.5, 0.5, 0.0]) && inside([0.5, 5.0, 0.0]), "the ceiling is open");
        assert!(!inside([0.5, -0.2, 0.0]) && !inside([1.2, 0.5, 0.0]));
    }
}
