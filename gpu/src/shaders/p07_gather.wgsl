// The moved particles into their slots, which stand where their cells did; runs once for each array.
fn pass_body(a: u32) {
  if a >= p.particle_count || head.status.failed != 0u { return; }
  gather_to[cell[a]] = gather_from[a];
}
