//! The points of emitters and the rows of drains, computed once from the scene.
use super::material::INACTIVE;
use crate::layout::{DRAIN_ROWS, DrainRows, f32x4};
use crate::scene::{DRAINS, Dimension, Drain, Emitter, Opening, Scene};
use glam::DVec3;

const _: () = assert!(DRAIN_ROWS == 2 * DRAINS, "two rows for each drain");

/// Largest number of particles along the width of an opening.
pub(crate) const MOST_ACROSS: f64 = 100.0;

/// A point of an emitter.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Point {
    /// Its position, m.
    pub(crate) place: DVec3,
    /// Velocity of the particles that leave it, m/s.
    pub(crate) velocity: DVec3,
}

/// Returns the points of an emitter: the cell centres of a square lattice across its opening, in rows. It ends for any
/// scene, checked or not.
pub(crate) fn points(scene: &Scene, emitter: &Emitter) -> impl Iterator<Item = Point> {
    let spacing = f64::from(scene.particle_spacing);
    let width = f64::from(emitter.opening.width());
    let across = libm::floor(width / spacing + 0.5).clamp(1.0, MOST_ACROSS);
    // NaN becomes 0
    let (across, half) = (across as u32, across / 2.0);
    let rows = if scene.dimension == Dimension::Two { 1 } else { across };
    let direction = emitter.direction.as_dvec3().normalize_or_zero();
    let [right, up] = across_of(direction, scene.dimension);
    let speed = f64::from(emitter.speed);
    let spread = libm::tan(f64::from(emitter.spread_degrees).to_radians()) / (width / 2.0);
    let is_round = matches!(emitter.opening, Opening::Circle(_));
    let centre = emitter.position.as_dvec3();
    let at = move |index: u32, count: u32| if count == 1 { 0.0 } else { (f64::from(index) + 0.5 - half) * spacing };
    let offsets = (0..rows).flat_map(move |row| (0..across).map(move |column| (row, column)));
    let offsets = offsets.map(move |(row, column)| [at(column, across), at(row, rows)]);
    // a circle of one particle has it, however narrow it is
    let inside = move |[x, y]: &[f64; 2]| !is_round || across == 1 || x * x + y * y <= width * width / 4.0;
    offsets.filter(inside).map(move |[x, y]| {
        let offset = right * x + up * y;
        Point { place: centre + offset, velocity: (direction + offset * spread) * speed }
    })
}

/// Returns two unit vectors across a direction (Duff et al. 2017); in 2D the second one is not used.
fn across_of(d: DVec3, dimension: Dimension) -> [DVec3; 2] {
    if dimension == Dimension::Two {
        return [DVec3::new(-d.y, d.x, 0.0), DVec3::ZERO];
    }
    let sign = if d.z < 0.0 { -1.0 } else { 1.0 };
    let a = -1.0 / (sign + d.z);
    let b = d.x * d.y * a;
    [DVec3::new(1.0 + sign * d.x * d.x * a, sign * b, -sign * d.x), DVec3::new(b, sign + d.y * d.y * a, -d.y)]
}

/// Returns the time between two layers of an emitter, s: they follow each other at the particle spacing.
pub(crate) fn interval(scene: &Scene, emitter: &Emitter) -> f32 {
    scene.particle_spacing / emitter.speed
}

/// Returns the rows of the drains. In 2D a box has no end along z.
pub(crate) fn drains(scene: &Scene) -> DrainRows {
    let mut rows = [[0.0; 4]; DRAIN_ROWS];
    for (rows, drain) in rows.chunks_exact_mut(2).zip(&scene.drains) {
        match *drain {
            Drain::Box { low, high } => {
                (rows[0], rows[1]) = (low.extend(0.0).to_array(), high.extend(0.0).to_array());
                if scene.dimension == Dimension::Two {
                    (rows[0][2], rows[1][2]) = (-f32::MAX, f32::MAX);
                }
            }
            Drain::Ball { centre, radius } => rows[0] = centre.extend(radius * radius).to_array(),
        }
    }
    rows
}

/// Returns the state of an emitter at the start: a first layer is due at its time.
pub(crate) fn state_at_start(scene: &Scene, emitter: &Emitter) -> f32x4 {
    let rest = emitter.duration.map_or(f32::MAX, |duration| emitter.start + duration);
    [interval(scene, emitter) - emitter.start, 0.0, rest, 0.0]
}

/// Fills the arrays of the emitters that steps only read.
pub(crate) fn fill_emitters(scene: &Scene, emitters: &mut [f32x4], rows: &mut [f32x4]) {
    let mut rows = rows.chunks_exact_mut(2);
    for (number, (emitter, own)) in scene.emitters.iter().zip(emitters.iter_mut()).enumerate() {
        *own = [interval(scene, emitter), emitter.life.unwrap_or(f32::MAX), 0.0, 0.0];
        for (point, rows) in points(scene, emitter).zip(&mut rows) {
            rows[0] = point.place.as_vec3().extend(number as f32).to_array();
            rows[1] = point.velocity.as_vec3().extend(emitter.fluid.min(INACTIVE) as f32).to_array();
        }
    }
}
