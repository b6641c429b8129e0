// Finds the liquid particles at the free surface, by the gradient of the colour of all fluids together.
fn pass_body(i: u32) {
  if i >= p.particle_count || head.status.failed != 0u { return; }
  let a = local(i);
  if a.wall > 0.0f {
    total_colour_gradient[i] = vec4(0.0f, 0.0f, 0.0f, 0.0f);
    return;
  }
  let own = cell_of(a.position);
  var sum = vec3(0.0f, 0.0f, 0.0f);
  for (var i = 0u; i < stencil_cells(); i += 1u) {
    let c = stencil_cell(own, i);
    let end = cell_start[c] + head.counter[c];
    for (var j = cell_start[c]; j < end; j += 1u) {
      let b = local(j);
      if is_near(a, b) { sum = sum + total_gradient(a, b); }
    }
  }
  if m.has_closed_walls == 1u {
    sum = sum - of_density(a.position, a.velocity, a.support, a.viscosity).surface;
  }
  let gradient = flush3(sum);
  total_colour_gradient[i] = vec4(gradient, is_exposed(gradient, a.wall, a.fluid));
}
