//! Promise: the folders of core contain what their names say. The folders of the passes hold exactly the passes, in the
//! order of the step, and every file of the terms is one of the texts that a device receives.
//!
//! `gpu/tests/terms_are_one_text.rs` checks that the shader folders hold the same passes.
use millpond_core::Pass;
use millpond_core::backend::terms::texts;
use std::collections::BTreeSet;
use std::path::Path;

mod support;
use support::files::passes_in;

#[test]
fn folders_hold_exactly_the_passes() {
    let names = Pass::ALL.map(|pass| format!("{}/{}", pass.folder(), pass.name()));
    assert_eq!(passes_in(&root().join("passes"), ".rs"), BTreeSet::from(names));
}

#[test]
fn folders_stand_in_the_order_of_the_step() {
    assert!(Pass::ALL.map(Pass::folder).is_sorted());
}

#[test]
fn every_term_file_is_a_text() {
    let stems = |folder: &str| {
        let folder = root().join(folder);
        let files = std::fs::read_dir(folder).expect("a folder").map(|e| e.expect("an entry").path());
        let names = files.filter_map(|f| f.file_stem().map(|name| name.to_string_lossy().into_owned()));
        names.filter(|name| name != "mod").collect::<Vec<String>>()
    };
    // the folders `kernel` and `integrate` are listed as well: their mod.rs is a text under the folder's name
    let folders = ["terms", "terms/kernel", "terms/integrate"];
    let mut files = folders.map(stems).concat();
    files.sort();
    let mut texts: Vec<String> = texts().map(|(name, _)| (*name).to_owned()).collect();
    texts.sort();
    assert_eq!(files, texts);
}

fn root() -> std::path::PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("src")
}
