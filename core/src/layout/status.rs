//! What a step on a device has to say for itself.
use super::shared;

/// No particle, no cell: the largest index, so that an atomic minimum finds the smallest offender.
pub const NONE: u32 = u32::MAX;

shared! {
    /// Head of the status buffer. The three offenders are minima over a pass, so no order of threads changes them; the
    /// last pass of a step looks at them once, and a step that finds one sets `failed`, after which no step does anything.
    pub struct Status {
        /// 0, or 1 for good.
        pub failed: u32,
        /// Steps that count.
        pub steps: u32,
        /// Smallest `4 id + axis` of a particle beyond the grid's range.
        pub out_of_range: u32,
        /// Smallest cell with more particles than places.
        pub cell_full: u32,
        /// Particles in that cell.
        pub cell_count: u32,
        /// Smallest `4 id + quantity` of a particle that is not finite any more.
        pub not_finite: u32,
        /// Unused.
        pub pad0: u32,
        /// Unused.
        pub pad1: u32,
    }
}

impl Status {
    /// Nothing has gone wrong after `steps` steps.
    #[must_use]
    pub fn fine(steps: u32) -> Status {
        let (failed, cell_count, pad0, pad1) = (0, 0, 0, 0);
        Status { failed, steps, out_of_range: NONE, cell_full: NONE, cell_count, not_finite: NONE, pad0, pad1 }
    }
}
