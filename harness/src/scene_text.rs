//! The text of a scene file: conversion from earlier versions, and the line of a field.
use std::borrow::Cow;

/// Converts a text of an earlier version to this version's form, and keeps the lines where they are. Version 0.1 had
/// `fluid`, directly followed by `other_fluids`; now there is one list, `fluids`. A byte order mark, which some editors
/// write, is removed.
pub fn current(text: &str) -> Cow<'_, str> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let code = code_of(text);
    let (Some(first), Some(others)) = (key(&code, "fluid"), key(&code, "other_fluids")) else { return text.into() };
    let Some(list) = code[others..].find('[').map(|at| others + at + 1) else { return text.into() };
    let after_first = first + "fluid:".len();
    let is_next = code.get(after_first..others).is_some_and(|fluid| fluid.trim_end().ends_with("),"));
    if !is_next || !code[first..].starts_with("fluid:") {
        return text.into();
    }
    format!("{}fluids: [{}{}", &text[..first], &text[after_first..others], &text[list..]).into()
}

/// Returns the line, counted from 1, of a field given by its path or the end of its path, such as
/// `fluids[1].rest_density`.
pub fn line_of(text: &str, field: &str) -> Option<usize> {
    let code = code_of(text);
    let mut at = 0;
    for (i, step) in field.split('.').enumerate() {
        let (name, item) = match step.split_once('[') {
            Some((name, rest)) => (name, rest.trim_end_matches(']').parse().ok()),
            None => (step, None),
        };
        // a field of the scene itself may have the name of another one inside of an earlier field
        let own = if i == 0 { own_key(&code, name) } else { None };
        at += own.or_else(|| key(&code[at..], name))?;
        if let Some(item) = item {
            at += start_of_item(&code[at..], item)?;
        }
    }
    Some(1 + code[..at].matches('\n').count())
}

/// Replaces comments and string literals by blanks, so that everything else stays in its place.
fn code_of(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(c) = rest.chars().next() {
        let end = match rest.as_bytes() {
            [b'"', ..] => rest[1..].find('"').map_or(rest.len(), |i| i + 2),
            [b'/', b'/', ..] => rest.find('\n').unwrap_or(rest.len()),
            [b'/', b'*', ..] => rest.find("*/").map_or(rest.len(), |i| i + 2),
            _ => c.len_utf8(),
        };
        let (part, after) = rest.split_at(end);
        if part.len() > c.len_utf8() {
            out.extend(part.chars().map(|c| if c == '\n' { '\n' } else { ' ' }));
        } else {
            out += part;
        }
        rest = after;
    }
    out
}

/// Returns the position of `name:` among the fields of the scene itself.
fn own_key(code: &str, name: &str) -> Option<usize> {
    let scene = key(code, "scene")?;
    let start = scene + code[scene..].find('(')? + 1;
    let (mut depth, mut own) = (0, String::new());
    for c in code[start..].chars() {
        match c {
            '(' | '[' => depth += 1,
            ')' | ']' => depth -= 1,
            _ => {}
        }
        if depth < 0 {
            break;
        }
        // what lies deeper is blanked out, byte by byte
        own.extend(if depth == 0 { Some(c) } else { None });
        if depth > 0 {
            own.extend(core::iter::repeat_n(' ', c.len_utf8()));
        }
    }
    key(&own, name).map(|at| start + at)
}

/// Returns the position of `name:`.
fn key(code: &str, name: &str) -> Option<usize> {
    let is_part = |c: char| c.is_alphanumeric() || c == '_';
    let stands = |&(at, _): &(usize, &str)| {
        !code[..at].ends_with(is_part) && code[at + name.len()..].trim_start().starts_with(':')
    };
    code.match_indices(name).find(stands).map(|(at, _)| at)
}

/// Returns the position of an item of the list that starts at or after the beginning of `code`. The list may also be a
/// single item without brackets.
fn start_of_item(code: &str, item: usize) -> Option<usize> {
    let start = code.find(['[', '('])?;
    if code[start..].starts_with('(') {
        return Some(start).filter(|_| item == 0);
    }
    let (mut depth, mut items) = (0, 0);
    for (at, c) in code[start..].char_indices() {
        match c {
            '(' if depth == 1 => {
                if items == item {
                    return Some(start + at);
                }
                items += 1;
                depth += 1;
            }
            '[' | '(' => depth += 1,
            ']' | ')' => depth -= 1,
            _ => {}
        }
        if depth == 0 {
            return None;
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::{current, line_of};

    const TEXT: &str = "/* rest_density: of old\n*/\n(\n  about: \"rest_density: 1\", // rest_density: 2\n  \
                        fluids: [\n    \
                        (rest_density: 1000.0),\n    (\n      rest_density: -5.0),\n  ],\n  \
                        container: (low: (0, 0)),\n)\n";

    #[test]
    fn files_of_the_first_version_are_read() {
        let old = "\u{feff}(\n fluid: (a: 1), // water\n other_fluids: [\n  (a: 2),\n ],\n)";
        assert_eq!(current(old), "(\n fluids: [ (a: 1), // water\n \n  (a: 2),\n ],\n)");
        assert_eq!(current("(fluid: (a: 1), blocks: [])"), "(fluid: (a: 1), blocks: [])");
    }

    #[test]
    fn a_field_is_found_in_its_item_and_never_in_a_comment() {
        assert_eq!(line_of(TEXT, "fluids[0].rest_density"), Some(6));
        assert_eq!(line_of(TEXT, "fluids[1].rest_density"), Some(8));
        assert_eq!(line_of(TEXT, "rest_density"), Some(6));
        assert_eq!(line_of(TEXT, "container.low"), Some(10));
        assert_eq!(line_of(TEXT, "fluids[2].rest_density"), None);
        assert_eq!(line_of(TEXT, "density"), None);
        let nested = "(\n scene: (\n  fluids: [\n   (time_step: 1),\n  ],\n  time_step: 2,\n ),\n)";
        assert_eq!(line_of(nested, "time_step"), Some(6));
        assert_eq!(line_of(nested, "fluids[0].time_step"), Some(4));
    }
}
