//! Differences of two states: in which arrays, and how large.
use crate::snapshot::Snapshot;
use millpond_core::Array;
use millpond_core::backend::plan::arrays::Class;
use serde::Serialize;

/// A value for positions and a value for velocities.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct PerQuantity<T> {
    /// For positions.
    pub position: T,
    /// For velocities.
    pub velocity: T,
}

/// Differences of two states.
#[derive(Clone, Debug, PartialEq)]
pub struct Difference {
    /// The first difference, in the order of the arrays and then of the ids, as text.
    pub first: String,
    /// Largest difference, in units in the last place (ULP).
    pub max_ulp: PerQuantity<u32>,
    /// Largest difference, m and m/s; NaN if one of two values is NaN.
    pub max_abs: PerQuantity<f64>,
    /// All arrays of the state that differ in at least one bit.
    pub arrays: Vec<Array>,
}

/// Returns the number of floats between two floats, in ULP. -0 and +0 are one apart, since bits are compared.
#[must_use]
pub fn ulp_distance(a: f32, b: f32) -> u32 {
    let place = |x: f32| {
        let bits = x.to_bits() as i32;
        if bits < 0 { i64::from(i32::MIN) - i64::from(bits) - 1 } else { i64::from(bits) }
    };
    place(a).abs_diff(place(b)) as u32
}

/// Returns the differences of two states, or `None` if all bits are equal. States of different sizes count as different
/// in every array.
#[must_use]
pub fn difference(want: &Snapshot, got: &Snapshot) -> Option<Difference> {
    let state = || Array::ALL.iter().copied().filter(|array| array.class() == Class::State);
    if let Some(array) = state().find(|&array| want.words(array).len() != got.words(array).len()) {
        let [a, b] = [want, got].map(|state| state.words(array).len() / array.words());
        let max_abs = PerQuantity { position: f64::NAN, velocity: f64::NAN };
        let max_ulp = PerQuantity { position: u32::MAX, velocity: u32::MAX };
        let first = format!("{}: {a} entries and {b}", array.name());
        return Some(Difference { first, max_ulp, max_abs, arrays: state().collect() });
    }
    let differing: Vec<ArrayDifference> = state().filter_map(|array| of_array(array, want, got)).collect();
    let step = (want.clock != got.clock).then(|| format!("time steps: {:?}, {:?}", want.clock, got.clock));
    let first = differing.first().map(|found| found.first.clone()).or(step)?;
    let of = |array| differing.iter().find(|found| found.array == array);
    let (position, velocity) = (of(Array::position), of(Array::velocity));
    let ulp = |found: Option<&ArrayDifference>| found.map_or(0, |found| found.ulp);
    let abs = |found: Option<&ArrayDifference>| found.map_or(0.0, |found| found.abs);
    Some(Difference {
        first,
        max_ulp: PerQuantity { position: ulp(position), velocity: ulp(velocity) },
        max_abs: PerQuantity { position: abs(position), velocity: abs(velocity) },
        arrays: differing.iter().map(|found| found.array).collect(),
    })
}

/// Returns the larger of two differences. NaN, once reached, stays.
pub(super) fn larger(before: f64, now: f64) -> f64 {
    if before.is_nan() || now <= before { before } else { now }
}

struct ArrayDifference {
    array: Array,
    first: String,
    ulp: u32,
    abs: f64,
}

/// Compares all words of an array, including the fourth component of each vector.
fn of_array(array: Array, want: &Snapshot, got: &Snapshot) -> Option<ArrayDifference> {
    let mut out: Option<ArrayDifference> = None;
    for (i, (a, b)) in want.words(array).iter().zip(got.words(array)).enumerate() {
        if a == b {
            continue;
        }
        let (id, word) = (i / array.words(), ["x", "y", "z", "w"][i % array.words()]);
        let [a, b] = [a, b].map(|bits| f32::from_bits(*bits));
        let (ulp, abs) = (ulp_distance(a, b), (f64::from(a) - f64::from(b)).abs());
        let found = out.get_or_insert_with(|| {
            let first = format!("{}.{word} of particle {id}: {a:e}, {b:e} ({ulp} ULP)", array.name());
            ArrayDifference { array, first, ulp: 0, abs: 0.0 }
        });
        found.ulp = found.ulp.max(ulp);
        found.abs = larger(found.abs, abs);
    }
    out
}
