//! Memory for a scene of any size, from the heap. An embedder with a fixed capacity uses `Storage` instead.
use millpond_core::layout::f32x4;
use millpond_core::scene::Scene;
use millpond_core::storage::{LIST_ENTRIES, Scratch, State};
use millpond_core::{Memory, Needs};

/// As much memory as a scene needs.
#[derive(Debug)]
pub struct Heap {
    vectors: [[Vec<f32x4>; 4]; 2],
    ids: [Vec<u32>; 2],
    slot: Vec<u32>,
    particle_words: [Vec<u32>; 3],
    block: Vec<[u32; 2]>,
    list: Vec<u32>,
    cell_words: [Vec<u32>; 2],
    grid_cells: Vec<u32>,
}

impl Heap {
    /// For a scene that `Scene::check` accepts.
    #[must_use]
    pub fn of(scene: &Scene) -> Heap {
        Heap::with(Needs::of(scene))
    }

    /// For these needs.
    #[must_use]
    pub fn with(needs: Needs) -> Heap {
        let Needs { particles: n, cells, places } = needs;
        let state = || [(); 4].map(|()| vec![[0.0; 4]; n]);
        Heap {
            vectors: [state(), state()],
            ids: [vec![0; n], vec![0; n]],
            slot: vec![0; n],
            particle_words: [(); 3].map(|()| vec![0; n]),
            block: vec![[0; 2]; n],
            list: vec![0; n * LIST_ENTRIES],
            cell_words: [vec![0; cells], vec![0; cells]],
            grid_cells: vec![0; places],
        }
    }

    /// Lends all of it.
    pub fn lend(&mut self) -> Memory<'_> {
        let [first, second] = &mut self.vectors;
        let [first_id, second_id] = &mut self.ids;
        let [cell, rank, order] = self.particle_words.each_mut().map(Vec::as_mut_slice);
        let [begin, counter] = self.cell_words.each_mut().map(Vec::as_mut_slice);
        let grid_cells = self.grid_cells.as_mut_slice();
        Memory {
            states: [state(first, first_id), state(second, second_id)],
            slot: &mut self.slot,
            scratch: Scratch {
                cell,
                rank,
                order,
                block: &mut self.block,
                list: &mut self.list,
                begin,
                counter,
                grid_cells,
            },
        }
    }
}

fn state<'m>(vectors: &'m mut [Vec<f32x4>; 4], id: &'m mut [u32]) -> State<'m> {
    let [position, velocity, acceleration, density_pressure] = vectors.each_mut().map(Vec::as_mut_slice);
    State { position, velocity, acceleration, density_pressure, id }
}
