//! The analysis of Hinsch 2024, section 7: a column of fluid in a narrow tower, and its mean density error over time
//! for three stiffnesses and for three time steps (figures 7.2 and 7.3).
use super::classify::{Trial, Verdict, classify};
use super::{Common, Outcome};
use crate::energy::fastest_sound;
use crate::failure::Failure;
use crate::output::seconds as readable;
use crate::output::{deliver, make_folder, progress, write_json};
use crate::plot::{Line, line_plot};
use crate::pool::Pool;
use crate::scenes::LoadedScene;
use millpond_core::Solver;
use millpond_core::backend::hash::tree_sum;
use millpond_core::scene::Scene;
use serde::Serialize;
use std::collections::BTreeMap;
use std::f64::consts::TAU;
use std::path::{Path, PathBuf};

/// Name of the suite and of its scene.
pub(super) const NAME: &str = "tower";

/// Stiffnesses, Pa (a choice: Hinsch 2024 gives no numbers). The fluid at the floor is compressed by 7, 2.3 and 0.7 %.
const STIFFNESSES: [f32; 3] = [2e4, 6e4, 2e5];

/// Time steps, s. With the middle stiffness sound crosses 0.05, 0.1 and 0.2 of the support in a step.
const TIME_STEPS: [f32; 3] = [1e-4, 2e-4, 4e-4];

/// Stiffness and time step that are kept while the other of the two varies.
const MIDDLE: (f32, f32) = (STIFFNESSES[1], TIME_STEPS[1]);

/// Fields that the suite sets itself.
const STUDIED: [&str; 2] = ["stiffness", "time_step"];

/// Resolution of the spectrum: number of frequencies between two that differ by one oscillation over the whole time.
const FINENESS: usize = 32;

/// Largest number of points of a series.
const MOST_POINTS: u64 = 500;

/// Result of the suite.
#[derive(Clone, Debug, Serialize)]
struct Tower {
    suite: &'static str,
    time_s: f64,
    runs: Vec<Run>,
    /// Conclusions from the runs.
    findings: Vec<String>,
    pictures: Vec<PathBuf>,
}

/// A run of the suite.
#[derive(Clone, Debug, Serialize)]
struct Run {
    label: String,
    choice: BTreeMap<&'static str, String>,
    outcome: Outcome,
    detail: String,
    #[serde(skip)]
    point: (f32, f32),
    /// Mean magnitude of the density error over the second half of the time.
    error: Option<f64>,
    /// Period of the oscillation of the column, s.
    period_s: Option<f64>,
    /// Period of the oscillation, in steps.
    period_steps: Option<f64>,
    /// Period of a quarter wave of sound in a column on a floor, `4 H / c`, s.
    quarter_wave_s: Option<f64>,
    /// Series of the time, s, and the relative error of the mean density, `mean(rho) / rho0 - 1`.
    series: Vec<[f64; 2]>,
}

/// Runs the suite and returns whether all runs were made: false if one was skipped.
///
/// # Errors
/// Returns an error if the caller sets a field that the suite varies, or if a file cannot be written.
pub(super) fn execute(
    common: &Common,
    base: &LoadedScene,
    seconds: f64,
    most_steps: u64,
    pool: &Pool,
) -> Result<bool, Failure> {
    let own = |change: &&String| {
        let field = change.split('=').next().and_then(|path| path.trim().rsplit('.').next());
        STUDIED.iter().any(|studied| field == Some(studied))
    };
    if let Some(change) = common.changes.set.iter().find(own) {
        return Err(Failure::Call(format!("--set {change} is not allowed: this field is what the suite varies")));
    }
    let by_step = TIME_STEPS.into_iter().filter(|step| *step != MIDDLE.1).map(|step| (MIDDLE.0, step));
    let points: Vec<(f32, f32)> = STIFFNESSES.into_iter().map(|k| (k, MIDDLE.1)).chain(by_step).collect();
    if let Some(folder) = &common.out {
        make_folder(folder)?;
    }
    let bar = progress("stability tower", points.len() as u64);
    let done = pool.map(&points, |point| {
        let run = run(&base.file.scene, *point, seconds, most_steps);
        bar.inc(1);
        run
    });
    bar.finish_and_clear();
    let (runs, complete): (Vec<Run>, Vec<bool>) = done.into_iter().unzip();
    let mut tower =
        Tower { suite: NAME, time_s: seconds, findings: findings(&runs, seconds), runs, pictures: Vec::new() };
    if let Some(folder) = &common.out {
        tower.pictures = pictures(folder, &tower.runs)?;
        write_json(&folder.join("stability.json"), &tower)?;
    }
    deliver(common, "stability.md", &tower, &words(&tower))?;
    Ok(complete.into_iter().all(|complete| complete))
}

/// Makes one run. The second value is false if it was skipped.
fn run(base: &Scene, point: (f32, f32), seconds: f64, most_steps: u64) -> (Run, bool) {
    let (stiffness, time_step) = point;
    let mut scene = base.clone();
    scene.fluids[0].stiffness = Some(stiffness);
    scene.time_step = time_step;
    let every = (seconds / f64::from(time_step) / MOST_POINTS as f64).ceil().max(1.0) as u64;
    let mut series = Vec::new();
    let Trial { verdict, steps, .. } = classify(&scene, seconds, most_steps, |solver| {
        if solver.steps().is_multiple_of(every) {
            series.push([solver.time(), error(&scene, solver)]);
        }
    });
    let complete = !matches!(verdict, Verdict::TooManySteps(_));
    let (outcome, detail) = match verdict {
        Verdict::Stable => (Outcome::Stable, format!("stable for {steps} steps")),
        Verdict::Unstable(broken) => (Outcome::Unstable, broken.to_string()),
        Verdict::Refused(why) => (Outcome::Refused, why),
        Verdict::TooManySteps(too_many) => (Outcome::Refused, too_many.to_string()),
    };
    let period = if outcome == Outcome::Stable { period(&series) } else { None };
    let run = Run {
        label: format!("k = {stiffness} Pa, dt = {}", readable(time_step)),
        choice: BTreeMap::from([("stiffness", stiffness.to_string()), ("time_step", time_step.to_string())]),
        outcome,
        detail,
        point,
        error: late(&series, seconds),
        period_s: period,
        period_steps: period.map(|period| period / f64::from(time_step)),
        quarter_wave_s: fastest_sound(&scene).map(|sound| 4.0 * height(&scene) / sound),
        series,
    };
    (run, complete)
}

/// Returns the height of the column, m.
fn height(scene: &Scene) -> f64 {
    scene.blocks.iter().map(|block| f64::from(block.size[1])).sum()
}

/// Returns the relative error of the mean density of the fluid (Hinsch 2024, section 7).
fn error(scene: &Scene, solver: &Solver<'_>) -> f64 {
    let fluid: Vec<f64> =
        solver.particles().filter(|p| !p.is_wall && !p.is_inactive).map(|p| f64::from(p.density)).collect();
    tree_sum(fluid.len(), &|i| fluid[i]) / fluid.len() as f64 / f64::from(scene.fluids[0].rest_density) - 1.0
}

/// Returns the mean magnitude of the error over the second half of the time, or `None` if the series ends before.
fn late(series: &[[f64; 2]], seconds: f64) -> Option<f64> {
    let late: Vec<f64> = series.iter().filter(|[t, _]| *t > seconds / 2.0).map(|[_, error]| error.abs()).collect();
    (!late.is_empty()).then(|| tree_sum(late.len(), &|i| late[i]) / late.len() as f64)
}

/// Returns the period of the strongest oscillation about the level at which a series settles, from its Fourier
/// transform. Counting passages through that level would also count sound waves that run through the column. Returns
/// `None` if there are fewer than two oscillations.
fn period(series: &[[f64; 2]]) -> Option<f64> {
    let settled = &series[series.len() / 2..];
    let level = tree_sum(settled.len(), &|i| settled[i][1]) / settled.len() as f64;
    let duration = series.last()?[0];
    let strength = |frequency: f64| {
        let part = |wave: fn(f64) -> f64| {
            let of = |i: usize| (series[i][1] - level) * wave(TAU * frequency * series[i][0]);
            tree_sum(series.len(), &of).powi(2)
        };
        part(f64::cos) + part(f64::sin)
    };
    // from two oscillations in the whole time to four points per oscillation
    let frequencies = (2 * FINENESS..=series.len() * FINENESS / 4).map(|i| i as f64 / (FINENESS as f64 * duration));
    let all = frequencies.map(|frequency| (frequency, strength(frequency)));
    let (frequency, strongest) = all.max_by(|(_, a), (_, b)| a.total_cmp(b))?;
    (strongest > 0.0).then_some(1.0 / frequency)
}

/// Returns the runs of a figure in order: those with the middle value of the other parameter.
fn of_figure(runs: &[Run], belongs: impl Fn((f32, f32)) -> bool) -> Vec<&Run> {
    let mut own: Vec<&Run> = runs.iter().filter(|run| belongs(run.point)).collect();
    own.sort_by(|a, b| a.point.0.total_cmp(&b.point.0).then(a.point.1.total_cmp(&b.point.1)));
    own
}

fn by_stiffness(runs: &[Run]) -> Vec<&Run> {
    of_figure(runs, |(_, step)| step == MIDDLE.1)
}

fn by_step(runs: &[Run]) -> Vec<&Run> {
    of_figure(runs, |(stiffness, _)| stiffness == MIDDLE.0)
}

/// Describes what the series show, compared with what Hinsch 2024 finds.
fn findings(runs: &[Run], seconds: f64) -> Vec<String> {
    let listed = |runs: &[&Run], number: fn(&Run) -> Option<f64>, show: fn(f64) -> String| -> String {
        let all: Vec<String> = runs.iter().map(|run| number(run).map_or_else(|| "none".into(), show)).collect();
        all.join(", ")
    };
    let percent = |x: f64| format!("{:.2} %", x * 100.0);
    let (stiff, steps) = (by_stiffness(runs), by_step(runs));
    let errors: Vec<f64> = stiff.iter().filter_map(|run| run.error).collect();
    let falls = errors.len() == stiff.len() && errors.windows(2).all(|pair| pair[1] < pair[0]);
    let verdict = if falls { "falling with k, as in Hinsch 2024" } else { "which does not fall with k" };
    let first = format!(
        "Over the second half of {seconds} s the density error is {} for k = {} Pa, {verdict}.",
        listed(&stiff, |run| run.error, percent),
        STIFFNESSES.map(|k| k.to_string()).join(", "),
    );
    let mut found = vec![first];
    let periods: Vec<f64> = steps.iter().filter_map(|run| run.period_s).collect();
    if periods.len() == steps.len() {
        let (low, high) =
            (periods.iter().fold(f64::INFINITY, |a, b| a.min(*b)), periods.iter().fold(0.0f64, |a, b| a.max(*b)));
        let apart = (high / low - 1.0) * 100.0;
        let verdict = if apart < 10.0 {
            "the lower frequency with smaller time steps in Hinsch 2024 is one per step; in seconds it is the same"
        } else {
            "the time step changes the oscillation itself"
        };
        found.push(format!(
            "For dt = {} the column's period is {} steps, or {}: the periods differ by {apart:.1} %, so {verdict}.",
            TIME_STEPS.map(readable).join(", "),
            listed(&steps, |run| run.period_steps, |n| format!("{n:.0}")),
            listed(&steps, |run| run.period_s, |t| format!("{t:.4} s")),
        ));
    } else {
        found.push("Not every time step shows an oscillation.".into());
    }
    found.push(format!("The density error is {} for these time steps.", listed(&steps, |run| run.error, percent)));
    found
}

/// Draws figures 7.2 and 7.3 of Hinsch 2024, the second one over steps and over seconds.
fn pictures(folder: &Path, runs: &[Run]) -> Result<Vec<PathBuf>, Failure> {
    let line = |run: &Run, label: String, unit: f64| {
        let points = run.series.iter().map(|[time, error]| [time / unit, *error]).collect();
        Line { label, points }
    };
    let stiff: Vec<Line> =
        by_stiffness(runs).into_iter().map(|run| line(run, format!("k = {} Pa", run.point.0), 1.0)).collect();
    let steps = |per_step: bool| -> Vec<Line> {
        let unit = |run: &Run| if per_step { f64::from(run.point.1) } else { 1.0 };
        by_step(runs).into_iter().map(|run| line(run, format!("dt = {}", readable(run.point.1)), unit(run))).collect()
    };
    let error = "relative error of the mean density";
    let all = [
        ("tower-stiffness.svg", "tower: three stiffnesses", "time, s", stiff),
        ("tower-time-step.svg", "tower: three time steps, over steps", "step", steps(true)),
        ("tower-time-step-seconds.svg", "tower: three time steps, over seconds", "time, s", steps(false)),
    ];
    let mut paths = Vec::new();
    for (name, title, x, lines) in all {
        let path = folder.join(name);
        line_plot(&path, title, [x, error], &lines)?;
        paths.push(path);
    }
    Ok(paths)
}

fn words(tower: &Tower) -> String {
    let mut out = format!("# {NAME}: the density of a column over {} s (Hinsch 2024, section 7)\n\n", tower.time_s);
    out += "| run | outcome | density error | period, s | 4 H / c, s | period, steps | |\n\
            | --- | --- | --- | --- | --- | --- | --- |\n";
    for run in &tower.runs {
        let outcome = run.outcome.name();
        let number =
            |value: Option<f64>, digits: usize| value.map_or(String::new(), |value| format!("{value:.digits$}"));
        let error = run.error.map_or(String::new(), |error| format!("{:.2} %", error * 100.0));
        out += &format!(
            "| {} | {outcome} | {error} | {} | {} | {} | {} |\n",
            run.label,
            number(run.period_s, 4),
            number(run.quarter_wave_s, 4),
            number(run.period_steps, 0),
            run.detail
        );
    }
    for finding in &tower.findings {
        out += &format!("\n{finding}\n");
    }
    if !tower.pictures.is_empty() {
        let all: Vec<String> = tower.pictures.iter().map(|path| path.display().to_string()).collect();
        out += &format!("\nPictures: {}\n", all.join(", "));
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_period_of_a_swing_is_found() {
        let swing = |i: u32| {
            let time = f64::from(i) * 0.001;
            let ripple = 0.002 * (-2.0 * time).exp() * (time * TAU / 0.013).sin();
            [time, 0.02 - 0.01 * (-2.0 * time).exp() * (time * TAU / 0.2).cos() + ripple]
        };
        let series: Vec<[f64; 2]> = (0..1000).map(swing).collect();
        let found = period(&series).expect("it oscillates");
        assert!((found / 0.2 - 1.0).abs() < 0.01, "{found}");
        let rest: Vec<[f64; 2]> = (0..100).map(|i| [f64::from(i), 1.0]).collect();
        assert_eq!((period(&rest), period(&[])), (None, None), "rest has no period");
        assert_eq!(late(&series, 5.0), None, "a series that ends early");
    }
}
