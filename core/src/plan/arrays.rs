//! The table of arrays: name, element type, what there is one entry for, what it is for, and when it exists. Views,
//! memory requirements, buffers and bindings of a device, comparisons and saved bytes all follow from it.
use crate::layout::{Model, f32x4, u32x2, u32x4};
use crate::terms::integrate::{has_history, needs_predicted_velocity, needs_start_acceleration};

/// Hands the table to a macro. A row is: name, for [`State`](crate::memory::State) the quantity that errors name,
/// element type, unit, condition; and, for an array that a step sorts, the array that its entries come from.
///
/// - `State`: what a step makes and the next one reads. There are two of each, of which one is the fluid; one that a scene never
///   changes (`constant`) there is once.
/// - `Index`: which slot a particle lies in. Two of each, but slots are nobody's business: neither compared nor saved.
/// - `Sorting`: what a step works in until the particles are sorted. On the CPU these lie where the neighbour lists come to lie after them.
/// - `Scratch`: what a step works in and forgets.
/// - `Given`: what is made at the start, or set by the host, and only read by steps.
macro_rules! with_arrays {
    ($callback:ident) => {
        $callback! {
            State {
                /// Position, m; w: mass over that of a particle of the fluid at rest.
                position as Position: f32x4 per Particle, if |_| true, from moved_position;
                /// Velocity, m/s; w: material.
                velocity as Velocity: f32x4 per Particle, if |_| true, from moved_velocity;
                /// Acceleration at that position, m/s2; w: with a tension by curvature the curvature of the surface,
                /// 1/m.
                acceleration as Acceleration: f32x4 per Particle, if |_| true;
                /// Density over the rest density less one, pressure and near pressure in Pa, volume in m3
                /// ([`QUANTITIES`](crate::layout::QUANTITIES)).
                density_pressure as Density: f32x4 per Particle, if |_| true;
                /// Velocity to move with beside a particle's own, m/s; w unused. Only with XSPH.
                xsph_velocity as XsphVelocity: f32x4 per Particle, if |m| m.has_xsph == 1;
                /// Thermal energy, J/kg, and its rate, W/kg; z and w unused. Only where a scene keeps account of heat.
                internal_energy as InternalEnergy: f32x4 per Particle, if |m| m.has_internal_energy == 1,
                    from internal_energy@old;
                /// Inward normal of the surface of a particle's fluid, 1/m; w: the surface's curvature by the Laplacian
                /// of the colour, 1/m, where tension takes that. Only where normals are found.
                normal as Normal: f32x4 per Particle, if |m| m.has_normals == 1;
                /// What the integrator remembers of the steps before: the last displacement, m, or the acceleration
                /// before, m/s2; w unused. Only with integrators that do.
                history as History: f32x4 per Particle, if |m| has_history(m), from history@old;
                /// Springs, those of each particle side by side: id of the particle at the other end, and as the bits
                /// of an f32 the length at rest in m, negative once the spring is broken. Only with elastic fluids.
                spring_ends as SpringLength: u32x2 per SpringEnd, if |m| m.has_springs == 1, constant if |m| m.is_plastic == 0;
            }
            Index {
                /// Which particle lies in a slot.
                id: u32 per Particle, if |_| true;
                /// Slot of each particle, by id.
                slot_of_id: u32 per Particle, if |_| true;
            }
            Sorting {
                /// Slot before the step of each slot after it.
                source_slot: u32 per Particle, if |_| true;
                /// Positions at which the forces are evaluated, m, in the slots before the step; w: mass.
                moved_position: f32x4 per Particle, if |_| true;
                /// Velocities that forces are evaluated with, m/s, in the slots before the step; w: material.
                moved_velocity: f32x4 per Particle, if |_| true;
                /// Cell of each particle, by its slot before the step.
                cell: u32 per Particle, if |_| true;
                /// How many of its cell were counted before it.
                rank: u32 per Particle, if |_| true;
                /// Slots before the step, cell by cell, in no order inside a cell. Only with the index sort.
                cell_members: u32 per Particle, if |m| m.cell_places == 0;
            }
            Scratch {
                /// Particles of each cell (the CUDA design's counters).
                grid_cell_counters: u32 per Cell, if |_| true;
                /// Slots before the step of the particles in each cell, a fixed number of places a cell. Only with cell
                /// lists.
                grid_cells: u32 per CellPlace, if |m| m.cell_places > 0;
                /// First slot of each cell.
                cell_start: u32 per Cell, if |_| true;
                /// Neighbour lists of groups of particles: their ranges, then the codes of the neighbours, two a word.
                neighbours: u32 per NeighbourWord, if |_| true;
                /// Density and pressures before the step, in the slots after it. Only where a step needs them.
                previous_density_pressure: f32x4 per Particle, if |m| m.needs_previous(), from density_pressure@old;
                /// Support radius of each particle over the scene's. Only where they vary.
                support_ratio: f32 per Particle, if |m| m.has_variable_support == 1;
                /// Acceleration but for pressure, m/s2; w as in the acceleration. Only where pressure is iterated.
                non_pressure_acceleration: f32x4 per Particle, if |m| m.corrects_pressure();
                /// Accelerations at the beginning of the step, in the slots after it, m/s2. Only with integrators that
                /// need them at its end.
                start_acceleration: f32x4 per Particle, if |m| needs_start_acceleration(m), from acceleration@old;
                /// Velocities at the end of the step, m/s; w: material. Only where pairs need them before.
                end_velocity: f32x4 per Particle, if |m| needs_predicted_velocity(m);
                /// Gradient of the colour of all fluids together, 1/m; w: 1 where a particle of liquid is exposed, else
                /// 0. Only with air.
                total_colour_gradient: f32x4 per Particle, if |m| m.has_air == 1;
                /// 1 for a particle beside which one of air is wanted, else 0; behind these a queue for devices. Only
                /// with air.
                spawn_requested: u32 per SpawnRequest, if |m| m.has_air == 1;
            }
            Given {
                /// By id: first of a particle's spring ends, how many, and as the bits of an f32 `k / (2 m)` in 1/s2; w
                /// unused.
                spring_ranges: u32x4 per Particle, if |m| m.has_springs == 1;
                /// Kernels as tables, one after the other. Only where kernels are read from there.
                kernel_tables: f32 per TableWord, if |m| m.reads_tables();
                /// Nodes of the host's acceleration field, m/s2, x fastest; w unused. Only where a scene has one.
                acceleration_field: f32x4 per FieldPoint, if |m| m.has_acceleration_field == 1;
            }
        }
    };
}
pub(crate) use with_arrays;

/// What an array has one entry for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unit {
    /// A particle.
    Particle,
    /// A cell.
    Cell,
    /// A place of a cell, with cell lists.
    CellPlace,
    /// A word of the neighbour lists: a fixed number a particle.
    NeighbourWord,
    /// An end of a spring.
    SpringEnd,
    /// A particle, and then each particle of air that there can be.
    SpawnRequest,
    /// A node of the host's field.
    FieldPoint,
    /// A word of the kernel tables.
    TableWord,
}

/// What an array is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Class {
    /// A step reads one and makes the other; both are what the fluid is.
    State,
    /// The same, of where particles lie in memory.
    Index,
    /// A step works in it until the particles are sorted.
    Sorting,
    /// A step works in it.
    Scratch,
    /// Steps only read it.
    Given,
}

/// Which of an array's copies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// Of the state before the step.
    Old,
    /// Of the state that the step makes.
    New,
    /// The only one there is.
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

/// A side by its name, none being the only one.
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
    ($class:ident, $name:ident, $type:ident, $unit:ident, $exists:expr, [$($constant:expr)?], [$($source:ident $(@ $side:ident)?)?]) => {{
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
            if $state_exists:expr $(, constant if $constant:expr)? $(, from $state_from:ident $(@ $state_side:ident)?)?;)* }
        $($class:ident { $($(#[$doc:meta])* $name:ident: $type:ident per $unit:ident,
            if $exists:expr $(, from $from:ident $(@ $side:ident)?)?;)* })*
    ) => {
        /// An array, by its name.
        #[expect(non_camel_case_types, reason = "an array has one name, in Rust, in WGSL and in reports")]
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum Array { $($(#[$state_doc])* $state,)* $($($(#[$doc])* $name,)*)* }

        /// A quantity of a particle that can stop being finite: an array of the state.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum Quantity { $($(#[$state_doc])* $quantity,)* }

        impl Array {
            /// All of them, those of the state first.
            pub const ALL: &[Array] = &[$(Array::$state,)* $($(Array::$name,)*)*];

            const ROWS: &[Row] = &[
                $(row!(State, $state, $state_type, $state_unit, $state_exists, [$($constant)?],
                    [$($state_from $(@ $state_side)?)?]),)*
                $($(row!($class, $name, $type, $unit, $exists, [], [$($from $(@ $side)?)?]),)*)*
            ];
        }

        impl Quantity {
            /// All of them, in the order of the arrays.
            pub const ALL: &[Quantity] = &[$(Quantity::$quantity,)*];
        }
    };
}
with_arrays!(declare);

impl Array {
    /// How many there are.
    pub const COUNT: usize = Array::ALL.len();

    fn row(self) -> &'static Row {
        &Array::ROWS[self as usize]
    }

    /// Its name.
    #[must_use]
    pub fn name(self) -> &'static str {
        self.row().name
    }

    /// The type of its elements, in Rust and in WGSL.
    #[must_use]
    pub fn element(self) -> &'static str {
        self.row().element
    }

    /// Words of an element, of four bytes each.
    #[must_use]
    pub fn words(self) -> usize {
        self.row().words
    }

    /// What it has one entry for.
    #[must_use]
    pub fn unit(self) -> Unit {
        self.row().unit
    }

    /// What it is for.
    #[must_use]
    pub fn class(self) -> Class {
        self.row().class
    }

    /// Does it exist by this model?
    #[must_use]
    pub fn exists(self, model: &Model) -> bool {
        (self.row().exists)(model)
    }

    /// Copies of it by this model: 0, 1 or 2.
    #[must_use]
    pub fn copies(self, model: &Model) -> usize {
        let Row { class, exists, constant, .. } = self.row();
        let two = matches!(class, Class::State | Class::Index) && !constant(model);
        if exists(model) { 1 + usize::from(two) } else { 0 }
    }

    /// The array that its entries are taken from once slots are known, where a step sorts it.
    #[must_use]
    pub fn source(self) -> Option<(Array, Side)> {
        self.row().source
    }

    /// Are its elements four floats?
    #[must_use]
    pub fn is_vector(self) -> bool {
        self.element() == stringify!(f32x4)
    }

    /// The arrays that a fluid consists of, by this model.
    pub fn of_state(model: &Model) -> impl Iterator<Item = Array> {
        Array::ALL.iter().copied().filter(|array| array.class() == Class::State && array.exists(model))
    }
}

impl Quantity {
    /// By the number of its array, as a status word holds it.
    #[must_use]
    pub fn from_word(word: u32) -> Quantity {
        Quantity::ALL.get(word as usize).copied().unwrap_or(Quantity::Position)
    }
}
