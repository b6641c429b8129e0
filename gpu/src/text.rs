//! Translates the Rust text of the terms (core's formulas) to WGSL: removes what only Rust needs, and marks float
//! literals.

/// Returns the WGSL of a term's Rust text.
///
/// Removes comments, `use`, `mod` and attribute lines, `pub `, `<R: Real>`, the `<R>` of structs, and the arguments
/// `m`, `p`, `u` and `t`, which are global in WGSL.
#[must_use]
pub fn wgsl_of(rust: &str) -> String {
    let mut out = String::new();
    for line in rust.lines() {
        let code = line.split("//").next().unwrap_or("").trim_end();
        let start = code.trim_start();
        let only_rust = ["use ", "#[", "pub mod ", "texts!("];
        if start.is_empty() || only_rust.iter().any(|word| start.starts_with(word)) {
            continue;
        }
        if matches!(
            start,
            "m: &Model," | "p: &Parameters," | "u: &StepUniform," | "t: &Tables," | "m," | "p," | "u," | "t,"
        ) {
            continue;
        }
        let mut code = code.replacen("pub ", "", 1);
        for (rust, wgsl) in
            [("<R: Real>", ""), ("Local<R>", "Local"), ("Stiffness<R>", "Stiffness"), ("Beyond<R>", "Beyond")]
        {
            code = code.replace(rust, wgsl);
        }
        // a function without any other argument
        for alone in ["(m: &Model)", "(m)"] {
            code = code.replace(alone, "()");
        }
        // these arguments are declared and passed in this order, each only where it is needed
        let arguments = [
            ("m: &Model, ", "m, "),
            ("p: &Parameters, ", "p, "),
            ("u: &StepUniform, ", "u, "),
            ("t: &Tables, ", "t, "),
        ];
        for (declared, passed) in arguments {
            code = code.replace(declared, "").replace(&format!("({passed}"), "(");
        }
        out += &mark_literals(&code);
        out.push('\n');
    }
    out
}

/// Turns `0.1` into `0.1f`. Without the suffix WGSL folds `0.1 * 0.7 * 0.3` in f64, whereas Rust folds it in f32;
/// strict mode could not prevent that difference.
fn mark_literals(code: &str) -> String {
    let mut out = String::new();
    let mut rest = code;
    while let Some(first) = rest.chars().next() {
        let is_word = |c: char| c.is_ascii_alphanumeric() || c == '_';
        let mut end = first.len_utf8();
        if is_word(first) {
            // a name, or a number with its fraction and exponent
            let number = first.is_ascii_digit();
            end = rest.find(|c: char| !(is_word(c) || number && c == '.')).unwrap_or(rest.len());
            if number && rest[..end].ends_with('e') && rest[end..].starts_with(['-', '+']) {
                let tail = &rest[end + 1..];
                end += 1 + tail.find(|c: char| !c.is_ascii_digit()).unwrap_or(tail.len());
            }
        }
        let (token, after) = rest.split_at(end);
        out += token;
        if first.is_ascii_digit() && token.contains(['.', 'e']) {
            out.push('f');
        }
        rest = after;
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rust_becomes_wgsl() {
        let rust = "/// Doc.\n#[inline(always)]\n\
                    pub fn f<R: Real>(m: &Model, p: &Parameters, a: Local<R>) -> R { // why\n    \
                    return g(m, p, t, a) * 1.5e-3 + h(p, a.q2) * 2.0;\n}\n";
        let wgsl = "fn f(a: Local) -> R {\n    return g(a) * 1.5e-3f + h(a.q2) * 2.0f;\n}\n";
        assert_eq!(wgsl_of(rust), wgsl);
    }
}
