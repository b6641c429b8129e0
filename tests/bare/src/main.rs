//! Steps a dam break in static memory, using only core, and prints the state hash.
#![no_std]
#![no_main]

mod scene;

use core::ffi::{c_char, c_int, c_void};
use millpond_core::{Serial, Solver, Storage};

static mut STORAGE: Storage<1000, 512> = Storage::new();

#[link(name = "c")]
unsafe extern "C" {
    fn write(file: c_int, bytes: *const c_void, count: usize) -> isize;
    fn abort() -> !;
}

#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    // SAFETY: `abort` only ends the process.
    unsafe { abort() }
}

#[unsafe(no_mangle)]
extern "C" fn main(_: c_int, _: *const *const c_char) -> c_int {
    // SAFETY: main runs once, so this is the only reference.
    let storage = unsafe { &mut *(&raw mut STORAGE) };
    let Ok(mut solver) = Solver::new(&scene::scene(), storage.lend()) else { return 2 };
    for _ in 0..200 {
        if solver.step(&Serial).is_err() {
            return 3;
        }
    }
    let hash = solver.hash();
    let digits: [u8; 16] = core::array::from_fn(|i| b"0123456789abcdef"[(hash >> (60 - 4 * i)) as usize & 15]);
    // SAFETY: the pointer and the length are those of one array.
    let written = unsafe { write(1, digits.as_ptr().cast(), digits.len()) };
    c_int::from(written != 16)
}
