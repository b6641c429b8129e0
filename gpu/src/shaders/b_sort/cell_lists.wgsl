// Enters each particle into the list of its cell.
fn pass_body(a: u32) {
  if a >= p.particle_count || atomicLoad(&head.status.failed) != 0u { return; }
  if rank[a] < m.cell_places {
    grid_cells[cell[a] * m.cell_places + rank[a]] = a;
  } else {
    atomicMin(&head.status.cell_full, cell[a]);
  }
}
