// Ascending id inside each cell: insertion sort, a thread a cell. With cell lists the members are in its places.
fn pass_body(c: u32) {
  if c >= p.cells.w || head.status.failed != 0u { return; }
  // nothing is ever summed over air that is not there
  if m.air == 1u && c == p.cells.w - 1u { return; }
  let first = begin[c];
  var count = head.counter[c];
  if m.cell_places > 0u { count = min(count, m.cell_places); }
  for (var i = 0u; i < count; i += 1u) {
    var slot = 0u;
    if m.cell_places > 0u { slot = grid_cells[c * m.cell_places + i]; } else { slot = order[first + i]; }
    let key = old_id[slot];
    var j = first + i;
    while j > first && new_id[j - 1u] > key {
      order[j] = order[j - 1u];
      new_id[j] = new_id[j - 1u];
      j -= 1u;
    }
    order[j] = slot;
    new_id[j] = key;
  }
  if m.springs == 1u || m.air == 1u {
    for (var j = first; j < first + count; j += 1u) { slot_of[new_id[j]] = j; }
  }
}
