//! What a state that is reported as good is held against.
use super::Run;
use crate::failure::Failure;
use crate::outcome::Metric;
use crate::state_summary::summarize;
use crate::warnings::{gained, warnings};

/// Of the way that a particle falls (the catalogue's X10).
const FALL: f64 = 1e-4;

/// Energy that may come out of nothing, as a share of what was in motion or came to be.
const GROWTH: f64 = 0.01;

/// What must hold of a run. That all its numbers are numbers is looked at in every case.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Measure {
    /// Nothing more.
    Finite,
    /// Everybody moves as if alone: `x0 + v0 t + g t^2 / 2`.
    Falls,
    /// Nobody moves.
    Stays,
    /// Nobody moves, and nobody has a velocity: not even one too small to move anything.
    Rests,
    /// Nobody is behind a wall, and the energy did not grow.
    Contained,
    /// Nobody is faster than sound at rest: a pair thrown apart had no more energy than pressure gave it.
    Subsonic,
    /// The energy did not grow, or `run` warns its user.
    Honest,
    /// `run` warns its user, whatever came of the scene.
    Warned,
}

impl Measure {
    /// What was measured, with limits.
    ///
    /// # Errors
    /// A state that no step could start from.
    pub(super) fn figures(self, run: &Run<'_>) -> Result<Vec<Metric>, Failure> {
        let moved = || Metric::below("moved", moved(run) as f64, 0.0);
        let grown = || Ok::<_, Failure>(Metric::below("energy grown by", growth(run)?, GROWTH));
        let warnings = |said: usize| Metric::above("warnings", said as f64, 1.0);
        Ok(match self {
            Measure::Finite => Vec::new(),
            Measure::Falls => vec![Metric::below("off free fall by", off_fall(run), FALL)],
            Measure::Stays => vec![moved()],
            Measure::Rests => vec![moved(), Metric::below("drifting", drifting(run) as f64, 0.0)],
            Measure::Contained => vec![Metric::below("behind walls", outside(run) as f64, 0.0), grown()?],
            Measure::Subsonic => {
                let fastest = summarize(run.scene, run.end)?.fastest;
                let sound = f64::from(run.scene.fluids[0].speed_of_sound);
                vec![Metric::below("fastest over sound", fastest / sound, 1.0)]
            }
            Measure::Honest => match said(run)? {
                0 => vec![grown()?],
                said => vec![warnings(said)],
            },
            Measure::Warned => vec![warnings(said(run)?)],
        })
    }
}

/// Largest distance from where a particle should have fallen, over the way of the fall.
fn off_fall(run: &Run<'_>) -> f64 {
    let t = run.seconds;
    let g = run.scene.gravity.to_array().map(f64::from);
    let way = g.iter().map(|g| g * g).sum::<f64>().sqrt() * t * t / 2.0;
    let mut off = 0.0f64;
    for ((x0, v0), x) in run.start.position().iter().zip(run.start.velocity()).zip(run.end.position()) {
        for axis in 0..3 {
            let due = f64::from(x0[axis]) + f64::from(v0[axis]) * t + g[axis] * t * t / 2.0;
            let miss = (f64::from(x[axis]) - due).abs() / way;
            // what is no number stays none
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

/// Warnings that `run` would give.
fn said(run: &Run<'_>) -> Result<usize, Failure> {
    let (start, end) = (summarize(run.scene, run.start)?, summarize(run.scene, run.end)?);
    let scene = run.scene.check().map_err(|error| Failure::Scene { origin: "warnings".into(), error })?;
    Ok(warnings(&scene, &end, 0).len() + usize::from(gained(run.scene, &start, &end).is_some()))
}

/// By how much mechanical energy grew, over what was in motion or fell.
fn growth(run: &Run<'_>) -> Result<f64, Failure> {
    let (start, end) = (summarize(run.scene, run.start)?.energies, summarize(run.scene, run.end)?.energies);
    let fell = start.potential - end.potential;
    let grown = end.kinetic - start.kinetic - fell;
    // of nothing nothing grows
    Ok(if grown <= 0.0 { 0.0 } else { grown / start.kinetic.max(fell.abs()).max(f64::MIN_POSITIVE) })
}
