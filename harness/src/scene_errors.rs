//! Errors in the text of a scene file, said in the words of scenes.
use ron::error::Error;

/// Smallest similarity of two names, from 0 to 1, at which one may be a misspelling of the other.
const SIMILAR: f64 = 0.8;

/// Smallest share of pairs of letters, from 0 to 1, that a part of a name has in common with the name.
const ALIKE: f64 = 0.5;

/// Fields that fluids had in the first version, and that are the model's now.
const MOVED: [&str; 6] = ["alpha", "beta", "velocity_exchange", "radial_exchange", "xsph", "heat_gain"];

/// Says what is wrong with a text, in a line that is quoted.
pub(crate) fn explained(error: &Error, line: &str) -> String {
    let of = |outer: &Option<String>| outer.as_ref().map_or("the scene".to_owned(), |outer| format!("`{outer}`"));
    let what = match error {
        Error::NoSuchStructField { found, .. } if MOVED.contains(&found.as_str()) => {
            format!("`{found}` is a field of model now")
        }
        Error::NoSuchStructField { expected, found, outer } => {
            format!("{} has no field `{found}`; {}", of(outer), instead(found, expected))
        }
        Error::NoSuchEnumVariant { expected, found, .. } => {
            format!("there is no choice `{found}`; {}", instead(found, expected))
        }
        Error::MissingStructField { field, outer } => format!("{} lacks the field `{field}`", of(outer)),
        Error::DuplicateStructField { field, outer } => format!("{} has the field `{field}` twice", of(outer)),
        Error::ExpectedAttribute | Error::ExpectedNamedStructLike("SceneFile") => {
            "this is not a scene: a scene file begins with `(`".to_owned()
        }
        Error::ExpectedDifferentLength { expected, found } if expected == "a sequence" => {
            format!("a list here has {found} items, and a scene has no room for so many")
        }
        Error::Eof => "the text ends before the scene does: a closing bracket is missing".to_owned(),
        other => other.to_string(),
    };
    if line.is_empty() { what } else { format!("{what} (at `{line}`)") }
}

/// Says which name to use instead of one that does not exist.
fn instead(found: &str, expected: &[&str]) -> String {
    match closest(found, expected.iter().copied()) {
        Some(name) => format!("did you mean `{name}`?"),
        None => format!("use one of {}", expected.join(", ")),
    }
}

/// Returns the name that is most similar to a given one, if it may be what was meant.
pub(crate) fn closest<'n>(name: &str, names: impl Iterator<Item = &'n str>) -> Option<&'n str> {
    let similarity = |other: &str| {
        let (spelling, pairs) = (strsim::jaro_winkler(name, other), strsim::sorensen_dice(name, other));
        (spelling >= SIMILAR || pairs >= ALIKE).then_some(spelling.max(pairs))
    };
    let rated = names.filter_map(|other| Some((similarity(other)?, other)));
    rated.max_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, other)| other)
}
