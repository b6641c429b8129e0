//! Tests whether a device computes the intrinsics of the terms as core does. The test runs on every device that is
//! opened in strict mode: a step can have core's bits only if every intrinsic has them.
use crate::buffers::{Maker, read};
use crate::device::Gpu;
use crate::error::GpuError;
use crate::pipelines::dispatch_once;
use millpond_core::backend::arithmetic::real::{abs, div, floor, flush, larger, less, root, select, smaller};
use millpond_core::backend::layout::{WORKGROUP, f32x4};

/// An intrinsic, or an expression that drivers tend to rewrite.
struct Word {
    name: &'static str,
    /// WGSL expression in `v.x`, `v.y`, `v.z` and `v.w`. Results are compared as bits.
    wgsl: &'static str,
    rust: fn(f32x4) -> f32,
}

/// All intrinsics and expressions to be tested. `v.w` is positive.
const WORDS: &[Word] = &[
    Word { name: "div", wgsl: "div(v.x, v.w)", rust: |v| div(v[0], v[3]) },
    Word { name: "root", wgsl: "root(v.w)", rust: |v| root(v[3]) },
    Word { name: "abs", wgsl: "abs(v.x)", rust: |v| abs(v[0]) },
    Word { name: "larger", wgsl: "larger(v.x, v.y)", rust: |v| larger(v[0], v[1]) },
    Word { name: "smaller", wgsl: "smaller(v.x, v.y)", rust: |v| smaller(v[0], v[1]) },
    Word { name: "select", wgsl: "select(v.x, v.y, less(v.z, v.x))", rust: |v| select(v[0], v[1], less(v[2], v[0])) },
    Word { name: "flush", wgsl: "flush(v.x * 1.0e-38f)", rust: |v| flush(v[0] * 1.0e-38) },
    // beyond the usual range: large and small operands, and operands that reveal a device that flushes denormals
    Word { name: "div, wide", wgsl: "div(v.x * 1.0e18f, v.w * 1.0e-10f)", rust: |v| div(v[0] * 1e18, v[3] * 1e-10) },
    Word { name: "root, wide", wgsl: "root(v.w * 1.0e-30f)", rust: |v| root(v[3] * 1e-30) },
    Word { name: "denormal product", wgsl: "v.x * 1.0e-38f * v.y", rust: |v| v[0] * 1e-38 * v[1] },
    Word {
        name: "denormal sum",
        wgsl: "(v.x - v.y) * 1.0e-38f + v.z * 1.0e-38f",
        rust: |v| (v[0] - v[1]) * 1e-38 + v[2] * 1e-38,
    },
    Word { name: "floor", wgsl: "floor(v.x * 1000.0f)", rust: |v| floor(v[0] * 1000.0) },
    Word { name: "product into sum", wgsl: "v.x * v.y + v.z", rust: |v| v[0] * v[1] + v[2] },
    // the optimisers of two drivers rewrite this as (x + y) * z unless they are told not to
    Word { name: "common factor", wgsl: "v.x * v.z + v.y * v.z", rust: |v| v[0] * v[2] + v[1] * v[2] },
    Word { name: "constant chain", wgsl: "(v.x * 0.1f) * 0.3f", rust: |v| (v[0] * 0.1) * 0.3 },
];

/// Number of inputs tried, enough to detect a rewrite that changes one result in a thousand.
const INPUTS: usize = 1 << 14;

/// Result of the test of one intrinsic.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct WordReport {
    /// Name of the intrinsic.
    pub word: &'static str,
    /// Number of inputs tried.
    pub tried: usize,
    /// Number of inputs whose results have other bits than core's.
    pub differing: usize,
}

/// Tests every intrinsic on a device, with the definitions in `prelude`
/// ([`Intrinsics::prelude`](crate::program::Intrinsics::prelude)).
///
/// # Errors
/// The device failed, or rejected the program.
pub fn test_intrinsics(gpu: &Gpu, prelude: &str) -> Result<Vec<WordReport>, GpuError> {
    let inputs = inputs();
    let results = WORDS.len() * INPUTS;
    let storage = Maker::storage(gpu);
    let from = storage.filled("words in", &inputs)?;
    let to = storage.allocate("words out", results * size_of::<u32>())?;
    let groups = INPUTS.div_ceil(WORKGROUP as usize) as u32;
    dispatch_once(gpu, "millpond.words", &program(prelude), [&from, &to], groups)?;
    let got: Vec<u32> = read(gpu, &to, results)?;
    let report = |(i, word): (usize, &Word)| {
        let differs = |(input, result): (&f32x4, &[u32])| (word.rust)(*input).to_bits() != result[i];
        let differing = inputs.iter().zip(got.chunks(WORDS.len())).filter(|pair| differs(*pair)).count();
        WordReport { word: word.name, tried: INPUTS, differing }
    };
    Ok(WORDS.iter().enumerate().map(report).collect())
}

/// Returns vectors whose first three components lie between -2 and 2, and whose fourth lies between 0 and 4.
fn inputs() -> Vec<f32x4> {
    let mut seed = 1u32;
    let mut random = || {
        seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        // 24 random bits, never 0
        ((seed >> 8) as f32 + 0.5) / (1u32 << 22) as f32
    };
    (0..INPUTS).map(|_| [random() - 2.0, random() - 2.0, random() - 2.0, random()]).collect()
}

fn program(prelude: &str) -> String {
    let mut out = prelude.to_owned();
    out += "@group(0) @binding(0) var<storage, read> words_in: array<f32x4>;\n";
    out += "@group(0) @binding(1) var<storage, read_write> words_out: array<u32>;\n";
    out += &format!("@compute @workgroup_size({WORKGROUP}) fn main(@builtin(global_invocation_id) g: vec3<u32>) {{\n");
    out += "  let v = words_in[g.x];\n";
    for (i, word) in WORDS.iter().enumerate() {
        out += &format!("  words_out[g.x * {}u + {i}u] = bitcast<u32>({});\n", WORDS.len(), word.wgsl);
    }
    out + "}\n"
}
