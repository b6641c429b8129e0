//! The gauges of a run as time series.
use crate::failure::Failure;
use crate::gauge::{Gauge, Measures};
use crate::output::write_text;
use crate::run_length::RunLength;
use millpond_core::Solver;
use millpond_core::scene::Scene;
use serde::Serialize;
use std::path::{Path, PathBuf};

/// Number of samples of a run whose interval is not given.
const USUAL_SAMPLES: f64 = 1000.0;

/// The gauges of a run, and what they have shown so far.
#[derive(Debug)]
pub struct Record<'a> {
    scene: &'a Scene,
    gauges: &'a [Gauge],
    /// Time between two samples, in steps or in seconds as in the length of the run.
    every: f64,
    next: f64,
    rows: Vec<(f64, Vec<f32>)>,
}

/// What a gauge showed in a run.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Shown {
    /// Name of the gauge, and of the component of a vector.
    pub name: String,
    /// Unit.
    pub unit: &'static str,
    /// Smallest value.
    pub smallest: f32,
    /// Largest value.
    pub largest: f32,
    /// Last value.
    pub last: f32,
}

impl<'a> Record<'a> {
    /// Returns an empty record of a run. `interval` is the time between two samples, s.
    ///
    /// # Errors
    /// An interval that is not larger than 0, or a gauge on a wall that the scene does not have.
    pub fn new(
        scene: &'a Scene,
        gauges: &'a [Gauge],
        span: RunLength,
        interval: Option<f64>,
    ) -> Result<Record<'a>, Failure> {
        if let Some(interval) = interval.filter(|interval| !(interval.is_finite() && *interval > 0.0)) {
            return Err(Failure::Call(format!("--gauges-every must be larger than 0 s, not {interval}")));
        }
        let walls = scene.walls.len();
        let missing = |gauge: &&Gauge| matches!(gauge.measures, Measures::ForceOnWall(wall) if wall as usize >= walls);
        if let Some(gauge) = gauges.iter().find(missing) {
            return Err(Failure::Call(format!(
                "gauge {:?} measures the force on a wall that is not there: the scene has {walls} walls",
                gauge.name
            )));
        }
        let every = match (span, interval) {
            (_, None) => span.length() / USUAL_SAMPLES,
            (RunLength::Steps(_), Some(interval)) => interval / f64::from(scene.time_step),
            (RunLength::Seconds(_), Some(interval)) => interval,
        };
        Ok(Record { scene, gauges, every, next: 0.0, rows: Vec::new() })
    }

    /// Returns when the next sample is due, in steps or seconds; `None` without gauges.
    #[must_use]
    pub fn next(&self) -> Option<f64> {
        (!self.gauges.is_empty()).then_some(self.next)
    }

    /// Reads all gauges after `passed` steps or seconds, at the simulated time `time`, s.
    pub fn sample(&mut self, passed: f64, time: f64, solver: &mut Solver<'_>) {
        let values = self.gauges.iter().flat_map(|gauge| gauge.measures.read(self.scene, solver));
        self.rows.push((time, values.collect()));
        self.next = ((passed / self.every).floor() + 1.0) * self.every;
        // an interval too short for f64, or a run without length
        if self.next.is_nan() || self.next <= passed {
            self.next = passed.next_up();
        }
    }

    /// Returns the names of all columns with their units.
    fn columns(&self) -> impl Iterator<Item = (String, &'static str)> {
        self.gauges.iter().flat_map(|gauge| {
            let (unit, components) = gauge.measures.unit();
            components.iter().map(move |component| (format!("{}{component}", gauge.name), unit))
        })
    }

    /// Returns what each gauge showed.
    #[must_use]
    pub fn shown(&self) -> Vec<Shown> {
        let values = |i: usize| self.rows.iter().map(move |(_, row)| row[i]);
        let columns = self.columns().enumerate();
        let shown = columns.map(|(i, (name, unit))| Shown {
            name,
            unit,
            smallest: values(i).fold(f32::INFINITY, f32::min),
            largest: values(i).fold(f32::NEG_INFINITY, f32::max),
            last: values(i).next_back().unwrap_or(0.0),
        });
        shown.collect()
    }

    /// Writes the series as `gauges.csv` into a folder. Returns its path, or `None` without gauges.
    ///
    /// # Errors
    /// A file that cannot be written.
    pub fn write(&self, folder: &Path) -> Result<Option<PathBuf>, Failure> {
        if self.gauges.is_empty() {
            return Ok(None);
        }
        let titles = self.columns().map(|(name, unit)| format!("\"{}, {unit}\"", name.replace('"', "\"\"")));
        let mut text = format!("\"time, s\",{}\n", titles.collect::<Vec<_>>().join(","));
        for (time, values) in &self.rows {
            let values: Vec<String> = values.iter().map(f32::to_string).collect();
            text += &format!("{time:.9},{}\n", values.join(","));
        }
        let path = folder.join("gauges.csv");
        write_text(&path, &text)?;
        Ok(Some(path))
    }
}
