//! Memory for a scene of any size, from the heap. An embedder with a fixed capacity uses `Storage` instead.
use millpond_core::layout::{TABLE_WORDS, f32x4, u32x2, u32x4};
use millpond_core::memory::{LIST_ENTRIES, Scratch, Springs, State};
use millpond_core::{Checked, Memory, Needs};

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
    smoothing: [Vec<f32x4>; 2],
    heat: [Vec<f32x4>; 2],
    previous: Vec<f32x4>,
    free: Vec<f32x4>,
    history: [Vec<f32x4>; 2],
    earlier: Vec<f32x4>,
    ahead: Vec<f32x4>,
    normal: [Vec<f32x4>; 2],
    springs_of: Vec<u32x4>,
    spring_ends: [Vec<u32x2>; 2],
    slot_of: Vec<u32>,
    bare: Vec<f32x4>,
    birth: Vec<u32>,
    tables: Vec<f32>,
    field: Vec<f32x4>,
}

impl Heap {
    /// For a scene.
    #[must_use]
    pub fn of(scene: &Checked<'_>) -> Heap {
        Heap::with(Needs::of(scene))
    }

    /// For these needs.
    #[must_use]
    pub fn with(needs: Needs) -> Heap {
        let Needs { particles: n, cells, places, smoothing, heat, previous, free, tables, nodes, .. } = needs;
        let Needs { normals, springs, spring_ends, plastic, air, history, earlier, ahead, .. } = needs;
        let sprung = if springs { n } else { 0 };
        let if_needed = |needed: bool| vec![[0.0; 4]; if needed { n } else { 0 }];
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
            smoothing: [if_needed(smoothing), if_needed(smoothing)],
            heat: [if_needed(heat), if_needed(heat)],
            previous: if_needed(previous),
            free: if_needed(free),
            history: [if_needed(history), if_needed(history)],
            earlier: if_needed(earlier),
            ahead: if_needed(ahead),
            normal: [if_needed(normals), if_needed(normals)],
            springs_of: vec![[0; 4]; sprung],
            spring_ends: [vec![[0; 2]; spring_ends], vec![[0; 2]; if plastic { spring_ends } else { 0 }]],
            slot_of: vec![0; if springs || air { n } else { 0 }],
            bare: if_needed(air),
            birth: vec![0; if air { n } else { 0 }],
            tables: vec![0.0; if tables { TABLE_WORDS } else { 0 }],
            field: vec![[0.0; 4]; nodes],
        }
    }

    /// Lends all of it.
    pub fn lend(&mut self) -> Memory<'_> {
        let [first, second] = &mut self.vectors;
        let [first_id, second_id] = &mut self.ids;
        let [cell, rank, order] = self.particle_words.each_mut().map(Vec::as_mut_slice);
        let [begin, counter] = self.cell_words.each_mut().map(Vec::as_mut_slice);
        let grid_cells = self.grid_cells.as_mut_slice();
        let [smoothing, other_smoothing] = self.smoothing.each_mut().map(Vec::as_mut_slice);
        let [heat, other_heat] = self.heat.each_mut().map(Vec::as_mut_slice);
        let [normal, other_normal] = self.normal.each_mut().map(Vec::as_mut_slice);
        let [history, other_history] = self.history.each_mut().map(Vec::as_mut_slice);
        Memory {
            states: [
                state(first, [smoothing, heat, normal, history], first_id),
                state(second, [other_smoothing, other_heat, other_normal, other_history], second_id),
            ],
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
                previous: &mut self.previous,
                free: &mut self.free,
                earlier: &mut self.earlier,
                ahead: &mut self.ahead,
                slot_of: &mut self.slot_of,
                bare: &mut self.bare,
                birth: &mut self.birth,
            },
            springs: Springs { of: &mut self.springs_of, ends: self.spring_ends.each_mut().map(Vec::as_mut_slice) },
            tables: &mut self.tables,
            field: &mut self.field,
        }
    }
}

fn state<'m>(
    vectors: &'m mut [Vec<f32x4>; 4],
    [smoothing, heat, normal, history]: [&'m mut [f32x4]; 4],
    id: &'m mut [u32],
) -> State<'m> {
    let [position, velocity, acceleration, density_pressure] = vectors.each_mut().map(Vec::as_mut_slice);
    State { position, velocity, acceleration, density_pressure, smoothing, heat, normal, history, id }
}
