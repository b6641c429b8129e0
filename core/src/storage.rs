//! Memory: preallocated arrays, lent to the solver as slices.
//!
//! [`Storage`] is all zero, so as a `static` it lies in .bss and costs the binary nothing. The solver itself only sees
//! [`Memory`], slices of any origin, and so is compiled once for every capacity.
use crate::error::SceneError;
use crate::layout::f32x4;
use crate::scene::{GridStructure, Scene};

/// Entries of the neighbour lists for each particle. A block whose list is full walks its stencil again; 25 was the
/// largest mean seen in moving fluid of 27 to 32 neighbours.
pub const LIST_ENTRIES: usize = 32;

/// The arrays of one state. A step reads one and writes the other.
#[derive(Debug)]
pub struct State<'m> {
    /// Position, m; w unused.
    pub position: &'m mut [f32x4],
    /// Velocity, m/s; w unused.
    pub velocity: &'m mut [f32x4],
    /// Acceleration at that position, m/s2; w unused.
    pub acceleration: &'m mut [f32x4],
    /// [`QUANTITIES`](crate::layout::QUANTITIES) of each particle.
    pub density_pressure: &'m mut [f32x4],
    /// Which particle stands in a slot.
    pub id: &'m mut [u32],
}

/// What a step works in and forgets.
#[derive(Debug)]
pub struct Scratch<'m> {
    /// Cell of each particle, by its slot before the step.
    pub cell: &'m mut [u32],
    /// How many of its cell came before it.
    pub rank: &'m mut [u32],
    /// Slot before the step of each slot after it.
    pub order: &'m mut [u32],
    /// Per block of lanes, at its first slot: where its neighbour list begins and how long it is.
    pub block: &'m mut [[u32; 2]],
    /// Neighbour lists of the blocks.
    pub list: &'m mut [u32],
    /// First slot of each cell.
    pub begin: &'m mut [u32],
    /// Particles of each cell.
    pub counter: &'m mut [u32],
    /// Places of the cells; empty with the index sort.
    pub grid_cells: &'m mut [u32],
}

/// All the memory of a simulation. It may be larger than a scene needs.
#[derive(Debug)]
pub struct Memory<'m> {
    /// The two states.
    pub states: [State<'m>; 2],
    /// Slot of each particle, by id.
    pub slot: &'m mut [u32],
    /// What a step works in and forgets.
    pub scratch: Scratch<'m>,
}

/// How much memory a scene needs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Needs {
    /// Particles.
    pub particles: usize,
    /// Cells.
    pub cells: usize,
    /// Places of all cells; 0 with the index sort.
    pub places: usize,
}

impl Needs {
    /// Of a scene that [`Scene::check`] accepts.
    #[must_use]
    pub fn of(scene: &Scene) -> Needs {
        let cells = scene.cells().iter().map(|&n| n as usize).product();
        let places = match scene.grid.structure {
            GridStructure::IndexSort => 0,
            GridStructure::CellLists { places } => places as usize * cells,
        };
        Needs { particles: scene.particle_count(), cells, places }
    }

    /// The arrays, with their bytes.
    #[must_use]
    pub fn arrays(&self) -> [(&'static str, usize); 12] {
        let Needs { particles, cells, places } = *self;
        let (vectors, words) = (2 * particles * size_of::<f32x4>(), particles * size_of::<u32>());
        let of_cells = cells * size_of::<u32>();
        [
            ("position", vectors),
            ("velocity", vectors),
            ("acceleration", vectors),
            ("density_pressure", vectors),
            ("id", 2 * words),
            ("slot", words),
            ("cell, rank, order", 3 * words),
            ("block", 2 * words),
            ("neighbour lists", LIST_ENTRIES * words),
            ("begin", of_cells),
            ("counter", of_cells),
            ("grid_cells", places * size_of::<u32>()),
        ]
    }

    /// Bytes of the arrays.
    #[must_use]
    pub fn bytes(&self) -> usize {
        self.arrays().iter().map(|(_, bytes)| bytes).sum()
    }
}

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
        let [[p0, v0, a0, d0], [p1, v1, a1, d1]] = &mut self.vectors;
        let [id0, id1] = &mut self.ids;
        Memory {
            states: [
                State { position: p0, velocity: v0, acceleration: a0, density_pressure: d0, id: id0 },
                State { position: p1, velocity: v1, acceleration: a1, density_pressure: d1, id: id1 },
            ],
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
            },
        }
    }

    /// Lends all of it and `places`, for a scene with cell lists.
    pub fn lend_with<'m, const P: usize>(&'m mut self, places: &'m mut CellPlaces<CELLS, P>) -> Memory<'m> {
        let mut memory = self.lend();
        memory.scratch.grid_cells = places.places.as_flattened_mut();
        memory
    }
}

impl<const N: usize, const CELLS: usize> Default for Storage<N, CELLS> {
    fn default() -> Self {
        Self::new()
    }
}

impl<const CELLS: usize, const PLACES: usize> CellPlaces<CELLS, PLACES> {
    /// All zero.
    #[must_use]
    pub const fn new() -> Self {
        CellPlaces { places: [[0; PLACES]; CELLS] }
    }
}

impl<const CELLS: usize, const PLACES: usize> Default for CellPlaces<CELLS, PLACES> {
    fn default() -> Self {
        Self::new()
    }
}

impl<'m> Memory<'m> {
    /// Exactly what `needs` says, or what is missing. Neighbour lists may have any length, 0 included.
    pub(crate) fn cut(self, needs: Needs) -> Result<Memory<'m>, SceneError> {
        let Needs { particles, cells, places } = needs;
        let [a, b] = self.states;
        let s = self.scratch;
        // entries are named by u32
        let entries = s.list.len().min(u32::MAX as usize);
        let list = &mut s.list[..entries];
        Ok(Memory {
            states: [a.cut(particles)?, b.cut(particles)?],
            slot: cut("particles", self.slot, particles)?,
            scratch: Scratch {
                cell: cut("particles", s.cell, particles)?,
                rank: cut("particles", s.rank, particles)?,
                order: cut("particles", s.order, particles)?,
                block: cut("particles", s.block, particles)?,
                list,
                begin: cut("cells", s.begin, cells)?,
                counter: cut("cells", s.counter, cells)?,
                grid_cells: cut("places of cells", s.grid_cells, places)?,
            },
        })
    }
}

impl<'m> State<'m> {
    fn cut(self, particles: usize) -> Result<State<'m>, SceneError> {
        Ok(State {
            position: cut("particles", self.position, particles)?,
            velocity: cut("particles", self.velocity, particles)?,
            acceleration: cut("particles", self.acceleration, particles)?,
            density_pressure: cut("particles", self.density_pressure, particles)?,
            id: cut("particles", self.id, particles)?,
        })
    }
}

fn cut<'m, T>(what: &'static str, lent: &'m mut [T], needed: usize) -> Result<&'m mut [T], SceneError> {
    let capacity = lent.len();
    lent.get_mut(..needed).ok_or(SceneError::CapacityExceeded { what, needed, capacity })
}
