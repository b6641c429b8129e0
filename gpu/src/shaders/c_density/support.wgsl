// Computes the support radius of each particle from its density before the step.
fn pass_body(a: u32) {
  if a >= p.particle_count || head.status.failed != 0u { return; }
  support_ratio[a] = support_close(previous_density_pressure[a].x);
}
