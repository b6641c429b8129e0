//! `--set`: changes of single fields of a scene, named by the end of their paths.
use crate::failure::Failure;
use crate::scene_errors::closest;
use crate::scene_file::SceneFile;
use serde_json::{Map, Value, json};

/// Returns a path as errors write it: items of lists in brackets, and the first fluid by its number.
pub(crate) fn indexed(path: &str) -> String {
    let path = path.strip_prefix("fluid.").map_or(path.to_owned(), |rest| format!("fluids.0.{rest}"));
    path.split('.').fold(String::new(), |out, step| match step.parse::<usize>() {
        Ok(item) => format!("{out}[{item}]"),
        Err(_) if out.is_empty() => step.to_owned(),
        Err(_) => format!("{out}.{step}"),
    })
}

/// Returns `file` changed by the argument of a `--set`.
pub(crate) fn set(file: &SceneFile, change: &str) -> Result<SceneFile, Failure> {
    let wrong = |what: String| Failure::Call(format!("--set {change}: {what}"));
    let (field, value) = change.split_once('=').ok_or_else(|| wrong("give FIELD=VALUE".into()))?;
    with(file, field, value).map_err(wrong)
}

/// Names of the recipe. It is no field of a scene that was read: it replaces the whole model.
const RECIPE: [&str; 3] = ["recipe", "model.recipe", "scene.model.recipe"];

/// Returns `file` with one field changed. A field is named by the end of its path; of several matches the shortest path
/// wins.
///
/// # Errors
/// An unknown or ambiguous field, or a value that does not fit, as text.
pub(crate) fn with(file: &SceneFile, field: &str, value: &str) -> Result<SceneFile, String> {
    let value = parsed(value);
    let mut tree = serde_json::to_value(file).map_err(|e| e.to_string())?;
    if RECIPE.contains(&field) {
        tree["scene"]["model"] = json!({ "recipe": value });
        return serde_json::from_value(tree).map_err(|e| e.to_string());
    }
    let mut paths = Vec::new();
    collect_paths(&tree, "", &mut paths);
    // items of a list may be named as in RON, and `fluid` stands for the first fluid
    let path = indexed(field).replace('[', ".").replace(']', "");
    let ending = format!("/{}", path.replace('.', "/"));
    let matches: Vec<&String> = paths.iter().filter(|path| path.ends_with(&ending)).collect();
    let shortest = matches.iter().map(|path| path.matches('/').count()).min();
    let mut best = matches.iter().filter(|path| Some(path.matches('/').count()) == shortest);
    let (Some(path), None) = (best.next(), best.next()) else {
        return Err(match matches.len() {
            0 => format!("the scene has no field {field}{}", suggestion(field, &paths)),
            n => format!("{field} matches {n} fields: give more of its path"),
        });
    };
    if let Some(place) = tree.pointer_mut(path) {
        *place = value;
    }
    serde_json::from_value(tree).map_err(|e| e.to_string())
}

/// Collects the JSON pointers of all values in a tree.
fn collect_paths(tree: &Value, prefix: &str, out: &mut Vec<String>) {
    let mut add = |key: &str, value: &Value| {
        let path = format!("{prefix}/{key}");
        collect_paths(value, &path, out);
        out.push(path);
    };
    match tree {
        Value::Object(fields) => fields.iter().for_each(|(key, value)| add(key, value)),
        Value::Array(items) => items.iter().enumerate().for_each(|(i, value)| add(&i.to_string(), value)),
        _ => {}
    }
}

/// Parses a value, in JSON or as in a scene file: `30`, `Tait`, `None`, `(0,-1.6,0)`, `ShortenStep(times: 4)`.
fn parsed(text: &str) -> Value {
    let name = text.split('(').next().unwrap_or_default().trim();
    let is_name = name.starts_with(|c: char| c.is_ascii_uppercase()) && name.chars().all(char::is_alphanumeric);
    let ron = |text: &str| ron::from_str::<Value>(text).ok();
    let value = match text.trim().strip_prefix(name) {
        Some("") if name == "None" => Some(Value::Null),
        Some("") if is_name => None,
        // a variant with fields
        Some(fields) if is_name && name != "Some" => {
            ron(fields).map(|fields| Value::Object(Map::from_iter([(name.to_owned(), fields)])))
        }
        _ => serde_json::from_str(text).ok().or_else(|| ron(text)),
    };
    value.unwrap_or_else(|| Value::String(text.trim().to_owned()))
}

/// Returns a hint at the field whose name is closest to a name that was not found.
fn suggestion(field: &str, paths: &[String]) -> String {
    let leaf = |path: &str| path.rsplit(['/', '.']).next().unwrap_or_default().to_owned();
    let names: Vec<String> = paths.iter().map(|path| leaf(path)).collect();
    closest(&leaf(field), names.iter().map(String::as_str))
        .map_or(String::new(), |name| format!("; did you mean {name}?"))
}

#[cfg(test)]
mod tests {
    use super::parsed;
    use serde_json::json;

    #[test]
    fn values_are_written_as_in_a_scene_file_or_in_json() {
        for (text, value) in [
            ("30", json!(30)),
            ("1e-3", json!(1e-3)),
            ("true", json!(true)),
            ("null", json!(null)),
            ("None", json!(null)),
            ("Tait", json!("Tait")),
            ("(0, -1.6, 0)", json!([0, -1.6, 0])),
            ("[8,8,8]", json!([8, 8, 8])),
            ("ShortenStep(times: 4)", json!({"ShortenStep": {"times": 4}})),
            ("{\"ShortenStep\": {\"times\": 4}}", json!({"ShortenStep": {"times": 4}})),
            ("Some((drag: 0.5, velocity: (1, 0, 0)))", json!({"drag": 0.5, "velocity": [1, 0, 0]})),
            ("Some(3)", json!(3)),
        ] {
            assert_eq!(parsed(text), value, "{text}");
        }
    }
}
