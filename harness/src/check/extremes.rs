//! `extremes`: scenes that nobody should ask for end in a sound state or in a refusal by name, the same on every backend.
use super::{Context, Metric, Outcome};
use crate::extremes::{Fault, Verdict, cases, judge};
use crate::failure::Failure;
use crate::fluid::device_if_any;
use crate::outcome::table;
use crate::output::progress;

/// Of the cases, those that a quick study also runs on a device, if there is one: it is by far the slowest backend, as each
/// case is a new program for it. The tests run all of them there.
const QUICK_DEVICE_EVERY: usize = 4;

pub(super) fn run(context: &Context) -> Result<Outcome, Failure> {
    let gpu = device_if_any()?;
    let cases = cases()?;
    let bar = progress("extremes", cases.len() as u64);
    let mut verdicts = Vec::new();
    for (i, case) in cases.iter().enumerate() {
        let device = gpu.as_ref().filter(|_| !context.quick || i.is_multiple_of(QUICK_DEVICE_EVERY));
        verdicts.push(judge(case, device)?);
        bar.inc(1);
    }
    bar.finish_and_clear();
    let faults = |is: fn(&Fault) -> bool| verdicts.iter().flat_map(|v| &v.faults).filter(|fault| is(fault)).count();
    let sum = |of: fn(&Verdict) -> usize| verdicts.iter().map(of).sum::<usize>();
    let none = |name: String, count: usize| Metric::below(name, count as f64, 0.0);
    let figures = vec![
        none(format!("of {} cases, those that ended otherwise", cases.len()), faults(|f| matches!(f, Fault::End(_)))),
        none(
            format!("of {} refused steps, those that changed the state", sum(|v| v.refusals)),
            faults(|f| matches!(f, Fault::Changed(_))),
        ),
        none(
            format!("of {} comparisons of backends, those with other bits or errors", sum(|v| v.compared)),
            faults(|f| matches!(f, Fault::Parted(_))),
        ),
    ];
    let row = |v: &Verdict| {
        let faults: Vec<String> = v.faults.iter().map(ToString::to_string).collect();
        [v.name.clone(), v.came.clone(), if faults.is_empty() { "as it must".into() } else { faults.join("; ") }]
    };
    let mut notes = vec![table(["case", "what came of it", ""], verdicts.iter().map(row))];
    if gpu.is_none() {
        notes.push("There is no device here: the CPU's scalar path and its lanes were compared.".into());
    }
    Ok(Outcome::new("extremes", figures, notes))
}
