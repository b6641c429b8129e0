//! The table of arrays: name, element type, what an entry stands for, purpose, and the condition under which the array
//! exists. Views, memory requirements, GPU buffers and bindings, comparisons and saved bytes are all derived from it.
use crate::layout::{Model, f32x4, u32x2, u32x4};
use crate::terms::integrate::{has_history, needs_predicted_velocity, needs_start_acceleration};
use crate::terms::shifting::drifts;
use crate::terms::wall::EXTRAPOLATED;

/// Hands the table to a macro. A row is: name, for [`State`](crate::memory::State) the quantity that errors name,
/// element type, unit, condition; and, for an array that a step sorts, the array from which its entries come. A slot is
/// the index of a particle in these arrays. Each step sorts the particles by cell, so a particle's slot changes; its id
/// does not.
///
/// - `State`: written by a step and read by the next one. There are two copies of each, of which one is the current
///   state. There is one copy of an array that a scene never changes (`constant`).
/// - `Index`: the slot of each particle. There are two copies of each. They are neither compared nor saved, because
///   slots are not part of the physical state.
/// - `Sorting`: used by a step until the particles are sorted. On the CPU these arrays lie in the memory of the
///   neighbour lists, which are made afterwards.
/// - `Scratch`: used only within a step.
/// - `Given`: set at the start or by the caller, and only read by steps.
macro_rules! with_arrays {
    ($callback:ident) => {
        $callback! {
            State {
                /// Position, m; w: mass over the mass of a particle of the same fluid at rest.
                position as Position: f32x4 per Particle, if |_| true, from moved_position;
                /// Velocity, m/s; w: material.
                velocity as Velocity: f32x4 per Particle, if |_| true, from moved_velocity;
                /// Acceleration at that position, m/s2; w: curvature of the surface, 1/m, with a surface tension by
                /// curvature.
                acceleration as Acceleration: f32x4 per Particle, if |_| true;
                /// Density over the rest density minus one, pressure and near pressure in Pa, volume in m3
                /// ([`QUANTITIES`](crate::layout::QUANTITIES)).
                density_pressure as Density: f32x4 per Particle, if |_| true;
                /// Velocity that is added to a particle's own to move it, m/s; w unused. Only with XSPH or shifting.
                drift_velocity as DriftVelocity: f32x4 per Particle, if |m| drifts(m);
                /// Internal energy, J/kg, and its rate, W/kg; z and w unused. Only in scenes that track internal
                /// energy.
                internal_energy as InternalEnergy: f32x4 per Particle, if |m| m.has_internal_energy == 1,
                    from internal_energy@old;
                /// Inward normal of the surface of a particle's fluid, 1/m; w: curvature of the surface by the
                /// Laplacian of the colour, 1/m, if the surface tension uses it. Only in scenes that compute normals.
                normal as Normal: f32x4 per Particle, if |m| m.has_normals == 1;
                /// Generation of a particle, which counts how often its id was used, and how long it still lives, s; z
                /// and w unused. Only if particles come and go.
                life as Life: f32x4 per Particle, if |m| m.has_turnover == 1, from life@old;
                /// Time since the last layer of an emitter, s, what it lost to rounding, how long the emitter still
                /// runs, s, and the number of its layers. Only with emitters.
                emitter_state as Emission: f32x4 per Emitter, if |m| m.has_emitters == 1;
                /// Position, rotation, velocity and angular velocity of each solid
                /// ([`POSE_STRIDE`](crate::layout::POSE_STRIDE) rows); then, for each side of a polygon, the corner at
                /// which it begins and the vector to its end, m, which never change. Only with solids.
                pose as Pose: f32x4 per PoseRow, if |m| m.has_solids == 1;
                /// What the integrator needs of previous steps: the last displacement, m, or the previous acceleration,
                /// m/s2; w unused. Only with integrators that need it.
                history as History: f32x4 per Particle, if |m| has_history(m), from history@old;
                /// Spring ends, those of each particle side by side: id of the particle at the other end, and the rest
                /// length in m as the bits of an f32, negative once the spring is broken. Only with elastic fluids.
                spring_ends as SpringLength: u32x2 per SpringEnd, if |m| m.has_springs == 1,
                    constant if |m| m.is_plastic == 0;
            }
            Index {
                /// Id of the particle in each slot.
                id: u32 per Particle, if |_| true;
                /// Slot of each particle, by id.
                slot_of_id: u32 per Particle, if |_| true;
            }
            Sorting {
                /// For each slot after the step, the particle's slot before the step.
                source_slot: u32 per Particle, if |_| true;
                /// Positions at which the forces are evaluated, m, in the slots before the step; w: mass as in the
                /// position.
                moved_position: f32x4 per Particle, if |_| true;
                /// Velocities with which the forces are evaluated, m/s, in the slots before the step; w: material.
                moved_velocity: f32x4 per Particle, if |_| true;
                /// Cell of each particle, by its slot before the step.
                cell: u32 per Particle, if |_| true;
                /// Rank of each particle within its cell: the number of particles of the cell that were counted before
                /// it.
                rank: u32 per Particle, if |_| true;
                /// Slots before the step, cell by cell, in any order within a cell. Only with the index sort.
                cell_members: u32 per Particle, if |m| m.cell_places == 0;
            }
            Scratch {
                /// Number of particles in each cell (the counters of the CUDA design, Pirovano, section 4.4.2).
                grid_cell_counters: u32 per Cell, if |_| true;
                /// Slots before the step of the particles in each cell, with a fixed number of places per cell. Only
                /// with cell lists.
                grid_cells: u32 per CellPlace, if |m| m.cell_places > 0;
                /// First slot of each cell.
                cell_start: u32 per Cell, if |_| true;
                /// Neighbour lists of groups of four particles: the range of each group, then the codes of the
                /// neighbours, two per word.
                neighbours: u32 per NeighbourWord, if |_| true;
                /// Density and pressures before the step, in the slots after it. Only if a step needs them.
                previous_density_pressure: f32x4 per Particle, if |m| m.needs_previous(), from density_pressure@old;
                /// Support radius of each particle over that of the scene. Only with variable support.
                support_ratio: f32 per Particle, if |m| m.has_variable_support == 1;
                /// Renormalised gradient of the density deviation before the step, 1/m; w: smallest eigenvalue lambda.
                /// Only if the diffusion of density, shifting or tensile control need them.
                renormalised_gradient: f32x4 per Particle, if |m| m.renormalises();
                /// Velocity of each particle as viscosity sees it, m/s; w: material. That of a wall particle is
                /// extrapolated from the fluid, and its w is its pressure in Pa until that is stored. Only with walls
                /// that are extrapolated.
                seen_velocity: f32x4 per Particle, if |m| m.wall_particles == EXTRAPOLATED;
                /// Acceleration without pressure, m/s2; w as in the acceleration. Only with pressure correction.
                non_pressure_acceleration: f32x4 per Particle, if |m| m.corrects_pressure();
                /// Accelerations at the start of the step, in the slots after it, m/s2. Only with integrators that need
                /// them at the end of the step.
                start_acceleration: f32x4 per Particle, if |m| needs_start_acceleration(m), from acceleration@old;
                /// Positions at the start of the step, in the slots after it, m. Only with solids.
                start_position: f32x4 per Particle, if |m| m.has_solids == 1, from position@old;
                /// Predicted velocities at the end of the step, m/s; w: material. Only if sums over pairs need them
                /// before they are final.
                end_velocity: f32x4 per Particle, if |m| needs_predicted_velocity(m);
                /// Gradient of the colour of all fluids together, 1/m; w: 1 for a particle of liquid at the free
                /// surface, else 0. Only with air.
                total_colour_gradient: f32x4 per Particle, if |m| m.has_air == 1;
                /// 1 for a particle beside which an air particle is requested, else 0; then, for the GPU, the queue of
                /// all requests. Only if particles can be inactive.
                spawn_requested: u32 per SpawnRequest, if |m| m.has_inactive == 1;
                /// For each point of an emitter two rows: the position of the particle that is to be made there, m, and
                /// how long it lives, s (0: none is to be made, -1: its place is taken); its velocity, m/s, and its
                /// material. Only with emitters.
                emission: f32x4 per EmitterRow, if |m| m.has_emitters == 1;
                /// What becomes of a particle: 0: it stays as it is, 1: it becomes inactive, 2 and more: it becomes
                /// that of a request, by number. Only if particles can be inactive.
                fate: u32 per Particle, if |m| m.has_inactive == 1;
            }
            Given {
                /// By id: first of a particle's spring ends, their number, and `k / (2 m)` in 1/s2 as the bits of an
                /// f32; w unused. Only with elastic fluids.
                spring_ranges: u32x4 per Particle, if |m| m.has_springs == 1;
                /// Tables of kernels and of what of them lies beyond a plane, one after the other. Only if kernels are
                /// read from tables, and with walls in closed form.
                kernel_tables: f32 per TableWord, if |m| m.has_tables();
                /// Nodes of the acceleration field supplied by the caller, m/s2, x fastest; w unused. Only in scenes
                /// with such a field.
                acceleration_field: f32x4 per FieldPoint, if |m| m.has_acceleration_field == 1;
                /// Time between two layers of an emitter, s, and how long its particles live, s; z and w unused. Only
                /// with emitters.
                emitters: f32x4 per Emitter, if |m| m.has_emitters == 1;
                /// For each point of an emitter two rows: its position, m, and the index of its emitter; the velocity
                /// of its particles, m/s, and their material. Only with emitters.
                emitter_points: f32x4 per EmitterRow, if |m| m.has_emitters == 1;
                /// By id: position of a particle of a solid in the frame of that solid, m; w: the number of the solid,
                /// or -1 for all other particles. Only if a solid with particles moves.
                anchor: f32x4 per Particle, if |m| m.has_carried == 1;
            }
        }
    };
}
pub(crate) use with_arrays;

/// What an entry of an array stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unit {
    /// A particle.
    Particle,
    /// A cell.
    Cell,
    /// A place of a cell, with cell lists.
    CellPlace,
    /// A word of the neighbour lists, of which each particle has a fixed number.
    NeighbourWord,
    /// An end of a spring.
    SpringEnd,
    /// A particle; after these, each particle that can become active.
    SpawnRequest,
    /// An emitter.
    Emitter,
    /// A row of the pose of a solid, or of a side of a polygon.
    PoseRow,
    /// A row of a point of an emitter, of which each point has two.
    EmitterRow,
    /// A node of the acceleration field supplied by the caller.
    FieldPoint,
    /// A word of the kernel tables.
    TableWord,
}

/// What an array is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Class {
    /// A step reads one copy and writes the other. Together these arrays are the state of the fluid.
    State,
    /// A step reads one copy and writes the other. These arrays say in which slots the particles lie.
    Index,
    /// A step uses it until the particles are sorted.
    Sorting,
    /// A step uses it, and nothing of it is kept.
    Scratch,
    /// Steps only read it.
    Given,
}

/// One of the copies of an array.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// The copy of the state before the step.
    Old,
    /// The copy of the state after the step.
    New,
    /// The only copy.
    Only,
}

/// A row of the table, as data.
struct Row {
    name: &'static str,
    element: &'static str,
    words: usize,
    unit: Unit,
    class: Class,
    exists: fn(&Model) -> bool,
    constant: fn(&Model) -> bool,
    source: Option<(Array, Side)>,
}

/// A side by its name. No name stands for the only copy.
macro_rules! side {
    () => {
        $crate::plan::arrays::Side::Only
    };
    (old) => {
        $crate::plan::arrays::Side::Old
    };
    (new) => {
        $crate::plan::arrays::Side::New
    };
}
pub(crate) use side;

macro_rules! row {
    ($class:ident, $name:ident, $type:ident, $unit:ident, $exists:expr, [$($constant:expr)?],
        [$($source:ident $(@ $side:ident)?)?]) => {{
        #[allow(unused_mut, unused_assignments, reason = "most rows have neither")]
        let mut constant: fn(&Model) -> bool = |_| false;
        #[allow(unused_mut, unused_assignments, reason = "most rows have neither")]
        let mut source = None;
        $(constant = $constant;)?
        $(source = Some((Array::$source, side!($($side)?)));)?
        let (name, element) = (stringify!($name), stringify!($type));
        let words = size_of::<$type>() / size_of::<u32>();
        Row { name, element, words, unit: Unit::$unit, class: Class::$class, exists: $exists, constant, source }
    }};
}

macro_rules! declare {
    (
        State { $($(#[$state_doc:meta])* $state:ident as $quantity:ident: $state_type:ident per $state_unit:ident,
            if $state_exists:expr $(, constant if $constant:expr)?
            $(, from $state_from:ident $(@ $state_side:ident)?)?;)* }
        $($class:ident { $($(#[$doc:meta])* $name:ident: $type:ident per $unit:ident,
            if $exists:expr $(, from $from:ident $(@ $side:ident)?)?;)* })*
    ) => {
        /// The arrays, by name.
        #[expect(non_camel_case_types, reason = "an array has one name, in Rust, in WGSL and in reports")]
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum Array { $($(#[$state_doc])* $state,)* $($($(#[$doc])* $name,)*)* }

        /// A particle's quantities that can become not finite: the arrays of the state.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum Quantity { $($(#[$state_doc])* $quantity,)* }

        impl Array {
            /// All arrays, those of the state first.
            pub const ALL: &[Array] = &[$(Array::$state,)* $($(Array::$name,)*)*];

            const ROWS: &[Row] = &[
                $(row!(State, $state, $state_type, $state_unit, $state_exists, [$($constant)?],
                    [$($state_from $(@ $state_side)?)?]),)*
                $($(row!($class, $name, $type, $unit, $exists, [], [$($from $(@ $side)?)?]),)*)*
            ];
        }

        impl Quantity {
            /// All quantities, in the order of their arrays.
            pub const ALL: &[Quantity] = &[$(Quantity::$quantity,)*];
        }
    };
}
with_arrays!(declare);

impl Array {
    /// Number of arrays.
    pub const COUNT: usize = Array::ALL.len();

    fn row(self) -> &'static Row {
        &Array::ROWS[self as usize]
    }

    /// Name of the array.
    #[must_use]
    pub fn name(self) -> &'static str {
        self.row().name
    }

    /// The type of its elements, in Rust and in WGSL.
    #[must_use]
    pub fn element(self) -> &'static str {
        self.row().element
    }

    /// Number of words of four bytes in an element.
    #[must_use]
    pub fn words(self) -> usize {
        self.row().words
    }

    /// What an entry of the array stands for.
    #[must_use]
    pub fn unit(self) -> Unit {
        self.row().unit
    }

    /// Purpose of the array.
    #[must_use]
    pub fn class(self) -> Class {
        self.row().class
    }

    /// Returns whether the array exists in a scene with this model.
    #[must_use]
    pub fn exists(self, model: &Model) -> bool {
        (self.row().exists)(model)
    }

    /// Number of copies of the array with this model: 0, 1 or 2.
    #[must_use]
    pub fn copies(self, model: &Model) -> usize {
        let Row { class, exists, constant, .. } = self.row();
        let two = matches!(class, Class::State | Class::Index) && !constant(model);
        if exists(model) { 1 + usize::from(two) } else { 0 }
    }

    /// The array from which its entries are taken once the slots are known, if a step sorts it.
    #[must_use]
    pub fn source(self) -> Option<(Array, Side)> {
        self.row().source
    }

    /// Returns whether its elements are four floats.
    #[must_use]
    pub fn is_vector(self) -> bool {
        self.element() == stringify!(f32x4)
    }

    /// The arrays that make up the state of the fluid with this model.
    pub fn of_state(model: &Model) -> impl Iterator<Item = Array> {
        Array::ALL.iter().copied().filter(|array| array.class() == Class::State && array.exists(model))
    }
}

impl Quantity {
    /// The quantity whose array has this number, as stored in a status word.
    #[must_use]
    pub fn from_word(word: u32) -> Quantity {
        Quantity::ALL.get(word as usize).copied().unwrap_or(Quantity::Position)
    }
}
