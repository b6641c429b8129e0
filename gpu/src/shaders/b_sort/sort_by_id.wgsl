// The slot of each particle, where its cell stood: inside a cell ids ascend. A particle counts the members that come before it.
// One thread that sorted a cell would be busy with a crowded one for the square of its members: some devices give up on that,
// and some, unasked, end its loops.
fn pass_body(a: u32) {
  if a >= p.particle_count || head.status.failed != 0u { return; }
  let own = cell[a];
  let id = old_id[a];
  let first = cell_start[own];
  var slot = first;
  if m.has_air == 1u && own == p.cells.w - 1u {
    // inactive particles need no order, and there may be too many to count
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
