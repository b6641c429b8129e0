// The cell that each particle comes to, and particles of each cell. Who gets which rank is a race; sort_by_id undoes it. The
// counters were cleared before. Behind those of the cells are those of the blocks of cells, for the scan. Air that is not there comes to the last cell, wherever it lies.
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
    // the step has failed, and its next passes must still find a cell
    cell[a] = 0u;
    rank[a] = 0u;
    return;
  }
  let own = cell_index(cell_of(x));
  cell[a] = own;
  rank[a] = enter(own);
}
