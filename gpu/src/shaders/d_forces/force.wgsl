// Computes the acceleration of each particle by pressure, viscosity and external forces. Where pressure is iterated
// later, pressure is left out.

// A neighbour with the velocity that viscosity sees.
fn seen(j: u32) -> Local {
  var b = local(j);
  if m.wall_particles == EXTRAPOLATED { b.velocity = seen_velocity[j].xyz; }
  return b;
}

fn pass_body(i: u32) {
  if i >= p.particle_count || head.status.failed != 0u { return; }
  let a = local(i);
  var acting = a;
  if m.has_tensile_control == 1u {
    acting.pressure = pressure_without_tension(a.pressure, renormalised_gradient[i].w);
  }
  if a.wall > 0.0f {
    force_out[i] = vec4(0.0f, 0.0f, 0.0f, 0.0f);
    return;
  }
  let own = cell_of(a.position);
  var force = vec3(0.0f, 0.0f, 0.0f);
  var change = vec3(0.0f, 0.0f, 0.0f);
  var shares = 0.0f;
  for (var i = 0u; i < stencil_cells(); i += 1u) {
    let c = stencil_cell(own, i);
    let end = cell_start[c] + head.counter[c];
    for (var j = cell_start[c]; j < end; j += 1u) {
      let b = seen(j);
      if is_near(a, b) {
        force = force + force_neighbour(acting, b);
        if m.has_velocity_exchange == 1u {
          change = change + exchange_neighbour(a, b);
          shares = shares + exchange_share(a, b);
        }
      }
    }
  }
  var internal = acceleration_close(force, a);
  var field = vec3(0.0f, 0.0f, 0.0f);
  if m.has_acceleration_field == 1u { field = field_at(a.position); }
  if m.has_closed_walls == 1u {
    let beyond = of_pressure(a.position, a.velocity, a.support, a.viscosity);
    if m.pressure_solver != PRESSURE_CORRECTION {
      let g = weight(density_ratio(a.deviation, a.rest_ratio)) + field;
      internal = internal + wall_push(a, acting.pressure, beyond, g);
    }
    if has_friction() { internal = internal + wall_rub(a, beyond); }
    internal = completed3(internal, beyond.gamma);
  }
  if m.has_repulsion == 1u { internal = internal + repelled(a.position); }
  if m.has_velocity_exchange == 1u { internal = internal + change * exchange_close(shares); }
  if m.has_acceleration_field == 1u { internal = internal + field; }
  force_out[i] = vec4(external_close(internal, a.velocity, density_ratio(a.deviation, a.rest_ratio)), 0.0f);
}
