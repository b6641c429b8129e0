//! Promise: core needs neither the standard library nor an allocator, and gives the same bits without them.
//!
//! `tests/bare` is a `#![no_std] #![no_main]` program that owns a `static` Storage and steps it. If anything that it
//! links used std, there would be a second panic handler and linking would fail; if anything allocated, linking would
//! fail for lack of an allocator. The test also checks the symbols and the sections of the program: static memory must
//! lie in .bss.
use millpond_core::OwnedMemory;
use millpond_core::{Serial, Solver, Storage};
use object::{Object as _, ObjectSection as _, ObjectSymbol as _};
use std::path::Path;
use std::process::Command;

#[path = "bare/src/scene.rs"]
#[allow(unreachable_pub, reason = "a module of two programs")]
mod bare;
use bare::scene;

#[test]
#[cfg(target_os = "linux")]
fn a_program_without_std_and_allocator_steps_the_same_bits() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let target = root.join("target/bare");
    let built = Command::new(env!("CARGO"))
        .args(["build", "--release", "--locked", "--manifest-path"])
        .arg(root.join("tests/bare/Cargo.toml"))
        .arg("--target-dir")
        .arg(&target)
        .output()
        .expect("cargo runs");
    assert!(built.status.success(), "{}", String::from_utf8_lossy(&built.stderr));
    let program = target.join("release/millpond-bare");

    let ran = Command::new(&program).output().expect("it runs");
    let mut heap = OwnedMemory::of(&scene().check().expect("a scene"));
    let mut solver = Solver::new(&scene(), heap.lend()).expect("a scene");
    (0..200).for_each(|_| solver.step(&Serial).expect("a step"));
    assert_eq!(String::from_utf8_lossy(&ran.stdout), format!("{:016x}", solver.hash()));
    assert_eq!(ran.status.code(), Some(0));

    let bytes = std::fs::read(&program).expect("a program");
    let file = object::File::parse(&*bytes).expect("an object file");
    let names: Vec<&str> = file.symbols().chain(file.dynamic_symbols()).filter_map(|s| s.name().ok()).collect();
    assert!(names.iter().any(|name| name.contains("millpond_core")), "symbols were read");
    for name in names {
        let base = name.split('@').next().unwrap_or_default();
        let allocates = ["malloc", "calloc", "realloc", "posix_memalign", "aligned_alloc"].contains(&base);
        assert!(!allocates && !name.contains("__rust_alloc") && !name.contains("__rdl_alloc"), "{name}");
        assert!(!name.contains("3std"), "{name} is std's");
    }
    // static memory lies in .bss: the program file records its size, but does not contain it
    let storage = size_of::<Storage<1000, 512>>() as u64;
    let bss = file.section_by_name(".bss").map_or(0, |section| section.size());
    assert!(storage > 200_000 && bss >= storage, "{bss} bytes of .bss, {storage} of memory");
}
