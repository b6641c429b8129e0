//! Two fluids at rest, the lighter one over the heavier one, evaluated by the rows of the lattice on which the
//! particles started. Used by the study `two-fluids`.
use super::Metric;
use super::flow::{fluid, larger, mean};
use millpond_core::scene::Scene;
use millpond_core::{Particle, Solver};

/// Gravity, as in case H1, m/s2, and rest density of the heavy fluid, kg/m3.
pub(super) const GRAVITY: f32 = 1.0;
pub(super) const HEAVY: f32 = 1000.0;

/// Rows at the floor and at the lid whose pressure is excluded: some of their neighbours are wall particles.
pub(super) const MARGIN: usize = 2;

/// Rows on either side of the interface that are evaluated one by one.
pub(super) const NEAR: usize = 4;

/// Limit of case M1: rms speed over `sqrt(g H)`, H being the height of the box.
pub(super) const SPEED_LIMIT: f64 = 0.01;

/// Limit of the pressure error of a row, and of the pressure step at the interface, over the pressure at the floor.
pub(super) const PRESSURE_LIMIT: f64 = 0.05;

/// Limit of the difference between the distance of the two rows at the interface and a spacing, over a spacing.
pub(super) const GAP_LIMIT: f64 = 0.1;

/// Limit of the relative error of a density against the fluid's own rest density. The weight alone causes 0.5 %.
pub(super) const DENSITY_LIMIT: f64 = 0.02;

/// Means over the particles of a row of the lattice, and over time.
#[derive(Clone, Copy, Debug)]
pub(super) struct Row {
    /// Height, m.
    pub(super) height: f64,
    /// Pressure, Pa.
    pub(super) pressure: f64,
    /// Density over the fluid's own rest density.
    pub(super) density: f64,
}

/// Results of a run.
#[derive(Clone, Debug)]
pub(super) struct Rest {
    pub(super) ratio: f64,
    pub(super) side: f64,
    pub(super) seconds: f64,
    pub(super) steps: u64,
    /// Particles that are more than a spacing beyond the interface, or outside of the box.
    pub(super) mixed: usize,
    /// Largest rms speed, over `sqrt(g H)`.
    pub(super) speed: f64,
    /// Rows from floor to lid.
    pub(super) rows: Vec<Row>,
}

/// Returns the rows in which the particles started, from floor to lid. The ids of a block run along x, and the lower
/// block is first.
pub(super) fn rows(solver: &Solver<'_>, scene: &Scene, side: u16) -> Vec<Row> {
    let row = |particles: &[Particle]| Row {
        height: mean(particles, |p| f64::from(p.position.y)),
        pressure: mean(particles, |p| f64::from(p.pressure)),
        density: mean(particles, |p| f64::from(p.density) / f64::from(scene.fluid_of(p.fluid).rest_density)),
    };
    fluid(solver).chunks(usize::from(side)).map(row).collect()
}

/// Returns the means of the rows over time.
pub(super) fn averaged(samples: &[Vec<Row>]) -> Vec<Row> {
    let row = |i: usize| Row {
        height: mean(samples, |rows| rows[i].height),
        pressure: mean(samples, |rows| rows[i].pressure),
        density: mean(samples, |rows| rows[i].density),
    };
    (0..samples.first().map_or(0, Vec::len)).map(row).collect()
}

pub(super) fn mixed(solver: &Solver<'_>, side: u16) -> usize {
    let spacing = 1.0 / f32::from(side);
    let at_home = |p: &Particle| {
        let y = if p.fluid == 0 { 0.0..0.5 + spacing } else { 0.5 - spacing..1.0 };
        (0.0..1.0).contains(&p.position.x) && y.contains(&p.position.y)
    };
    fluid(solver).iter().filter(|p| !at_home(p)).count()
}

/// Returns the rows near the interface, half of them below it, or all rows if there are fewer.
pub(super) fn near(rows: &[Row]) -> &[Row] {
    let first = (rows.len() / 2).saturating_sub(NEAR);
    rows.get(first..first + 2 * NEAR).unwrap_or(rows)
}

impl Rest {
    /// Returns the error of a row's pressure against `p = g int rho dy`, the integral from the lid downwards, over the
    /// pressure at the floor.
    pub(super) fn miss(&self, row: &Row) -> f64 {
        let exact = |y: f64| (0.5 - y).max(0.0) + (1.0 - y).min(0.5) / self.ratio;
        (row.pressure / f64::from(HEAVY * GRAVITY) - exact(row.height)) / exact(0.0)
    }

    /// Returns the rows whose pressure counts.
    pub(super) fn inner(&self) -> &[Row] {
        self.rows.get(MARGIN..self.rows.len().saturating_sub(MARGIN)).unwrap_or(&[])
    }

    /// Returns the mean pressure error, over the pressure at the floor. A closed box may hold its fluids at any level
    /// of pressure. Half a row more or less between its walls makes such a difference.
    pub(super) fn level(&self) -> f64 {
        mean(self.inner(), |row| self.miss(row))
    }

    pub(super) fn rms_miss(&self) -> f64 {
        mean(self.inner(), |row| (self.miss(row) - self.level()).powi(2)).sqrt()
    }

    pub(super) fn largest_miss(&self) -> f64 {
        // without rows the error must not pass as zero
        let least = if self.inner().is_empty() { f64::NAN } else { 0.0 };
        self.inner().iter().map(|row| (self.miss(row) - self.level()).abs()).fold(least, larger)
    }

    /// Returns the mean error of the nearest rows above the interface, less that of the nearest rows below: a step of
    /// the pressure at the interface.
    pub(super) fn jump(&self) -> f64 {
        let near = near(&self.rows);
        let (below, above) = near.split_at(near.len() / 2);
        mean(above, |row| self.miss(row)) - mean(below, |row| self.miss(row))
    }

    /// Returns the distance from the highest heavy row to the lowest light row, in spacings.
    pub(super) fn gap(&self) -> f64 {
        let (heavy, light) = self.rows.split_at(self.rows.len() / 2);
        match (heavy.last(), light.first()) {
            (Some(below), Some(above)) => (above.height - below.height) * self.side,
            _ => f64::NAN,
        }
    }

    /// Returns the largest relative error of a density near the interface, against the fluid's own rest density.
    pub(super) fn predicted_density_error(&self) -> f64 {
        let near = near(&self.rows);
        let least = if near.is_empty() { f64::NAN } else { 0.0 };
        near.iter().map(|row| (row.density - 1.0).abs()).fold(least, larger)
    }

    pub(super) fn figures(&self) -> Vec<Metric> {
        let name = |what: &str| format!("ratio {}: {what}", self.ratio);
        vec![
            Metric::below(name("particles beyond the interface"), self.mixed as f64, 0.0),
            Metric::below(name("rms speed over sqrt(g H)"), self.speed, SPEED_LIMIT),
            Metric::below(
                name("largest pressure error of a row, over that at the floor"),
                self.largest_miss(),
                PRESSURE_LIMIT,
            ),
            Metric::below(name("pressure step at the interface"), self.jump().abs(), PRESSURE_LIMIT),
            Metric::below(name("error of the gap at the interface, in spacings"), (self.gap() - 1.0).abs(), GAP_LIMIT),
            Metric::below(
                name("largest density error near the interface"),
                self.predicted_density_error(),
                DENSITY_LIMIT,
            ),
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A run without errors, with a density ratio of 10.
    fn perfect() -> Rest {
        let row = |i: u16| {
            let height = (f64::from(i) + 0.5) / 20.0;
            let depths = [(0.5 - height).max(0.0), (1.0 - height).min(0.5)];
            Row { height, pressure: 1000.0 * depths[0] + 100.0 * depths[1], density: 1.0 }
        };
        let rows = (0..20).map(row).collect();
        Rest { ratio: 10.0, side: 20.0, seconds: 1.0, steps: 1, mixed: 0, speed: 0.0, rows }
    }

    #[test]
    fn a_perfect_rest_passes() {
        assert!(perfect().figures().iter().all(|figure| figure.ok));
    }

    #[test]
    fn a_gap_and_a_step_are_seen() {
        let mut torn = perfect();
        for row in &mut torn.rows[10..] {
            row.height += 0.5 / 20.0;
            row.pressure += 100.0;
        }
        assert!((torn.gap() - 1.5).abs() < 1e-12);
        assert!((torn.jump() - 102.5 / 550.0).abs() < 1e-12);
    }

    #[test]
    fn no_rows_are_no_rest() {
        let nothing = Rest { rows: Vec::new(), ..perfect() };
        assert_eq!(nothing.figures().iter().filter(|figure| figure.ok).count(), 2);
    }
}
