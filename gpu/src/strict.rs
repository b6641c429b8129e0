//! Strict mode: naga's SPIR-V with `NoContraction` on every float operation, so that a driver may neither fuse nor
//! reorder operations, and with the float controls that the driver offers, so that it neither flushes denormals nor
//! uses another rounding mode. WGSL alone does not guarantee any of this, and naga never writes these decorations and
//! controls.
use crate::error::GpuError;
use crate::float_controls::FloatControls;

/// Parses and validates WGSL.
///
/// # Errors
/// naga's message, with the place in the text.
pub fn validate(wgsl: &str) -> Result<(naga::Module, naga::valid::ModuleInfo), GpuError> {
    let module = naga::front::wgsl::parse_str(wgsl).map_err(|e| GpuError::Shader(e.emit_to_string(wgsl)))?;
    let flags = naga::valid::ValidationFlags::all();
    let mut validator = naga::valid::Validator::new(flags, naga::valid::Capabilities::default());
    let info = validator.validate(&module).map_err(|e| GpuError::Shader(e.emit_to_string(wgsl)))?;
    Ok((module, info))
}

/// Returns the SPIR-V of a WGSL program whose float operations a driver must execute exactly as written, with these
/// float controls. Request only controls that the device offers, since it may reject others.
///
/// # Errors
/// naga's message.
pub fn spirv(wgsl: &str, controls: FloatControls) -> Result<Vec<u32>, GpuError> {
    let (module, info) = validate(wgsl)?;
    // pass-through skips wgpu's bounds checks, so naga has to add them
    let restrict = naga::proc::BoundsCheckPolicy::Restrict;
    let options = naga::back::spv::Options {
        lang_version: (1, 0),
        bounds_check_policies: naga::proc::BoundsCheckPolicies {
            index: restrict,
            buffer: restrict,
            ..Default::default()
        },
        ..Default::default()
    };
    let words =
        naga::back::spv::write_vec(&module, &info, &options, None).map_err(|e| GpuError::Shader(e.to_string()))?;
    Ok(by_the_letter(&words, controls))
}

/// Index of the first instruction of a SPIR-V module, after its header.
const HEADER: usize = 5;
const OP_EXTENSION: u32 = 10;
const OP_ENTRY_POINT: u32 = 15;
const OP_EXECUTION_MODE: u32 = 16;
const OP_CAPABILITY: u32 = 17;
const OP_DECORATE: u32 = 71;
const OP_MEMBER_DECORATE: u32 = 72;
const NO_CONTRACTION: u32 = 42;
/// Width of the floats that the controls apply to. Programs have floats of no other width, so this also suits a driver
/// whose controls for different widths depend on each other.
const BITS: u32 = 32;

/// Returns whether an instruction is float arithmetic that a driver could contract: FNegate, FAdd, FSub, FMul, FDiv,
/// FRem, FMod, and the products of vectors and matrices.
fn is_float_arithmetic(op: u32) -> bool {
    matches!(op, 127 | 129 | 131 | 133 | 136 | 140 | 141 | 142..=148)
}

/// Encodes an instruction: its length and opcode, then its operands.
fn instruction(op: u32, operands: &[u32]) -> Vec<u32> {
    let length = operands.len() as u32 + 1;
    [&[(length << 16) | op], operands].concat()
}

/// Returns the instruction that declares the extension for float controls. From version 1.4 on they are part of SPIR-V
/// itself, but this crate writes version 1.0.
fn extension() -> Vec<u32> {
    // a string ends with a zero byte, and zeros fill up its last word
    let letters = b"SPV_KHR_float_controls\0\0".chunks(4);
    let words: Vec<u32> = letters.map(|c| u32::from_le_bytes([c[0], c[1], c[2], c[3]])).collect();
    instruction(OP_EXTENSION, &words)
}

/// Adds the float controls to each entry point, and the decoration to each result of float arithmetic.
fn by_the_letter(words: &[u32], controls: FloatControls) -> Vec<u32> {
    let (mut entries, mut results) = (Vec::new(), Vec::new());
    // indices at which the sections of a module end (capabilities, extensions, execution modes), and at which
    // annotations begin
    let (mut capabilities, mut extensions, mut modes, mut annotations) = (HEADER, HEADER, HEADER, words.len());
    let mut i = HEADER;
    while let Some(&word) = words.get(i) {
        let (op, length) = (word & 0xffff, (word >> 16) as usize);
        let next = i + length.max(1);
        match op {
            OP_CAPABILITY => capabilities = next,
            OP_EXTENSION => extensions = next,
            OP_ENTRY_POINT => {
                entries.push(words[i + 2]);
                modes = next;
            }
            OP_EXECUTION_MODE => modes = next,
            // decorations form one section before the types (opcodes 19 to 46)
            OP_DECORATE | OP_MEMBER_DECORATE | 19..=46 => annotations = annotations.min(i),
            _ if is_float_arithmetic(op) => results.push(words[i + 2]),
            _ => {}
        }
        i = next;
    }
    let asked: Vec<_> = controls.offered().collect();
    let by_entry = entries.iter().flat_map(|&entry| asked.iter().map(move |control| [entry, control.mode, BITS]));
    // what is added, in the order of the sections
    let added: [(usize, Vec<u32>); 4] = [
        (capabilities, asked.iter().flat_map(|control| instruction(OP_CAPABILITY, &[control.capability])).collect()),
        (extensions.max(capabilities), if asked.is_empty() { Vec::new() } else { extension() }),
        (modes, by_entry.flat_map(|operands| instruction(OP_EXECUTION_MODE, &operands)).collect()),
        (annotations, results.iter().flat_map(|&id| instruction(OP_DECORATE, &[id, NO_CONTRACTION])).collect()),
    ];
    let mut out = Vec::with_capacity(words.len() + added.iter().map(|(_, new)| new.len()).sum::<usize>());
    let mut from = 0;
    for (place, new) in added {
        out.extend_from_slice(&words[from..place]);
        out.extend(new);
        from = place;
    }
    out.extend_from_slice(&words[from..]);
    out
}
