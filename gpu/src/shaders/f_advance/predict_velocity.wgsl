// Predicts the velocities at the end of the step.
fn pass_body(a: u32) {
  if a >= p.particle_count || head.status.failed != 0u { return; }
  var before = vec3(0.0f, 0.0f, 0.0f);
  var history = vec3(0.0f, 0.0f, 0.0f);
  if needs_start_acceleration() { before = start_acceleration[a].xyz; }
  if has_history() { history = new_history[a].xyz; }
  let v = new_velocity[a];
  end_velocity[a] = vec4(velocity_after(v.xyz, new_acceleration[a].xyz, before, history), v.w);
}
