//! Memory on the heap, for a scene of any size.
use super::lend::Memory;
use super::requirements::Requirements;
use crate::validate::Checked;
use alloc::vec::Vec;

/// A cache line.
#[derive(Clone, Copy, Debug, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C, align(64))]
struct Line([u8; 64]);

/// Memory on the heap, as much as a scene needs.
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
    /// Allocates the memory for a scene.
    #[must_use]
    pub fn of(scene: &Checked<'_>) -> OwnedMemory {
        OwnedMemory::with(&Requirements::of(scene))
    }

    /// Allocates memory for these requirements.
    #[must_use]
    pub fn with(requirements: &Requirements) -> OwnedMemory {
        let lines = requirements.arena_bytes() / size_of::<Line>();
        OwnedMemory(bytemuck::zeroed_vec(lines))
    }

    /// Lends all of the memory.
    pub fn lend(&mut self) -> Memory<'_> {
        Memory::of_arena(bytemuck::cast_slice_mut(&mut self.0))
    }
}
