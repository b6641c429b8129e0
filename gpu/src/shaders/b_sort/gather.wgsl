// An array into the slots after the step; runs once for each array that a step sorts.
fn pass_body(a: u32) {
  if a >= p.particle_count || head.status.failed != 0u { return; }
  gather_to[a] = gather_from[source_slot[a]];
}
