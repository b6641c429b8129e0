//! Requirements on the final state of a case that ran to its end.
use super::Run;
use crate::failure::Failure;
use crate::outcome::Metric;
use crate::state_summary::summarize;
use crate::warnings::{gained, warnings};

/// Largest deviation from free fall, as a share of the distance fallen (case X10 of the validation catalogue).
const FALL: f64 = 1e-4;

/// Largest growth of the energy, as a share of the initial kinetic energy or of the potential energy that was released.
const GROWTH: f64 = 0.01;

/// A requirement on a case that ran to its end. In every case all values must be finite.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Measure {
    /// No further requirement.
    Finite,
    /// Every particle moves as if it were alone: `x0 + v0 t + g t^2 / 2`.
    Falls,
    /// No particle moves.
    Stays,
    /// No particle moves, and all velocity components are exactly +0, not just too small to change a position.
    Rests,
    /// No particle is outside of the container, and the energy did not grow.
    Contained,
    /// No particle is faster than the speed of sound at rest: two particles that repel each other gain only the energy
    /// of their pressure.
    Subsonic,
    /// The energy did not grow, or `run` prints a warning.
    Honest,
    /// `run` prints a warning, whatever the result.
    Warned,
}

impl Measure {
    /// Returns the measured figures with their limits.
    ///
    /// # Errors
    /// A state from which no solver can start.
    pub(super) fn figures(self, run: &Run<'_>) -> Result<Vec<Metric>, Failure> {
        let moved = || Metric::below("particles moved", moved(run) as f64, 0.0);
        let grown = || Ok::<_, Failure>(Metric::below("energy growth", growth(run)?, GROWTH));
        let warnings = |count: usize| Metric::above("warnings", count as f64, 1.0);
        Ok(match self {
            Measure::Finite => Vec::new(),
            Measure::Falls => vec![Metric::below("off free fall", off_fall(run), FALL)],
            Measure::Stays => vec![moved()],
            Measure::Rests => vec![moved(), Metric::below("not at rest", drifting(run) as f64, 0.0)],
            Measure::Contained => vec![Metric::below("outside walls", outside(run) as f64, 0.0), grown()?],
            Measure::Subsonic => {
                let fastest = summarize(run.scene, run.end)?.fastest;
                let sound = f64::from(run.scene.fluids[0].speed_of_sound);
                vec![Metric::below("speed over sound", fastest / sound, 1.0)]
            }
            Measure::Honest => match number_of_warnings(run)? {
                0 => vec![grown()?],
                count => vec![warnings(count)],
            },
            Measure::Warned => vec![warnings(number_of_warnings(run)?)],
        })
    }
}

/// Returns the largest deviation of a particle from free fall, divided by the distance fallen.
fn off_fall(run: &Run<'_>) -> f64 {
    let t = run.seconds;
    let g = run.scene.gravity.to_array().map(f64::from);
    let way = g.iter().map(|g| g * g).sum::<f64>().sqrt() * t * t / 2.0;
    let mut off = 0.0f64;
    for ((x0, v0), x) in run.start.position().iter().zip(run.start.velocity()).zip(run.end.position()) {
        for axis in 0..3 {
            let due = f64::from(x0[axis]) + f64::from(v0[axis]) * t + g[axis] * t * t / 2.0;
            let miss = (f64::from(x[axis]) - due).abs() / way;
            // NaN, once reached, stays
            off = if off.is_nan() || off >= miss { off } else { miss };
        }
    }
    off
}

fn moved(run: &Run<'_>) -> usize {
    run.start.position().iter().zip(run.end.position()).filter(|(before, after)| before != after).count()
}

fn drifting(run: &Run<'_>) -> usize {
    run.end.velocity().iter().filter(|v| v[..3].iter().any(|x| x.to_bits() != 0)).count()
}

fn outside(run: &Run<'_>) -> usize {
    let Some(container) = &run.scene.container else { return 0 };
    let inside = |x: &[f32; 4], axis: usize| container.low[axis] <= x[axis] && x[axis] <= container.high[axis];
    let axes = run.scene.dimension.count();
    run.end.position().iter().filter(|x| !(0..axes).all(|axis| inside(x, axis))).count()
}

/// Returns the number of warnings that `run` would print.
fn number_of_warnings(run: &Run<'_>) -> Result<usize, Failure> {
    let (start, end) = (summarize(run.scene, run.start)?, summarize(run.scene, run.end)?);
    let scene = run.scene.check().map_err(|error| Failure::Scene { origin: "warnings".into(), error })?;
    Ok(warnings(&scene, &end, 0).len() + usize::from(gained(run.scene, &start, &end).is_some()))
}

/// Returns the growth of the mechanical energy, divided by the initial kinetic energy or the released potential energy,
/// whichever is larger.
fn growth(run: &Run<'_>) -> Result<f64, Failure> {
    let (start, end) = (summarize(run.scene, run.start)?.energies, summarize(run.scene, run.end)?.energies);
    let fell = start.potential - end.potential;
    let grown = end.kinetic - start.kinetic - fell;
    // also avoids 0 / 0
    Ok(if grown <= 0.0 { 0.0 } else { grown / start.kinetic.max(fell.abs()).max(f64::MIN_POSITIVE) })
}
