//! Memory for a scene of any size, from the heap.
use super::lend::Memory;
use super::requirements::Requirements;
use crate::validate::Checked;
use alloc::vec::Vec;

/// A cache line.
#[derive(Clone, Copy, Debug, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C, align(64))]
struct Line([u8; 64]);

/// As much memory as a scene needs, on the heap.
///
/// ```
/// use millpond_core::glam::Vec3;
/// use millpond_core::scene::{Block, Dimension, Fluid, Scene};
/// use millpond_core::{OwnedMemory, Solver};
///
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// let block = Block { size: Vec3::splat(0.5), ..Block::default() };
/// let scene = Scene::of(Dimension::Three, 0.05, 0.001, Fluid::default(), block);
/// let mut memory = OwnedMemory::of(&scene.check()?);
/// let solver = Solver::new(&scene, memory.lend())?;
/// assert_eq!(solver.particles().len(), 1000);
/// # Ok(())
/// # }
/// ```
#[derive(Debug, Default)]
pub struct OwnedMemory(Vec<Line>);

impl OwnedMemory {
    /// For a scene.
    #[must_use]
    pub fn of(scene: &Checked<'_>) -> OwnedMemory {
        OwnedMemory::with(&Requirements::of(scene))
    }

    /// For these requirements.
    #[must_use]
    pub fn with(requirements: &Requirements) -> OwnedMemory {
        let lines = requirements.arena_bytes() / size_of::<Line>();
        OwnedMemory(bytemuck::zeroed_vec(lines))
    }

    /// Lends all of it.
    pub fn lend(&mut self) -> Memory<'_> {
        Memory::of_arena(bytemuck::cast_slice_mut(&mut self.0))
    }
}
