//! The buffers that each pass binds, as WGSL declarations and as types. Both follow from core's table of passes.
use millpond_core::backend::layout::{Model, Status, WORKGROUP};
use millpond_core::backend::plan::arrays::{Class, Side};
use millpond_core::backend::plan::passes::{Access, Binding, Bound, Threads};
use millpond_core::{Array, Pass};

/// Number of uniform buffers, which are bound before the arrays: the parameters, the constants of the step, the
/// materials and the kernel tables.
pub const UNIFORMS: u32 = 4;

/// Number of cells in a block; one work group sums the counters of one block. The counters of the blocks follow those
/// of the cells.
pub const CELL_BLOCK: u32 = 4096;

/// Threads of a work group in which each thread processes its share of a block of cells, or of all particles.
const WIDE: u32 = 256;

const _: () = assert!(CELL_BLOCK.is_multiple_of(WIDE));

/// Returns the number of blocks that `cells` cells form.
#[must_use]
pub fn cell_blocks(cells: u32) -> u32 {
    cells.div_ceil(CELL_BLOCK)
}

/// A buffer that a program binds after the uniforms.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Declared {
    /// Name in WGSL.
    pub name: String,
    /// Type in WGSL.
    pub kind: String,
    /// How the pass accesses it; `None` for a uniform.
    pub access: Option<Access>,
}

impl Declared {
    fn storage(name: impl Into<String>, kind: &str, access: Access) -> Declared {
        Declared { name: name.into(), kind: kind.into(), access: Some(access) }
    }
}

/// Returns the WGSL name of a binding.
fn name(binding: Binding) -> String {
    let array = binding.array.name();
    match binding.bound {
        Bound::Copy(Side::Old) => format!("old_{array}"),
        Bound::Copy(Side::New) => format!("new_{array}"),
        Bound::Copy(Side::Only) => array.into(),
        Bound::Force => "force_out".into(),
    }
}

fn of(binding: Binding) -> Declared {
    Declared::storage(name(binding), &format!("array<{}>", binding.array.element()), binding.access)
}

/// Returns the bindings of a pass whose arrays exist in this model.
pub fn bound(pass: Pass, model: &Model) -> impl Iterator<Item = Binding> {
    let model = *model;
    pass.bindings().iter().copied().filter(move |binding| binding.array.exists(&model))
}

/// Returns what a pass binds after the [`UNIFORMS`], in the order of the bindings: the status with the cell counters,
/// the arrays that exist, and the buffers that only this pass's commands need.
#[must_use]
pub fn declared(pass: Pass, model: &Model) -> Vec<Declared> {
    let access = if pass.counts() { Access::Write } else { Access::Read };
    let mut all = vec![Declared::storage("head", "Head", access)];
    all.extend(bound(pass, model).map(of));
    match pass {
        Pass::Gather => {
            all.push(Declared::storage("gather_from", "array<f32x4>", Access::Read));
            all.push(Declared::storage("gather_to", "array<f32x4>", Access::Write));
        }
        Pass::Validate => {
            all.push(Declared::storage("checked", "array<f32x4>", Access::Read));
            all.push(Declared { name: "subject".into(), kind: "vec4<u32>".into(), access: None });
        }
        _ => {}
    }
    all
}

/// Returns the WGSL declarations of everything that a pass binds. An array that does not exist is declared as a
/// private array that is never accessed, so that the text of a loop may name it inside its conditions.
#[must_use]
pub fn declarations(pass: Pass, model: &Model) -> String {
    let atomic = if pass.counts() { "atomic<u32>" } else { "u32" };
    let mut out = Status::WGSL.replace(": u32", &format!(": {atomic}"));
    out += &format!("struct Head {{ status: Status, counter: array<{atomic}> }}\n");
    for (i, Declared { name, kind, access }) in declared(pass, model).iter().enumerate() {
        let space = match access {
            Some(Access::Read) => "storage, read",
            Some(Access::Write) => "storage, read_write",
            None => "uniform",
        };
        out += &format!("@group(0) @binding({}) var<{space}> {name}: {kind};\n", i as u32 + UNIFORMS);
    }
    for binding in pass.bindings().iter().filter(|binding| !binding.array.exists(model)) {
        out += &format!("var<private> {}: array<{}, 2>;\n", name(*binding), binding.array.element());
    }
    out
}

/// Returns whether a pass sums over pairs. Its text may then read the particles through `particle`.
#[must_use]
pub fn sums_over_pairs(pass: Pass) -> bool {
    let binds = |array| pass.bindings().iter().any(|binding| binding.array == array);
    binds(Array::cell_start) && binds(Array::support_ratio)
}

/// Returns whether a pass iterates over pairs whose densities are known. Its text then reads the particles through
/// `local`.
#[must_use]
pub fn reads_pairs(pass: Pass) -> bool {
    let reads = |array| pass.bindings().iter().any(|binding| binding.array == array && binding.access == Access::Read);
    reads(Array::cell_start) && reads(Array::density_pressure)
}

/// Returns whether an array has a buffer of its own on the device. Arrays that only passes on the CPU use have none,
/// and neither have arrays that are part of another buffer.
#[must_use]
pub fn is_on_device(array: Array) -> bool {
    let binds = |pass: Pass| pass.bindings().iter().any(|binding| binding.array == array);
    array.class() == Class::State || Pass::ALL.into_iter().any(binds)
}

/// Returns the number of threads in a work group of a pass.
#[must_use]
pub fn workgroup(pass: Pass) -> u32 {
    let is_wide = match pass.threads() {
        Threads::Cells => true,
        Threads::Group => !pass.bindings().is_empty(),
        Threads::Particles | Threads::Host => false,
    };
    if is_wide { WIDE } else { WORKGROUP }
}
