//! Two fluids at rest, the lighter one over the other, row by row of the lattice that they began on.
use super::Metric;
use super::flow::{fluid, larger, mean};
use millpond_core::scene::Scene;
use millpond_core::{Particle, Solver};

/// Of the catalogue's case H1, m/s2; of the heavy fluid, kg/m3.
pub(super) const GRAVITY: f32 = 1.0;
pub(super) const HEAVY: f32 = 1000.0;

/// Rows at the floor and at the lid whose pressure does not count: some of their neighbours are walls.
pub(super) const MARGIN: usize = 2;

/// Rows on either side of the interface that are looked at one by one.
pub(super) const NEAR: usize = 4;

/// Of the catalogue: rms speed over `sqrt(g H)`.
pub(super) const SPEED_LIMIT: f64 = 0.01;

/// Of the pressure at the floor, for each row and for the step at the interface.
pub(super) const PRESSURE_LIMIT: f64 = 0.05;

/// The distance of the two rows at the interface, off a spacing by.
pub(super) const GAP_LIMIT: f64 = 0.1;

/// Density over the fluid's own rest density, off 1 by: the weight makes half a per cent.
pub(super) const DENSITY_LIMIT: f64 = 0.02;

/// Means over the particles of one row of the lattice, and over time.
#[derive(Clone, Copy, Debug)]
pub(super) struct Row {
    /// m.
    pub(super) height: f64,
    /// Pa.
    pub(super) pressure: f64,
    /// Over the fluid's own rest density.
    pub(super) density: f64,
}

/// What a run came to.
#[derive(Clone, Debug)]
pub(super) struct Rest {
    pub(super) ratio: f64,
    pub(super) side: f64,
    pub(super) seconds: f64,
    pub(super) steps: u64,
    /// Particles beyond the interface by more than a spacing, or out of the box.
    pub(super) mixed: usize,
    /// Largest rms speed, over `sqrt(g H)`.
    pub(super) speed: f64,
    /// From floor to lid.
    pub(super) rows: Vec<Row>,
}

/// The rows that the particles began in, from floor to lid: the ids of a block run along x, and the lower block is first.
pub(super) fn rows(solver: &Solver<'_>, scene: &Scene, side: u16) -> Vec<Row> {
    let row = |particles: &[Particle]| Row {
        height: mean(particles, |p| f64::from(p.position.y)),
        pressure: mean(particles, |p| f64::from(p.pressure)),
        density: mean(particles, |p| f64::from(p.density) / f64::from(scene.fluid_of(p.fluid).rest_density)),
    };
    fluid(solver).chunks(usize::from(side)).map(row).collect()
}

/// Means over time.
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

/// The rows about the interface, half of them below it; all of what has fewer.
pub(super) fn near(rows: &[Row]) -> &[Row] {
    let first = (rows.len() / 2).saturating_sub(NEAR);
    rows.get(first..first + 2 * NEAR).unwrap_or(rows)
}

impl Rest {
    /// Pressure of a row less `p = g int rho dy` from the lid down, over that at the floor.
    pub(super) fn miss(&self, row: &Row) -> f64 {
        let exact = |y: f64| (0.5 - y).max(0.0) + (1.0 - y).min(0.5) / self.ratio;
        (row.pressure / f64::from(HEAVY * GRAVITY) - exact(row.height)) / exact(0.0)
    }

    /// Rows whose pressure counts.
    pub(super) fn inner(&self) -> &[Row] {
        self.rows.get(MARGIN..self.rows.len().saturating_sub(MARGIN)).unwrap_or(&[])
    }

    /// By how much all of the pressure is off, over that at the floor: a closed box may hold its fluids at any level, and
    /// half a row more or less between its walls is one.
    pub(super) fn level(&self) -> f64 {
        mean(self.inner(), |row| self.miss(row))
    }

    pub(super) fn rms_miss(&self) -> f64 {
        mean(self.inner(), |row| (self.miss(row) - self.level()).powi(2)).sqrt()
    }

    pub(super) fn largest_miss(&self) -> f64 {
        // no rows at all are no good rows
        let least = if self.inner().is_empty() { f64::NAN } else { 0.0 };
        self.inner().iter().map(|row| (self.miss(row) - self.level()).abs()).fold(least, larger)
    }

    /// What the nearest rows above miss more than those below: a step that the pressure makes at the interface.
    pub(super) fn jump(&self) -> f64 {
        let near = near(&self.rows);
        let (below, above) = near.split_at(near.len() / 2);
        mean(above, |row| self.miss(row)) - mean(below, |row| self.miss(row))
    }

    /// From the highest heavy row to the lowest light one, spacings.
    pub(super) fn gap(&self) -> f64 {
        let (heavy, light) = self.rows.split_at(self.rows.len() / 2);
        match (heavy.last(), light.first()) {
            (Some(below), Some(above)) => (above.height - below.height) * self.side,
            _ => f64::NAN,
        }
    }

    /// Largest miss of a density about the interface, over the fluid's own.
    pub(super) fn density_miss(&self) -> f64 {
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
                name("pressure of a row off by, over that at the floor"),
                self.largest_miss(),
                PRESSURE_LIMIT,
            ),
            Metric::below(name("step of the pressure at the interface"), self.jump().abs(), PRESSURE_LIMIT),
            Metric::below(name("gap at the interface, off a spacing by"), (self.gap() - 1.0).abs(), GAP_LIMIT),
            Metric::below(name("density about it over its own, off 1 by"), self.density_miss(), DENSITY_LIMIT),
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A run that came out as it should, of a fluid ten times as heavy.
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
