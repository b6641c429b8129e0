//! Strict mode: naga's SPIR-V with `NoContraction` on every float operation, so that a driver may neither fuse nor
//! reorder, and with the float controls that the driver offers, so that it neither flushes denormals nor rounds otherwise.
//! WGSL alone does not promise that, and naga never writes either.
use crate::error::GpuError;
use crate::float_controls::FloatControls;

/// Parses and validates WGSL.
///
/// # Errors
/// What naga says, with the place in the text.
pub fn validate(wgsl: &str) -> Result<(naga::Module, naga::valid::ModuleInfo), GpuError> {
    let module = naga::front::wgsl::parse_str(wgsl).map_err(|e| GpuError::Shader(e.emit_to_string(wgsl)))?;
    let flags = naga::valid::ValidationFlags::all();
    let mut validator = naga::valid::Validator::new(flags, naga::valid::Capabilities::default());
    let info = validator.validate(&module).map_err(|e| GpuError::Shader(e.emit_to_string(wgsl)))?;
    Ok((module, info))
}

/// SPIR-V of a WGSL program that drivers must take by the letter, under these float controls: those that the device
/// offers, since it may refuse others.
///
/// # Errors
/// What naga says.
pub fn spirv(wgsl: &str, controls: FloatControls) -> Result<Vec<u32>, GpuError> {
    let (module, info) = validate(wgsl)?;
    // pass-through skips wgpu's bounds checks, so ask naga for them
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

/// First instruction of a SPIR-V module, after its header.
const HEADER: usize = 5;
const OP_EXTENSION: u32 = 10;
const OP_ENTRY_POINT: u32 = 15;
const OP_EXECUTION_MODE: u32 = 16;
const OP_CAPABILITY: u32 = 17;
const OP_DECORATE: u32 = 71;
const OP_MEMBER_DECORATE: u32 = 72;
const NO_CONTRACTION: u32 = 42;
/// Width of the floats that are asked about. There are no others in a program, so a driver whose widths depend on each
/// other takes this too.
const BITS: u32 = 32;

/// Is it an arithmetic instruction that a driver could contract? FNegate, FAdd, FSub, FMul, FDiv, FRem, FMod, and the
/// products of vectors and matrices.
fn is_float_arithmetic(op: u32) -> bool {
    matches!(op, 127 | 129 | 131 | 133 | 136 | 140 | 141 | 142..=148)
}

/// An instruction: its length, its number, its operands.
fn instruction(op: u32, operands: &[u32]) -> Vec<u32> {
    let length = operands.len() as u32 + 1;
    [&[(length << 16) | op], operands].concat()
}

/// The extension that has the float controls; SPIR-V has them in core from 1.4 on, and this crate writes 1.0.
fn extension() -> Vec<u32> {
    // a string ends with a zero, and with zeros fills its last word
    let letters = b"SPV_KHR_float_controls\0\0".chunks(4);
    let words: Vec<u32> = letters.map(|c| u32::from_le_bytes([c[0], c[1], c[2], c[3]])).collect();
    instruction(OP_EXTENSION, &words)
}

/// Adds the float controls for each entry point, and the decoration for each result of float arithmetic.
fn by_the_letter(words: &[u32], controls: FloatControls) -> Vec<u32> {
    let (mut entries, mut results) = (Vec::new(), Vec::new());
    // where the sections of a module end: capabilities, extensions, execution modes; and where annotations begin
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
            // decorations stand together, before the types (19 to 46)
            OP_DECORATE | OP_MEMBER_DECORATE | 19..=46 => annotations = annotations.min(i),
            _ if is_float_arithmetic(op) => results.push(words[i + 2]),
            _ => {}
        }
        i = next;
    }
    let asked: Vec<_> = controls.offered().collect();
    let by_entry = entries.iter().flat_map(|&entry| asked.iter().map(move |control| [entry, control.mode, BITS]));
    // in the order of the sections
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
