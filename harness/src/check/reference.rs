//! References from outside of the project: published tables, and series that are evaluated here.
use crate::failure::Failure;
use std::f64::consts::PI;

/// Returns the rows of a table, without the line of its source and the line of titles.
pub(super) fn rows(text: &'static str) -> impl Iterator<Item = Vec<&'static str>> {
    let lines = text.lines().filter(|line| !line.starts_with('#') && !line.trim().is_empty());
    lines.skip(1).map(|line| line.split(',').map(str::trim).collect())
}

/// Reads a table that contains only numbers.
///
/// # Errors
/// An entry is not a number.
pub(super) fn numbers(text: &'static str) -> Result<Vec<Vec<f64>>, Failure> {
    rows(text).map(|row| row.into_iter().map(number).collect()).collect()
}

/// Reads a table of pairs of numbers.
///
/// # Errors
/// An entry is not a number, or a row is not a pair.
pub(super) fn pairs(text: &'static str) -> Result<Vec<[f64; 2]>, Failure> {
    let pair = |row: Vec<f64>| <[f64; 2]>::try_from(row).map_err(|row| broken(&format!("{row:?}")));
    numbers(text)?.into_iter().map(pair).collect()
}

/// Reads a number of a table.
///
/// # Errors
/// The text is not a number.
pub(super) fn number(word: &str) -> Result<f64, Failure> {
    word.parse().map_err(|_| broken(word))
}

/// Returns an entry of a row.
///
/// # Errors
/// The row is too short.
pub(super) fn entry(row: &[&'static str], column: usize) -> Result<&'static str, Failure> {
    row.get(column).copied().ok_or_else(|| broken(&row.join(",")))
}

fn broken(what: &str) -> Failure {
    Failure::System(format!("cannot read a reference table at {what}"))
}

/// Terms of the series. The last one is negligible from the first time on at which the series are used.
const TERMS: u32 = 60;

/// Returns the velocity in a channel of width 1 and viscosity 1, at the share `y` of its width, at the time `t` after a
/// body force of 1 sets in (Morris, Fox and Zhu 1997, eq. 21). Its largest value, in steady flow, is 1/8.
pub(super) fn poiseuille(y: f64, t: f64) -> f64 {
    let term = |n: u32| {
        let k = f64::from(2 * n + 1) * PI;
        4.0 / k.powi(3) * (k * y).sin() * (-k * k * t).exp()
    };
    y * (1.0 - y) / 2.0 - (0..TERMS).map(term).sum::<f64>()
}

/// Returns the velocity in a channel of width 1 and viscosity 1 after the side `y = 1` starts to move with velocity 1
/// (Morris, Fox and Zhu 1997, eq. 22).
pub(super) fn couette(y: f64, t: f64) -> f64 {
    let term = |n: u32| {
        let k = f64::from(n) * PI;
        let sign = if n.is_multiple_of(2) { 1.0 } else { -1.0 };
        2.0 / k * sign * (k * y).sin() * (-k * k * t).exp()
    };
    y + (1..=TERMS).map(term).sum::<f64>()
}

/// Returns the value at `x` of a piecewise linear curve through `points`, which ascend in x. It is constant beyond its
/// ends.
pub(super) fn along(points: &[[f64; 2]], x: f64) -> f64 {
    let after = points.partition_point(|point| point[0] < x);
    match (after.checked_sub(1).and_then(|i| points.get(i)), points.get(after)) {
        (Some([x0, y0]), Some([x1, y1])) => y0 + (y1 - y0) * (x - x0) / (x1 - x0),
        (Some([_, y]), None) | (None, Some([_, y])) => *y,
        (None, None) => f64::NAN,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn curves_are_straight_between_points() {
        let points = [[0.0, 1.0], [1.0, 3.0], [2.0, 3.5]];
        assert_eq!(along(&points, 0.5), 2.0);
        assert_eq!(along(&points, -1.0), 1.0);
        assert_eq!(along(&points, 5.0), 3.5);
        assert!(along(&[], 0.0).is_nan());
    }

    #[test]
    fn a_channel_starts_at_rest() {
        assert!(poiseuille(0.5, 0.0).abs() < 1e-5);
        assert!((poiseuille(0.5, 10.0) - 0.125).abs() < 1e-12);
        assert!((couette(0.3, 10.0) - 0.3).abs() < 1e-12);
    }
}
