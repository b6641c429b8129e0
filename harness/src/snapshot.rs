//! A state of either backend: every array of the state, bit by bit, in the order of the particle ids.
use crate::failure::Failure;
use millpond_core::backend::hash::state_hash;
use millpond_core::backend::layout::{f32x4, u32x2};
use millpond_core::backend::plan::arrays::{Class, Unit};
use millpond_core::scene::InitialParticle;
use millpond_core::{Array, Solver, TimeReport};
use millpond_gpu::GpuSolver;

/// A state in the order of the particle ids. Two snapshots are equal if every bit of every array is equal.
#[derive(Clone, Debug, PartialEq)]
pub struct Snapshot {
    /// Words of each array, by the number of the array; empty for arrays that the scene does not have.
    arrays: Vec<Vec<u32>>,
    /// Simulated time and time step.
    pub clock: TimeReport,
}

impl Default for Snapshot {
    fn default() -> Self {
        Snapshot { arrays: vec![Vec::new(); Array::COUNT], clock: TimeReport::default() }
    }
}

impl Snapshot {
    /// Sorts arrays by id: the particle with id i lies in slot `slots[i]` of the arrays.
    fn of<'a>(slots: &[u32], words: impl Fn(Array) -> &'a [u32], clock: TimeReport) -> Snapshot {
        let by_id = |&array: &Array| {
            let (all, entry) = (words(array), array.words());
            match (array.class(), array.unit()) {
                (Class::State, Unit::Particle) if !all.is_empty() => {
                    slots.iter().flat_map(|&slot| &all[slot as usize * entry..][..entry]).copied().collect()
                }
                (Class::State, _) => all.to_vec(),
                _ => Vec::new(),
            }
        };
        Snapshot { arrays: Array::ALL.iter().map(by_id).collect(), clock }
    }

    /// Takes a snapshot of a CPU solver.
    #[must_use]
    pub fn of_cpu(solver: &Solver<'_>) -> Snapshot {
        Snapshot::of(solver.slots(), |array| solver.words(array), solver.time_report())
    }

    /// Takes a snapshot of a GPU solver.
    ///
    /// # Errors
    /// A failure of the device.
    pub fn of_gpu(solver: &GpuSolver) -> Result<Snapshot, Failure> {
        let state = solver.read()?;
        Ok(Snapshot::of(state.slots(), |array| state.words(array), solver.time_report()?))
    }

    /// Makes a snapshot of positions and velocities only.
    #[must_use]
    pub fn of_particles(position: &[f32x4], velocity: &[f32x4]) -> Snapshot {
        let mut state = Snapshot::default();
        state.arrays[Array::position as usize] = bytemuck::cast_slice(position).to_vec();
        state.arrays[Array::velocity as usize] = bytemuck::cast_slice(velocity).to_vec();
        state
    }

    /// Returns an array as 32-bit words.
    #[must_use]
    pub fn words(&self, array: Array) -> &[u32] {
        &self.arrays[array as usize]
    }

    /// Returns an array as 32-bit words that can be changed.
    pub fn words_mut(&mut self, array: Array) -> &mut Vec<u32> {
        &mut self.arrays[array as usize]
    }

    /// Returns an array as vectors.
    #[must_use]
    pub fn vectors(&self, array: Array) -> &[f32x4] {
        bytemuck::cast_slice(self.words(array))
    }

    /// Returns the positions, m, with the relative masses in the fourth component.
    #[must_use]
    pub fn position(&self) -> &[f32x4] {
        self.vectors(Array::position)
    }

    /// Returns the velocities, m/s, with the material indices in the fourth component.
    #[must_use]
    pub fn velocity(&self) -> &[f32x4] {
        self.vectors(Array::velocity)
    }

    /// Returns density deviation, pressure, near pressure and volume
    /// ([`QUANTITIES`](millpond_core::backend::layout::QUANTITIES)).
    #[must_use]
    pub fn density_pressure(&self) -> &[f32x4] {
        self.vectors(Array::density_pressure)
    }

    /// Returns the internal energy, J/kg, and its rate, W/kg; empty if the scene does not compute it.
    #[must_use]
    pub fn internal_energy(&self) -> &[f32x4] {
        self.vectors(Array::internal_energy)
    }

    /// Returns the ends of springs, grouped by particle; empty if the scene has no springs.
    #[must_use]
    pub fn spring_ends(&self) -> &[u32x2] {
        bytemuck::cast_slice(self.words(Array::spring_ends))
    }

    /// Returns particles with which a solver can start from this state.
    pub fn places(&self) -> impl Iterator<Item = InitialParticle> {
        let vector = |[x, y, z, _]: f32x4| [x, y, z];
        let all = self.position().iter().zip(self.velocity()).zip(self.density_pressure());
        all.map(move |((x, v), d)| InitialParticle {
            position: vector(*x).into(),
            velocity: vector(*v).into(),
            material: v[3] as u32,
            mass: x[3],
            deviation: d[0],
            pressure: d[1],
        })
    }

    /// Returns the state hash, as the core crate computes it.
    #[must_use]
    pub fn hash(&self) -> u64 {
        let slots: Vec<u32> = (0..self.position().len() as u32).collect();
        state_hash(&slots, self.position(), self.velocity())
    }
}
