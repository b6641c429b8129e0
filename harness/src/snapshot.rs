//! A state of either backend: every array that a fluid consists of, bit by bit, in the order of the ids.
use crate::failure::Failure;
use millpond_core::backend::hash::state_hash;
use millpond_core::backend::layout::{f32x4, u32x2};
use millpond_core::backend::plan::arrays::{Class, Unit};
use millpond_core::scene::InitialParticle;
use millpond_core::{Array, Solver, TimeReport};
use millpond_gpu::GpuSolver;

/// A state, by particle id. Two are equal where every bit of every array is.
#[derive(Clone, Debug, PartialEq)]
pub struct Snapshot {
    /// The words of each array, by its number; empty where the scene does without.
    arrays: Vec<Vec<u32>>,
    /// What became of the time step.
    pub clock: TimeReport,
}

impl Default for Snapshot {
    fn default() -> Self {
        Snapshot { arrays: vec![Vec::new(); Array::COUNT], clock: TimeReport::default() }
    }
}

impl Snapshot {
    /// Of arrays whose particles lie in these slots.
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

    /// Of a CPU solver.
    #[must_use]
    pub fn of_cpu(solver: &Solver<'_>) -> Snapshot {
        Snapshot::of(solver.slots(), |array| solver.words(array), solver.time_report())
    }

    /// Of a GPU solver.
    ///
    /// # Errors
    /// The device failed.
    pub fn of_gpu(solver: &GpuSolver) -> Result<Snapshot, Failure> {
        let state = solver.read()?;
        Ok(Snapshot::of(state.slots(), |array| state.words(array), solver.time_report()?))
    }

    /// Of particles alone.
    #[must_use]
    pub fn of_particles(position: &[f32x4], velocity: &[f32x4]) -> Snapshot {
        let mut state = Snapshot::default();
        state.arrays[Array::position as usize] = bytemuck::cast_slice(position).to_vec();
        state.arrays[Array::velocity as usize] = bytemuck::cast_slice(velocity).to_vec();
        state
    }

    /// An array as words of four bytes.
    #[must_use]
    pub fn words(&self, array: Array) -> &[u32] {
        &self.arrays[array as usize]
    }

    /// The same, to be changed.
    pub fn words_mut(&mut self, array: Array) -> &mut Vec<u32> {
        &mut self.arrays[array as usize]
    }

    /// An array of vectors.
    #[must_use]
    pub fn vectors(&self, array: Array) -> &[f32x4] {
        bytemuck::cast_slice(self.words(array))
    }

    /// Position, m.
    #[must_use]
    pub fn position(&self) -> &[f32x4] {
        self.vectors(Array::position)
    }

    /// Velocity, m/s.
    #[must_use]
    pub fn velocity(&self) -> &[f32x4] {
        self.vectors(Array::velocity)
    }

    /// [`QUANTITIES`](millpond_core::backend::layout::QUANTITIES).
    #[must_use]
    pub fn density_pressure(&self) -> &[f32x4] {
        self.vectors(Array::density_pressure)
    }

    /// Thermal energy, J/kg, and its rate, W/kg; empty where the scene keeps no account of it.
    #[must_use]
    pub fn internal_energy(&self) -> &[f32x4] {
        self.vectors(Array::internal_energy)
    }

    /// Ends of springs, each particle's side by side; empty where the scene has none.
    #[must_use]
    pub fn spring_ends(&self) -> &[u32x2] {
        bytemuck::cast_slice(self.words(Array::spring_ends))
    }

    /// Where particles would be to go on from here.
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

    /// The state hash, as core computes it.
    #[must_use]
    pub fn hash(&self) -> u64 {
        let slots: Vec<u32> = (0..self.position().len() as u32).collect();
        state_hash(&slots, self.position(), self.velocity())
    }
}
