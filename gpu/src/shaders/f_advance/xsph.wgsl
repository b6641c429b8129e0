// Computes the XSPH velocity: a velocity that each particle moves with in the next step, in addition to its own.
fn at_step(i: u32) -> Local {
  var a = local(i);
  a.velocity = end_velocity[i].xyz;
  return a;
}

fn pass_body(i: u32) {
  if i >= p.particle_count || head.status.failed != 0u { return; }
  let a = at_step(i);
  if a.wall > 0.0f {
    new_drift_velocity[i] = vec4(0.0f, 0.0f, 0.0f, 0.0f);
    return;
  }
  let own = cell_of(a.position);
  var sum = vec3(0.0f, 0.0f, 0.0f);
  for (var i = 0u; i < stencil_cells(); i += 1u) {
    let c = stencil_cell(own, i);
    let end = cell_start[c] + head.counter[c];
    for (var j = cell_start[c]; j < end; j += 1u) {
      let b = at_step(j);
      if is_near(a, b) { sum = sum + xsph_neighbour(a, b); }
    }
  }
  new_drift_velocity[i] = vec4(xsph_close(sum), 0.0f);
}
