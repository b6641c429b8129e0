// Acceleration of each particle: pressure, viscosity and gravity.
fn local(a: u32) -> Local {
  let state = new_density_pressure[a];
  return Local(new_position[a].xyz, new_velocity[a].xyz, state.y, state.z, state.w);
}

fn pass_body(i: u32) {
  if i >= p.particle_count || head.status.failed != 0u { return; }
  let a = local(i);
  let own = cell_of(a.position);
  var force = vec3(0.0f, 0.0f, 0.0f);
  for (var i = 0u; i < stencil_cells(); i += 1u) {
    let c = stencil_cell(own, i);
    let end = begin[c] + head.counter[c];
    for (var b = begin[c]; b < end; b += 1u) {
      let q2 = length2(a.position - new_position[b].xyz) * p.inverse_support_squared;
      if less(q2, 1.0f) {
        force = force + force_neighbour(a, local(b));
      }
    }
  }
  new_acceleration[i] = vec4(acceleration_close(force, new_density_pressure[i].x, p.gravity.xyz), 0.0f);
}
