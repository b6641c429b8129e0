//! Promise: the text of the terms is the whole physics on both sides. Every pass compiles as WGSL without a device, uses
//! no builtin whose bits are a driver's affair, and folders and lists of passes agree.
use millpond_core::layout::Model;
use millpond_core::terms::TEXTS;
use millpond_core::{Pass, Plan};
use millpond_gpu::program::{Words, library, loop_text, program};
use millpond_gpu::strict::validate;
use millpond_gpu::text::wgsl_of;
use naga::{BinaryOperator, Expression, Function, Handle, Literal, MathFunction, Module, ScalarKind};
use std::collections::BTreeSet;
use std::path::Path;

mod support;

fn model() -> Model {
    Plan::everything(&support::scene("dam-break", &[]).file.scene).model
}

/// All functions of a module with their names.
fn functions(module: &Module) -> impl Iterator<Item = (String, &Function)> {
    let entries = module.entry_points.iter().map(|e| (e.name.clone(), &e.function));
    module.functions.iter().map(|(_, f)| (f.name.clone().unwrap_or_default(), f)).chain(entries)
}

#[test]
fn every_pass_compiles_as_wgsl() {
    for pass in Pass::ALL {
        for words in [Words::Native, Words::Exact] {
            if let Err(error) = validate(&program(pass, &model(), words)) {
                panic!("{}, {words:?}: {error}", pass.name());
            }
        }
    }
}

/// Is it a literal 0, which drivers fold even in strict mode?
fn is_float_zero(function: &Function, operand: Handle<Expression>) -> bool {
    matches!(function.expressions[operand], Expression::Literal(Literal::F32(x)) if x == 0.0)
}

/// Is it an integer, as far as the lint must know: a literal, a constant, or computed from one?
fn is_integer(module: &Module, function: &Function, operand: Handle<Expression>) -> bool {
    match &function.expressions[operand] {
        Expression::Literal(Literal::U32(_) | Literal::I32(_)) => true,
        Expression::Binary { left, right, .. } => {
            is_integer(module, function, *left) || is_integer(module, function, *right)
        }
        Expression::FunctionArgument(i) => {
            let kind = module.types[function.arguments[*i as usize].ty].inner.scalar_kind();
            matches!(kind, Some(ScalarKind::Uint | ScalarKind::Sint))
        }
        _ => false,
    }
}

/// What a lint over naga's reading of a program finds: builtins and operators that may differ between drivers.
fn loose(module: &Module) -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    for (name, function) in functions(module) {
        for (_, expression) in function.expressions.iter() {
            match expression {
                Expression::Math { fun: MathFunction::Abs | MathFunction::Floor | MathFunction::Min, .. } => {}
                Expression::Math { fun: MathFunction::Sqrt, .. } if name == "root" => {}
                Expression::Math { fun, .. } => {
                    found.insert(format!("{name}: {fun:?}"));
                }
                Expression::Binary { op: BinaryOperator::Divide, .. } if name == "div" => {}
                // integers: the cells of the stencil, the runs of the scan
                Expression::Binary { op: BinaryOperator::Divide, left, .. } if is_integer(module, function, *left) => {}
                Expression::Binary { op: BinaryOperator::Divide, .. } => {
                    found.insert(format!("{name}: /"));
                }
                Expression::Binary {
                    op: BinaryOperator::Add | BinaryOperator::Subtract | BinaryOperator::Multiply,
                    left,
                    right,
                } if [left, right].into_iter().any(|operand| is_float_zero(function, *operand)) => {
                    found.insert(format!("{name}: an operand is a literal 0"));
                }
                _ => {}
            }
        }
    }
    found
}

#[test]
fn no_program_uses_a_loose_builtin() {
    for pass in Pass::ALL {
        let (module, _) = validate(&program(pass, &model(), Words::Native)).expect("it compiles");
        assert_eq!(loose(&module), BTreeSet::new(), "{}", pass.name());
        // Min is for integers: loops spell the float one as a word
        assert!(!loop_text(pass).contains("max("), "{}", pass.name());
    }
    // and the lint can fail
    let (bad, _) = validate("fn f(x: f32) -> f32 { return pow(x, 2.0) / x + 0.0; }").expect("it compiles");
    let found = ["f: /", "f: Pow", "f: an operand is a literal 0"].map(str::to_owned);
    assert_eq!(loose(&bad), BTreeSet::from(found));
}

#[test]
fn every_function_of_the_terms_is_in_the_wgsl_and_defined_once() {
    let (module, _) = validate(&library(&model(), Words::Native)).expect("it compiles");
    let defined: Vec<String> = functions(&module).map(|(name, _)| name).collect();
    let mut wanted = 0;
    for (file, text) in TEXTS {
        for line in text.lines().filter(|line| line.starts_with("pub fn ")) {
            let name = line["pub fn ".len()..].split(['<', '(']).next().unwrap_or_default();
            assert_eq!(defined.iter().filter(|d| *d == name).count(), 1, "{file}: {name}");
            wanted += 1;
        }
        assert!(!wgsl_of(text).is_empty(), "{file}");
    }
    assert!(wanted > 30, "{wanted} functions: the texts were read");
}

/// Names of the files of a folder, without extension, that begin with p and a number.
fn passes_in(folder: &str, extension: &str) -> Vec<String> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join(folder);
    let entries = std::fs::read_dir(&folder).unwrap_or_else(|e| panic!("{}: {e}", folder.display()));
    let names = entries.map(|e| e.expect("an entry").file_name().into_string().expect("a name"));
    let stem = |name: String| name.strip_suffix(extension).map(str::to_owned);
    let mut names: Vec<String> =
        names.filter_map(stem).filter(|n| n.len() > 3 && n.starts_with('p') && n[1..3].parse::<u8>().is_ok()).collect();
    names.sort();
    names
}

#[test]
fn both_folders_hold_exactly_the_passes() {
    let passes: Vec<String> = Pass::ALL.iter().map(|pass| pass.name().to_owned()).collect();
    assert_eq!(passes_in("core/src/passes", ".rs"), passes);
    assert_eq!(passes_in("gpu/src/shaders", ".wgsl"), passes);
}

#[test]
fn every_term_file_is_a_text() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("core/src/terms");
    let files = std::fs::read_dir(folder).expect("a folder").map(|e| e.expect("an entry").path());
    let mut files: Vec<String> = files.map(|f| f.file_stem().expect("a name").to_string_lossy().into_owned()).collect();
    files.retain(|name| name != "mod");
    files.sort();
    let mut texts: Vec<String> = TEXTS.iter().map(|(name, _)| (*name).to_owned()).collect();
    texts.sort();
    assert_eq!(files, texts);
}
