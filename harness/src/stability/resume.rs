//! Log of finished points, from which an interrupted study is resumed: one line of JSON for each point, appended as
//! soon as it is finished.
use super::Run;
use crate::failure::Failure;
use millpond_core::backend::hash::Fnv;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::fs::{File, OpenOptions};
use std::io::{ErrorKind, Write as _};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

/// A line of the log.
#[derive(Debug, Serialize, Deserialize)]
struct Line<R> {
    key: String,
    run: R,
}

/// The finished points.
#[derive(Debug, Default)]
pub(super) struct ResumeLog {
    known: BTreeMap<String, Run>,
    file: Option<(PathBuf, Mutex<File>)>,
}

impl ResumeLog {
    /// Opens a log, or creates it if it does not exist. `fresh` discards its content.
    ///
    /// # Errors
    /// Returns an error if the file cannot be read or written.
    pub(super) fn open(path: &Path, fresh: bool) -> Result<ResumeLog, Failure> {
        let text = match std::fs::read(path) {
            Ok(bytes) if !fresh => String::from_utf8_lossy(&bytes).into_owned(),
            Err(error) if error.kind() != ErrorKind::NotFound => return Err(Failure::file(path)(error)),
            _ => String::new(),
        };
        let open = OpenOptions::new().create(true).append(true).open(path);
        let mut file = open.map_err(Failure::unwritten(path))?;
        if fresh {
            file.set_len(0).map_err(Failure::unwritten(path))?;
        }
        if !text.is_empty() && !text.ends_with('\n') {
            // a truncated last line is closed, so that the next line is complete
            file.write_all(b"\n").map_err(Failure::unwritten(path))?;
        }
        Ok(ResumeLog { known: read(&text), file: Some((path.to_owned(), Mutex::new(file))) })
    }

    /// Returns a point if it is finished.
    pub(super) fn find(&self, key: &str) -> Option<&Run> {
        self.known.get(key)
    }

    /// Appends a finished point.
    ///
    /// # Errors
    /// Returns an error if the file cannot be written.
    pub(super) fn add(&self, key: &str, run: &Run) -> Result<(), Failure> {
        let Some((path, file)) = &self.file else { return Ok(()) };
        let line = serde_json::to_string(&Line { key: key.to_owned(), run });
        let line = line.map_err(|e| Failure::System(e.to_string()))? + "\n";
        // a thread that panicked with the lock held had written a line, or a part of one
        let mut file = file.lock().unwrap_or_else(PoisonError::into_inner);
        file.write_all(line.as_bytes()).map_err(Failure::unwritten(path))
    }
}

/// Parses the points of a log. Truncated lines are ignored. If a point occurs twice, the later line counts.
fn read(text: &str) -> BTreeMap<String, Run> {
    let lines = text.lines().filter_map(|line| serde_json::from_str::<Line<Run>>(line).ok());
    lines.map(|line| (line.key, line.run)).collect()
}

/// Returns the key of a point: its choice, and a hash of all settings on which its result depends.
///
/// # Errors
/// Returns an error for a number that JSON cannot represent.
pub(super) fn key(label: &str, settings: &impl Serialize) -> Result<String, Failure> {
    let text = serde_json::to_string(settings).map_err(|e| Failure::System(e.to_string()))?;
    let hash = text.bytes().fold(Fnv::default(), |hash, byte| hash.word(u32::from(byte)));
    Ok(format!("{label} #{:016x}", hash.0))
}

#[cfg(test)]
mod tests {
    use super::super::Outcome;
    use super::*;

    fn run(label: &str) -> Run {
        Run {
            label: label.into(),
            choice: BTreeMap::from([("viscosity".to_owned(), "1".to_owned())]),
            outcome: Outcome::Stable,
            detail: "it is stable".into(),
            criterion: None,
            too_long: false,
            time_step: Some(0.1),
            unstable_time_step: Some(0.11),
            courant: None,
            particles: 7,
            steps: 100,
        }
    }

    #[test]
    fn a_line_that_was_cut_off_is_none() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("stability.jsonl");
        let ledger = ResumeLog::open(&path, false).expect("it can be made");
        ledger.add("a #1", &run("a")).expect("it can be written");
        ledger.add("b #1", &run("b")).expect("it can be written");
        let text = std::fs::read_to_string(&path).expect("it is there");
        std::fs::write(&path, &text[..text.len() - 9]).expect("it can be cut");

        let ledger = ResumeLog::open(&path, false).expect("it can be read");
        assert_eq!((ledger.find("a #1"), ledger.find("b #1")), (Some(&run("a")), None));
        ledger.add("c #1", &run("c")).expect("it can be written");
        let ledger = ResumeLog::open(&path, false).expect("it can be read");
        assert!(ledger.find("c #1").is_some(), "the line after the truncated one is complete");
        assert!(ledger.find("a #2").is_none(), "a point with another hash is another point");
        assert!(ResumeLog::open(&path, true).expect("it can be emptied").find("a #1").is_none());
    }

    #[test]
    fn a_key_knows_its_settings() {
        let one = key("a", &[1.0, 2.0]).expect("numbers");
        assert_eq!(one, key("a", &[1.0, 2.0]).expect("numbers"));
        assert_ne!(one, key("a", &[1.0, 2.5]).expect("numbers"));
    }
}
