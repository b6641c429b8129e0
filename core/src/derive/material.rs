//! Indices of materials. The fourth number of a particle's velocity is the index of its material, which selects the row
//! of its constants. First come the fluids, then the blocks with their own viscosity, the walls, the solids, and
//! the inactive particles.
use crate::layout::MATERIALS;
use crate::scene::{BLOCKS, FLUIDS, SOLIDS, Scene, SolidModel, WALLS};

/// First material of the blocks with their own viscosity; the materials before it are the fluids.
pub(crate) const FIRST_BLOCK: u32 = FLUIDS as u32;

/// First material of the walls.
pub(crate) const FIRST_WALL: u32 = FIRST_BLOCK + BLOCKS as u32;

/// First material of the solids.
pub(crate) const FIRST_SOLID: u32 = FIRST_WALL + WALLS as u32;

/// The material of inactive particles.
pub(crate) const INACTIVE: u32 = MATERIALS as u32 - 1;

/// Value that inactive particles have where wall particles have a 1. Particles with any value above 0 are held, and
/// this value distinguishes inactive particles from walls.
pub(crate) const INACTIVE_ROLE: f32 = 2.0;

const _: () = assert!((FIRST_SOLID as usize) + SOLIDS <= INACTIVE as usize, "room for every material");

/// What a particle belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Material {
    /// A fluid, by index.
    Fluid(u32),
    /// A wall, by index.
    Wall(u32),
    /// A solid, by index.
    Solid(u32),
    /// Inactive: it takes no part in anything.
    Inactive,
}

/// What the material with this index is in a scene; `None` if the scene has no such material. For a block with its own
/// viscosity it is the fluid of the block.
#[must_use]
pub fn material_of(number: u32, scene: &Scene) -> Option<Material> {
    match number {
        INACTIVE => scene.has_inactive().then_some(Material::Inactive),
        FIRST_SOLID.. => {
            let number = number - FIRST_SOLID;
            let solid = scene.solids.get(number as usize)?;
            (solid.model == SolidModel::Particles).then_some(Material::Solid(number))
        }
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
