// Support radius of each particle from its density before the step.
fn pass_body(a: u32) {
  if a >= p.particle_count || head.status.failed != 0u { return; }
  let before = previous[a];
  previous[a] = vec4(before.xy, support_close(before.x), before.w);
}
