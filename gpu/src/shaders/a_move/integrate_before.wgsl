// First half of the integrator: advances particles to the positions at which forces are evaluated. The particles are
// not sorted yet, so the results stay in the old slots.
fn pass_body(a: u32) {
  if a >= p.particle_count || head.status.failed != 0u { return; }
  let x = old_position[a];
  let v = old_velocity[a];
  let acceleration = old_acceleration[a].xyz;
  var history = vec3(0.0f, 0.0f, 0.0f);
  if has_history() { history = old_history[a].xyz; }
  var place = moved(x.xyz, v.xyz, acceleration, history);
  if drifts() { place = drift(place, old_drift_velocity[a].xyz, u.time_step); }
  place = wrap(only_if_free(x.xyz, place, properties_of(v.w).y));
  moved_velocity[a] = vec4(velocity_for_forces(v.xyz, acceleration, history), v.w);
  moved_position[a] = vec4(place, x.w);
}
