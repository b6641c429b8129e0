//! Kinds of particle: what stands in the fourth number of a velocity, and names the row of a particle's constants.
use super::{BLOCKS, FLUIDS, Scene, WALLS};
use crate::layout::SPECIES;

/// First kind of the blocks with a viscosity of their own; before it come the fluids.
pub(crate) const FIRST_BLOCK: u32 = FLUIDS as u32;

/// First kind of the walls.
pub(crate) const FIRST_WALL: u32 = FIRST_BLOCK + BLOCKS as u32;

/// The kind of a particle of air that is not there.
pub(crate) const DORMANT: u32 = FIRST_WALL + WALLS as u32;

const _: () = assert!(DORMANT as usize + 1 == SPECIES);

/// What a particle is of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A fluid, by number.
    Fluid(u32),
    /// A wall, by number.
    Wall(u32),
    /// Air that is not there.
    Dormant,
}

/// What a kind's number means in a scene, if anything: of a block with a viscosity of its own its fluid.
#[must_use]
pub fn kind_of(number: u32, scene: &Scene) -> Option<Kind> {
    match number {
        DORMANT => scene.air.map(|_| Kind::Dormant),
        FIRST_WALL.. => {
            let wall = number - FIRST_WALL;
            scene.walls.get(wall as usize).map(|_| Kind::Wall(wall))
        }
        FIRST_BLOCK.. => {
            let block = scene.blocks.get((number - FIRST_BLOCK) as usize)?;
            block.dynamic_viscosity.map(|_| Kind::Fluid(block.fluid))
        }
        fluid => scene.fluids().nth(fluid as usize).map(|_| Kind::Fluid(fluid)),
    }
}
