//! Strict mode: naga's SPIR-V with `NoContraction` on every float operation, so that a driver may neither fuse nor
//! reorder. WGSL alone does not promise that, and naga never writes that decoration.
use crate::error::GpuError;

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

/// SPIR-V of a WGSL program that drivers must take by the letter.
///
/// # Errors
/// What naga says.
pub fn spirv(wgsl: &str) -> Result<Vec<u32>, GpuError> {
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
    Ok(decorate(&words))
}

/// First instruction of a SPIR-V module, after its header.
const HEADER: usize = 5;
const OP_DECORATE: u32 = 71;
const OP_MEMBER_DECORATE: u32 = 72;
const NO_CONTRACTION: u32 = 42;

/// Is it an arithmetic instruction that a driver could contract? FNegate, FAdd, FSub, FMul, FDiv, FRem, FMod, and the
/// products of vectors and matrices.
fn is_float_arithmetic(op: u32) -> bool {
    matches!(op, 127 | 129 | 131 | 133 | 136 | 140 | 141 | 142..=148)
}

/// Adds the decoration for each result of float arithmetic.
fn decorate(words: &[u32]) -> Vec<u32> {
    let mut results = Vec::new();
    let mut annotations = words.len();
    let mut i = HEADER;
    while let Some(&word) = words.get(i) {
        let (op, length) = (word & 0xffff, (word >> 16) as usize);
        if is_float_arithmetic(op) {
            results.push(words[i + 2]);
        }
        // decorations stand together, before the types (19 to 46)
        if op == OP_DECORATE || op == OP_MEMBER_DECORATE || (19..=46).contains(&op) {
            annotations = annotations.min(i);
        }
        i += length.max(1);
    }
    let (before, after) = words.split_at(annotations);
    let decorations = results.into_iter().flat_map(|id| [(3 << 16) | OP_DECORATE, id, NO_CONTRACTION]);
    before.iter().copied().chain(decorations).chain(after.iter().copied()).collect()
}
