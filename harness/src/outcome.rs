//! Result of a study: figures with limits, and notes.
use serde::Serialize;

/// The side of its limit on which a figure must lie.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub enum Sense {
    /// At or below the limit.
    #[serde(rename = "<=")]
    AtMost,
    /// At or above the limit.
    #[serde(rename = ">=")]
    AtLeast,
}

/// A measured figure and its limit.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Metric {
    /// What was measured.
    pub name: String,
    /// The measured value.
    pub value: f64,
    /// The limit.
    pub limit: f64,
    /// The side of the limit on which the value must lie.
    pub sense: Sense,
    /// Whether the value is within its limit. False for NaN.
    pub ok: bool,
}

impl Metric {
    /// Returns a figure that must not exceed its limit.
    #[must_use]
    pub fn below(name: impl Into<String>, value: f64, limit: f64) -> Metric {
        Metric { name: name.into(), value, limit, sense: Sense::AtMost, ok: value <= limit }
    }

    /// Returns a figure that must not be less than its limit.
    #[must_use]
    pub fn above(name: impl Into<String>, value: f64, limit: f64) -> Metric {
        Metric { name: name.into(), value, limit, sense: Sense::AtLeast, ok: value >= limit }
    }
}

/// Result of a study.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Outcome {
    /// Name of the study.
    pub name: String,
    /// Whether all figures are within their limits.
    pub passed: bool,
    /// The measured figures.
    pub figures: Vec<Metric>,
    /// Further results without limits: paragraphs and tables.
    pub notes: Vec<String>,
}

impl Outcome {
    /// Returns the result of a study, which passes if all figures are within their limits.
    #[must_use]
    pub fn new(name: &str, figures: Vec<Metric>, notes: Vec<String>) -> Outcome {
        Outcome { name: name.to_owned(), passed: figures.iter().all(|figure| figure.ok), figures, notes }
    }

    /// Formats the result as a Markdown page.
    #[must_use]
    pub fn words(&self, about: &str) -> String {
        let verdict = if self.passed { "passed" } else { "FAILED" };
        let mut out = format!("# {}: {about}: {verdict}\n\n", self.name);
        out += "| figure | value | limit | |\n| --- | --- | --- | --- |\n";
        for Metric { name, value, limit, sense, ok } in &self.figures {
            let sign = match sense {
                Sense::AtMost => "<=",
                Sense::AtLeast => ">=",
            };
            let mark = if *ok { "ok" } else { "FAILED" };
            out += &format!("| {name} | {} | {sign} {} | {mark} |\n", short(*value), short(*limit));
        }
        for note in &self.notes {
            out += &format!("\n{}\n", note.trim_end());
        }
        out
    }
}

/// Formats a number with four decimals, or in scientific notation if it is very small or very large.
fn short(value: f64) -> String {
    if value == 0.0 || (1e-3..1e4).contains(&value.abs()) { format!("{value:.4}") } else { format!("{value:.2e}") }
}

/// Formats a Markdown table from a row of titles and rows of the same length.
pub(crate) fn table<const N: usize>(titles: [&str; N], rows: impl IntoIterator<Item = [String; N]>) -> String {
    table_of(&titles, rows)
}

/// Formats a Markdown table whose number of columns is not known in advance.
pub(crate) fn table_of(titles: &[&str], rows: impl IntoIterator<Item = impl AsRef<[String]>>) -> String {
    let mut out = format!("| {} |\n| {} |\n", titles.join(" | "), vec!["---"; titles.len()].join(" | "));
    for row in rows {
        out += &format!("| {} |\n", row.as_ref().join(" | "));
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
