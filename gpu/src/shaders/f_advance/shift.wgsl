// Computes the velocity with which each particle is shifted in the next step, and adds it to that of XSPH if there is
// one.
fn pass_body(i: u32) {
  if i >= p.particle_count || head.status.failed != 0u { return; }
  let a = local(i);
  if a.wall > 0.0f {
    new_drift_velocity[i] = vec4(0.0f, 0.0f, 0.0f, 0.0f);
    return;
  }
  let own = cell_of(a.position);
  var concentration = vec3(0.0f, 0.0f, 0.0f);
  var repulsion = vec3(0.0f, 0.0f, 0.0f);
  var normal = vec3(0.0f, 0.0f, 0.0f);
  var approach2 = 0.0f;
  let is_near_surface = less(inside_share(renormalised_gradient[i].w), 1.0f);
  for (var k = 0u; k < stencil_cells(); k += 1u) {
    let c = stencil_cell(own, k);
    let end = cell_start[c] + head.counter[c];
    for (var j = cell_start[c]; j < end; j += 1u) {
      let b = local(j);
      if is_near(a, b) {
        if m.shifting == FICKIAN {
          concentration = concentration + concentration_gradient(a, b);
          if m.has_shifting_speed == 0u { approach2 = approach2 + approach_squared(a, b); }
          if is_near_surface {
            normal = normal + lambda_gradient(a, b, renormalised_gradient[i].w, renormalised_gradient[j].w);
            repulsion = repulsion + close_repulsion(a, b);
          }
        }
        if m.shifting == TRANSPORT_VELOCITY { concentration = concentration + background_gradient(a, b); }
      }
    }
  }
  if m.has_closed_walls == 1u {
    let surface = of_pressure(a.position, a.velocity, a.support, a.viscosity).surface;
    if m.shifting == TRANSPORT_VELOCITY {
      // beyond the walls particles have the volume of this one
      concentration = concentration - surface * 2.0f;
    } else {
      concentration = concentration - surface;
    }
  }
  var drift = fickian_velocity(concentration, repulsion, approach2, renormalised_gradient[i].w, normal);
  if m.shifting == TRANSPORT_VELOCITY { drift = transport_velocity(a, concentration); }
  if m.has_xsph == 1u { drift = new_drift_velocity[i].xyz + drift; }
  new_drift_velocity[i] = vec4(flush3(drift), 0.0f);
}
