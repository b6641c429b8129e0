// Second half of the integrator, followed by the penalty planes.
fn pass_body(a: u32) {
  if a >= p.particle_count || head.status.failed != 0u { return; }
  let material = new_velocity[a].w;
  let acceleration = new_acceleration[a].xyz;
  var at_start = vec3(0.0f, 0.0f, 0.0f);
  var before = vec3(0.0f, 0.0f, 0.0f);
  if needs_start_acceleration() { at_start = start_acceleration[a].xyz; }
  if has_history() { before = new_history[a].xyz; }
  var v = new_velocity[a].xyz;
  if needs_predicted_velocity() {
    v = end_velocity[a].xyz;
  } else {
    v = velocity_after(v, acceleration, at_start, before);
  }
  var history = history_after(at_start, before);
  if m.has_container == 1u || moves_again() {
    var x = new_position[a].xyz;
    let wall = properties_of(material).y;
    if moves_again() { x = wrap(only_if_free(x, position_after(x, acceleration, at_start, before), wall)); }
    if m.has_container == 1u {
      for (var i = 0u; i < p.plane_count; i += 1u) {
        let plane = p.planes[i];
        let depth = depth_if_free(depth_behind(x, plane.xyz, plane.w), wall);
        v = reflect(v, plane.xyz, depth);
        x = put_back(x, plane.xyz, depth);
        if has_history() { history = select_if_behind(history, history_reversed(v, acceleration, history), depth); }
      }
    }
    new_position[a] = vec4(x, new_position[a].w);
  }
  if has_history() { new_history[a] = vec4(history, 0.0f); }
  new_velocity[a] = vec4(v, material);
}
