//! The complete WGSL program of a pass: intrinsics, struct layouts, the choices of the model, arrays, loop, entry
//! point, and the terms (core's formulas) that these call.
use crate::bindings::{CELL_BLOCK, declarations, reads_pairs, sums_over_pairs, workgroup};
use crate::functions::Functions;
use millpond_core::backend::layout::{
    DRAIN_ROWS, LEAST_STEP, MATERIALS, MOST_ATTEMPTS, MOST_TRACED, Materials, Model, ON_COURSE, PLANES, POSE_STRIDE,
    Parameters, QUANTITIES_OF_ID, ROUNDS, SOLID_ROWS, SOLID_STRIDE, StepUniform, TABLE_ENTRIES, TABLE_WORDS,
};
use millpond_core::scene::SolidModel;
use millpond_core::{Array, Pass};

/// Where division and square root come from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Intrinsics {
    /// The operations of the device.
    Native,
    /// The operations of the device, corrected with integer arithmetic, for a device whose results are slightly off.
    Exact,
}

impl Intrinsics {
    /// Returns the WGSL of the intrinsics: `div`, `root` and everything else that WGSL lacks.
    #[must_use]
    pub fn prelude(self) -> String {
        let words = match self {
            Intrinsics::Native => include_str!("shaders/intrinsics_native.wgsl"),
            Intrinsics::Exact => include_str!("shaders/intrinsics_exact.wgsl"),
        };
        // in WGSL declarations may stand in any order
        words.to_owned() + include_str!("shaders/prelude.wgsl")
    }
}

macro_rules! loop_texts {
    ($($(#[$doc:meta])* $pass:ident: $folder:ident / $file:ident, $threads:ident, $status:ident, if $runs:expr,
        [$($access:ident $array:ident $(@ $bound:ident)?),*];)*) => {
        /// Returns the loop of a pass as written in `shaders/`, or an empty function for a pass that runs on the CPU
        /// only.
        #[must_use]
        fn loop_text(pass: Pass) -> &'static str {
            match pass { $(Pass::$pass => loop_text_of!($threads $folder $file),)* }
        }
    };
}

macro_rules! loop_text_of {
    (host $folder:ident $file:ident) => {
        "fn pass_body(thread: u32) {}\n"
    };
    ($threads:ident $folder:ident $file:ident) => {
        include_str!(concat!("shaders/", stringify!($folder), "/", stringify!($file), ".wgsl"))
    };
}
millpond_core::with_passes!(loop_texts);

/// Returns the intrinsics and all terms without a pass, for tests of single terms.
#[must_use]
pub fn library(model: &Model, intrinsics: Intrinsics) -> String {
    head(model, intrinsics) + &Functions::of_terms().whole()
}

/// Returns the intrinsics, the constants of the scene and its choices.
fn head(model: &Model, intrinsics: Intrinsics) -> String {
    let mut out = intrinsics.prelude();
    out += &format!("const PLANES: u32 = {PLANES}u;\nalias Planes = array<f32x4, PLANES>;\n");
    out += &format!("alias DrainRows = array<f32x4, {DRAIN_ROWS}>;\nalias SolidRows = array<f32x4, {SOLID_ROWS}>;\n");
    out += &format!("const SOLID_STRIDE: u32 = {SOLID_STRIDE}u;\nconst POSE_STRIDE: u32 = {POSE_STRIDE}u;\n");
    out += &format!("const ON_COURSE: f32 = {ON_COURSE:?}f;\nconst LEAST_STEP: f32 = {LEAST_STEP:?}f;\n");
    out += &format!("const ROUNDS: u32 = {ROUNDS}u;\nconst MOST_TRACED: u32 = {MOST_TRACED}u;\n");
    out += &format!("const CLOSED_FORM: f32 = {:?}f;\n", SolidModel::ClosedForm as u32 as f32);
    out += &format!("const REPELS: f32 = {:?}f;\n", SolidModel::Repulsion as u32 as f32);
    out += &format!("alias MaterialRows = array<f32x4, {MATERIALS}>;\n");
    out +=
        &format!("const QUANTITIES_OF_ID: u32 = {QUANTITIES_OF_ID}u;\nconst MOST_ATTEMPTS: u32 = {MOST_ATTEMPTS}u;\n");
    out += &format!("const MATERIALS: u32 = {MATERIALS}u;\nconst TABLE_ENTRIES: u32 = {TABLE_ENTRIES}u;\n");
    out += &[Parameters::WGSL, StepUniform::WGSL, Materials::WGSL].concat();
    let tables = format!("array<f32x4, {}>", TABLE_WORDS / 4);
    let uniforms = [("p", "Parameters"), ("u", "StepUniform"), ("materials", "Materials"), ("tables", &tables)];
    for (binding, (name, kind)) in uniforms.into_iter().enumerate() {
        out += &format!("@group(0) @binding({binding}) var<uniform> {name}: {kind};\n");
    }
    out += include_str!("shaders/constants.wgsl");
    // the choices are constants, so that the compiler removes the branches that are not chosen
    out += Model::WGSL;
    let choices: Vec<String> = bytemuck::cast_slice::<_, u32>(&[*model]).iter().map(|c| format!("{c}u")).collect();
    out += &format!("const m = Model({});\n", choices.join(", "));
    out
}

/// Returns the program of a pass. Its entry point is named `main`.
#[must_use]
pub fn program(pass: Pass, model: &Model, intrinsics: Intrinsics) -> String {
    let mut out = head(model, intrinsics);
    out += include_str!("shaders/grid.wgsl");
    if sums_over_pairs(pass) {
        out += include_str!("shaders/particle.wgsl");
    }
    if reads_pairs(pass) {
        out += include_str!("shaders/local.wgsl");
    }
    let calls = |function: &str| loop_text(pass).contains(function);
    let has_solids = model.has_solids == 1;
    if pass.bindings().iter().any(|binding| binding.array == Array::pose) {
        let is_for_solids = has_solids || matches!(pass, Pass::MoveSolids | Pass::Carry | Pass::Contact);
        let [solids, none] = [include_str!("shaders/solids.wgsl"), include_str!("shaders/no_solids.wgsl")];
        out += if is_for_solids { solids } else { none };
    }
    if calls("of_pressure(") || calls("of_density(") {
        out += include_str!("shaders/beyond.wgsl");
        out += if has_solids {
            include_str!("shaders/closed_solids.wgsl")
        } else {
            include_str!("shaders/no_closed_solids.wgsl")
        };
    }
    if loop_text(pass).contains("is_free(") {
        out += include_str!("shaders/places.wgsl");
    }
    if pass.bindings().iter().any(|binding| binding.array == Array::acceleration_field) {
        out += include_str!("shaders/field.wgsl");
    }
    out += &format!("const WORKGROUP: u32 = {}u;\nconst CELL_BLOCK: u32 = {CELL_BLOCK}u;\n", workgroup(pass));
    out += &declarations(pass, model);
    out += loop_text(pass);
    // one row of groups holds fewer threads than a large scene has particles, so there may be several rows
    out += "@compute @workgroup_size(WORKGROUP) fn main(\n  \
            @builtin(global_invocation_id) thread: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {\n  \
            pass_body(thread.x + thread.y * groups.x * WORKGROUP);\n}\n";
    let terms = Functions::of_terms().called_in(&out);
    out + &terms
}
