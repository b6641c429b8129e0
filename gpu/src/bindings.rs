//! Which arrays each pass reads and writes: the one table from which bind groups and WGSL declarations are made.
use millpond_core::Pass;
use millpond_core::layout::Status;

/// An array on the device.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Array {
    /// The status, and after it the counters of the cells.
    Head,
    /// Old state.
    OldPosition,
    /// Old state.
    OldVelocity,
    /// Old state.
    OldAcceleration,
    /// Old state.
    OldId,
    /// New state.
    NewPosition,
    /// New state.
    NewVelocity,
    /// New state; before the force pass, where the moved velocities wait.
    NewAcceleration,
    /// New state; before the density pass, where the moved positions wait.
    NewDensityPressure,
    /// New state.
    NewId,
    /// Cell of each particle.
    Cell,
    /// Rank of each particle in its cell.
    Rank,
    /// First slot of each cell.
    Begin,
    /// Old slot of each new one.
    Order,
    /// Places of the cells.
    GridCells,
    /// What a gather reads.
    GatherFrom,
    /// What it writes.
    GatherTo,
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

/// The arrays of a pass, in the order of their bindings (binding 0 is the parameters). At most 8, wgpu's default limit.
#[must_use]
pub fn arrays(pass: Pass) -> &'static [(Array, Access)] {
    use Access::{Atomic, Read, Write};
    use Array::*;
    match pass {
        Pass::IntegrateBefore => &[
            (Head, Atomic),
            (OldPosition, Read),
            (OldVelocity, Read),
            (OldAcceleration, Read),
            (OldId, Read),
            (NewDensityPressure, Write),
            (NewAcceleration, Write),
            (Cell, Write),
        ],
        Pass::Count => &[(Head, Atomic), (Cell, Read), (Rank, Write)],
        Pass::CellLists => &[(Head, Atomic), (Cell, Read), (Rank, Read), (GridCells, Write)],
        Pass::Scan => &[(Head, Read), (Begin, Write)],
        Pass::Place => &[(Head, Read), (Cell, Read), (Rank, Read), (Begin, Read), (Order, Write)],
        Pass::Order => &[(Head, Read), (Begin, Read), (OldId, Read), (GridCells, Read), (Order, Write), (NewId, Write)],
        Pass::Gather => &[(Head, Read), (Order, Read), (GatherFrom, Read), (GatherTo, Write)],
        Pass::Density => &[(Head, Read), (Begin, Read), (NewPosition, Read), (NewDensityPressure, Write)],
        Pass::Force => &[
            (Head, Read),
            (Begin, Read),
            (NewPosition, Read),
            (NewVelocity, Read),
            (NewDensityPressure, Read),
            (NewAcceleration, Write),
        ],
        Pass::IntegrateAfter => &[
            (Head, Atomic),
            (NewPosition, Write),
            (NewVelocity, Write),
            (NewAcceleration, Read),
            (NewDensityPressure, Read),
            (NewId, Read),
        ],
        Pass::Commit => &[(Head, Atomic)],
    }
}

/// Over what the threads of a pass are counted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Threads {
    /// One a particle.
    Particles,
    /// One a cell.
    Cells,
    /// One work group.
    OneGroup,
}

/// Threads of a pass.
#[must_use]
pub fn threads(pass: Pass) -> Threads {
    match pass {
        Pass::Order => Threads::Cells,
        Pass::Scan | Pass::Commit => Threads::OneGroup,
        _ => Threads::Particles,
    }
}

/// Threads of a work group of a pass.
#[must_use]
pub fn workgroup(pass: Pass) -> u32 {
    // the scan's only group is wide: each of its threads walks its share of all cells
    if pass == Pass::Scan { 256 } else { millpond_core::layout::WORKGROUP }
}

impl Array {
    /// Its name in WGSL.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Array::Head => "head",
            Array::OldPosition => "old_position",
            Array::OldVelocity => "old_velocity",
            Array::OldAcceleration => "old_acceleration",
            Array::OldId => "old_id",
            Array::NewPosition => "new_position",
            Array::NewVelocity => "new_velocity",
            Array::NewAcceleration => "new_acceleration",
            Array::NewDensityPressure => "new_density_pressure",
            Array::NewId => "new_id",
            Array::Cell => "cell",
            Array::Rank => "rank",
            Array::Begin => "begin",
            Array::Order => "order",
            Array::GridCells => "grid_cells",
            Array::GatherFrom => "gather_from",
            Array::GatherTo => "gather_to",
        }
    }

    /// Its type in WGSL.
    fn type_name(self) -> &'static str {
        match self {
            Array::Head => "Head",
            Array::OldId
            | Array::NewId
            | Array::Cell
            | Array::Rank
            | Array::Begin
            | Array::Order
            | Array::GridCells => "array<u32>",
            _ => "array<f32x4>",
        }
    }
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
        out += &format!("@group(0) @binding({}) var<storage, {mode}> {name}: {kind};\n", i + 1);
    }
    out
}
