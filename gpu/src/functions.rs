//! The terms (core's formulas) as WGSL functions. A program contains only those that it calls, so drivers do not have
//! to compile the others.
use crate::text::wgsl_of;
use millpond_core::backend::terms::texts;
use std::collections::BTreeMap;
use std::sync::OnceLock;

/// A function of the terms.
#[derive(Debug)]
struct Function {
    text: String,
    /// Indices of the functions that its text names.
    calls: Vec<usize>,
}

/// All functions of the terms, by name, and the constants beside them.
#[derive(Debug)]
pub(crate) struct Functions {
    constants: String,
    all: Vec<Function>,
    by_name: BTreeMap<String, usize>,
}

impl Functions {
    /// Returns the functions of the terms, which are parsed once.
    pub(crate) fn of_terms() -> &'static Functions {
        static TERMS: OnceLock<Functions> = OnceLock::new();
        TERMS.get_or_init(|| Functions::read(texts().map(|(_, text)| wgsl_of(text))))
    }

    /// Parses the functions of these texts. A function ends at the first line that consists of a closing brace.
    fn read(texts: impl Iterator<Item = String>) -> Functions {
        let mut functions = Functions { constants: String::new(), all: Vec::new(), by_name: BTreeMap::new() };
        for text in texts {
            let mut is_inside = false;
            for line in text.lines() {
                if let Some(rest) = line.strip_prefix("fn ") {
                    let name = rest.split('(').next().unwrap_or_default();
                    functions.by_name.insert(name.into(), functions.all.len());
                    functions.all.push(Function { text: String::new(), calls: Vec::new() });
                    is_inside = true;
                }
                let last = functions.all.last_mut().filter(|_| is_inside).map(|function| &mut function.text);
                let to = last.unwrap_or(&mut functions.constants);
                to.push_str(line);
                to.push('\n');
                is_inside &= line != "}";
            }
        }
        let calls: Vec<Vec<usize>> = functions.all.iter().map(|function| functions.named_in(&function.text)).collect();
        for (function, calls) in functions.all.iter_mut().zip(calls) {
            function.calls = calls;
        }
        functions
    }

    /// Returns the indices of the functions that a text names.
    fn named_in(&self, text: &str) -> Vec<usize> {
        let words = text.split(|c: char| !c.is_alphanumeric() && c != '_');
        words.filter_map(|word| self.by_name.get(word).copied()).collect()
    }

    /// Returns the constants and all functions that a text calls, directly or through other functions.
    pub(crate) fn called_in(&self, text: &str) -> String {
        let mut is_called = vec![false; self.all.len()];
        let mut rest = self.named_in(text);
        while let Some(function) = rest.pop() {
            if !std::mem::replace(&mut is_called[function], true) {
                rest.extend(&self.all[function].calls);
            }
        }
        let called = self.all.iter().zip(is_called).filter(|(_, is_called)| *is_called);
        called.fold(self.constants.clone(), |text, (function, _)| text + &function.text)
    }

    /// Returns the constants and all functions.
    pub(crate) fn whole(&self) -> String {
        self.all.iter().fold(self.constants.clone(), |text, function| text + &function.text)
    }
}
