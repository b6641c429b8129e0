//! What a pass binds, as WGSL and as types: declarations that follow from core's table of passes.
use millpond_core::backend::layout::{Model, Status, WORKGROUP};
use millpond_core::backend::plan::arrays::{Class, Side};
use millpond_core::backend::plan::passes::{Access, Binding, Bound, Threads};
use millpond_core::{Array, Pass};

/// Uniforms before the arrays: the parameters, the numbers of the step, the materials, the kernel tables.
pub const UNIFORMS: u32 = 4;

/// Cells of a block: how many one work group sums up. The particles of each block are counted behind those of the cells.
pub const CELL_BLOCK: u32 = 4096;

/// Threads of a group each of which walks its share of a block of cells, or of all particles.
const WIDE: u32 = 256;

const _: () = assert!(CELL_BLOCK.is_multiple_of(WIDE));

/// Blocks of so many cells.
#[must_use]
pub fn cell_blocks(cells: u32) -> u32 {
    cells.div_ceil(CELL_BLOCK)
}

/// A buffer that a program binds behind the uniforms.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Declared {
    /// Its name in WGSL.
    pub name: String,
    /// Its type in WGSL.
    pub kind: String,
    /// What the pass does to it; none for a uniform.
    pub access: Option<Access>,
}

impl Declared {
    fn storage(name: impl Into<String>, kind: &str, access: Access) -> Declared {
        Declared { name: name.into(), kind: kind.into(), access: Some(access) }
    }
}

/// Name in WGSL of what a pass binds.
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

/// The arrays of a pass that exist by this model.
pub fn bound(pass: Pass, model: &Model) -> impl Iterator<Item = Binding> {
    let model = *model;
    pass.bindings().iter().copied().filter(move |binding| binding.array.exists(&model))
}

/// What a pass binds behind the [`UNIFORMS`], in the order of the bindings: the status with the cells' counters, its arrays that exist,
/// and what only this command is about.
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

/// WGSL declarations of all that a pass binds. Arrays that do not exist are declared as a private entry that nobody touches, so that the
/// text of a loop may name them behind its conditions.
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

/// Does a pass walk over pairs whose densities are known? Its text then reads them through `local`.
#[must_use]
pub fn reads_pairs(pass: Pass) -> bool {
    let reads = |array| pass.bindings().iter().any(|binding| binding.array == array && binding.access == Access::Read);
    reads(Array::cell_start) && reads(Array::density_pressure)
}

/// Is an array on the device at all? Not where only the host's passes use it, nor as part of another buffer.
#[must_use]
pub fn is_on_device(array: Array) -> bool {
    let binds = |pass: Pass| pass.bindings().iter().any(|binding| binding.array == array);
    array.class() == Class::State || Pass::ALL.into_iter().any(binds)
}

/// Threads of a work group of a pass.
#[must_use]
pub fn workgroup(pass: Pass) -> u32 {
    let is_wide = match pass.threads() {
        Threads::Cells => true,
        Threads::Group => !pass.bindings().is_empty(),
        Threads::Particles | Threads::Host => false,
    };
    if is_wide { WIDE } else { WORKGROUP }
}
