// Adds the acceleration by the pressure of an iteration to the other accelerations. Runs once more after the last
// iteration.
fn pass_body(i: u32) {
  if i >= p.particle_count || head.status.failed != 0u || head.status.pressure_converged > 1u { return; }
  let a = local(i);
  if a.wall > 0.0f {
    new_acceleration[i] = vec4(0.0f, 0.0f, 0.0f, non_pressure_acceleration[i].w);
    return;
  }
  let own = cell_of(a.position);
  var force = vec3(0.0f, 0.0f, 0.0f);
  for (var i = 0u; i < stencil_cells(); i += 1u) {
    let c = stencil_cell(own, i);
    let end = cell_start[c] + head.counter[c];
    for (var j = cell_start[c]; j < end; j += 1u) {
      let b = local(j);
      if is_near(a, b) { force = force + pressure_neighbour(a, b); }
    }
  }
  let non_pressure = non_pressure_acceleration[i];
  var pushed = acceleration_close(force, a);
  if m.has_closed_walls == 1u {
    let beyond = of_pressure(a.position, a.velocity, a.support, a.viscosity);
    var g = weight(density_ratio(a.deviation, a.rest_ratio));
    if m.has_acceleration_field == 1u { g = g + field_at(a.position); }
    pushed = completed3(pushed + wall_push(a, a.pressure, beyond, g), beyond.gamma);
  }
  new_acceleration[i] = vec4(flush3(non_pressure.xyz + pushed), non_pressure.w);
}
