//! The passes of a time step: loops over all particles. The folders are in the order of a step, with one file per pass.
//! The table of passes is [`plan::passes`](crate::plan::passes). The passes on a GPU have the same names.
//!
//! A pass only loads data, calls the functions in [`terms`](crate::terms) and stores the results; it contains no
//! formula of its own. It is cut into jobs, which may run in parallel. No job reads what another job of the same pass
//! writes.
//!
//! The passes use these words:
//!
//! - slot: the index of a particle in the arrays. Each step sorts the particles by cell, so slots change from step to
//!   step. The id of a particle never changes.
//! - cell: a cell of the uniform grid that neighbours are searched in, at least one support radius wide. The particles
//!   of a cell lie in consecutive slots.
//! - receiver: the particle whose sum is computed, `a` in the formulas.
//! - neighbour: a particle within the support radius of a receiver, `b` in the formulas. A particle is its own
//!   neighbour.
//! - lane: one element of a SIMD register. In passes over pairs the lanes hold one or more receivers, with up to four
//!   neighbours of each; in other passes each lane holds one particle.
//! - group: four particles in consecutive slots, whose neighbours are stored together (`lists.rs`). In a loop, the
//!   receivers that share a register (`group.rs`).
//! - list: the neighbours of a particle, found once per step and read by all passes over pairs (`lists.rs`).
//! - code: the slot of a neighbour, packed into 16 bits.
//! - window: a range of 8192 consecutive slots. A code names a window and a place in it.
//! - material: the fluid, block, wall or inactive air that a particle belongs to. The fourth number of its velocity is
//!   the number of its material.
//! - exposed particle: a liquid particle at the free surface.
//! - inactive particle: one that is currently unused: air, one of an emitter, or one that a drain has taken. Inactive
//!   particles have no effect, and all of them lie in the last cell.
pub(crate) mod beyond;
mod by_model;
mod candidates;
mod closed_solids;
pub(crate) mod columns;
pub(crate) mod context;
mod density_sums;
mod faces;
pub(crate) mod field;
mod group;
mod half_stencil;
pub(crate) mod lanes;
mod listing;
pub(crate) mod lists;
pub(crate) mod local;
mod pairs;
mod places;

pub(crate) mod a_move {
    pub(crate) mod carry;
    pub(crate) mod integrate_before;
    pub(crate) mod move_solids;
}

pub(crate) mod b_sort {
    pub(crate) mod cell_lists;
    pub(crate) mod count;
    pub(crate) mod gather;
    pub(crate) mod index_ids;
    pub(crate) mod scan;
    pub(crate) mod scatter;
    pub(crate) mod sort_by_id;
}

pub(crate) mod c_density {
    pub(crate) mod density;
    pub(crate) mod neighbours;
    pub(crate) mod renormalise;
    pub(crate) mod support;
    pub(crate) mod wall_states;
    pub(crate) mod wall_sums;
}

pub(crate) mod d_forces {
    pub(crate) mod exposure;
    pub(crate) mod force;
    pub(crate) mod normals;
    pub(crate) mod spring_lengths;
    pub(crate) mod springs;
    pub(crate) mod tension;
}

pub(crate) mod e_pressure {
    pub(crate) mod pressure_converged;
    pub(crate) mod pressure_correct;
    pub(crate) mod pressure_force;
}

pub(crate) mod f_advance {
    pub(crate) mod contact;
    pub(crate) mod emit;
    pub(crate) mod integrate_after;
    pub(crate) mod internal_energy;
    pub(crate) mod predict_velocity;
    pub(crate) mod shift;
    pub(crate) mod spawn_requests;
    pub(crate) mod xsph;
}

pub(crate) mod g_finish {
    pub(crate) mod commit;
    pub(crate) mod leave;
    pub(crate) mod measure;
    pub(crate) mod renew;
    pub(crate) mod spawn;
    pub(crate) mod validate;
}

use crate::plan::passes::Pass;
use context::Step;

macro_rules! dispatch {
    ($($(#[$doc:meta])* $pass:ident: $folder:ident / $file:ident, $threads:ident, $status:ident, if $runs:expr,
        [$($access:ident $array:ident $(@ $bound:ident)?),*];)*) => {
        /// Runs a pass.
        pub(crate) fn run(pass: Pass, step: &mut Step<'_, '_>) {
            match pass { $(Pass::$pass => $folder::$file::run(step),)* }
        }
    };
}
crate::with_passes!(dispatch);
