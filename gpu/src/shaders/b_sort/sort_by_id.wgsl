// Finds the slot of each particle after the step, so that ids ascend within a cell. Each thread counts the particles of
// its cell that have smaller ids. A single thread that sorted a whole cell would take time proportional to the square
// of the number of its particles. In a crowded cell some devices would report a timeout, and some would end the loops
// without an error.
fn pass_body(a: u32) {
  if a >= p.particle_count || head.status.failed != 0u { return; }
  let own = cell[a];
  let id = old_id[a];
  let first = cell_start[own];
  var slot = first;
  if m.has_inactive == 1u && own == p.cells.w - 1u {
    // inactive particles need no order, and there may be too many of them to count
    slot = first + rank[a];
  } else {
    var count = head.counter[own];
    if m.cell_places > 0u { count = min(count, m.cell_places); }
    for (var i = 0u; i < count; i += 1u) {
      var other = 0u;
      if m.cell_places > 0u { other = grid_cells[own * m.cell_places + i]; } else { other = cell_members[first + i]; }
      if old_id[other] < id { slot += 1u; }
    }
  }
  source_slot[slot] = a;
  new_id[slot] = id;
}
