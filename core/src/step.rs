//! One step: the passes and their order.
use crate::error::StepError;
use crate::executor::Executor;
use crate::grid::Cells;
use crate::layout::{NONE, Status};
use crate::passes::p09_force::Inputs;
use crate::passes::{
    Setup, p01_integrate_before, p02_count, p03_cell_lists, p04_scan, p05_place, p06_order, p07_gather, p08_density,
    p09_force, p10_integrate_after, p11_commit,
};
use crate::storage::{Scratch, State};

/// The passes of a step, in the order in which they run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pass {
    /// Half kick, drift, cell of each particle.
    IntegrateBefore,
    /// Particles of each cell.
    Count,
    /// Places of each cell (cell lists).
    CellLists,
    /// First slot of each cell.
    Scan,
    /// Slot of each particle (index sort).
    Place,
    /// Ids ascending inside each cell.
    Order,
    /// Particles into their slots.
    Gather,
    /// Density and pressures.
    Density,
    /// Accelerations.
    Force,
    /// Half kick, walls, a look for what is not finite.
    IntegrateAfter,
    /// The step counts, or says why not.
    Commit,
}

impl Pass {
    /// All of them, in order.
    pub const ALL: [Pass; 11] = [
        Pass::IntegrateBefore,
        Pass::Count,
        Pass::CellLists,
        Pass::Scan,
        Pass::Place,
        Pass::Order,
        Pass::Gather,
        Pass::Density,
        Pass::Force,
        Pass::IntegrateAfter,
        Pass::Commit,
    ];

    /// Name of its file here, of its shader, of its row in a benchmark.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Pass::IntegrateBefore => "p01_integrate_before",
            Pass::Count => "p02_count",
            Pass::CellLists => "p03_cell_lists",
            Pass::Scan => "p04_scan",
            Pass::Place => "p05_place",
            Pass::Order => "p06_order",
            Pass::Gather => "p07_gather",
            Pass::Density => "p08_density",
            Pass::Force => "p09_force",
            Pass::IntegrateAfter => "p10_integrate_after",
            Pass::Commit => "p11_commit",
        }
    }
}

/// Makes `new` from `old`, or says why it cannot; `old` stays as it was. `begins` is told of each pass before it runs.
pub(crate) fn run(
    setup: Setup<'_>,
    executor: &impl Executor,
    begins: &mut dyn FnMut(Pass),
    steps: u32,
    old: &State<'_>,
    new: &mut State<'_>,
    scratch: &mut Scratch<'_>,
) -> Result<(), StepError> {
    let places = setup.model.cell_places;
    let fine = Status::fine(steps);
    let s = scratch;

    begins(Pass::IntegrateBefore);
    // the moved particles wait where densities and accelerations will stand
    let (waiting_position, waiting_velocity) = (&mut *new.density_pressure, &mut *new.acceleration);
    let out_of_range = p01_integrate_before::run(setup, executor, old, waiting_position, waiting_velocity, s.cell);
    p11_commit::verdict(&Status { out_of_range, ..fine }, places)?;

    begins(Pass::Count);
    p02_count::run(s.cell, s.rank, s.counter);
    if places > 0 {
        begins(Pass::CellLists);
        let cell_full = p03_cell_lists::run(s.cell, s.rank, places, s.grid_cells);
        let cell_count = if cell_full == NONE { 0 } else { s.counter[cell_full as usize] };
        p11_commit::verdict(&Status { cell_full, cell_count, ..fine }, places)?;
    }
    begins(Pass::Scan);
    p04_scan::run(s.counter, s.begin);
    if places == 0 {
        begins(Pass::Place);
        p05_place::run(s.cell, s.rank, s.begin, s.order);
    }
    begins(Pass::Order);
    let sorted = Cells { begin: s.begin, counter: s.counter };
    p06_order::run(executor, sorted, (s.grid_cells, places), old.id, s.order, new.id);
    begins(Pass::Gather);
    p07_gather::run(executor, s.order, waiting_position, new.position);
    p07_gather::run(executor, s.order, waiting_velocity, new.velocity);

    begins(Pass::Density);
    p08_density::run(setup, executor, sorted, new.position, new.density_pressure, s.block, s.list);
    begins(Pass::Force);
    let inputs = Inputs {
        position: new.position,
        velocity: new.velocity,
        density_pressure: new.density_pressure,
        block: s.block,
        list: s.list,
    };
    p09_force::run(setup, executor, sorted, inputs, new.acceleration);
    begins(Pass::IntegrateAfter);
    let not_finite = p10_integrate_after::run(setup, executor, new);

    begins(Pass::Commit);
    p11_commit::verdict(&Status { not_finite, ..fine }, places)
}
