//! The table of passes: name, condition, number of GPU threads, and the arrays that the pass reads and writes on a GPU.
//! A pass consists of its row, a Rust file, a WGSL file of the same name, and a `mod` line.
use super::arrays::{Array, Side, side};
use crate::layout::Model;
use crate::terms::integrate::needs_predicted_velocity;
use crate::terms::shifting::NO_SHIFTING;
use crate::terms::wall::EXTRAPOLATED;

/// Hands the table to a macro, in the order of a step. A row is: name, folder and file, GPU threads, use of the status,
/// condition, and the arrays that the pass reads and writes on a GPU, in the order of their bindings. `@old` and `@new`
/// are the copies of the two states, and `@force` is the array in which forces are summed (the new acceleration, or the
/// acceleration without pressure). A GPU binds those arrays that exist by the plan; on the CPU a pass takes its arrays
/// itself.
///
/// - `particles`: one thread per particle. `cells`: one work group per block of cells. `group`: a single work group.
///   `host`: the pass runs only on the CPU, because each GPU thread searches its cells itself.
/// - `status`: a pass either `reads` the status, or `counts`: it writes by atomics to the status and to the counters of
///   the cells behind it.
#[doc(hidden)]
#[macro_export]
macro_rules! with_passes {
    ($callback:ident) => {
        $callback! {
            /// Moves the solids to where they are at the end of the step (with solids).
            MoveSolids: a_move / move_solids, group, reads, if |m| m.has_solids == 1, [read pose@old, write pose@new];
            /// Moves the particles to the positions at which the forces are evaluated: the first half of the
            /// integrator.
            IntegrateBefore: a_move / integrate_before, particles, reads, if |_| true, [
                read position@old, read velocity@old, read acceleration@old, read drift_velocity@old, read history@old,
                write moved_position, write moved_velocity];
            /// Carries the particles of solids along with them (if a solid with particles moves).
            Carry: a_move / carry, particles, reads, if |m| m.has_carried == 1, [
                read id@old, read anchor, read pose@new, write moved_position, write moved_velocity];
            /// Finds the cell of each particle, and counts the particles in each cell.
            Count: b_sort / count, particles, counts, if |_| true, [
                read moved_position, read moved_velocity, read id@old, write cell, write rank];
            /// Stores each particle in a place of its cell (cell lists).
            CellLists: b_sort / cell_lists, particles, counts, if |m| m.cell_places > 0, [
                read cell, read rank, write grid_cells];
            /// Finds the first slot of each cell.
            Scan: b_sort / scan, cells, reads, if |_| true, [write cell_start];
            /// Orders the particles by cell (index sort).
            Scatter: b_sort / scatter, particles, reads, if |m| m.cell_places == 0, [
                read cell, read rank, read cell_start, write cell_members];
            /// Sorts the particles of each cell by id.
            SortById: b_sort / sort_by_id, particles, reads, if |_| true, [
                read cell, read rank, read cell_start, read id@old, read grid_cells, read cell_members,
                write source_slot, write id@new];
            /// Records the slot of each id.
            IndexIds: b_sort / index_ids, particles, reads, if |_| true, [read id@new, write slot_of_id@new];
            /// Copies the entries of an array into the new slots; runs once for each array that a step sorts.
            Gather: b_sort / gather, particles, reads, if |_| true, [read source_slot];
            /// Finds the support radius of each particle (with variable support).
            Support: c_density / support, particles, reads, if |m| m.has_variable_support == 1, [
                read previous_density_pressure, write support_ratio];
            /// Lists the neighbours of each particle. If density depends only on distances, the density pass makes the
            /// lists instead. The half stencil makes no lists.
            Neighbours: c_density / neighbours, host, reads, if |m| m.makes_lists() && !m.sums_distances(), [];
            /// Computes renormalised gradients and lambda (if the diffusion of density, shifting or tensile control
            /// need them).
            Renormalise: c_density / renormalise, particles, reads, if |m| m.renormalises(), [
                read cell_start, read position@new, read velocity@new, read previous_density_pressure,
                read support_ratio, read acceleration_field, read pose@new, write renormalised_gradient];
            /// Computes density, pressure and volume.
            Density: c_density / density, particles, reads, if |_| true, [
                read cell_start, read position@new, read velocity@new, read previous_density_pressure,
                read support_ratio, read renormalised_gradient, read pose@new, write density_pressure@new];
            /// Takes pressure and velocity from the fluid to wall particles (with extrapolated walls).
            WallSums: c_density / wall_sums, particles, reads, if |m| m.wall_particles == EXTRAPOLATED, [
                read cell_start, read position@new, read velocity@new, read density_pressure@new, read support_ratio,
                read acceleration_field, write seen_velocity];
            /// Sets pressure, density and volume of wall particles (with extrapolated walls).
            WallStates: c_density / wall_states, particles, reads, if |m| m.wall_particles == EXTRAPOLATED, [
                read position@new, read velocity@new, write density_pressure@new, write seen_velocity];
            /// Computes accelerations; with pressure correction, those without pressure.
            Force: d_forces / force, particles, reads, if |_| true, [
                read cell_start, read position@new, read velocity@new, read density_pressure@new, read support_ratio,
                read acceleration_field, read seen_velocity, read renormalised_gradient, read pose@new,
                write acceleration@force];
            /// Finds the normals of surfaces (if the surface tension or the caller needs them).
            Normals: d_forces / normals, particles, reads, if |m| m.has_normals == 1, [
                read cell_start, read position@new, read velocity@new, read density_pressure@new, read support_ratio,
                read pose@new, write normal@new];
            /// Finds the particles of liquid at the free surface (with air).
            Exposure: d_forces / exposure, particles, reads, if |m| m.has_air == 1, [
                read cell_start, read position@new, read velocity@new, read density_pressure@new, read support_ratio,
                read pose@new, write total_colour_gradient];
            /// Adds the acceleration by the curvature of surfaces (with a surface tension by curvature).
            Tension: d_forces / tension, particles, reads, if |m| m.has_curvature(), [
                read cell_start, read position@new, read velocity@new, read density_pressure@new, read support_ratio,
                read normal@new, write acceleration@force];
            /// Adds the acceleration by springs (with elastic fluids).
            Springs: d_forces / springs, particles, reads, if |m| m.has_springs == 1, [
                read position@new, read id@new, read slot_of_id@new, read spring_ranges, read spring_ends@old,
                write acceleration@force];
            /// Changes the rest lengths of springs according to their strain (with plastic or brittle springs).
            SpringLengths: d_forces / spring_lengths, particles, reads, if |m| m.is_plastic == 1, [
                read position@new, read id@new, read slot_of_id@new, read spring_ranges, read spring_ends@old,
                write spring_ends@new];
            /// Adds the acceleration by pressure (with pressure correction; runs once more than the next two passes).
            PressureForce: e_pressure / pressure_force, particles, reads, if |m| m.corrects_pressure(), [
                read cell_start, read position@new, read velocity@new, read density_pressure@new, read support_ratio,
                read acceleration_field, read non_pressure_acceleration, read pose@new, write acceleration@new];
            /// Corrects the pressures by the error of the density that they would lead to (with pressure correction).
            PressureCorrect: e_pressure / pressure_correct, particles, counts, if |m| m.corrects_pressure(), [
                read cell_start, read position@new, read velocity@new, read acceleration@new, read support_ratio,
                read pose@new, write density_pressure@new];
            /// Checks whether the pressure iteration has converged.
            PressureConverged: e_pressure / pressure_converged, group, counts, if |m| m.corrects_pressure(), [];
            /// Predicts the velocities at the end of the step (if sums over pairs need them).
            PredictVelocity: f_advance / predict_velocity, particles, reads, if |m| needs_predicted_velocity(m), [
                read velocity@new, read acceleration@new, read start_acceleration, read history@new,
                write end_velocity];
            /// Advances the internal energy (in scenes that track it).
            InternalEnergy: f_advance / internal_energy, particles, reads, if |m| m.has_internal_energy == 1, [
                read cell_start, read position@new, read velocity@new, read density_pressure@new, read end_velocity,
                read support_ratio, write internal_energy@new];
            /// Computes the XSPH velocities (with XSPH).
            Xsph: f_advance / xsph, particles, reads, if |m| m.has_xsph == 1, [
                read cell_start, read position@new, read velocity@new, read density_pressure@new, read end_velocity,
                read support_ratio, write drift_velocity@new];
            /// Computes the velocities of the shifting of particles (with shifting).
            Shift: f_advance / shift, particles, reads, if |m| m.shifting != NO_SHIFTING, [
                read cell_start, read position@new, read velocity@new, read density_pressure@new, read support_ratio,
                read renormalised_gradient, read pose@new, write drift_velocity@new];
            /// Finds the particles that request an air particle beside them (with air).
            SpawnRequests: f_advance / spawn_requests, particles, reads, if |m| m.has_air == 1, [
                read cell_start, read position@new, read total_colour_gradient, read id@new, read pose@new,
                write spawn_requested];
            /// Finds the points of emitters at which a particle is to be made (with emitters).
            Emit: f_advance / emit, particles, reads, if |m| m.has_emitters == 1, [
                read cell_start, read position@new, read total_colour_gradient, read spawn_requested,
                read emitter_points, read emitters, read pose@new, read emitter_state@old, write emitter_state@new,
                write emission];
            /// Advances velocities and positions to the end of the step, and applies the penalty planes: the second
            /// half of the integrator.
            IntegrateAfter: f_advance / integrate_after, particles, reads, if |m| m.integrates_after(), [
                write position@new, write velocity@new, read acceleration@new, read start_acceleration,
                read end_velocity, write history@new];
            /// Puts particles that came into a solid back to its surface, and reflects their velocities (with solids).
            Contact: f_advance / contact, particles, counts, if |m| m.has_solids == 1, [
                read start_position, write position@new, write velocity@new, read acceleration@new, write history@new,
                read pose@old, read pose@new];
            /// Finds the particles that become inactive: air that is too thin, what drains take, and what has lived long
            /// enough (if particles can be inactive).
            Leave: g_finish / leave, particles, reads, if |m| m.has_inactive == 1, [
                read position@new, read velocity@new, read density_pressure@new, read id@new, write life@new,
                write fate];
            /// Gives each request an inactive particle, in the order of ids (if particles can be inactive).
            Spawn: g_finish / spawn, group, counts, if |m| m.has_inactive == 1, [
                read velocity@new, read emission, write spawn_requested, read slot_of_id@new, write fate];
            /// Sets the particles that come and go (if particles can be inactive).
            Renew: g_finish / renew, particles, reads, if |m| m.has_inactive == 1, [
                write position@new, write velocity@new, write acceleration@new, write density_pressure@new,
                write life@new, read total_colour_gradient, read emission, read fate];
            /// Checks that an array of the new state is finite; runs once for each array.
            Validate: g_finish / validate, particles, counts, if |_| true, [read id@new];
            /// Finds the maxima that determine the next time step (with adaptive steps).
            Measure: g_finish / measure, particles, counts, if |m| m.has_changing_step == 1, [
                read velocity@new, read acceleration@new, read density_pressure@new];
            /// Accepts the step, or reports why it failed.
            Commit: g_finish / commit, group, counts, if |_| true, [];
        }
    };
}

/// What a pass does to an array.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Access {
    /// Reads it.
    Read,
    /// Writes it, or parts of it.
    Write,
}

/// The buffer of an array that a pass binds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Bound {
    /// A copy of the array.
    Copy(Side),
    /// The array in which forces are summed.
    Force,
}

/// An array that a pass binds on a GPU.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Binding {
    /// The array.
    pub array: Array,
    /// Which of its buffers.
    pub bound: Bound,
    /// Whether the pass reads or writes it.
    pub access: Access,
}

/// How many GPU threads a pass gets.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Threads {
    /// One thread per particle.
    Particles,
    /// One work group per block of cells.
    Cells,
    /// One work group.
    Group,
    /// None: the pass runs only on the CPU.
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
            /// All passes, in order.
            pub const ALL: [Pass; [$(Pass::$pass),*].len()] = [$(Pass::$pass),*];

            /// Name of the pass, of its Rust and WGSL files, and of its row in a benchmark.
            #[must_use]
            pub fn name(self) -> &'static str {
                match self { $(Pass::$pass => stringify!($file),)* }
            }

            /// Folder of its files.
            #[must_use]
            pub fn folder(self) -> &'static str {
                match self { $(Pass::$pass => stringify!($folder),)* }
            }

            /// Returns whether the pass runs in a scene with this model.
            #[must_use]
            pub fn runs(self, model: &Model) -> bool {
                let runs: fn(&Model) -> bool = match self { $(Pass::$pass => $runs,)* };
                runs(model)
            }

            /// Threads on a GPU.
            #[must_use]
            pub fn threads(self) -> Threads {
                match self { $(Pass::$pass => threads!($threads),)* }
            }

            /// Returns whether the pass writes to the status by atomics. Otherwise it only reads the status.
            #[must_use]
            pub fn counts(self) -> bool {
                match self { $(Pass::$pass => counts!($status),)* }
            }

            /// The arrays that the pass binds on a GPU, in the order of their bindings, including those that a plan
            /// leaves out.
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
