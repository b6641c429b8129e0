//! The text of a scene file: the line of a field, and the form of files of earlier versions.
use std::borrow::Cow;
use std::ops::Range;

/// Returns the text in the form that this version reads, with the same lines. Version 0.1 had `fluid` and, directly
/// after it, `other_fluids`, which are one list now. A byte order mark, which some editors write, is removed.
pub fn current(text: &str) -> Cow<'_, str> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let code = code_of(text);
    let scene = scene_of(&code);
    let (Some(first), Some(others)) = (child(&code, &scene, "fluid"), child(&code, &scene, "other_fluids")) else {
        return text.into();
    };
    let after_first = first + "fluid:".len();
    let is_next = code.get(after_first..others).is_some_and(|fluid| fluid.trim_end().ends_with("),"));
    let Some(list) = code[others..].find('[').map(|at| others + at + 1) else { return text.into() };
    if !is_next || !code[first..].starts_with("fluid:") {
        return text.into();
    }
    format!("{}fluids: [{}{}", &text[..first], &text[after_first..others], &text[list..]).into()
}

/// Returns the line, counted from 1, of a field given by its path from the scene on, such as `fluids[1].rest_density`,
/// or by the end of its path. Where an item of a list leaves the field out, it is the line of the item.
pub fn line_of(text: &str, field: &str) -> Option<usize> {
    let code = code_of(text);
    let mut within = scene_of(&code);
    let mut found = None;
    for (i, step) in field.split('.').enumerate() {
        let (name, item) = match step.split_once('[') {
            Some((name, rest)) => (name, rest.trim_end_matches(']').parse().ok()),
            None => (step, None),
        };
        let own = child(&code, &within, name);
        // the end of a path may begin anywhere
        let anywhere = || (i == 0).then(|| key(&code, name)).flatten();
        let Some(at) = own.or_else(anywhere) else { break };
        found = Some(at);
        within = value(&code, at);
        if let Some(item) = item {
            let Some(start) = start_of_item(&code, &within, item) else { break };
            found = Some(start);
            within = contents(&code, start);
        }
    }
    found.map(|at| 1 + code[..at].matches('\n').count())
}

/// Returns the text with every byte of a comment or a quotation blanked out, except for line breaks.
fn code_of(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(c) = rest.chars().next() {
        let (length, is_code) = match length_of_aside(rest) {
            Some(length) => (length, false),
            None => (c.len_utf8(), true),
        };
        let (part, after) = rest.split_at(length);
        if is_code {
            out += part;
        } else {
            out.extend(part.bytes().map(|byte| if byte == b'\n' { '\n' } else { ' ' }));
        }
        rest = after;
    }
    out
}

/// Returns the length of the comment or quotation that a text begins with.
fn length_of_aside(text: &str) -> Option<usize> {
    let until = |end: &str, from: usize| text[from..].find(end).map_or(text.len(), |at| from + at + end.len());
    match text.as_bytes() {
        [b'/', b'/', ..] => Some(text.find('\n').unwrap_or(text.len())),
        [b'/', b'*', ..] => {
            let (mut depth, mut at) = (0, 0);
            while let Some(next) = text[at..].find(['/', '*']).map(|next| at + next) {
                at = next + 2;
                match text.get(next..at) {
                    Some("/*") => depth += 1,
                    Some("*/") => depth -= 1,
                    _ => at = next + 1,
                }
                if depth == 0 {
                    return Some(at);
                }
            }
            Some(text.len())
        }
        [b'"', ..] => {
            let mut is_escaped = true; // the quotation mark that begins it
            for (at, c) in text.char_indices() {
                match c {
                    _ if is_escaped => is_escaped = false,
                    '\\' => is_escaped = true,
                    '"' => return Some(at + 1),
                    _ => {}
                }
            }
            Some(text.len())
        }
        [b'r', b'"' | b'#', ..] => {
            let marks = text[1..].len() - text[1..].trim_start_matches('#').len();
            let start = 1 + marks;
            text[start..].starts_with('"').then(|| until(&format!("\"{}", "#".repeat(marks)), start + 1))
        }
        _ => None,
    }
}

/// Returns the range of the fields of the scene: inside `scene: (..)`, or else inside the first brackets.
fn scene_of(code: &str) -> Range<usize> {
    let all = code.find('(').map_or(0..code.len(), |start| contents(code, start));
    child(code, &all, "scene").map_or(all, |scene| value(code, scene))
}

/// Returns the range inside the brackets that open at `start`.
fn contents(code: &str, start: usize) -> Range<usize> {
    let mut depth = 0;
    for (at, c) in code[start..].char_indices() {
        match c {
            '(' | '[' => depth += 1,
            ')' | ']' => depth -= 1,
            _ => {}
        }
        if depth == 0 {
            return (start + 1).min(start + at)..start + at;
        }
    }
    (start + 1).min(code.len())..code.len()
}

/// Returns the range inside the brackets of the value of the field that stands at `at`; empty if it has none.
fn value(code: &str, at: usize) -> Range<usize> {
    let open = code[at..].find(['(', '[', ',']).map(|open| at + open);
    match open.map(|open| (open, code.as_bytes()[open])) {
        // with the bracket, so that the items of a list can be counted
        Some((open, b'[')) => open..contents(code, open).end,
        Some((open, b'(')) => contents(code, open),
        _ => at..at,
    }
}

/// Returns the position of `name:` within a range, but not inside of brackets there.
fn child(code: &str, within: &Range<usize>, name: &str) -> Option<usize> {
    let mut depth = 0;
    code[within.clone()].char_indices().find_map(|(at, c)| {
        match c {
            '(' | '[' => depth += 1,
            ')' | ']' => depth -= 1,
            _ => {}
        }
        (depth == 0 && stands(code, within.start + at, name)).then_some(within.start + at)
    })
}

/// Returns the first position of `name:`.
fn key(code: &str, name: &str) -> Option<usize> {
    code.match_indices(name).map(|(at, _)| at).find(|&at| stands(code, at, name))
}

/// Returns whether `name:` stands at a position.
fn stands(code: &str, at: usize, name: &str) -> bool {
    let is_part = |c: char| c.is_alphanumeric() || c == '_';
    let after = code[at..].strip_prefix(name);
    !code[..at].ends_with(is_part) && after.is_some_and(|after| after.trim_start().starts_with(':'))
}

/// Returns the position of an item of the list in a range. The list may also be a single item without its brackets.
fn start_of_item(code: &str, list: &Range<usize>, item: usize) -> Option<usize> {
    if !code[list.start..].starts_with('[') {
        return list.start.checked_sub(1).filter(|_| item == 0 && !list.is_empty());
    }
    let mut depth = 0;
    let starts = code[list.clone()].char_indices().filter_map(|(at, c)| {
        match c {
            '(' | '[' => depth += 1,
            ')' | ']' => depth -= 1,
            _ => {}
        }
        (c == '(' && depth == 2).then_some(list.start + at)
    });
    starts.skip(item).take(1).last()
}

#[cfg(test)]
mod tests {
    use super::{current, line_of};

    const TEXT: &str = "/* rest_density: of /* the */ old\n*/\n(\n  \
                        about: \"rest_density: \\\"1\u{e9}\", // rest_density: \u{2014}\n  \
                        fluids: [\n    (rest_density: 1000.0),\n    (\n      rest_density: -5.0),\n    (\n    \
                        ),\n  ],\n  \
                        container: (low: (0, 0)),\n)\n";

    #[test]
    fn files_of_the_first_version_are_read() {
        let old = "\u{feff}(\n fluid: (a: 1), // water \u{e9}\n other_fluids: [\n  (a: 2),\n ],\n)";
        assert_eq!(current(old), "(\n fluids: [ (a: 1), // water \u{e9}\n \n  (a: 2),\n ],\n)");
        assert_eq!(current("(fluid: (a: 1), blocks: [])"), "(fluid: (a: 1), blocks: [])");
        let below = "/*\u{e9}*/(scene: (blocks: [(fluid: 0)], fluid: (a: 1), other_fluids: [(a: 2)]))";
        assert_eq!(current(below), "/*\u{e9}*/(scene: (blocks: [(fluid: 0)], fluids: [ (a: 1), (a: 2)]))");
        let quoted = "(about: r#\"fluid: \"\"#, fluid: (a: 1), other_fluids: [(a: 2)])";
        assert_eq!(current(quoted), "(about: r#\"fluid: \"\"#, fluids: [ (a: 1), (a: 2)])");
    }

    #[test]
    fn a_field_is_found_in_its_item_and_never_in_a_comment() {
        assert_eq!(line_of(TEXT, "fluids[0].rest_density"), Some(6));
        assert_eq!(line_of(TEXT, "fluids[1].rest_density"), Some(8));
        assert_eq!(line_of(TEXT, "fluids[2].rest_density"), Some(9), "the item, which leaves it out");
        assert_eq!(line_of(TEXT, "fluids[3].rest_density"), Some(5), "the list, which has no such item");
        assert_eq!(line_of(TEXT, "rest_density"), Some(6));
        assert_eq!(line_of(TEXT, "container.low"), Some(12));
        assert_eq!(line_of(TEXT, "density"), None);
        let nested = "(\n scene: (\n  fluids: [\n   (time_step: 1),\n  ],\n  time_step: 2,\n ),\n)";
        assert_eq!(line_of(nested, "time_step"), Some(6));
        assert_eq!(line_of(nested, "fluids[0].time_step"), Some(4));
        let single = "(\n scene: (\n  fluid: (\n   a: 1)))";
        assert_eq!(line_of(single, "fluid[0].a"), Some(4));
    }

    #[test]
    fn no_text_is_too_odd() {
        for text in [
            "",
            "(",
            ")",
            "(((",
            "fluids: [",
            "\"",
            "r#\"",
            "/*",
            "(fluid: ",
            "fluid:other_fluids:[",
            "\u{2014}(\u{e9}: [",
        ] {
            let _ = (current(text), line_of(text, "fluids[1].a"), line_of(text, "a"));
        }
    }
}
