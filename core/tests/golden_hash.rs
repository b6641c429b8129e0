//! Promise: known scenes have these known bits, on every path, on every machine, at every level of optimisation.
//!
//! The scenes name every field (a test checks that), so that a change of a default changes no bit here. CI also runs
//! this test without optimisation. Change a value only when the simulation is meant to change, and give the reason in
//! the commit message.
use millpond_core::scene::Scene;
use millpond_core::{OwnedMemory, Serial, Simd, Solver};

#[path = "../../tests/bare/src/scene.rs"]
#[allow(unreachable_pub, reason = "a module of several programs")]
mod bare;

/// Hash of positions and velocities of the scene of `tests/bare` after 200 steps.
const BARE: u64 = 0x31ef_eaef_794e_fb8c;

const STEPS: u32 = 60;

macro_rules! golden {
    ($($name:literal: $hash:literal, $full:literal;)*) => {
        &[$(($name, include_str!(concat!("golden/", $name, ".ron")), $hash, $full)),*]
    };
}

/// Name, text, hash of positions and velocities and hash of all state after [`STEPS`] steps.
const GOLDEN: &[(&str, &str, u64, u64)] = golden! {
    "pirovano-forms": 0x3d9a_9f44_70c3_97c1, 0xc945_a82e_0c0c_004e;
    "tables-in-cell-lists": 0x1c50_6809_c154_9b96, 0x98e4_ad86_fae1_0e04;
    "monaghan-in-a-box": 0xbbb2_eb98_e4f4_09bf, 0xae54_2cf9_ef9b_8664;
    "adaptive-dynamic-walls": 0xf3b6_2a92_5f18_07b5, 0x1f84_a0e2_5546_2ca3;
    "corrected-pressure": 0x571b_fc89_96a1_71f7, 0xc040_7246_eecb_34b7;
    "two-fluids-periodic": 0xdd32_a2f8_0ac2_235d, 0xcc73_16a0_8b1b_017c;
    "plastic-and-warm": 0xfd1b_708d_a8cd_9cbb, 0x65c3_3676_d97c_2cdb;
    "air-and-curvature": 0xcca2_713c_c35c_f080, 0xd8a7_0fe3_cca0_8702;
    "stepped-density-verlet": 0x3bb5_2de3_7c89_413b, 0x2a63_b2fd_6ee5_7d8d;
    "beeman-exchange": 0xb4dc_7133_fad1_b89e, 0x2bb6_de96_36c7_5209;
    "half-stencil": 0xafbf_ed23_95e2_1c56, 0x28f1_bea7_62f9_44a9;
    "half-stencil-periodic": 0x1905_bec2_6f21_786e, 0xd2cc_8412_297a_893d;
    "everything": 0x9f95_7708_9468_e93d, 0xba3f_9791_13ae_5fc1;
};

fn run(scene: &Scene, simd: Simd, steps: u32) -> [String; 2] {
    let mut memory = OwnedMemory::of(&scene.check().expect("a scene"));
    let mut solver = Solver::new(scene, memory.lend()).expect("a scene").at_level(simd);
    (0..steps).for_each(|_| solver.step(&Serial).expect("a step"));
    [solver.hash(), solver.full_hash()].map(|hash| format!("{hash:#018x}"))
}

fn scene(text: &str) -> Scene {
    ron::from_str(text).expect("a scene in RON")
}

#[test]
fn known_scenes_have_their_known_bits() {
    for simd in Simd::available() {
        assert_eq!(run(&bare::scene(), simd, 200)[0], format!("{BARE:#018x}"), "bare, {simd:?}");
    }
    let wrong = |(name, text, hash, full): &(&str, &str, u64, u64)| {
        let runs = Simd::available().map(|simd| (simd, run(&scene(text), simd, STEPS)));
        let others = runs.filter(|(_, got)| *got != [hash, full].map(|hash| format!("{hash:#018x}")));
        others.map(|(simd, [got, got_full])| format!("\"{name}\": {got}, {got_full}; by {simd:?}")).collect::<Vec<_>>()
    };
    // unoptimised, each of them takes seconds
    let wrong: Vec<String> = std::thread::scope(|threads| {
        let runs: Vec<_> = GOLDEN.iter().map(|known| threads.spawn(move || wrong(known))).collect();
        runs.into_iter().flat_map(|run| run.join().expect("a run")).collect()
    });
    assert!(wrong.is_empty(), "other bits than the known ones:\n{}", wrong.join("\n"));
}

#[test]
fn known_scenes_spell_out_every_field() {
    for (name, text, ..) in GOLDEN {
        let pretty = ron::ser::PrettyConfig::new().depth_limit(3);
        let spelled = ron::ser::to_string_pretty(&scene(text), pretty).expect("a scene in RON") + "\n";
        assert_eq!(*text, spelled, "{name}: a field that its file does not name");
    }
}
