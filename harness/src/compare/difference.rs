//! Where two states differ, and by how much.
use crate::fluid::Snapshot;
use millpond_core::layout::f32x4;
use serde::Serialize;

/// Position and velocity of something.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct PerQuantity<T> {
    /// Of positions.
    pub position: T,
    /// Of velocities.
    pub velocity: T,
}

/// How two states differ.
#[derive(Clone, Debug, PartialEq)]
pub struct Difference {
    /// The first value that does, by id, in words.
    pub first: String,
    /// Largest distance in units in the last place.
    pub max_ulp: PerQuantity<u32>,
    /// Largest distance, m and m/s; NaN where one of two values is.
    pub max_abs: PerQuantity<f64>,
}

/// Steps between two floats on the line of all floats; -0 and +0 are one step apart, as bits are what is compared.
#[must_use]
pub fn ulp_distance(a: f32, b: f32) -> u32 {
    let place = |x: f32| {
        let bits = x.to_bits() as i32;
        if bits < 0 { i64::from(i32::MIN) - i64::from(bits) - 1 } else { i64::from(bits) }
    };
    place(a).abs_diff(place(b)) as u32
}

/// What differs between two states, if any bit does. States of different sizes differ everywhere.
#[must_use]
pub fn difference(want: &Snapshot, got: &Snapshot) -> Option<Difference> {
    if want.position.len() != got.position.len() || want.velocity.len() != got.velocity.len() {
        let (a, b) = (want.position.len(), got.position.len());
        let max_abs = PerQuantity { position: f64::NAN, velocity: f64::NAN };
        let max_ulp = PerQuantity { position: u32::MAX, velocity: u32::MAX };
        return Some(Difference { first: format!("{a} particles against {b}"), max_ulp, max_abs });
    }
    let position = of_array("position", &want.position, &got.position);
    let velocity = of_array("velocity", &want.velocity, &got.velocity);
    let step = (want.clock != got.clock).then(|| format!("the time step: {:?}, {:?}", want.clock, got.clock));
    let first = position.first.or(velocity.first).or(step)?;
    Some(Difference {
        first,
        max_ulp: PerQuantity { position: position.ulp, velocity: velocity.ulp },
        max_abs: PerQuantity { position: position.abs, velocity: velocity.abs },
    })
}

struct ArrayDifference {
    first: Option<String>,
    ulp: u32,
    abs: f64,
}

fn of_array(name: &str, want: &[f32x4], got: &[f32x4]) -> ArrayDifference {
    let mut out = ArrayDifference { first: None, ulp: 0, abs: 0.0 };
    for (id, (a, b)) in want.iter().zip(got).enumerate() {
        for (axis, (a, b)) in a.iter().zip(b).take(3).enumerate() {
            if a.to_bits() != b.to_bits() {
                let ulp = ulp_distance(*a, *b);
                let axis = ["x", "y", "z"][axis];
                out.first.get_or_insert_with(|| format!("{name}.{axis} of particle {id}: {a:e}, {b:e} ({ulp} ULP)"));
                out.ulp = out.ulp.max(ulp);
                let abs = (f64::from(*a) - f64::from(*b)).abs();
                out.abs = if abs <= out.abs { out.abs } else { abs };
            }
        }
    }
    out
}
