// Particles of each cell. Who gets which rank is a race; p06_order undoes it. The counters were cleared before.
fn pass_body(a: u32) {
  if a >= p.particle_count || atomicLoad(&head.status.failed) != 0u { return; }
  rank[a] = atomicAdd(&head.counter[cell[a]], 1u);
}
