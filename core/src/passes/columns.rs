//! The constants of materials, column by column, so that lanes can look them up in a register.
use super::lanes::material_of;
use crate::arithmetic::codes::FEW;
use crate::arithmetic::lanes::Lanes;
use crate::arithmetic::real::{less, real, select};
use crate::derive::material::{FIRST_BLOCK, FIRST_WALL};
use crate::layout::{MaterialRows, Materials};

/// A column of a table: one number per material in use.
pub(crate) type Column = [f32; FEW];

/// The columns of the materials that a scene uses. Unused numbers of materials are left out.
#[derive(Clone, Debug)]
pub(crate) struct Columns {
    pub properties: [Column; 4],
    pub states: [Column; 4],
    pub corrections: [Column; 4],
    /// Whether the columns hold all materials of the scene.
    pub hold_all: bool,
    /// How far the numbers of blocks, and those of walls, lie above their places in the columns. The difference is the
    /// number of unused materials before them.
    gaps: [f32; 2],
}

impl Columns {
    /// Builds the columns of a scene with this many fluids, blocks, walls and solids. They have no room for solids.
    pub(crate) fn of(materials: &Materials, [fluids, blocks, walls, solids]: [usize; 4]) -> Columns {
        let [first_block, first_wall] = [FIRST_BLOCK as usize, FIRST_WALL as usize];
        let in_use = (0..fluids).chain(first_block..first_block + blocks).chain(first_wall..first_wall + walls);
        let mut columns = Columns {
            properties: [[0.0; FEW]; 4],
            states: [[0.0; FEW]; 4],
            corrections: [[0.0; FEW]; 4],
            hold_all: fluids + blocks + walls <= FEW && solids == 0,
            gaps: [(first_block - fluids) as f32, (first_wall - fluids - blocks) as f32],
        };
        for (place, material) in in_use.enumerate().take(FEW) {
            for i in 0..4 {
                columns.properties[i][place] = materials.properties[material][i];
                columns.states[i][place] = materials.states[material][i];
                columns.corrections[i][place] = materials.corrections[material][i];
            }
        }
        columns
    }

    /// Returns the places of materials in the columns.
    #[inline(always)]
    pub(crate) fn places<R: Lanes>(&self, material: R) -> R {
        let [of_blocks, of_walls] = self.gaps;
        let place = select(material, material - of_blocks, less(real(FIRST_BLOCK as f32 - 0.5), material));
        select(place, material - of_walls, less(real(FIRST_WALL as f32 - 0.5), material))
    }
}

/// Returns number `i` of the constants of materials, without the columns.
#[inline(always)]
pub(crate) fn of_materials<R: Lanes>(rows: &MaterialRows, material: R, i: usize) -> R {
    R::from_lanes(|lane| rows[material_of(material.lane(lane))][i])
}
