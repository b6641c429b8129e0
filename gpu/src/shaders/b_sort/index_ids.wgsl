// Records the slot of each particle, by id.
fn pass_body(a: u32) {
  if a >= p.particle_count || head.status.failed != 0u { return; }
  new_slot_of_id[new_id[a]] = a;
}
