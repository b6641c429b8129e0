// Density of each particle from its neighbours, and the pressures that follow.
fn pass_body(a: u32) {
  if a >= p.particle_count || head.status.failed != 0u { return; }
  let x_a = new_position[a].xyz;
  let own = cell_of(x_a);
  var sum = 0.0f;
  for (var i = 0u; i < stencil_cells(); i += 1u) {
    let c = stencil_cell(own, i);
    let end = begin[c] + head.counter[c];
    for (var b = begin[c]; b < end; b += 1u) {
      let q2 = length2(x_a - new_position[b].xyz) * p.inverse_support_squared;
      if less(q2, 1.0f) {
        sum = sum + density_neighbour(q2);
      }
    }
  }
  let density = density_close(sum);
  new_density_pressure[a] =
    vec4(density, pressure_close(density), near_pressure_close(density), volume_close(density));
}
