//! References from outside: tables that others measured or computed, and series that are computed here.
use crate::failure::Failure;
use std::f64::consts::PI;

/// Rows of a table: what follows its line of source and its line of titles.
pub(super) fn rows(text: &'static str) -> impl Iterator<Item = Vec<&'static str>> {
    let lines = text.lines().filter(|line| !line.starts_with('#') && !line.trim().is_empty());
    lines.skip(1).map(|line| line.split(',').map(str::trim).collect())
}

/// A table of nothing but numbers.
///
/// # Errors
/// What is no number.
pub(super) fn numbers(text: &'static str) -> Result<Vec<Vec<f64>>, Failure> {
    rows(text).map(|row| row.into_iter().map(number).collect()).collect()
}

/// A table of pairs of numbers.
///
/// # Errors
/// What is no number, or no pair.
pub(super) fn pairs(text: &'static str) -> Result<Vec<[f64; 2]>, Failure> {
    let pair = |row: Vec<f64>| <[f64; 2]>::try_from(row).map_err(|row| broken(&format!("{row:?}")));
    numbers(text)?.into_iter().map(pair).collect()
}

/// A number of a table.
///
/// # Errors
/// What is no number.
pub(super) fn number(word: &str) -> Result<f64, Failure> {
    word.parse().map_err(|_| broken(word))
}

/// The entry of a row.
///
/// # Errors
/// A row too short.
pub(super) fn entry(row: &[&'static str], column: usize) -> Result<&'static str, Failure> {
    row.get(column).copied().ok_or_else(|| broken(&row.join(",")))
}

fn broken(what: &str) -> Failure {
    Failure::System(format!("a table of references that cannot be read, at {what}"))
}

/// Terms of the series: the last one is nothing from the first time on at which they are asked for.
const TERMS: u32 = 60;

/// Velocity in a channel of width 1 and viscosity 1, a share `y` across it, `t` after the force `1` sets in:
/// Morris, Fox and Zhu 1997, eq. 21. Its largest, at last, is 1/8.
pub(super) fn poiseuille(y: f64, t: f64) -> f64 {
    let term = |n: u32| {
        let k = f64::from(2 * n + 1) * PI;
        4.0 / k.powi(3) * (k * y).sin() * (-k * k * t).exp()
    };
    y * (1.0 - y) / 2.0 - (0..TERMS).map(term).sum::<f64>()
}

/// The same, after the side `y = 1` begins to move with velocity 1: their eq. 22.
pub(super) fn couette(y: f64, t: f64) -> f64 {
    let term = |n: u32| {
        let k = f64::from(n) * PI;
        let sign = if n.is_multiple_of(2) { 1.0 } else { -1.0 };
        2.0 / k * sign * (k * y).sin() * (-k * k * t).exp()
    };
    y + (1..=TERMS).map(term).sum::<f64>()
}

/// Value at `x` of a curve through `points`, which ascend in x; its ends go on as they are.
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
