//! The complete WGSL of a pass: prelude, layout, choices, terms, arrays, loop, entry point.
use crate::bindings::{declarations, workgroup};
use crate::text::wgsl_of;
use millpond_core::Pass;
use millpond_core::layout::{Model, PLANES, Parameters, SPECIES, TABLE_ENTRIES, TABLE_WORDS};
use millpond_core::terms::texts;

/// Where division and root come from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Words {
    /// The device's own.
    Native,
    /// The device's own, corrected by integers: for a device that is a little off.
    Exact,
}

impl Words {
    /// The vocabulary: `div`, `root` and all that WGSL lacks beside them.
    #[must_use]
    pub fn prelude(self) -> String {
        let words = match self {
            Words::Native => include_str!("shaders/words_native.wgsl"),
            Words::Exact => include_str!("shaders/words_exact.wgsl"),
        };
        // in WGSL the order of declarations is free
        words.to_owned() + include_str!("shaders/prelude.wgsl")
    }
}

/// The loop of a pass, as written.
#[must_use]
fn loop_text(pass: Pass) -> &'static str {
    match pass {
        Pass::IntegrateBefore => include_str!("shaders/p01_integrate_before.wgsl"),
        Pass::Count => include_str!("shaders/p02_count.wgsl"),
        Pass::CellLists => include_str!("shaders/p03_cell_lists.wgsl"),
        Pass::Scan => include_str!("shaders/p04_scan.wgsl"),
        Pass::Place => include_str!("shaders/p05_place.wgsl"),
        Pass::Order => include_str!("shaders/p06_order.wgsl"),
        Pass::Gather => include_str!("shaders/p07_gather.wgsl"),
        Pass::Support => include_str!("shaders/p08_support.wgsl"),
        Pass::Density => include_str!("shaders/p09_density.wgsl"),
        Pass::Force => include_str!("shaders/p10_force.wgsl"),
        Pass::Normals => include_str!("shaders/p11_normals.wgsl"),
        Pass::Tension => include_str!("shaders/p12_tension.wgsl"),
        Pass::Springs => include_str!("shaders/p13_springs.wgsl"),
        Pass::PressureForce => include_str!("shaders/p14_pressure_force.wgsl"),
        Pass::PressureCorrect => include_str!("shaders/p15_pressure_correct.wgsl"),
        Pass::PressureSettle => include_str!("shaders/p16_pressure_settle.wgsl"),
        Pass::Foresee => include_str!("shaders/p17_foresee.wgsl"),
        Pass::Heat => include_str!("shaders/p18_heat.wgsl"),
        Pass::Smooth => include_str!("shaders/p19_smooth.wgsl"),
        Pass::Coat => include_str!("shaders/p20_coat.wgsl"),
        Pass::IntegrateAfter => include_str!("shaders/p21_integrate_after.wgsl"),
        Pass::Air => include_str!("shaders/p22_air.wgsl"),
        Pass::Look => include_str!("shaders/p23_look.wgsl"),
        Pass::Commit => include_str!("shaders/p24_commit.wgsl"),
    }
}

/// The vocabulary and all terms, without a pass: what a test of a single term needs.
#[must_use]
pub fn library(model: &Model, words: Words) -> String {
    let mut out = words.prelude();
    out += &format!("alias Planes = array<f32x4, {PLANES}>;\nalias Kinds = array<f32x4, {SPECIES}>;\n");
    out += &format!("const SPECIES: u32 = {SPECIES}u;\nconst TABLE_ENTRIES: u32 = {TABLE_ENTRIES}u;\n");
    out += Parameters::WGSL;
    out += "@group(0) @binding(0) var<uniform> p: Parameters;\n";
    out += &format!("@group(0) @binding(1) var<uniform> tables: array<f32x4, {}>;\n", TABLE_WORDS / 4);
    out += include_str!("shaders/constants.wgsl");
    // the choices are constants, so that what is not chosen is compiled away
    out += Model::WGSL;
    let choices: Vec<String> = bytemuck::cast_slice::<_, u32>(&[*model]).iter().map(|c| format!("{c}u")).collect();
    out += &format!("const m = Model({});\n", choices.join(", "));
    for (_, text) in texts() {
        out += &wgsl_of(text);
    }
    out
}

/// The program of a pass, its entry point named `main`.
#[must_use]
pub fn program(pass: Pass, model: &Model, words: Words) -> String {
    let mut out = library(model, words);
    out += include_str!("shaders/grid.wgsl");
    let pairs = [Pass::Force, Pass::Normals, Pass::Tension, Pass::PressureForce, Pass::Heat, Pass::Smooth];
    if pairs.contains(&pass) {
        out += include_str!("shaders/local.wgsl");
    }
    out += &format!("const WORKGROUP: u32 = {}u;\n", workgroup(pass));
    out += &declarations(pass);
    out += loop_text(pass);
    // one row of groups holds fewer threads than a large scene has particles, so there may be several rows
    out += "@compute @workgroup_size(WORKGROUP) fn main(\n  \
            @builtin(global_invocation_id) thread: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {\n  \
            pass_body(thread.x + thread.y * groups.x * WORKGROUP);\n}\n";
    out
}
