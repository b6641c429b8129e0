//! `matrix`: every pair of choices that goes together, on all paths: scalar, in lanes on two threads, with every term
//! that a plan can leave out, and on a device. `tests/every_choice_keeps_its_bits.rs` has each choice alone; here are
//! those faults that only two choices together have.
//!
//! Few scenes contain many pairs (`cover.rs`). If the paths of a scene part, choices are taken back as long
//! as they do, and the report names those that remain.
mod choices;
mod cover;
pub mod scenes;

use self::choices::{Choice, choices};
use self::cover::{Combination, cover};
use super::{Context, Metric, Outcome};
use crate::extremes::{Case, End, Fault, Measure, Verdict, judge_with_every_term};
use crate::failure::Failure;
use crate::fluid::device_if_any;
use crate::outcome::table;
use crate::output::progress;
use millpond_core::scene::{Dimension, Scene};
use millpond_gpu::Gpu;

/// Steps of each scene: a predictor, a corrector and a sort by new positions have taken part more than once.
const STEPS: u32 = 6;

/// A quick study runs one in this number of scenes.
const QUICK_EVERY: usize = 16;

/// Returns the scene of a combination.
fn scene(base: &Scene, choices: &[Choice], row: &[Option<usize>]) -> Scene {
    let mut scene = base.clone();
    for (choice, option) in choices.iter().zip(row) {
        if let Some((_, change)) = option.and_then(|option| choice.options.get(option)) {
            change(&mut scene);
        }
    }
    scene
}

/// Returns the options of a combination by name.
fn names(choices: &[Choice], row: &[Option<usize>]) -> String {
    let named = choices.iter().zip(row).filter_map(|(choice, option)| {
        let (option, _) = choice.options.get((*option)?)?;
        Some(format!("{} {option}", choice.name))
    });
    named.collect::<Vec<_>>().join(", ")
}

/// Runs the scene of a combination on all paths.
fn verdict(base: &Scene, choices: &[Choice], row: &[Option<usize>], gpu: Option<&Gpu>) -> Result<Verdict, Failure> {
    let (name, scene) = (names(choices, row), scene(base, choices, row));
    // a step may be refused, as long as all paths refuse it alike
    judge_with_every_term(&Case { name, scene, places: None, steps: STEPS, end: End::Either(Measure::Finite) }, gpu)
}

/// Takes back choices as long as the scene has a fault, and returns what remains.
fn shortest(base: &Scene, choices: &[Choice], row: &Combination, gpu: Option<&Gpu>) -> Result<Combination, Failure> {
    let mut row = row.clone();
    for i in 0..row.len() {
        let taken = row[i].take();
        let is_needed =
            scene(base, choices, &row).check().is_err() || verdict(base, choices, &row, gpu)?.faults.is_empty();
        if is_needed {
            row[i] = taken;
        }
    }
    Ok(row)
}

pub(super) fn run(context: &Context) -> Result<Outcome, Failure> {
    let gpu = device_if_any()?;
    let choices = choices();
    let sizes: Vec<usize> = choices.iter().map(|choice| choice.options.len()).collect();
    let (mut figures, mut notes) = (Vec::new(), Vec::new());
    for dimension in [Dimension::Two, Dimension::Three] {
        let base = scenes::base(dimension);
        let found = cover(&sizes, |row| scene(&base, &choices, row).check().is_ok());
        let every = if context.quick { QUICK_EVERY } else { 1 };
        let rows: Vec<&Combination> = found.combinations.iter().step_by(every).collect();
        let bar = progress("matrix", rows.len() as u64);
        let (mut faults, mut stopped, mut compared) = (Vec::new(), 0, 0);
        for row in &rows {
            let verdict = verdict(&base, &choices, row, gpu.as_ref())?;
            stopped += usize::from(verdict.refusals > 0);
            compared += verdict.compared;
            if !verdict.faults.is_empty() {
                let least = names(&choices, &shortest(&base, &choices, row, gpu.as_ref())?);
                let words: Vec<String> = verdict.faults.iter().map(Fault::to_string).collect();
                faults.push([least, words.join("; ")]);
            }
            bar.inc(1);
        }
        bar.finish_and_clear();
        figures.push(Metric::below(
            format!("{dimension:?}: of {compared} comparisons of {} scenes, scenes with a fault", rows.len()),
            faults.len() as f64,
            0.0,
        ));
        notes.push(format!(
            "{dimension:?}: {} options of {} choices; {} pairs go together and are covered by {} scenes, {} do not go \
             together. In {stopped} scenes a step was refused.",
            sizes.iter().sum::<usize>(),
            sizes.len(),
            found.covered,
            found.combinations.len(),
            found.refused.len(),
        ));
        if !faults.is_empty() {
            notes.push(table(["smallest combination with a fault", "fault"], faults));
        }
    }
    if gpu.is_none() {
        notes.push("There is no GPU here: only paths of the CPU were compared.".into());
    }
    Ok(Outcome::new("matrix", figures, notes))
}
