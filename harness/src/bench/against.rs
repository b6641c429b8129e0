//! Two builds of this program, timed alternately: shows what a code change does to the time of a step, even on a shared
//! machine.
use super::Options;
use crate::failure::Failure;
use crate::output::deliver;
use serde::Serialize;
use std::ffi::OsString;
use std::path::Path;
use std::process::{Command, Stdio};

/// Result of `bench --against`.
#[derive(Clone, Debug, Serialize)]
pub(super) struct Against {
    /// Shortest step of each round with this build, ms.
    pub this: Vec<f64>,
    /// Shortest step of each round with the other build, ms.
    pub other: Vec<f64>,
    /// Shortest step of all rounds with this build, divided by that with the other build.
    pub ratio: f64,
}

/// Runs the two builds alternately.
///
/// # Errors
/// A binary that does not start, fails, or does not print the JSON document of `bench`.
pub(super) fn execute(options: &Options, other: &Path) -> Result<bool, Failure> {
    let this =
        std::env::current_exe().map_err(|e| Failure::System(format!("cannot find the file of this program: {e}")))?;
    // a bare file name would be searched for in PATH
    let other = &std::fs::canonicalize(other)
        .map_err(|e| Failure::Call(format!("--against {}: {e}: give the path of another build", other.display())))?;
    let arguments = arguments(std::env::args_os().skip(1));
    let (mut times, mut others) = (Vec::new(), Vec::new());
    for _ in 0..options.rounds {
        times.push(shortest_step(&this, &arguments)?);
        others.push(shortest_step(other, &arguments)?);
    }
    let least = |times: &[f64]| times.iter().copied().fold(f64::INFINITY, f64::min);
    let ratio = least(&times) / least(&others);
    let words = format!(
        "this build   {:8.3} ms per step, minimum\nother build  {:8.3}\nratio        {ratio:8.3}\n",
        least(&times),
        least(&others)
    );
    deliver(&options.common, "against.txt", &Against { this: times, other: others, ratio }, &words)?;
    Ok(true)
}

/// Returns this program's arguments without those that are not for the other build, plus `--json`.
fn arguments(mut given: impl Iterator<Item = OsString>) -> Vec<OsString> {
    let mut kept = Vec::new();
    while let Some(argument) = given.next() {
        let name = argument.to_string_lossy();
        let (name, has_value) = name.split_once('=').map_or((&*name, false), |(name, _)| (name, true));
        match name {
            "--against" | "--rounds" | "--out" if has_value => {}
            "--against" | "--rounds" | "--out" => drop(given.next()),
            "--json" => {}
            _ => kept.push(argument),
        }
    }
    kept.push("--json".into());
    kept
}

/// Runs a build once and returns its shortest step, ms.
fn shortest_step(binary: &Path, arguments: &[OsString]) -> Result<f64, Failure> {
    let failed = |why: String| Failure::System(format!("{}: {why}", binary.display()));
    let run = Command::new(binary).args(arguments).stderr(Stdio::inherit()).output();
    let output = run.map_err(|e| failed(e.to_string()))?;
    if !output.status.success() {
        return Err(failed(output.status.to_string()));
    }
    let document: serde_json::Value = serde_json::from_slice(&output.stdout).map_err(|e| failed(e.to_string()))?;
    document["ms_per_step"]["min"].as_f64().ok_or_else(|| failed("its JSON document has no ms_per_step.min".into()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_other_build_is_called_as_this_one_was_but_for_what_is_this_ones_own() {
        let given = "bench drop --against old --steps 3 --rounds=2 --set model.xsph=0.1 --json --out=x --threads 1";
        let kept = arguments(given.split(' ').map(OsString::from));
        let expected = "bench drop --steps 3 --set model.xsph=0.1 --threads 1 --json";
        assert_eq!(kept, expected.split(' ').map(OsString::from).collect::<Vec<_>>());
    }
}
