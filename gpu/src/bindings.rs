//! Which arrays each pass reads and writes: the one table from which bind groups and WGSL declarations are made.
use millpond_core::Pass;
use millpond_core::layout::Status;

/// Declares the arrays once: name, meaning, name and type in WGSL.
macro_rules! arrays {
    ($($(#[$doc:meta])* $array:ident = $name:literal: $type:literal,)*) => {
        /// An array on the device.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum Array { $($(#[$doc])* $array,)* }

        impl Array {
            /// Its name in WGSL.
            #[must_use]
            pub fn name(self) -> &'static str {
                match self { $(Array::$array => $name,)* }
            }

            /// Its type in WGSL.
            fn type_name(self) -> &'static str {
                match self { $(Array::$array => $type,)* }
            }
        }
    };
}

arrays! {
    /// The status, and after it the counters of the cells.
    Head = "head": "Head",
    /// Old state.
    OldPosition = "old_position": "array<f32x4>",
    /// Old state.
    OldVelocity = "old_velocity": "array<f32x4>",
    /// Old state.
    OldAcceleration = "old_acceleration": "array<f32x4>",
    /// Old state.
    OldDensityPressure = "old_density_pressure": "array<f32x4>",
    /// Old state, with XSPH.
    OldSmoothing = "old_smoothing": "array<f32x4>",
    /// Old state, with thermal energy.
    OldHeat = "old_heat": "array<f32x4>",
    /// Old state, with integrators that remember.
    OldHistory = "old_history": "array<f32x4>",
    /// Old state.
    OldId = "old_id": "array<u32>",
    /// New state.
    NewPosition = "new_position": "array<f32x4>",
    /// New state.
    NewVelocity = "new_velocity": "array<f32x4>",
    /// New state; before the force pass, where the moved velocities wait.
    NewAcceleration = "new_acceleration": "array<f32x4>",
    /// New state; before the density pass, where the moved positions wait.
    NewDensityPressure = "new_density_pressure": "array<f32x4>",
    /// New state, with XSPH.
    NewSmoothing = "new_smoothing": "array<f32x4>",
    /// New state, with thermal energy.
    NewHeat = "new_heat": "array<f32x4>",
    /// New state, with normals.
    NewNormal = "new_normal": "array<f32x4>",
    /// New state, with integrators that remember.
    NewHistory = "new_history": "array<f32x4>",
    /// New state.
    NewId = "new_id": "array<u32>",
    /// Densities and pressures before the step, where it needs them.
    Previous = "previous": "array<f32x4>",
    /// Accelerations without pressure, where that is corrected.
    Free = "free": "array<f32x4>",
    /// Where the force pass writes: the new accelerations, or those without pressure.
    ForceOut = "force_out": "array<f32x4>",
    /// Accelerations at the beginning of the step, where its end needs them.
    Earlier = "earlier": "array<f32x4>",
    /// Velocities at the end of the step, where pairs need them.
    Ahead = "ahead": "array<f32x4>",
    /// Slot of each particle, by id; with springs or air.
    SlotOf = "slot_of": "array<u32>",
    /// Gradient of the colour of all that is there, and who is bare; with air.
    Bare = "bare": "array<f32x4>",
    /// Beside whom air is to be made, and behind these entries a queue of them; with air.
    Birth = "birth": "array<u32>",
    /// What each particle has of springs, by id.
    SpringsOf = "springs_of": "array<u32x4>",
    /// Ends of springs before the step.
    OldEnds = "old_ends": "array<u32x2>",
    /// And after it, where lengths at rest change.
    NewEnds = "new_ends": "array<u32x2>",
    /// Nodes of the host's field.
    FieldNodes = "field_nodes": "array<f32x4>",
    /// Cell of each particle, by its slot before the step; once that is known, its slot after it.
    Cell = "cell": "array<u32>",
    /// Rank of each particle in its cell.
    Rank = "rank": "array<u32>",
    /// First slot of each cell.
    Begin = "begin": "array<u32>",
    /// Slots before the step, cell by cell, those of a cell in no order.
    Order = "order": "array<u32>",
    /// Places of the cells.
    GridCells = "grid_cells": "array<u32>",
    /// What a gather reads.
    GatherFrom = "gather_from": "array<f32x4>",
    /// What it writes.
    GatherTo = "gather_to": "array<f32x4>",
}

/// What a pass does to an array.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Access {
    /// Reads it.
    Read,
    /// Writes it.
    Write,
    /// Writes it through atomics.
    Atomic,
}

/// Uniforms before the arrays: the parameters, the kernel tables.
pub const UNIFORMS: u32 = 2;

/// The arrays of a pass, in the order of their bindings (after the [`UNIFORMS`]). At most 8, wgpu's default limit.
#[must_use]
#[allow(clippy::too_many_lines, reason = "one table, of everything")]
pub fn arrays(pass: Pass) -> &'static [(Array, Access)] {
    use Access::{Atomic, Read, Write};
    use Array::*;
    match pass {
        Pass::IntegrateBefore => &[
            (Head, Read),
            (OldPosition, Read),
            (OldVelocity, Read),
            (OldAcceleration, Read),
            (OldSmoothing, Read),
            (OldHistory, Read),
            (NewDensityPressure, Write),
            (NewAcceleration, Write),
        ],
        Pass::Count => &[
            (Head, Atomic),
            (NewDensityPressure, Read),
            (NewAcceleration, Read),
            (OldId, Read),
            (Cell, Write),
            (Rank, Write),
        ],
        Pass::CellLists => &[(Head, Atomic), (Cell, Read), (Rank, Read), (GridCells, Write)],
        Pass::Scan => &[(Head, Read), (Begin, Write)],
        Pass::Place => &[
            (Head, Read),
            (Cell, Read),
            (Rank, Read),
            (Begin, Read),
            (OldId, Read),
            (Order, Write),
            (NewId, Write),
            (SlotOf, Write),
        ],
        Pass::Order => &[
            (Head, Read),
            (Cell, Write),
            (Begin, Read),
            (OldId, Read),
            (GridCells, Read),
            (Order, Read),
            (NewId, Write),
            (SlotOf, Write),
        ],
        Pass::Gather => &[(Head, Read), (Cell, Read), (GatherFrom, Read), (GatherTo, Write)],
        Pass::Support => &[(Head, Read), (Previous, Write)],
        Pass::Density => &[
            (Head, Read),
            (Begin, Read),
            (NewPosition, Read),
            (NewVelocity, Read),
            (Previous, Read),
            (NewDensityPressure, Write),
        ],
        Pass::Force => &[
            (Head, Read),
            (Begin, Read),
            (NewPosition, Read),
            (NewVelocity, Read),
            (NewDensityPressure, Read),
            (Previous, Read),
            (FieldNodes, Read),
            (ForceOut, Write),
        ],
        Pass::Normals => &[
            (Head, Read),
            (Begin, Read),
            (NewPosition, Read),
            (NewVelocity, Read),
            (NewDensityPressure, Read),
            (Previous, Read),
            (NewNormal, Write),
            (Bare, Write),
        ],
        Pass::Tension => &[
            (Head, Read),
            (Begin, Read),
            (NewPosition, Read),
            (NewVelocity, Read),
            (NewDensityPressure, Read),
            (Previous, Read),
            (NewNormal, Read),
            (ForceOut, Write),
        ],
        Pass::Springs => &[
            (Head, Read),
            (NewPosition, Read),
            (NewId, Read),
            (SlotOf, Read),
            (SpringsOf, Read),
            (OldEnds, Read),
            (NewEnds, Write),
            (ForceOut, Write),
        ],
        Pass::PressureForce => &[
            (Head, Read),
            (Begin, Read),
            (NewPosition, Read),
            (NewVelocity, Read),
            (NewDensityPressure, Read),
            (Previous, Read),
            (Free, Read),
            (NewAcceleration, Write),
        ],
        Pass::PressureCorrect => &[
            (Head, Atomic),
            (Begin, Read),
            (NewPosition, Read),
            (NewVelocity, Read),
            (NewAcceleration, Read),
            (Previous, Read),
            (NewDensityPressure, Write),
        ],
        Pass::PressureSettle | Pass::Commit => &[(Head, Atomic)],
        Pass::Heat => &[
            (Head, Read),
            (Begin, Read),
            (NewPosition, Read),
            (NewVelocity, Read),
            (NewDensityPressure, Read),
            (Ahead, Read),
            (Previous, Read),
            (NewHeat, Write),
        ],
        Pass::Smooth => &[
            (Head, Read),
            (Begin, Read),
            (NewPosition, Read),
            (NewVelocity, Read),
            (NewDensityPressure, Read),
            (Ahead, Read),
            (Previous, Read),
            (NewSmoothing, Write),
        ],
        Pass::Coat => &[(Head, Read), (Begin, Read), (NewPosition, Read), (Bare, Read), (NewId, Read), (Birth, Write)],
        Pass::Air => &[
            (Head, Atomic),
            (NewPosition, Write),
            (NewVelocity, Write),
            (NewAcceleration, Write),
            (NewDensityPressure, Write),
            (Bare, Read),
            (Birth, Write),
            (SlotOf, Read),
        ],
        Pass::Foresee => &[
            (Head, Read),
            (NewVelocity, Read),
            (NewAcceleration, Read),
            (Earlier, Read),
            (NewHistory, Read),
            (Ahead, Write),
        ],
        Pass::IntegrateAfter => &[
            (Head, Read),
            (NewPosition, Write),
            (NewVelocity, Write),
            (NewAcceleration, Read),
            (Earlier, Read),
            (Ahead, Read),
            (NewHistory, Write),
        ],
        Pass::Look => &[
            (Head, Atomic),
            (NewPosition, Read),
            (NewVelocity, Read),
            (NewAcceleration, Read),
            (NewDensityPressure, Read),
            (NewHeat, Read),
            (NewHistory, Read),
            (NewId, Read),
        ],
    }
}

/// Over what the threads of a pass are counted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Threads {
    /// One a particle.
    Particles,
    /// One work group.
    OneGroup,
}

/// Threads of a pass.
#[must_use]
pub fn threads(pass: Pass) -> Threads {
    match pass {
        Pass::Scan | Pass::PressureSettle | Pass::Air | Pass::Commit => Threads::OneGroup,
        _ => Threads::Particles,
    }
}

/// Threads of a work group of a pass.
#[must_use]
pub fn workgroup(pass: Pass) -> u32 {
    // where the only group is wide, each of its threads walks its share of all cells, or of all particles
    if matches!(pass, Pass::Scan | Pass::Air) { 256 } else { millpond_core::layout::WORKGROUP }
}

/// WGSL declarations of the arrays of a pass.
#[must_use]
pub fn declarations(pass: Pass) -> String {
    let atomic = arrays(pass).contains(&(Array::Head, Access::Atomic));
    let mut out = if atomic { Status::WGSL.replace(": u32", ": atomic<u32>") } else { Status::WGSL.to_owned() };
    out += if atomic {
        "struct Head { status: Status, counter: array<atomic<u32>> }\n"
    } else {
        "struct Head { status: Status, counter: array<u32> }\n"
    };
    for (i, (array, access)) in arrays(pass).iter().enumerate() {
        let mode = if *access == Access::Read { "read" } else { "read_write" };
        let (name, kind) = (array.name(), array.type_name());
        out += &format!("@group(0) @binding({}) var<storage, {mode}> {name}: {kind};\n", i as u32 + UNIFORMS);
    }
    out
}
