//! Promise: the first things that a program does need little stack, even without optimisation: the first lines of the
//! README and of the examples (`first_lines.rs`), the example `embed` up to its first picture, and every doctest.
//!
//! They are built without optimisation into a target folder of their own, and run with a stack of 1 MiB for the main
//! thread (`ulimit -s`) and for all other threads (`RUST_MIN_STACK`). Nothing of wgpu is built for this test.
#![cfg(target_os = "linux")]
use std::io::{BufRead as _, BufReader};
use std::os::unix::fs::PermissionsExt as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// Size of the stack, KiB: that of a main thread on Windows.
const STACK: u64 = 1024;

/// Returns a cargo command for core, without optimisation.
fn cargo(target: &Path, what: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO"));
    command.args(what).args(["--locked", "--package", "millpond-core", "--target-dir"]).arg(target);
    command.current_dir(env!("CARGO_MANIFEST_DIR")).env("CARGO_PROFILE_DEV_OPT_LEVEL", "0");
    command
}

/// Runs a command, which must succeed, and returns its output.
fn done(command: &mut Command) -> String {
    let ran = command.output().expect("it runs");
    let [out, err] = [&ran.stdout, &ran.stderr].map(|text| String::from_utf8_lossy(text).into_owned());
    assert!(ran.status.success(), "{command:?}: {}\n{out}\n{err}", ran.status);
    out
}

/// Writes a script that runs a program with a small stack and records that it did; returns the path of the script.
fn runner(target: &Path) -> PathBuf {
    let (runner, ran) = (target.join("small-stack"), target.join("ran"));
    let _ = std::fs::remove_file(&ran);
    let bytes = STACK * 1024;
    let text = format!(
        "#!/bin/sh\nulimit -s {STACK} || exit 1\necho \"$1\" >> '{}'\nRUST_MIN_STACK={bytes} exec \"$@\"\n",
        ran.display()
    );
    std::fs::write(&runner, text).expect("a file");
    std::fs::set_permissions(&runner, std::fs::Permissions::from_mode(0o755)).expect("a program");
    runner
}

#[test]
fn of_first_lines_example_and_doctests_without_optimisation() {
    let target = Path::new(env!("CARGO_TARGET_TMPDIR")).join("unoptimised");
    std::fs::create_dir_all(&target).expect("a folder");
    let runner = runner(&target);
    let host = done(Command::new(env!("CARGO")).arg("-vV"));
    let host = host.lines().find_map(|line| line.strip_prefix("host: ")).expect("a host");
    let variable = format!("CARGO_TARGET_{}_RUNNER", host.to_uppercase().replace(['-', '.'], "_"));
    let small = |what: &[&str]| done(cargo(&target, what).env(&variable, &runner));

    let lines = small(&["test", "--test", "first_lines"]);
    assert!(lines.contains("2 passed; 0 failed; 0 ignored"), "{lines}");
    // of items, whose names have a path: that of the crate is among the first lines, and takes minutes unoptimised
    let doctests = small(&["test", "--doc", "::"]);
    let passed = doctests.lines().find(|line| line.starts_with("test result: ok. ")).unwrap_or_default();
    assert!(passed.contains("passed; 0 failed") && !passed.contains(" 0 passed"), "{doctests}");

    // without optimisation the whole example takes minutes; after its first picture it only repeats what it has done
    done(&mut cargo(&target, &["build", "--example", "embed"]));
    let mut example =
        Command::new(&runner).arg(target.join("debug/examples/embed")).stdout(Stdio::piped()).spawn().expect("it runs");
    let mut lines = BufReader::new(example.stdout.take().expect("its output")).lines().map_while(Result::ok);
    let frame = lines.by_ref().filter(|line| line.starts_with('|') && line.ends_with('|')).take(12).count();
    // killing fails if the program has already ended, which does not matter
    let _ = example.kill();
    let ended = example.wait().expect("its end");
    assert_eq!(frame, 12, "the rows of a picture, and not {ended}");

    let ran = std::fs::read_to_string(target.join("ran")).expect("what ran with a small stack");
    let ran: Vec<&str> = ran.lines().collect();
    let is = |part: &str| ran.iter().any(|program| program.contains(part));
    assert!(is("first_lines") && is("doctest") && is("examples/embed"), "{ran:?}");
}
