//! One step: the passes and their order.
use crate::error::StepError;
use crate::executor::Executor;
use crate::grid::Cells;
use crate::layout::{NONE, Status, f32x4, u32x2, u32x4};
use crate::memory::{Scratch, State};
use crate::passes::local::Particles;
use crate::passes::p10_force::Force;
use crate::passes::p11_normals::{Bare, Normals};
use crate::passes::p12_tension::Tension;
use crate::passes::p13_springs::{self, Sprung};
use crate::passes::p14_pressure_force::PressureForce;
use crate::passes::p15_pressure_correct::PressureCorrect;
use crate::passes::p18_heat::Heat;
use crate::passes::p19_smooth::Smooth;
use crate::passes::p20_coat::{self, Coated};
use crate::passes::p23_look::Seen;
use crate::passes::pairs::{self, Lists};
use crate::passes::{
    Setup, p01_integrate_before, p02_count, p03_cell_lists, p04_scan, p05_place, p06_order, p07_gather, p08_support,
    p09_density, p16_pressure_settle, p17_foresee, p21_integrate_after, p22_air, p23_look, p24_commit,
};
use crate::terms::integrate::{has_history, needs_earlier};

/// Declares the passes once: name, what it does, name of its file.
macro_rules! passes {
    ($($(#[$doc:meta])* $pass:ident = $name:literal,)*) => {
        /// The passes of a step, in the order in which they run.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum Pass { $($(#[$doc])* $pass,)* }

        impl Pass {
            /// All of them, in order.
            pub const ALL: [Pass; [$($name),*].len()] = [$(Pass::$pass),*];

            /// Name of its file here, of its shader, of its row in a benchmark.
            #[must_use]
            pub fn name(self) -> &'static str {
                match self { $(Pass::$pass => $name,)* }
            }
        }
    };
}

passes! {
    /// To where the forces are evaluated.
    IntegrateBefore = "p01_integrate_before",
    /// Cell of each particle, particles of each cell.
    Count = "p02_count",
    /// Places of each cell (cell lists).
    CellLists = "p03_cell_lists",
    /// First slot of each cell.
    Scan = "p04_scan",
    /// Slot of each particle (index sort).
    Place = "p05_place",
    /// Ids ascending inside each cell.
    Order = "p06_order",
    /// Particles into their slots.
    Gather = "p07_gather",
    /// Support radii (where they vary).
    Support = "p08_support",
    /// Density and pressures.
    Density = "p09_density",
    /// Accelerations.
    Force = "p10_force",
    /// Normals of surfaces (where somebody needs them), of all that is there (with air).
    Normals = "p11_normals",
    /// Accelerations by the curvature of surfaces (where they have a tension).
    Tension = "p12_tension",
    /// Accelerations by springs (where a fluid is elastic).
    Springs = "p13_springs",
    /// Accelerations by pressure (where it is corrected; once more than the next two).
    PressureForce = "p14_pressure_force",
    /// Pressures (where they are corrected).
    PressureCorrect = "p15_pressure_correct",
    /// Whether that will do.
    PressureSettle = "p16_pressure_settle",
    /// Velocities at the end of the step (where pairs need them).
    Foresee = "p17_foresee",
    /// Thermal energy (where it is kept account of).
    Heat = "p18_heat",
    /// Velocities to move with (XSPH).
    Smooth = "p19_smooth",
    /// Where air is to be made (with air).
    Coat = "p20_coat",
    /// Velocities and places at the end of the step, penalty walls.
    IntegrateAfter = "p21_integrate_after",
    /// Air is made, and vanishes (with air).
    Air = "p22_air",
    /// Is all finite? And what the next time step follows from.
    Look = "p23_look",
    /// The step counts, or says why not.
    Commit = "p24_commit",
}

/// What a step came to, of corrected pressure and of air.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Settled {
    /// Iterations made.
    pub iterations: u32,
    /// Largest density miss of the last one, over the rest density.
    pub residual: f32,
    /// Births of air for which no particle was left.
    pub refused: u32,
}

/// Springs, by id, and their ends before and, where lengths at rest change, after a step.
pub(crate) struct SpringEnds<'a> {
    pub of: &'a [u32x4],
    pub old: &'a [u32x2],
    pub new: &'a mut [u32x2],
}

/// Makes `new` from `old`, or says why it cannot; `old` stays as it was. `begins` is told of each pass before it runs.
/// Pressure is iterated at most `iterations` times.
pub(crate) fn run(
    setup: Setup<'_>,
    executor: &impl Executor,
    begins: &mut dyn FnMut(Pass),
    (steps, iterations): (u32, u32),
    old: &State<'_>,
    new: &mut State<'_>,
    (s, springs): (&mut Scratch<'_>, SpringEnds<'_>),
) -> Result<(Settled, Seen), StepError> {
    let (m, p) = (setup.model, setup.parameters);
    let places = m.cell_places;
    let fine = Status::fine(steps);

    arrange(setup, executor, begins, &fine, old, new, s)?;
    let sorted = Cells { begin: s.begin, counter: s.counter };

    begins(Pass::Density);
    let unknown =
        Particles { position: new.position, velocity: new.velocity, density_pressure: &[], previous: s.previous };
    p09_density::run(setup, executor, sorted, unknown, new.density_pressure, s.block, s.list);
    let lists = Lists { sorted, block: s.block, list: s.list };
    let mut settled = Settled::default();
    let known = Particles { density_pressure: new.density_pressure, ..unknown };
    let sprung = Sprung { position: new.position, id: new.id, slot_of: s.slot_of, of: springs.of, ends: springs.old };
    // what pressure is added to later stands by itself
    let driven = if m.corrects_pressure() { &mut *s.free } else { &mut *new.acceleration };
    begins(Pass::Force);
    pairs::run(setup, executor, known, lists, &Force, driven);
    if m.normals == 1 || m.air == 1 {
        begins(Pass::Normals);
    }
    if m.normals == 1 {
        pairs::run(setup, executor, known, lists, &Normals, new.normal);
    }
    if m.air == 1 {
        pairs::run(setup, executor, known, lists, &Bare, s.bare);
    }
    pull(setup, executor, begins, known, lists, (new.normal, sprung), driven);
    if m.plastic == 1 {
        p13_springs::give_way(setup, executor, sprung, springs.new);
    }
    if m.corrects_pressure() {
        for _ in 0..iterations {
            begins(Pass::PressureForce);
            let known = Particles { density_pressure: new.density_pressure, ..unknown };
            pairs::run(setup, executor, known, lists, &PressureForce { free: s.free }, new.acceleration);
            begins(Pass::PressureCorrect);
            let correct = PressureCorrect { acceleration: new.acceleration };
            let residual = pairs::run(setup, executor, unknown, lists, &correct, new.density_pressure);
            begins(Pass::PressureSettle);
            settled = Settled { iterations: settled.iterations + 1, residual: f32::from_bits(residual), ..settled };
            if p16_pressure_settle::run(p, residual) {
                break;
            }
        }
        begins(Pass::PressureForce);
        let known = Particles { density_pressure: new.density_pressure, ..unknown };
        pairs::run(setup, executor, known, lists, &PressureForce { free: s.free }, new.acceleration);
    }

    let earlier = if needs_earlier(m) { &*s.earlier } else { &[] };
    if m.foresees() {
        begins(Pass::Foresee);
        p17_foresee::run(setup, executor, new, earlier, s.ahead);
    }
    let known = Particles { density_pressure: new.density_pressure, ..unknown };
    if m.thermal_energy == 1 {
        begins(Pass::Heat);
        pairs::run(setup, executor, known, lists, &Heat { ahead: s.ahead }, new.heat);
    }
    if m.xsph == 1 {
        begins(Pass::Smooth);
        pairs::run(setup, executor, known, lists, &Smooth { ahead: s.ahead }, new.smoothing);
    }
    if m.reevaluates == 1 {
        begins(Pass::Force);
        let known = Particles { velocity: s.ahead, ..known };
        pairs::run(setup, executor, known, lists, &Force, new.acceleration);
        pull(setup, executor, begins, known, lists, (new.normal, sprung), new.acceleration);
    }
    // while time stands still nothing is made
    let makes_air = m.air == 1 && p.time_step > 0.0;
    if makes_air {
        begins(Pass::Coat);
        let coated = Coated { sorted, position: new.position, bare: s.bare, id: new.id };
        p20_coat::run(setup, executor, coated, s.birth);
    }
    if m.integrates_after() {
        begins(Pass::IntegrateAfter);
        let ahead = if m.foresees() { &*s.ahead } else { &[] };
        p21_integrate_after::run(setup, executor, new, earlier, ahead);
    }
    if makes_air {
        begins(Pass::Air);
        settled.refused = p22_air::run(setup, new, (s.bare, s.birth), s.slot_of).refused;
    }
    begins(Pass::Look);
    let seen = p23_look::run(setup, executor, new);

    begins(Pass::Commit);
    p24_commit::verdict(&Status { not_finite: seen.not_finite, ..fine }, places)?;
    Ok((settled, seen))
}

/// Adds what has a pass of its own to the forces: tension by curvature, springs.
fn pull(
    setup: Setup<'_>,
    executor: &impl Executor,
    begins: &mut dyn FnMut(Pass),
    known: Particles<'_>,
    lists: Lists<'_>,
    (normal, sprung): (&[f32x4], Sprung<'_>),
    driven: &mut [f32x4],
) {
    if setup.model.has_curvature() {
        begins(Pass::Tension);
        pairs::run(setup, executor, known, lists, &Tension { normal }, driven);
    }
    if setup.model.springs == 1 {
        begins(Pass::Springs);
        p13_springs::run(setup, executor, sprung, driven);
    }
}

/// Moves the particles of `old` and puts them into their slots in `new`: all passes before the density.
fn arrange(
    setup: Setup<'_>,
    executor: &impl Executor,
    begins: &mut dyn FnMut(Pass),
    fine: &Status,
    old: &State<'_>,
    new: &mut State<'_>,
    s: &mut Scratch<'_>,
) -> Result<(), StepError> {
    let (m, places) = (setup.model, setup.model.cell_places);
    begins(Pass::IntegrateBefore);
    // the moved particles wait where densities and accelerations will stand
    let (waiting_position, waiting_velocity) = (&mut *new.density_pressure, &mut *new.acceleration);
    p01_integrate_before::run(setup, executor, old, waiting_position, waiting_velocity);

    begins(Pass::Count);
    let out_of_range = p02_count::find(setup, executor, [&*waiting_position, &*waiting_velocity], old.id, s.cell);
    p24_commit::verdict(&Status { out_of_range, ..*fine }, places)?;
    p02_count::run(s.cell, s.rank, s.counter);
    if places > 0 {
        begins(Pass::CellLists);
        let cell_full = p03_cell_lists::run(s.cell, s.rank, places, s.grid_cells);
        let cell_count = if cell_full == NONE { 0 } else { s.counter[cell_full as usize] };
        p24_commit::verdict(&Status { cell_full, cell_count, ..*fine }, places)?;
    }
    begins(Pass::Scan);
    p04_scan::run(s.counter, s.begin);
    if places == 0 {
        begins(Pass::Place);
        p05_place::run(s.cell, s.rank, s.begin, s.order);
    }
    begins(Pass::Order);
    let sorted = Cells { begin: s.begin, counter: s.counter };
    p06_order::run(setup, executor, sorted, (s.grid_cells, places), old.id, s.order, new.id);
    if m.springs == 1 || m.air == 1 {
        p06_order::find(new.id, s.slot_of);
    }
    begins(Pass::Gather);
    p07_gather::run(executor, s.order, waiting_position, new.position);
    p07_gather::run(executor, s.order, waiting_velocity, new.velocity);
    if m.needs_previous() {
        p07_gather::run(executor, s.order, old.density_pressure, s.previous);
    }
    if m.thermal_energy == 1 {
        p07_gather::run(executor, s.order, old.heat, new.heat);
    }
    if has_history(m) {
        p07_gather::run(executor, s.order, old.history, new.history);
    }
    if needs_earlier(m) {
        p07_gather::run(executor, s.order, old.acceleration, s.earlier);
    }
    if m.variable_support == 1 {
        begins(Pass::Support);
        p08_support::run(setup, executor, s.previous);
    }
    Ok(())
}
