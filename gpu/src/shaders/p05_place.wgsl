// Each particle into the slots of its cell. Air that is not there needs no order among itself, and it is too much to be counted in
// the pass that comes next, so its ids are written here.
fn pass_body(a: u32) {
  if a >= p.particle_count || head.status.failed != 0u { return; }
  let slot = begin[cell[a]] + rank[a];
  order[slot] = a;
  if m.air == 1u && cell[a] == p.cells.w - 1u {
    new_id[slot] = old_id[a];
    slot_of[old_id[a]] = slot;
  }
}
