//! Promise: the bits of a known scene are these, on every path, on every machine, however the compiler optimised.
//!
//! CI runs this unoptimised too. The value changes only when the simulation is meant to; say why in the commit.
use millpond_core::{Serial, Simd, Solver, Storage};

#[path = "../../tests/bare/src/scene.rs"]
#[allow(unreachable_pub, reason = "a module of several programs")]
mod bare;

/// After 200 steps of `tests/bare`'s scene.
const GOLDEN: u64 = 0x31ef_eaef_794e_fb8c;

#[test]
fn a_known_scene_has_its_known_bits() {
    for simd in [Simd::Scalar, Simd::Base, Simd::detect()] {
        let mut storage = Box::new(Storage::<1000, 512>::new());
        let mut solver = Solver::new(&bare::scene(), storage.lend()).expect("a scene").at_level(simd);
        (0..200).for_each(|_| solver.step(&Serial).expect("a step"));
        assert_eq!(format!("{:016x}", solver.hash()), format!("{GOLDEN:016x}"), "{simd:?}");
    }
}
