//! Memory as preallocated arrays, to be lent to the solver.
//!
//! [`Storage`] is all zero, so as a `static` it lies in .bss and costs the binary nothing. The solver itself only sees
//! [`Memory`], slices of any origin, and so is compiled once for every capacity.
use crate::layout::{TABLE_WORDS, f32x4, u32x2, u32x4};
use crate::memory::{LIST_ENTRIES, Memory, Scratch, Springs, State};

/// Memory for `N` particles and `CELLS` cells.
///
/// As a `static`, or on the heap by `bytemuck::zeroed_box`, it never meets the stack, which a large one would overflow.
///
/// ```
/// use millpond_core::Storage;
/// static STORAGE: Storage<4096, 32768> = Storage::new();
/// assert!(size_of_val(&STORAGE) < 4096 * 512);
/// ```
#[derive(Debug, bytemuck::Zeroable)]
pub struct Storage<const N: usize, const CELLS: usize> {
    vectors: [[[f32x4; N]; 4]; 2],
    ids: [[u32; N]; 2],
    slot: [u32; N],
    cell: [u32; N],
    rank: [u32; N],
    order: [u32; N],
    block: [[u32; 2]; N],
    list: [[u32; LIST_ENTRIES]; N],
    begin: [u32; CELLS],
    counter: [u32; CELLS],
}

/// Memory for the places of the cell lists, where a scene uses them.
#[derive(Debug, bytemuck::Zeroable)]
pub struct CellPlaces<const CELLS: usize, const PLACES: usize> {
    places: [[u32; PLACES]; CELLS],
}

/// Memory for what only some choices need, as much of each as [`Needs`](crate::Needs) says: `Extras::<N, 0, 0, 0>` for XSPH alone.
///
/// `SMOOTHING` entries for XSPH, `HEAT` for thermal energy, `PREVIOUS` for the continuity equation, variable supports and the
/// pressure correction, `FREE` for the pressure correction: the number of particles, or 0.
#[derive(Debug, bytemuck::Zeroable)]
pub struct Extras<const SMOOTHING: usize, const HEAT: usize, const PREVIOUS: usize, const FREE: usize> {
    smoothing: [[f32x4; SMOOTHING]; 2],
    heat: [[f32x4; HEAT]; 2],
    previous: [f32x4; PREVIOUS],
    free: [f32x4; FREE],
}

/// Memory for what only some integrators need, as much of each as [`Needs`](crate::Needs) says.
///
/// `HISTORY` entries for what Verlet's and Beeman's remember, `EARLIER` for those whose step ends with the acceleration at its
/// beginning too, `AHEAD` for thermal energy, XSPH and forces that are evaluated again: the number of particles, or 0.
#[derive(Debug, bytemuck::Zeroable)]
pub struct TimeStorage<const HISTORY: usize, const EARLIER: usize, const AHEAD: usize> {
    history: [[f32x4; HISTORY]; 2],
    earlier: [f32x4; EARLIER],
    ahead: [f32x4; AHEAD],
}

/// Memory for the normals of surfaces, where a scene finds them.
#[derive(Debug, bytemuck::Zeroable)]
pub struct SurfaceStorage<const N: usize> {
    normal: [[f32x4; N]; 2],
}

/// Memory for the springs of elastic fluids, two `ENDS` a spring; `CHANGING` is as many where lengths at rest change, else 0.
#[derive(Debug, bytemuck::Zeroable)]
pub struct SpringStorage<const N: usize, const ENDS: usize, const CHANGING: usize> {
    of: [u32x4; N],
    ends: [u32x2; ENDS],
    changing: [u32x2; CHANGING],
    slot_of: [u32; N],
}

/// Memory for a coat of air; `N` is that of [`Storage`], of all particles.
#[derive(Debug, bytemuck::Zeroable)]
pub struct AirStorage<const N: usize> {
    bare: [f32x4; N],
    birth: [u32; N],
    slot_of: [u32; N],
}

/// Memory for kernels as tables.
#[derive(Debug, bytemuck::Zeroable)]
pub struct TableStorage([f32; TABLE_WORDS]);

/// Memory for a field of the host's with so many nodes.
#[derive(Debug, bytemuck::Zeroable)]
pub struct FieldStorage<const NODES: usize>([f32x4; NODES]);

impl<const N: usize, const CELLS: usize> Storage<N, CELLS> {
    /// All zero.
    #[must_use]
    pub const fn new() -> Self {
        Storage {
            vectors: [[[[0.0; 4]; N]; 4]; 2],
            ids: [[0; N]; 2],
            slot: [0; N],
            cell: [0; N],
            rank: [0; N],
            order: [0; N],
            block: [[0; 2]; N],
            list: [[0; LIST_ENTRIES]; N],
            begin: [0; CELLS],
            counter: [0; CELLS],
        }
    }

    /// Lends all of it, for a scene with the index sort.
    pub fn lend(&mut self) -> Memory<'_> {
        let [first, second] = &mut self.vectors;
        let [first_id, second_id] = &mut self.ids;
        Memory {
            states: [State::bare(first, first_id), State::bare(second, second_id)],
            slot: &mut self.slot,
            scratch: Scratch {
                cell: &mut self.cell,
                rank: &mut self.rank,
                order: &mut self.order,
                block: &mut self.block,
                list: self.list.as_flattened_mut(),
                begin: &mut self.begin,
                counter: &mut self.counter,
                grid_cells: &mut [],
                previous: &mut [],
                free: &mut [],
                earlier: &mut [],
                ahead: &mut [],
                slot_of: &mut [],
                bare: &mut [],
                birth: &mut [],
            },
            springs: Springs { of: &mut [], ends: [&mut [], &mut []] },
            tables: &mut [],
            field: &mut [],
        }
    }

    /// Lends all of it and `places`, for a scene with cell lists.
    pub fn lend_with<'m, const P: usize>(&'m mut self, places: &'m mut CellPlaces<CELLS, P>) -> Memory<'m> {
        let mut memory = self.lend();
        memory.scratch.grid_cells = places.places.as_flattened_mut();
        memory
    }
}

impl<'m> State<'m> {
    /// Of the four arrays that every scene has.
    fn bare<const N: usize>(vectors: &'m mut [[f32x4; N]; 4], id: &'m mut [u32]) -> State<'m> {
        let [position, velocity, acceleration, density_pressure] = vectors;
        State {
            position,
            velocity,
            acceleration,
            density_pressure,
            smoothing: &mut [],
            heat: &mut [],
            normal: &mut [],
            history: &mut [],
            id,
        }
    }
}

impl<'m> Memory<'m> {
    /// And what only some choices need.
    ///
    /// ```
    /// use millpond_core::{Extras, Storage};
    /// let mut extras = Box::new(Extras::<4096, 0, 0, 0>::new());
    /// let mut storage = Box::new(Storage::<4096, 32768>::new());
    /// let memory = storage.lend().with_extras(&mut extras);
    /// ```
    #[must_use]
    pub fn with_extras<const S: usize, const H: usize, const P: usize, const F: usize>(
        mut self,
        extras: &'m mut Extras<S, H, P, F>,
    ) -> Memory<'m> {
        let [smoothing, other_smoothing] = &mut extras.smoothing;
        let [heat, other_heat] = &mut extras.heat;
        let [a, b] = &mut self.states;
        (a.smoothing, b.smoothing) = (smoothing, other_smoothing);
        (a.heat, b.heat) = (heat, other_heat);
        (self.scratch.previous, self.scratch.free) = (&mut extras.previous, &mut extras.free);
        self
    }

    /// And what only some integrators need.
    ///
    /// ```
    /// use millpond_core::{Storage, TimeStorage};
    /// let mut beeman = Box::new(TimeStorage::<4096, 4096, 0>::new());
    /// let mut storage = Box::new(Storage::<4096, 32768>::new());
    /// let memory = storage.lend().with_time(&mut beeman);
    /// ```
    #[must_use]
    pub fn with_time<const H: usize, const E: usize, const A: usize>(
        mut self,
        time: &'m mut TimeStorage<H, E, A>,
    ) -> Memory<'m> {
        let [a, b] = &mut self.states;
        let [history, other_history] = &mut time.history;
        (a.history, b.history) = (history, other_history);
        (self.scratch.earlier, self.scratch.ahead) = (&mut time.earlier, &mut time.ahead);
        self
    }

    /// And normals of surfaces.
    #[must_use]
    pub fn with_surface<const N: usize>(mut self, surface: &'m mut SurfaceStorage<N>) -> Memory<'m> {
        let [a, b] = &mut self.states;
        let [normal, other_normal] = &mut surface.normal;
        (a.normal, b.normal) = (normal, other_normal);
        self
    }

    /// And springs.
    ///
    /// ```
    /// use millpond_core::{SpringStorage, Storage};
    /// let mut springs = Box::new(SpringStorage::<4096, 73728, 0>::new());
    /// let mut storage = Box::new(Storage::<4096, 32768>::new());
    /// let memory = storage.lend().with_springs(&mut springs);
    /// ```
    #[must_use]
    pub fn with_springs<const N: usize, const ENDS: usize, const CHANGING: usize>(
        mut self,
        springs: &'m mut SpringStorage<N, ENDS, CHANGING>,
    ) -> Memory<'m> {
        self.springs = Springs { of: &mut springs.of, ends: [&mut springs.ends, &mut springs.changing] };
        self.scratch.slot_of = &mut springs.slot_of;
        self
    }

    /// And a coat of air. With springs, [`Memory::with_springs`] lends a part of the same, and either order will do.
    #[must_use]
    pub fn with_air<const N: usize>(mut self, air: &'m mut AirStorage<N>) -> Memory<'m> {
        let scratch = &mut self.scratch;
        (scratch.bare, scratch.birth, scratch.slot_of) = (&mut air.bare, &mut air.birth, &mut air.slot_of);
        self
    }

    /// And kernels as tables.
    #[must_use]
    pub fn with_tables(mut self, tables: &'m mut TableStorage) -> Memory<'m> {
        self.tables = &mut tables.0;
        self
    }

    /// And a field of the host's.
    #[must_use]
    pub fn with_field<const NODES: usize>(mut self, field: &'m mut FieldStorage<NODES>) -> Memory<'m> {
        self.field = &mut field.0;
        self
    }
}

macro_rules! all_zero {
    ($name:ident<$($n:ident),*> = $value:expr) => {
        impl<$(const $n: usize),*> $name<$($n),*> {
            /// All zero.
            #[must_use]
            pub const fn new() -> Self {
                $value
            }
        }

        impl<$(const $n: usize),*> Default for $name<$($n),*> {
            fn default() -> Self {
                Self::new()
            }
        }
    };
}

all_zero!(CellPlaces<CELLS, PLACES> = CellPlaces { places: [[0; PLACES]; CELLS] });
all_zero!(Extras<S, H, P, F> = Extras {
    smoothing: [[[0.0; 4]; S]; 2],
    heat: [[[0.0; 4]; H]; 2],
    previous: [[0.0; 4]; P],
    free: [[0.0; 4]; F],
});
all_zero!(TimeStorage<H, E, A> = TimeStorage {
    history: [[[0.0; 4]; H]; 2],
    earlier: [[0.0; 4]; E],
    ahead: [[0.0; 4]; A],
});
all_zero!(SurfaceStorage<N> = SurfaceStorage { normal: [[[0.0; 4]; N]; 2] });
all_zero!(SpringStorage<N, ENDS, CHANGING> = SpringStorage {
    of: [[0; 4]; N],
    ends: [[0; 2]; ENDS],
    changing: [[0; 2]; CHANGING],
    slot_of: [0; N],
});
all_zero!(AirStorage<N> = AirStorage { bare: [[0.0; 4]; N], birth: [0; N], slot_of: [0; N] });
all_zero!(TableStorage<> = TableStorage([0.0; TABLE_WORDS]));
all_zero!(FieldStorage<NODES> = FieldStorage([[0.0; 4]; NODES]));

impl<const N: usize, const CELLS: usize> Default for Storage<N, CELLS> {
    fn default() -> Self {
        Self::new()
    }
}
