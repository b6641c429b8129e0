//! Numbers of materials: what stands in the fourth number of a particle's velocity, and names the row of its constants. First come
//! the fluids, then the blocks with a viscosity of their own, the walls, and the air that is not there.
use crate::layout::MATERIALS;
use crate::scene::{BLOCKS, FLUIDS, Scene, WALLS};

/// First material of the blocks with a viscosity of their own; before it come the fluids.
pub(crate) const FIRST_BLOCK: u32 = FLUIDS as u32;

/// First material of the walls.
pub(crate) const FIRST_WALL: u32 = FIRST_BLOCK + BLOCKS as u32;

/// The material of a particle of air that is not there.
pub(crate) const INACTIVE: u32 = MATERIALS as u32 - 1;

/// What air that is not there has where a particle of a wall has a 1: whatever is more than 0 is held, and this can be told
/// from a wall.
pub(crate) const NOT_THERE: f32 = 2.0;

const _: () = assert!((FIRST_WALL as usize) + WALLS <= INACTIVE as usize, "room for every material");

/// What a particle is of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Material {
    /// A fluid, by number.
    Fluid(u32),
    /// A wall, by number.
    Wall(u32),
    /// Air that is not there.
    Inactive,
}

/// What a material's number means in a scene, if anything: of a block with a viscosity of its own its fluid.
#[must_use]
pub fn material_of(number: u32, scene: &Scene) -> Option<Material> {
    match number {
        INACTIVE => scene.air.map(|_| Material::Inactive),
        FIRST_WALL.. => {
            let wall = number - FIRST_WALL;
            scene.walls.get(wall as usize).map(|_| Material::Wall(wall))
        }
        FIRST_BLOCK.. => {
            let block = scene.blocks.get((number - FIRST_BLOCK) as usize)?;
            block.dynamic_viscosity.map(|_| Material::Fluid(block.fluid))
        }
        fluid => scene.fluids.get(fluid as usize).map(|_| Material::Fluid(fluid)),
    }
}
