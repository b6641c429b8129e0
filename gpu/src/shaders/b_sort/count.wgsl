// Finds the cell of each particle, and counts the particles of each cell. The rank of a particle within its cell
// depends on the order of threads; the pass sort_by_id removes that dependence. The counters were cleared before. The
// counters of the cells are followed by those of the blocks of cells, which the scan needs. Inactive air particles go
// to the last cell, whatever their position.
fn enter(own: u32) -> u32 {
  atomicAdd(&head.counter[p.cells.w + own / CELL_BLOCK], 1u);
  return atomicAdd(&head.counter[own], 1u);
}

fn pass_body(a: u32) {
  if a >= p.particle_count || atomicLoad(&head.status.failed) != 0u { return; }
  if is_inactive(moved_velocity[a].w) {
    cell[a] = p.cells.w - 1u;
    rank[a] = enter(p.cells.w - 1u);
    return;
  }
  let x = moved_position[a].xyz;
  let axis = axis_out_of_range(x);
  if axis < 3u {
    atomicMin(&head.status.out_of_range, 4u * old_id[a] + axis);
    // the step has failed, but its remaining passes must still find a valid cell
    cell[a] = 0u;
    rank[a] = 0u;
    return;
  }
  let own = cell_index(cell_of(x));
  cell[a] = own;
  rank[a] = enter(own);
}
