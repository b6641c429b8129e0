//! Promise: the SPIR-V that a driver gets in strict mode contains everything that strict mode requests: `NoContraction`
//! on every result of float arithmetic, and exactly those float controls that the device offers. The test needs no
//! device; `intrinsics_parity.rs` checks how drivers compute.
use millpond_gpu::FloatControls;
use millpond_gpu::strict::spirv;

/// An instruction: its opcode and its operands.
type Instruction = (u32, Vec<u32>);

/// Parses a module, whose instructions must fill it to the last word.
fn instructions(words: &[u32]) -> Vec<Instruction> {
    assert_eq!(words[0], 0x0723_0203, "SPIR-V");
    let mut out = Vec::new();
    let mut rest = &words[5..];
    while let [first, ..] = rest {
        let length = (first >> 16) as usize;
        assert!(length > 0 && length <= rest.len(), "{length} words, and {} are left", rest.len());
        out.push((first & 0xffff, rest[1..length].to_vec()));
        rest = &rest[length..];
    }
    out
}

/// Returns the section of a module to which an instruction belongs. Everything from the first function on is the last
/// section.
fn section(op: u32) -> u32 {
    match op {
        17 => 0,                     // capabilities
        10 => 1,                     // extensions
        11 => 2,                     // imports
        14 => 3,                     // memory model
        15 => 4,                     // entry points
        16 => 5,                     // execution modes
        3..=8 => 6,                  // names
        71 | 72 => 7,                // decorations
        19..=46 | 48 | 50 | 59 => 8, // types, constants, variables
        54 => 9,                     // functions
        _ => panic!("instruction {op} stands in no section"),
    }
}

fn operands(module: &[Instruction], op: u32) -> Vec<&[u32]> {
    module.iter().filter(|(o, _)| *o == op).map(|(_, operands)| &operands[..]).collect()
}

/// Decodes the string of an instruction.
fn text(words: &[u32]) -> String {
    let letters = words.iter().flat_map(|word| word.to_le_bytes()).take_while(|&letter| letter != 0);
    String::from_utf8(letters.collect()).expect("letters")
}

/// A program with every operator that a driver may rewrite.
const PROGRAM: &str = "
    @group(0) @binding(0) var<storage, read_write> a: array<vec4<f32>>;
    fn chain(x: f32) -> f32 { return (x * 0.1f) * 0.3f - x / 3.0f; }
    @compute @workgroup_size(64) fn main(@builtin(global_invocation_id) thread: vec3<u32>) {
        let v = a[thread.x];
        for (var i = 0u; i < thread.y; i++) { a[i] = -(v * v.x + v); }
        a[thread.x].w = chain(sqrt(v.x)) + dot(v, v);
    }";

/// Returns every combination of float controls.
fn choices() -> impl Iterator<Item = FloatControls> {
    (0..8).map(|bits| FloatControls {
        denorm_preserve: bits & 1 != 0,
        rounding_rte: bits & 2 != 0,
        signed_zero_inf_nan_preserve: bits & 4 != 0,
    })
}

#[test]
fn controls_stand_where_they_are_asked_for_and_nowhere_else() {
    for controls in choices() {
        let module = instructions(&spirv(PROGRAM, controls).expect("it compiles"));
        // SPIR-V's numbers of the capability and of the execution mode
        let all = [
            (controls.denorm_preserve, 4464, 4459),
            (controls.rounding_rte, 4467, 4462),
            (controls.signed_zero_inf_nan_preserve, 4466, 4461),
        ];
        let entries = operands(&module, 15);
        let [entry] = entries[..] else { panic!("{} entry points", entries.len()) };
        let modes = operands(&module, 16);
        for (asked, capability, mode) in all {
            let count = usize::from(asked);
            let capabilities = operands(&module, 17).into_iter().filter(|c| **c == [capability]);
            assert_eq!(capabilities.count(), count, "{controls:?}, capability {capability}");
            assert_eq!(modes.iter().filter(|m| m[1] == mode).count(), count, "{controls:?}, mode {mode}");
            assert_eq!(
                modes.iter().filter(|m| ***m == [entry[1], mode, 32]).count(),
                count,
                "{controls:?}, mode {mode}"
            );
        }
        let any = controls != FloatControls::default();
        let extensions = operands(&module, 10).into_iter().filter(|name| text(name) == "SPV_KHR_float_controls");
        assert_eq!(extensions.count(), usize::from(any), "{controls:?}");
    }
}

#[test]
fn sections_are_in_their_order() {
    for controls in choices() {
        let module = instructions(&spirv(PROGRAM, controls).expect("it compiles"));
        let head: Vec<u32> = module.iter().map(|(op, _)| *op).take_while(|op| *op != 54).map(section).collect();
        assert!(head.is_sorted(), "{controls:?}: {head:?}");
    }
}

#[test]
fn a_program_is_the_same_but_for_the_controls() {
    let bare = instructions(&spirv(PROGRAM, FloatControls::default()).expect("it compiles"));
    for controls in choices() {
        let mut module = instructions(&spirv(PROGRAM, controls).expect("it compiles"));
        module.retain(|instruction| match instruction {
            (17, c) => !(4459..=4468).contains(&c[0]),
            (16, m) => !(4459..=4468).contains(&m[1]),
            (10, name) => text(name) != "SPV_KHR_float_controls",
            _ => true,
        });
        assert_eq!(module, bare, "{controls:?}");
    }
}

#[test]
fn every_float_operation_is_decorated() {
    let module = instructions(&spirv(PROGRAM, FloatControls::default()).expect("it compiles"));
    let mut results: Vec<u32> = Vec::new();
    for (op, operands) in &module {
        // FNegate, FAdd, FSub, FMul, FDiv, VectorTimesScalar, Dot
        if [127, 129, 131, 133, 136, 142, 148].contains(op) {
            results.push(operands[1]);
        }
    }
    assert!(results.len() >= 8, "{} operations", results.len());
    let mut decorated: Vec<u32> = operands(&module, 71).into_iter().filter(|d| d[1] == 42).map(|d| d[0]).collect();
    decorated.sort_unstable();
    results.sort_unstable();
    assert_eq!(decorated, results);
}
