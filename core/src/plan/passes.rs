//! The table of passes: name, when it runs, how many threads a device gives it, and what it reads and writes there. A pass is its row,
//! a Rust file, a WGSL file of the same name, and a `mod` line.
use super::arrays::{Array, Side, side};
use crate::layout::Model;
use crate::terms::integrate::needs_predicted_velocity;

/// Hands the table to a macro, in the order of a step. A row is: name, folder and file, threads on a device, what it does to the status,
/// condition, and the arrays that it reads and writes on a device, in the order of their bindings: `@old` and `@new` are the two
/// states', `@force` is where forces are collected (the new acceleration, or that without pressure). Of these a device binds those that
/// exist by the plan; on the CPU a pass takes its arrays itself.
///
/// - `particles`: a thread a particle. `cells`: a work group a block of cells. `group`: one work group. `host`: nothing to do on a device, whose threads walk their cells
///   themselves.
/// - `status`: `reads` it; or `counts` in it by atomics, and in the cells' counters behind it.
#[doc(hidden)]
#[macro_export]
macro_rules! with_passes {
    ($callback:ident) => {
        $callback! {
            /// Moves the particles to where the forces are evaluated: the first half of the integrator.
            IntegrateBefore: a_move / integrate_before, particles, reads, if |_| true, [
                read position@old, read velocity@old, read acceleration@old, read xsph_velocity@old, read history@old,
                write moved_position, write moved_velocity];
            /// Finds the cell of each particle, and counts the particles of each cell.
            Count: b_sort / count, particles, counts, if |_| true, [
                read moved_position, read moved_velocity, read id@old, write cell, write rank];
            /// Gives each particle a place of its cell (cell lists).
            CellLists: b_sort / cell_lists, particles, counts, if |m| m.cell_places > 0, [
                read cell, read rank, write grid_cells];
            /// Finds the first slot of each cell.
            Scan: b_sort / scan, cells, reads, if |_| true, [write cell_start];
            /// Puts the particles cell by cell (index sort).
            Scatter: b_sort / scatter, particles, reads, if |m| m.cell_places == 0, [
                read cell, read rank, read cell_start, write cell_members];
            /// Sorts the particles of each cell by their ids.
            SortById: b_sort / sort_by_id, particles, reads, if |_| true, [
                read cell, read rank, read cell_start, read id@old, read grid_cells, read cell_members, write source_slot,
                write id@new];
            /// Notes the slot of each id.
            IndexIds: b_sort / index_ids, particles, reads, if |_| true, [read id@new, write slot_of_id@new];
            /// Moves an array into the slots; runs once for each array that a step sorts.
            Gather: b_sort / gather, particles, reads, if |_| true, [read source_slot];
            /// Finds the support radius of each particle (where they vary).
            Support: c_density / support, particles, reads, if |m| m.has_variable_support == 1, [
                read previous_density_pressure, write support_ratio];
            /// Lists the neighbours of each particle. Where density follows from distances alone, the density pass does that; the half
            /// stencil makes no lists.
            Neighbours: c_density / neighbours, host, reads, if |m| m.makes_lists() && !m.sums_distances(), [];
            /// Computes density, pressure and volume.
            Density: c_density / density, particles, reads, if |_| true, [
                read cell_start, read position@new, read velocity@new, read previous_density_pressure, read support_ratio,
                write density_pressure@new];
            /// Computes accelerations; without pressure where that is iterated.
            Force: d_forces / force, particles, reads, if |_| true, [
                read cell_start, read position@new, read velocity@new, read density_pressure@new, read support_ratio,
                read acceleration_field, write acceleration@force];
            /// Finds the normals of surfaces (where somebody needs them).
            Normals: d_forces / normals, particles, reads, if |m| m.has_normals == 1, [
                read cell_start, read position@new, read velocity@new, read density_pressure@new, read support_ratio,
                write normal@new];
            /// Finds the particles of liquid that nothing covers (with air).
            Exposure: d_forces / exposure, particles, reads, if |m| m.has_air == 1, [
                read cell_start, read position@new, read velocity@new, read density_pressure@new, read support_ratio,
                write total_colour_gradient];
            /// Adds the acceleration by the curvature of surfaces (where they have a tension).
            Tension: d_forces / tension, particles, reads, if |m| m.has_curvature(), [
                read cell_start, read position@new, read velocity@new, read density_pressure@new, read support_ratio,
                read normal@new, write acceleration@force];
            /// Adds the acceleration by springs (where a fluid is elastic).
            Springs: d_forces / springs, particles, reads, if |m| m.has_springs == 1, [
                read position@new, read id@new, read slot_of_id@new, read spring_ranges, read spring_ends@old,
                write acceleration@force];
            /// Lets the lengths at rest of springs follow their strain (where they are plastic or brittle).
            SpringLengths: d_forces / spring_lengths, particles, reads, if |m| m.is_plastic == 1, [
                read position@new, read id@new, read slot_of_id@new, read spring_ranges, read spring_ends@old,
                write spring_ends@new];
            /// Adds the acceleration by pressure (where pressure is iterated; once more than the next two).
            PressureForce: e_pressure / pressure_force, particles, reads, if |m| m.corrects_pressure(), [
                read cell_start, read position@new, read velocity@new, read density_pressure@new, read support_ratio,
                read non_pressure_acceleration, write acceleration@new];
            /// Corrects the pressures by the density that they would lead to (where pressure is iterated).
            PressureCorrect: e_pressure / pressure_correct, particles, counts, if |m| m.corrects_pressure(), [
                read cell_start, read position@new, read velocity@new, read acceleration@new, read support_ratio,
                write density_pressure@new];
            /// Checks whether the iteration of pressure has converged.
            PressureConverged: e_pressure / pressure_converged, group, counts, if |m| m.corrects_pressure(), [];
            /// Predicts the velocities at the end of the step (where pairs need them).
            PredictVelocity: f_advance / predict_velocity, particles, reads, if |m| needs_predicted_velocity(m), [
                read velocity@new, read acceleration@new, read start_acceleration, read history@new,
                write end_velocity];
            /// Steps the thermal energy (where a scene keeps account of it).
            InternalEnergy: f_advance / internal_energy, particles, reads, if |m| m.has_internal_energy == 1, [
                read cell_start, read position@new, read velocity@new, read density_pressure@new, read end_velocity,
                read support_ratio, write internal_energy@new];
            /// Computes the velocities to move with (XSPH).
            Xsph: f_advance / xsph, particles, reads, if |m| m.has_xsph == 1, [
                read cell_start, read position@new, read velocity@new, read density_pressure@new, read end_velocity,
                read support_ratio, write xsph_velocity@new];
            /// Finds the particles beside which air is wanted (with air).
            SpawnRequests: f_advance / spawn_requests, particles, reads, if |m| m.has_air == 1, [
                read cell_start, read position@new, read total_colour_gradient, read id@new, write spawn_requested];
            /// Moves velocities and positions to the end of the step, and applies the penalty walls: the second half of the integrator.
            IntegrateAfter: f_advance / integrate_after, particles, reads, if |m| m.integrates_after(), [
                write position@new, write velocity@new, read acceleration@new, read start_acceleration,
                read end_velocity, write history@new];
            /// Makes air where it is wanted, and removes it where it is thin (with air).
            Spawn: g_finish / spawn, group, counts, if |m| m.has_air == 1, [
                write position@new, write velocity@new, write acceleration@new, write density_pressure@new,
                read total_colour_gradient, write spawn_requested, read slot_of_id@new];
            /// Checks that an array of the new state is finite; runs once for each.
            Validate: g_finish / validate, particles, counts, if |_| true, [read id@new];
            /// Finds the maxima that the next time step follows from (where it does).
            Measure: g_finish / measure, particles, counts, if |m| m.is_adaptive == 1, [
                read velocity@new, read acceleration@new, read density_pressure@new];
            /// Makes the step count, or says why it does not.
            Commit: g_finish / commit, group, counts, if |_| true, [];
        }
    };
}

/// What a pass does to an array.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Access {
    /// Reads it.
    Read,
    /// Writes it, or some of it.
    Write,
}

/// Which of the buffers of an array a pass binds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Bound {
    /// One of its copies.
    Copy(Side),
    /// Where forces are collected.
    Force,
}

/// An array that a pass binds on a device.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Binding {
    /// Which array.
    pub array: Array,
    /// Which of its buffers.
    pub bound: Bound,
    /// What for.
    pub access: Access,
}

/// How many threads a device gives a pass.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Threads {
    /// One a particle.
    Particles,
    /// A work group a block of cells.
    Cells,
    /// One work group.
    Group,
    /// None: the pass is the host's alone.
    Host,
}

macro_rules! bound {
    (force) => {
        Bound::Force
    };
    ($($side:ident)?) => {
        Bound::Copy(side!($($side)?))
    };
}

macro_rules! access {
    (read) => {
        Access::Read
    };
    (write) => {
        Access::Write
    };
}

macro_rules! threads {
    (particles) => {
        Threads::Particles
    };
    (cells) => {
        Threads::Cells
    };
    (group) => {
        Threads::Group
    };
    (host) => {
        Threads::Host
    };
}

macro_rules! counts {
    (reads) => {
        false
    };
    (counts) => {
        true
    };
}

macro_rules! declare {
    ($($(#[$doc:meta])* $pass:ident: $folder:ident / $file:ident, $threads:ident, $status:ident, if $runs:expr,
        [$($access:ident $array:ident $(@ $bound:ident)?),*];)*) => {
        /// The passes, in the order of a step.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum Pass { $($(#[$doc])* $pass,)* }

        impl Pass {
            /// All of them, in order.
            pub const ALL: [Pass; [$(Pass::$pass),*].len()] = [$(Pass::$pass),*];

            /// Name of its files here and on a device, and of its row in a benchmark.
            #[must_use]
            pub fn name(self) -> &'static str {
                match self { $(Pass::$pass => stringify!($file),)* }
            }

            /// Folder of its files.
            #[must_use]
            pub fn folder(self) -> &'static str {
                match self { $(Pass::$pass => stringify!($folder),)* }
            }

            /// Does it run by this model?
            #[must_use]
            pub fn runs(self, model: &Model) -> bool {
                let runs: fn(&Model) -> bool = match self { $(Pass::$pass => $runs,)* };
                runs(model)
            }

            /// Threads on a device.
            #[must_use]
            pub fn threads(self) -> Threads {
                match self { $(Pass::$pass => threads!($threads),)* }
            }

            /// Does it write to the status by atomics? Else it only reads it.
            #[must_use]
            pub fn counts(self) -> bool {
                match self { $(Pass::$pass => counts!($status),)* }
            }

            /// The arrays that it binds on a device, in the order of their bindings, those that a plan leaves out too.
            #[must_use]
            pub fn bindings(self) -> &'static [Binding] {
                match self {
                    $(Pass::$pass => &[$(Binding {
                        array: Array::$array,
                        bound: bound!($($bound)?),
                        access: access!($access),
                    }),*],)*
                }
            }
        }
    };
}
with_passes!(declare);
