// Inward normal of the surface of each particle's fluid, and its curvature where that follows from the same colour. With air also
// the gradient of the colour of all that is there.
fn pass_body(i: u32) {
  if i >= p.particle_count || head.status.failed != 0u { return; }
  let a = local(i);
  if a.wall > 0.0f {
    if m.normals == 1u { new_normal[i] = vec4(0.0f, 0.0f, 0.0f, 0.0f); }
    if m.air == 1u { bare[i] = vec4(0.0f, 0.0f, 0.0f, 0.0f); }
    return;
  }
  let own = cell_of(a.position);
  var sum = vec3(0.0f, 0.0f, 0.0f);
  var whole = vec3(0.0f, 0.0f, 0.0f);
  var laplacian = 0.0f;
  for (var i = 0u; i < stencil_cells(); i += 1u) {
    let c = stencil_cell(own, i);
    let end = begin[c] + head.counter[c];
    for (var j = begin[c]; j < end; j += 1u) {
      let b = local(j);
      if is_near(a, b) {
        if m.normals == 1u { sum = sum + colour_gradient(a, b); }
        if m.air == 1u { whole = whole + whole_gradient(a, b); }
        if m.tension == CURVATURE { laplacian = laplacian + colour_laplacian(a, b); }
      }
    }
  }
  if m.air == 1u {
    let all = flush3(whole);
    bare[i] = vec4(all, is_bare(all, a.wall, a.fluid));
  }
  if m.normals == 0u { return; }
  let normal = flush3(sum);
  var curvature = 0.0f;
  if m.tension == CURVATURE { curvature = curvature_of_colour(normal, laplacian); }
  new_normal[i] = vec4(normal, curvature);
}
