//! Lists files of folders.
use std::collections::BTreeSet;
use std::path::Path;

/// Returns `folder/name` of the files with this extension in those folders under `root` whose names begin with a letter
/// and an underscore, as the folders of passes do.
pub fn passes_in(root: &Path, extension: &str) -> BTreeSet<String> {
    let entries = |folder: &Path| {
        let all = std::fs::read_dir(folder).unwrap_or_else(|e| panic!("{}: {e}", folder.display()));
        all.map(|e| e.expect("an entry").file_name().into_string().expect("a name")).collect::<Vec<_>>()
    };
    let folders = entries(root).into_iter().filter(|name| name.as_bytes().get(1) == Some(&b'_'));
    let files =
        folders.flat_map(|folder| entries(&root.join(&folder)).into_iter().map(move |file| format!("{folder}/{file}")));
    files.filter_map(|file| file.strip_suffix(extension).map(str::to_owned)).collect()
}
