//! The showcase, which runs if no command is given: compare, run, plan and error study in a few minutes.
use crate::arguments::BackendName;
use crate::compare::{self, Paths, compare};
use crate::error_study::{self, CASE, QUICK};
use crate::failure::Failure;
use crate::fluid::device_if_any;
use crate::gauges::Record;
use crate::output::{make_folder, say, write_text};
use crate::plan_view;
use crate::pool::Pool;
use crate::run::{self, run};
use crate::run_length::RunLength;
use crate::scenes::{Changes, load};
use std::path::Path;

/// Output folder of the showcase.
const FOLDER: &str = "out/showcase";

/// Number of steps of the comparison.
const COMPARED_STEPS: u64 = 200;

/// Number of pictures of the run.
const PICTURES: u64 = 41;

/// Runs the showcase. Returns false if a backend differs or a run of the error study fails.
///
/// # Errors
/// A step that fails, or files that cannot be written.
pub fn execute() -> Result<bool, Failure> {
    let folder = Path::new(FOLDER);
    make_folder(folder)?;
    let named = load("dam-break", &Changes::default())?;
    let scene = &named.file.scene;
    let pool = Pool::new(0)?;
    let mut report = String::from("# millpond: the showcase\n\n");
    let mut tell = |text: &str| {
        report += text;
        report += "\n";
        say(&format!("{text}\n"))
    };

    tell("## The same bits on every path\n")?;
    let devices: Vec<_> = device_if_any()?.into_iter().collect();
    if devices.is_empty() {
        tell("No Vulkan device: the GPU is left out. A software device will do (Debian: mesa-vulkan-drivers).\n")?;
    }
    let paths = Paths { cpu: true, threads: 2, devices };
    let comparison = compare(&named, RunLength::Steps(COMPARED_STEPS), &paths, &mut |_, _| ())?;
    tell(&compare::table(&comparison))?;

    tell("## A dam break\n")?;
    let span = RunLength::of_seconds(scene, named.file.duration)?;
    let no_gauges = Record::new(&named.file.scene, &[], span, None)?;
    let outcome = run(&named, BackendName::Cpu, &pool, span, Some((folder, PICTURES)), no_gauges)?;
    tell(below_heading(&run::report(&named, &outcome)))?;

    tell("## What the plan leaves out\n")?;
    tell(&format!("```text\n{}```\n", plan_view::table(&plan_view::view(&named, &pool, 20)?)))?;

    let tank = load(CASE, &Changes::default())?;
    let study = error_study::study(&tank, &QUICK, &Pool::new(1)?, Some(folder))?;
    tell("## A still tank: error against run time\n")?;
    tell(below_heading(&error_study::table(&study)))?;
    tell(&format!("Pictures, plot and this report: {FOLDER}"))?;
    write_text(&folder.join("report.md"), &report)?;
    Ok(comparison.kept() && study.runs.iter().all(|run| run.error.is_some()))
}

/// Returns a page without its first line, for a section that has its own heading.
fn below_heading(page: &str) -> &str {
    page.split_once('\n').map_or(page, |(_, below)| below.trim_start())
}
