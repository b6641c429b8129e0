//! Output of a command: one JSON document or text on stdout, files, and progress bars.
use crate::arguments::Common;
use crate::failure::Failure;
use indicatif::{ProgressBar, ProgressStyle};
use serde::Serialize;
use std::io::Write as _;
use std::path::Path;
use std::time::Duration;

/// Prints a result as JSON or as text, as the caller chose. With `--out`, also writes the text to a file of this name.
///
/// # Errors
/// A result that JSON cannot represent, or a file that cannot be written.
pub fn deliver(common: &Common, name: &str, result: &impl Serialize, words: &str) -> Result<(), Failure> {
    if let Some(folder) = &common.out {
        make_folder(folder)?;
        write_text(&folder.join(name), words)?;
    }
    if common.json { print_json(result) } else { say(words) }
}

/// Prints a result as the single JSON document on stdout.
///
/// # Errors
/// A result that JSON cannot represent, or a stdout that cannot be written.
pub fn print_json(result: &impl Serialize) -> Result<(), Failure> {
    say(&json(result)?)
}

/// Writes a result to a JSON file.
///
/// # Errors
/// A result that JSON cannot represent, or a file that cannot be written.
pub fn write_json(path: &Path, result: &impl Serialize) -> Result<(), Failure> {
    write_text(path, &(json(result)? + "\n"))
}

fn json(result: &impl Serialize) -> Result<String, Failure> {
    serde_json::to_string_pretty(result).map_err(|e| Failure::System(e.to_string()))
}

/// Prints text. A closed pipe, as with `head`, is not an error.
///
/// # Errors
/// A stdout that cannot be written.
pub fn say(words: &str) -> Result<(), Failure> {
    match writeln!(std::io::stdout(), "{}", words.trim_end()) {
        Err(error) if error.kind() != std::io::ErrorKind::BrokenPipe => {
            Err(Failure::unwritten(Path::new("stdout"))(error))
        }
        _ => Ok(()),
    }
}

/// Formats a time with its unit: two decimals below 10, one below 100, none above. A bisection is no more precise than
/// that.
#[must_use]
pub fn seconds(time: f32) -> String {
    let (value, unit) = match time {
        t if t >= 1.0 => (t, "s"),
        t if t >= 1e-3 => (t * 1e3, "ms"),
        t => (t * 1e6, "µs"),
    };
    let digits = if value < 9.995 { 2 } else { usize::from(value < 99.95) };
    format!("{value:.digits$} {unit}")
}

/// Returns a progress bar on stderr. It is hidden if stderr is not a terminal.
#[must_use]
pub fn progress(what: &str, steps: u64) -> ProgressBar {
    let bar = ProgressBar::new(steps);
    let style = ProgressStyle::with_template("{msg:28} {bar:40} {pos}/{len}  {eta} left");
    bar.set_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
    bar.set_message(what.to_owned());
    bar.enable_steady_tick(Duration::from_millis(200));
    bar
}

/// Creates a folder for results.
///
/// # Errors
/// A folder that cannot be created.
pub fn make_folder(folder: &Path) -> Result<(), Failure> {
    std::fs::create_dir_all(folder).map_err(Failure::unwritten(folder))
}

/// Writes a text file.
///
/// # Errors
/// A file that cannot be written.
pub fn write_text(path: &Path, text: &str) -> Result<(), Failure> {
    std::fs::write(path, text).map_err(Failure::unwritten(path))
}
