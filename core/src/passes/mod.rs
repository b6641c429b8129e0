//! The loops over particles: folders in the order of a step, one file a pass, listed in [`plan::passes`](crate::plan::passes). A
//! device's passes have the same names.
//!
//! Loops only load, call a term and store. No job reads what another job of its pass writes.
mod by_model;
mod candidates;
pub(crate) mod columns;
pub(crate) mod context;
mod density_sums;
mod field;
mod group;
mod half_stencil;
pub(crate) mod lanes;
mod listing;
pub(crate) mod lists;
mod local;
mod pairs;

pub(crate) mod a_move {
    pub(crate) mod integrate_before;
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
    pub(crate) mod support;
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
    pub(crate) mod integrate_after;
    pub(crate) mod internal_energy;
    pub(crate) mod predict_velocity;
    pub(crate) mod spawn_requests;
    pub(crate) mod xsph;
}

pub(crate) mod g_finish {
    pub(crate) mod commit;
    pub(crate) mod measure;
    pub(crate) mod spawn;
    pub(crate) mod validate;
}

use crate::executor::Executor;
use crate::plan::passes::Pass;
use context::Step;

macro_rules! dispatch {
    ($($(#[$doc:meta])* $pass:ident: $folder:ident / $file:ident, $threads:ident, $status:ident, if $runs:expr,
        [$($access:ident $array:ident $(@ $bound:ident)?),*];)*) => {
        /// Runs a pass.
        pub(crate) fn run(pass: Pass, step: &mut Step<'_, '_, impl Executor>) {
            match pass { $(Pass::$pass => $folder::$file::run(step),)* }
        }
    };
}
crate::with_passes!(dispatch);
