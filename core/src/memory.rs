//! The memory of a simulation as slices of any origin, and how much of it a scene needs. What a scene does not use has no
//! entries.
use crate::error::SceneError;
use crate::layout::{TABLE_WORDS, Tables, f32x4, u32x2, u32x4};

/// Entries of the neighbour lists for each particle. A block whose list is full walks its stencil again; 25 was the
/// largest mean seen in moving fluid of 27 to 32 neighbours.
pub const LIST_ENTRIES: usize = 32;

/// The arrays of one state. A step reads one and writes the other.
#[derive(Debug)]
pub struct State<'m> {
    /// Position, m; w: mass over the scene's particle mass.
    pub position: &'m mut [f32x4],
    /// Velocity, m/s; w: which of the scene's kinds of particle.
    pub velocity: &'m mut [f32x4],
    /// Acceleration at that position, m/s2; w: with a tension by curvature the curvature of the surface, 1/m.
    pub acceleration: &'m mut [f32x4],
    /// [`QUANTITIES`](crate::layout::QUANTITIES) of each particle.
    pub density_pressure: &'m mut [f32x4],
    /// Velocity to move with beside a particle's own, m/s; w unused. Only with XSPH.
    pub smoothing: &'m mut [f32x4],
    /// Thermal energy, J/kg, and its rate, W/kg; z and w unused. Only where heat is kept account of.
    pub heat: &'m mut [f32x4],
    /// Inward normal of the surface of a particle's fluid, 1/m; w: the surface's curvature by the Laplacian of the colour, 1/m,
    /// where tension takes that. Only where normals are found.
    pub normal: &'m mut [f32x4],
    /// What the integrator remembers of the steps before: the last displacement, m, or the acceleration before, m/s2; w unused.
    /// Only with integrators that do.
    pub history: &'m mut [f32x4],
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
    /// Density and pressures before the step, in the slots after it; with variable supports the third is the support over
    /// the scene's. Only where a step needs them.
    pub previous: &'m mut [f32x4],
    /// Acceleration but for pressure, m/s2; w unused. Only where pressure is iterated.
    pub free: &'m mut [f32x4],
    /// Accelerations at the beginning of the step, in the slots after it, m/s2; w unused. Only with integrators that need them
    /// at its end.
    pub earlier: &'m mut [f32x4],
    /// Velocities at the end of the step, m/s; w: kind. Only where pairs need them before.
    pub ahead: &'m mut [f32x4],
    /// Slot of each particle in the step that is tried, by id. Only with springs or air.
    pub slot_of: &'m mut [u32],
    /// Gradient of the colour of all that is there, 1/m; w: 1 where a particle of liquid is bare, else 0. Only with air.
    pub bare: &'m mut [f32x4],
    /// 1 for a particle beside which one of air is to be made, else 0. Only with air.
    pub birth: &'m mut [u32],
}

/// Springs between particles, by what each particle has of them. Only with elastic fluids.
#[derive(Debug)]
pub struct Springs<'m> {
    /// By id: first of its ends, how many, and as the bits of an f32 `k / (2 m)` in 1/s2; w unused.
    pub of: &'m mut [u32x4],
    /// Ends of each particle side by side: who is at the other end, and as the bits of an f32 the length at rest in m, negative
    /// once the spring is broken. Two, which trade places at each step, where lengths at rest change; else the second is empty.
    pub ends: [&'m mut [u32x2]; 2],
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
    /// Springs of elastic fluids.
    pub springs: Springs<'m>,
    /// Kernels as tables, where a scene reads them from there.
    pub tables: &'m mut Tables,
    /// Nodes of the host's field, m/s2, x fastest; w unused. Only where a scene has one.
    pub field: &'m mut [f32x4],
}

/// How much memory a scene needs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Needs {
    /// Particles, those of walls too, and air that is not there yet.
    pub particles: usize,
    /// Cells.
    pub cells: usize,
    /// Places of all cells; 0 with the index sort.
    pub places: usize,
    /// Velocities to move with beside the particles' own: XSPH.
    pub smoothing: bool,
    /// Thermal energy.
    pub heat: bool,
    /// Densities and pressures of the step before.
    pub previous: bool,
    /// Accelerations but for pressure.
    pub free: bool,
    /// What an integrator remembers.
    pub history: bool,
    /// Accelerations at the beginning of a step.
    pub earlier: bool,
    /// Velocities at the end of a step.
    pub ahead: bool,
    /// Normals of surfaces.
    pub normals: bool,
    /// Springs.
    pub springs: bool,
    /// Ends of springs, two a spring.
    pub spring_ends: usize,
    /// Do their lengths at rest change?
    pub plastic: bool,
    /// A coat of air.
    pub air: bool,
    /// Kernels as tables.
    pub tables: bool,
    /// Nodes of the host's field.
    pub nodes: usize,
}

impl Needs {
    /// Entries of an array that exists only where it is needed.
    fn if_needed(&self, needed: bool) -> usize {
        if needed { self.particles } else { 0 }
    }

    /// Ends of springs in the state that a step makes.
    fn other_ends(&self) -> usize {
        if self.plastic { self.spring_ends } else { 0 }
    }

    /// The arrays, with their bytes.
    #[must_use]
    pub fn arrays(&self) -> [(&'static str, usize); 27] {
        let Needs { particles, cells, places, .. } = *self;
        let vector = size_of::<f32x4>();
        let (vectors, words) = (2 * particles * vector, particles * size_of::<u32>());
        let of_cells = cells * size_of::<u32>();
        [
            ("position", vectors),
            ("velocity", vectors),
            ("acceleration", vectors),
            ("density_pressure", vectors),
            ("smoothing", 2 * self.if_needed(self.smoothing) * vector),
            ("heat", 2 * self.if_needed(self.heat) * vector),
            ("id", 2 * words),
            ("slot", words),
            ("cell, rank, order", 3 * words),
            ("block", 2 * words),
            ("neighbour lists", LIST_ENTRIES * words),
            ("begin", of_cells),
            ("counter", of_cells),
            ("grid_cells", places * size_of::<u32>()),
            ("previous", self.if_needed(self.previous) * vector),
            ("free", self.if_needed(self.free) * vector),
            ("history", 2 * self.if_needed(self.history) * vector),
            ("earlier", self.if_needed(self.earlier) * vector),
            ("ahead", self.if_needed(self.ahead) * vector),
            ("normal", 2 * self.if_needed(self.normals) * vector),
            ("springs", self.if_needed(self.springs) * size_of::<u32x4>()),
            ("spring ends", (self.spring_ends + self.other_ends()) * size_of::<u32x2>()),
            ("slot_of", self.if_needed(self.springs || self.air) * size_of::<u32>()),
            ("bare", self.if_needed(self.air) * vector),
            ("birth", self.if_needed(self.air) * size_of::<u32>()),
            ("tables", if self.tables { TABLE_WORDS * size_of::<f32>() } else { 0 }),
            ("field", self.nodes * vector),
        ]
    }

    /// Bytes of the arrays.
    #[must_use]
    pub fn bytes(&self) -> usize {
        self.arrays().iter().map(|(_, bytes)| bytes).sum()
    }
}

impl<'m> Memory<'m> {
    /// Exactly what `needs` says, or what is missing. Neighbour lists may have any length, 0 included.
    pub(crate) fn cut(self, needs: &Needs) -> Result<Memory<'m>, SceneError> {
        let Needs { particles, cells, places, .. } = *needs;
        let [a, b] = self.states;
        let s = self.scratch;
        // entries are named by u32
        let entries = s.list.len().min(u32::MAX as usize);
        let list = &mut s.list[..entries];
        let tables = if needs.tables { TABLE_WORDS } else { 0 };
        let [ends, other_ends] = self.springs.ends;
        Ok(Memory {
            states: [a.cut(needs)?, b.cut(needs)?],
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
                previous: cut("extras for previous densities", s.previous, needs.if_needed(needs.previous))?,
                free: cut("extras for free accelerations", s.free, needs.if_needed(needs.free))?,
                earlier: cut("extras for earlier accelerations", s.earlier, needs.if_needed(needs.earlier))?,
                ahead: cut("extras for velocities ahead", s.ahead, needs.if_needed(needs.ahead))?,
                slot_of: cut("particles with springs or air", s.slot_of, needs.if_needed(needs.springs || needs.air))?,
                bare: cut("particles with air", s.bare, needs.if_needed(needs.air))?,
                birth: cut("particles with air", s.birth, needs.if_needed(needs.air))?,
            },
            springs: Springs {
                of: cut("particles with springs", self.springs.of, needs.if_needed(needs.springs))?,
                ends: [
                    cut("ends of springs", ends, needs.spring_ends)?,
                    cut("ends of springs that change", other_ends, needs.other_ends())?,
                ],
            },
            tables: cut("words of kernel tables", self.tables, tables)?,
            field: cut("nodes of the field", self.field, needs.nodes)?,
        })
    }
}

impl<'m> State<'m> {
    fn cut(self, needs: &Needs) -> Result<State<'m>, SceneError> {
        let particles = needs.particles;
        Ok(State {
            position: cut("particles", self.position, particles)?,
            velocity: cut("particles", self.velocity, particles)?,
            acceleration: cut("particles", self.acceleration, particles)?,
            density_pressure: cut("particles", self.density_pressure, particles)?,
            smoothing: cut("extras for XSPH", self.smoothing, needs.if_needed(needs.smoothing))?,
            heat: cut("extras for thermal energy", self.heat, needs.if_needed(needs.heat))?,
            normal: cut("normals", self.normal, needs.if_needed(needs.normals))?,
            history: cut("extras for an integrator's history", self.history, needs.if_needed(needs.history))?,
            id: cut("particles", self.id, particles)?,
        })
    }
}

fn cut<'m, T>(what: &'static str, lent: &'m mut [T], needed: usize) -> Result<&'m mut [T], SceneError> {
    let capacity = lent.len();
    lent.get_mut(..needed).ok_or(SceneError::CapacityExceeded { what, needed, capacity })
}
