//! What a command says: one JSON document on stdout, or words.
use crate::arguments::Common;
use crate::failure::Failure;
use indicatif::{ProgressBar, ProgressStyle};
use serde::Serialize;
use std::io::Write as _;
use std::path::Path;
use std::time::Duration;

/// Says a result as the caller wants it, in JSON or in words, and leaves the words in `out` as a file of this name.
///
/// # Errors
/// A number that JSON cannot hold, a file that cannot be written.
pub fn deliver(common: &Common, name: &str, result: &impl Serialize, words: &str) -> Result<(), Failure> {
    if let Some(folder) = &common.out {
        make_folder(folder)?;
        write_text(&folder.join(name), words)?;
    }
    if common.json { print_json(result) } else { say(words) }
}

/// Prints a result as the one JSON document.
///
/// # Errors
/// A number that JSON cannot hold, a stdout that cannot be written.
pub fn print_json(result: &impl Serialize) -> Result<(), Failure> {
    say(&json(result)?)
}

/// Writes a result as a JSON document beside the words.
///
/// # Errors
/// A number that JSON cannot hold, what the system says.
pub fn write_json(path: &Path, result: &impl Serialize) -> Result<(), Failure> {
    write_text(path, &(json(result)? + "\n"))
}

fn json(result: &impl Serialize) -> Result<String, Failure> {
    serde_json::to_string_pretty(result).map_err(|e| Failure::System(e.to_string()))
}

/// Prints words. A reader who has seen enough, as `head` has, is no failure.
///
/// # Errors
/// A stdout that cannot be written.
pub fn say(words: &str) -> Result<(), Failure> {
    match writeln!(std::io::stdout(), "{}", words.trim_end()) {
        Err(error) if error.kind() != std::io::ErrorKind::BrokenPipe => Err(Failure::System(error.to_string())),
        _ => Ok(()),
    }
}

/// A time in words, to the two digits that a bisection finds or the three that somebody gives.
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

/// A bar on stderr for long work; nothing where stderr is no terminal.
#[must_use]
pub fn progress(what: &str, steps: u64) -> ProgressBar {
    let bar = ProgressBar::new(steps);
    let style = ProgressStyle::with_template("{msg:28} {bar:40} {pos}/{len}  {eta} left");
    bar.set_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
    bar.set_message(what.to_owned());
    bar.enable_steady_tick(Duration::from_millis(200));
    bar
}

/// Makes a folder for results.
///
/// # Errors
/// What the system says.
pub fn make_folder(folder: &Path) -> Result<(), Failure> {
    std::fs::create_dir_all(folder).map_err(Failure::file(folder))
}

/// Writes a text beside the results.
///
/// # Errors
/// What the system says.
pub fn write_text(path: &Path, text: &str) -> Result<(), Failure> {
    std::fs::write(path, text).map_err(Failure::file(path))
}
