//! What a study comes to: figures with limits, and notes.
use serde::Serialize;

/// On which side of its limit a figure must lie.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub enum Sense {
    /// Not above it.
    #[serde(rename = "<=")]
    AtMost,
    /// Not below it.
    #[serde(rename = ">=")]
    AtLeast,
}

/// A measured number and its limit.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Metric {
    /// What was measured.
    pub name: String,
    /// How much it is.
    pub value: f64,
    /// How much it may be.
    pub limit: f64,
    /// On which side of the limit it must lie.
    pub sense: Sense,
    /// Does it? Never where the value is no number.
    pub ok: bool,
}

impl Metric {
    /// One that must not be above its limit.
    #[must_use]
    pub fn below(name: impl Into<String>, value: f64, limit: f64) -> Metric {
        Metric { name: name.into(), value, limit, sense: Sense::AtMost, ok: value <= limit }
    }

    /// One that must not be below its limit.
    #[must_use]
    pub fn above(name: impl Into<String>, value: f64, limit: f64) -> Metric {
        Metric { name: name.into(), value, limit, sense: Sense::AtLeast, ok: value >= limit }
    }
}

/// Result of a study.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Outcome {
    /// The study.
    pub name: String,
    /// Are all figures within their limits?
    pub passed: bool,
    /// What was measured.
    pub figures: Vec<Metric>,
    /// What else is to be known: paragraphs and tables, with no limit to them.
    pub notes: Vec<String>,
}

impl Outcome {
    /// It passes where all figures do.
    #[must_use]
    pub fn new(name: &str, figures: Vec<Metric>, notes: Vec<String>) -> Outcome {
        Outcome { name: name.to_owned(), passed: figures.iter().all(|figure| figure.ok), figures, notes }
    }

    /// The outcome as a page.
    #[must_use]
    pub fn words(&self, about: &str) -> String {
        let verdict = if self.passed { "passed" } else { "FELL SHORT" };
        let mut out = format!("# {}: {about}: {verdict}\n\n", self.name);
        out += "| figure | value | limit | |\n| --- | --- | --- | --- |\n";
        for Metric { name, value, limit, sense, ok } in &self.figures {
            let sign = match sense {
                Sense::AtMost => "<=",
                Sense::AtLeast => ">=",
            };
            let mark = if *ok { "ok" } else { "SHORT" };
            out += &format!("| {name} | {} | {sign} {} | {mark} |\n", short(*value), short(*limit));
        }
        for note in &self.notes {
            out += &format!("\n{}\n", note.trim_end());
        }
        out
    }
}

/// Four digits, in whichever way is readable.
fn short(value: f64) -> String {
    if value == 0.0 || (1e-3..1e4).contains(&value.abs()) { format!("{value:.4}") } else { format!("{value:.2e}") }
}

/// A table in words: a row of titles, and rows of the same length.
pub(crate) fn table<const N: usize>(titles: [&str; N], rows: impl IntoIterator<Item = [String; N]>) -> String {
    let mut out = format!("| {} |\n| {} |\n", titles.join(" | "), ["---"; N].join(" | "));
    for row in rows {
        out += &format!("| {} |\n", row.join(" | "));
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_number_that_is_none_never_passes() {
        assert!(!Metric::below("", f64::NAN, 1.0).ok);
        assert!(!Metric::above("", f64::NAN, 1.0).ok);
        assert!(Metric::below("", 1.0, 1.0).ok && !Metric::below("", 1.1, 1.0).ok);
        assert!(Metric::above("", 1.0, 1.0).ok && !Metric::above("", 0.9, 1.0).ok);
    }
}
