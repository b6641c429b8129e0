// Computes the inward surface normal of each particle's fluid, and the curvature where it follows from the colour of
// that fluid.
fn pass_body(i: u32) {
  if i >= p.particle_count || head.status.failed != 0u { return; }
  let a = local(i);
  if a.wall > 0.0f {
    new_normal[i] = vec4(0.0f, 0.0f, 0.0f, 0.0f);
    return;
  }
  let own = cell_of(a.position);
  var sum = vec3(0.0f, 0.0f, 0.0f);
  var laplacian = 0.0f;
  for (var i = 0u; i < stencil_cells(); i += 1u) {
    let c = stencil_cell(own, i);
    let end = cell_start[c] + head.counter[c];
    for (var j = cell_start[c]; j < end; j += 1u) {
      let b = local(j);
      if is_near(a, b) {
        sum = sum + colour_gradient(a, b);
        if m.tension == CURVATURE { laplacian = laplacian + colour_laplacian(a, b); }
      }
    }
  }
  if m.has_closed_walls == 1u {
    sum = sum - of_density(a.position, a.velocity, a.support, a.viscosity).surface;
  }
  let normal = flush3(sum);
  var curvature = 0.0f;
  if m.tension == CURVATURE { curvature = curvature_of_colour(normal, laplacian); }
  new_normal[i] = vec4(normal, curvature);
}
