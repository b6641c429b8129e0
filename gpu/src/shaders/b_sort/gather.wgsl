// Copies an array from the slots before the step into the slots after it. Runs once for each array that a step sorts.
fn pass_body(a: u32) {
  if a >= p.particle_count || head.status.failed != 0u { return; }
  gather_to[a] = gather_from[source_slot[a]];
}
