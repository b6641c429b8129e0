//! Memory as preallocated static arrays that are lent to the solver.
//!
//! [`Storage`] and [`Arena`] are initialised with zeros, so as a `static` they lie in .bss and add nothing to the size
//! of the binary. The solver itself only receives slices, wherever they come from, and is therefore compiled once for
//! all capacities.
use super::lend::Memory;
use super::requirements::{Requirements, list_words};
use crate::layout::{TABLE_WORDS, f32x4};
use crate::plan::arrays::Array;
use crate::scene::Dimension;

/// Memory for `N` particles and `CELLS` cells, with `PLACES` places per cell for cell lists (0, the default, for the
/// index sort). It contains by name the arrays that a scene with the default formulas needs, in a container or without
/// one. Arrays that only other features need come from an additional [`Arena`].
///
/// As a `static`, or allocated by `Storage::boxed`, it is never on the stack, which a large one would overflow.
///
/// ```
/// use millpond_core::Storage;
/// use std::sync::Mutex;
/// static STORAGE: Mutex<Storage<4096, 32768>> = Mutex::new(Storage::new());
/// let mut storage = STORAGE.lock().expect("nobody else holds it");
/// let memory = storage.lend();
/// ```
#[derive(Debug, bytemuck::Zeroable)]
pub struct Storage<const N: usize, const CELLS: usize, const PLACES: usize = 0> {
    position: [[f32x4; N]; 2],
    velocity: [[f32x4; N]; 2],
    acceleration: [[f32x4; N]; 2],
    density_pressure: [[f32x4; N]; 2],
    id: [[u32; N]; 2],
    slot_of_id: [[u32; N]; 2],
    neighbours: [[u32; USUAL_LIST_WORDS]; N],
    grid_cells: [[u32; PLACES]; CELLS],
    grid_cell_counters: [u32; CELLS],
    cell_start: [u32; CELLS],
    previous_density_pressure: [f32x4; N],
    kernel_tables: [f32; TABLE_WORDS],
}

/// Words of the neighbour lists per particle: enough for the default number of neighbours, in 2D and in 3D.
const USUAL_LIST_WORDS: usize = list_words(Dimension::Three.average_neighbours());

/// The arrays that a storage contains by name.
const NAMED: [Array; 12] = [
    Array::position,
    Array::velocity,
    Array::acceleration,
    Array::density_pressure,
    Array::id,
    Array::slot_of_id,
    Array::neighbours,
    Array::grid_cells,
    Array::grid_cell_counters,
    Array::cell_start,
    Array::previous_density_pressure,
    Array::kernel_tables,
];

impl<const N: usize, const CELLS: usize, const PLACES: usize> Storage<N, CELLS, PLACES> {
    /// A storage of zeros, for a `static`. On the heap use `Storage::boxed`, since a value of this size does not fit on
    /// the stack.
    #[must_use]
    #[expect(clippy::new_without_default, reason = "a default would be made on the stack")]
    #[expect(clippy::large_stack_arrays, reason = "it is evaluated for a static")]
    pub const fn new() -> Self {
        Storage {
            position: [[[0.0; 4]; N]; 2],
            velocity: [[[0.0; 4]; N]; 2],
            acceleration: [[[0.0; 4]; N]; 2],
            density_pressure: [[[0.0; 4]; N]; 2],
            id: [[0; N]; 2],
            slot_of_id: [[0; N]; 2],
            neighbours: [[0; USUAL_LIST_WORDS]; N],
            grid_cells: [[0; PLACES]; CELLS],
            grid_cell_counters: [0; CELLS],
            cell_start: [0; CELLS],
            previous_density_pressure: [[0.0; 4]; N],
            kernel_tables: [0.0; TABLE_WORDS],
        }
    }

    /// A storage of zeros on the heap. It is never on the stack.
    ///
    /// ```
    /// use millpond_core::Storage;
    /// let mut storage: Box<Storage<4096, 32768>> = Storage::boxed();
    /// let memory = storage.lend();
    /// ```
    #[cfg(feature = "alloc")]
    #[must_use]
    pub fn boxed() -> alloc::boxed::Box<Self> {
        bytemuck::zeroed_box()
    }

    /// Lends all of the memory.
    pub fn lend(&mut self) -> Memory<'_> {
        fn each<T, const M: usize, const COPIES: usize>(
            copies: &mut [[T; M]; COPIES],
        ) -> impl Iterator<Item = &mut [T]> {
            copies.iter_mut().map(<[T; M]>::as_mut_slice)
        }
        Memory::of_arena(&mut [])
            .with(Array::position, each(&mut self.position))
            .with(Array::velocity, each(&mut self.velocity))
            .with(Array::acceleration, each(&mut self.acceleration))
            .with(Array::density_pressure, each(&mut self.density_pressure))
            .with(Array::id, each(&mut self.id))
            .with(Array::slot_of_id, each(&mut self.slot_of_id))
            .with(Array::neighbours, [self.neighbours.as_flattened_mut()])
            .with(Array::grid_cells, [self.grid_cells.as_flattened_mut()])
            .with(Array::grid_cell_counters, [self.grid_cell_counters.as_mut_slice()])
            .with(Array::cell_start, [self.cell_start.as_mut_slice()])
            .with(Array::previous_density_pressure, [self.previous_density_pressure.as_mut_slice()])
            .with(Array::kernel_tables, [self.kernel_tables.as_mut_slice()])
    }
}

/// Memory for all arrays that a scene needs in addition to those of a [`Storage`], or for all arrays.
/// [`Requirements`](super::Requirements) give the number of bytes.
///
/// ```
/// use millpond_core::{Arena, Storage};
/// let mut storage: Box<Storage<4096, 32768>> = Storage::boxed();
/// let mut arena: Box<Arena<{ 1 << 20 }>> = Arena::boxed();
/// let memory = storage.lend().with_arena(&mut arena);
/// ```
#[derive(Debug, bytemuck::Zeroable)]
#[repr(C, align(64))]
pub struct Arena<const BYTES: usize>([u8; BYTES]);

impl<const BYTES: usize> Arena<BYTES> {
    /// An arena of zeros, for a `static`.
    #[must_use]
    #[expect(clippy::new_without_default, reason = "a default would be made on the stack")]
    pub const fn new() -> Self {
        Arena([0; BYTES])
    }

    /// An arena of zeros on the heap. It is never on the stack.
    #[cfg(feature = "alloc")]
    #[must_use]
    pub fn boxed() -> alloc::boxed::Box<Self> {
        bytemuck::zeroed_box()
    }

    /// Lends all of the memory, for use without a [`Storage`].
    pub fn lend(&mut self) -> Memory<'_> {
        Memory::of_arena(&mut self.0)
    }
}

impl<'m> Memory<'m> {
    /// Adds an arena for all arrays that are not lent by name.
    #[must_use]
    pub fn with_arena<const BYTES: usize>(self, arena: &'m mut Arena<BYTES>) -> Memory<'m> {
        self.with_arena_bytes(&mut arena.0)
    }
}

impl Requirements {
    /// Bytes of the arena needed in addition to a [`Storage`] whose number of places per cell is that of the scene's
    /// cell lists.
    #[must_use]
    pub fn arena_bytes_beside_storage(&self) -> usize {
        let optional = Array::ALL.iter().filter(|array| !NAMED.contains(array));
        optional.map(|&array| self.arena_bytes_of(array)).fold(0, usize::saturating_add)
    }
}
