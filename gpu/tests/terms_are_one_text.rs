//! Promise: the text of the terms (core's formulas) is the whole physics on the CPU and on a device. Every pass
//! compiles as WGSL without a device and uses no builtin whose bits may differ between drivers, and the shader folders
//! hold exactly the passes.
use millpond_core::backend::layout::Model;
use millpond_core::backend::plan::passes::Threads;
use millpond_core::backend::terms::texts;
use millpond_core::{Pass, Plan};
use millpond_gpu::program::{Intrinsics, library, program};
use millpond_gpu::strict::validate;
use naga::valid::{FunctionInfo, ModuleInfo};
use naga::{BinaryOperator, Expression, Function, Handle, Literal, MathFunction, Module, ScalarKind};
use std::collections::BTreeSet;
use std::path::Path;

mod support;
use support::files::passes_in;

fn model() -> Model {
    Plan::everything(&support::checked(&support::dam_break(1.0))).model
}

/// Returns all functions of a program: name, body, and naga's information about types.
fn functions((module, info): &Program) -> impl Iterator<Item = (String, &Function, &FunctionInfo)> {
    let entries = module.entry_points.iter().enumerate();
    let entries = entries.map(|(i, e)| (e.name.clone(), &e.function, info.get_entry_point(i)));
    module.functions.iter().map(|(i, f)| (f.name.clone().unwrap_or_default(), f, &info[i])).chain(entries)
}

/// A program as parsed by naga.
type Program = (Module, ModuleInfo);

#[test]
fn every_pass_and_every_term_compiles_as_wgsl() {
    for intrinsics in [Intrinsics::Native, Intrinsics::Exact] {
        // the program of a pass contains only the terms that it calls, so all terms are validated here
        if let Err(error) = validate(&library(&model(), intrinsics)) {
            panic!("all terms, {intrinsics:?}: {error}");
        }
    }
    for pass in Pass::ALL {
        for intrinsics in [Intrinsics::Native, Intrinsics::Exact] {
            if let Err(error) = validate(&program(pass, &model(), intrinsics)) {
                panic!("{}, {intrinsics:?}: {error}", pass.name());
            }
        }
    }
}

/// Returns whether an operand is the literal 0, which drivers fold even in strict mode.
fn is_float_zero(function: &Function, operand: Handle<Expression>) -> bool {
    matches!(function.expressions[operand], Expression::Literal(Literal::F32(x)) if x == 0.0)
}

/// Returns the builtins and operators in a program whose results may differ between drivers.
fn loose(program: &Program) -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    for (name, function, info) in functions(program) {
        let kind = |e: Handle<Expression>| info[e].ty.inner_with(&program.0.types).scalar_kind();
        let is_float = |e: Handle<Expression>| kind(e) == Some(ScalarKind::Float);
        for (_, expression) in function.expressions.iter() {
            let fault = match expression {
                Expression::Math { arg, .. } if !is_float(*arg) => continue,
                Expression::Math { fun: MathFunction::Abs | MathFunction::Floor, .. } => continue,
                Expression::Math { fun: MathFunction::Sqrt, .. } if name == "root" => continue,
                Expression::Math { fun, .. } => format!("{fun:?}"),
                Expression::Binary { left, .. } if !is_float(*left) => continue,
                Expression::Binary { op: BinaryOperator::Divide, .. } if name == "div" => continue,
                Expression::Binary { op: op @ (BinaryOperator::Divide | BinaryOperator::Modulo), .. } => {
                    format!("{op:?}")
                }
                Expression::Binary {
                    op: BinaryOperator::Add | BinaryOperator::Subtract | BinaryOperator::Multiply,
                    left,
                    right,
                } if [left, right].into_iter().any(|operand| is_float_zero(function, *operand)) => "literal 0".into(),
                _ => continue,
            };
            found.insert(format!("{name}: {fault}"));
        }
    }
    found
}

#[test]
fn no_program_uses_a_loose_builtin() {
    for intrinsics in [Intrinsics::Native, Intrinsics::Exact] {
        let read = validate(&library(&model(), intrinsics)).expect("it compiles");
        assert_eq!(loose(&read), BTreeSet::new(), "all terms, {intrinsics:?}");
    }
    for pass in Pass::ALL {
        for intrinsics in [Intrinsics::Native, Intrinsics::Exact] {
            let read = validate(&program(pass, &model(), intrinsics)).expect("it compiles");
            assert_eq!(loose(&read), BTreeSet::new(), "{}, {intrinsics:?}", pass.name());
        }
    }
    // the lint finds every fault of a bad program
    let bad = "fn f(x: f32, i: i32) -> f32 { return pow(x, 2.0) / x + 0.0 + max(x, f32(min(i, 2) / i)); }";
    let found = ["f: Divide", "f: Max", "f: Pow", "f: literal 0"].map(str::to_owned);
    assert_eq!(loose(&validate(bad).expect("it compiles")), BTreeSet::from(found));
}

#[test]
fn every_function_of_the_terms_is_in_the_wgsl_and_defined_once() {
    let read = validate(&library(&model(), Intrinsics::Native)).expect("it compiles");
    let defined: Vec<String> = functions(&read).map(|(name, ..)| name).collect();
    let mut wanted = 0;
    for (file, text) in texts() {
        for line in text.lines().filter(|line| line.starts_with("pub fn ")) {
            let name = line["pub fn ".len()..].split(['<', '(']).next().unwrap_or_default();
            assert_eq!(defined.iter().filter(|d| *d == name).count(), 1, "{file}: {name}");
            wanted += 1;
        }
    }
    assert!(wanted > 30, "{wanted} functions: the texts were read");
}

#[test]
fn the_shaders_folders_hold_exactly_the_passes_of_a_device() {
    let of_a_device = Pass::ALL.into_iter().filter(|pass| pass.threads() != Threads::Host);
    let names = of_a_device.map(|pass| format!("{}/{}", pass.folder(), pass.name())).collect();
    assert_eq!(passes_in(&Path::new(env!("CARGO_MANIFEST_DIR")).join("src/shaders"), ".wgsl"), names);
}
