//! `extremes`: scenes with extreme inputs must end in a valid state, or in a named error that leaves the state
//! unchanged. All backends must end alike.
use super::{Context, Metric, Outcome};
use crate::extremes::{Fault, Verdict, cases, judge};
use crate::failure::Failure;
use crate::fluid::device_if_any;
use crate::outcome::table;
use crate::output::progress;

/// A quick study runs one in this number of cases also on a GPU, if there is one. It is by far the slowest backend,
/// since each case needs a new program there. The tests run all cases on it.
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
        none(format!("of {} cases, those with a wrong end", cases.len()), faults(|f| matches!(f, Fault::End(_)))),
        none(
            format!("of {} failed steps, those that changed the state", sum(|v| v.refusals)),
            faults(|f| matches!(f, Fault::Changed(_))),
        ),
        none(
            format!("of {} comparisons of backends, those with different bits or errors", sum(|v| v.compared)),
            faults(|f| matches!(f, Fault::Parted(_))),
        ),
    ];
    let row = |v: &Verdict| {
        let faults: Vec<String> = v.faults.iter().map(ToString::to_string).collect();
        [v.name.clone(), v.result.clone(), if faults.is_empty() { "as required".into() } else { faults.join("; ") }]
    };
    let mut notes = vec![table(["case", "outcome", "verdict"], verdicts.iter().map(row))];
    if gpu.is_none() {
        notes.push("There is no GPU here: only the scalar and the SIMD path of the CPU were compared.".into());
    }
    Ok(Outcome::new("extremes", figures, notes))
}
