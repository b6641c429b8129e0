// Adds the acceleration by the curvature of the surface to the other accelerations, and stores the curvature in w.
fn pass_body(i: u32) {
  if i >= p.particle_count || head.status.failed != 0u { return; }
  let a = local(i);
  if a.wall > 0.0f { return; }
  let normal = new_normal[i].xyz;
  var curvature = new_normal[i].w;
  if m.tension == NORMAL_CURVATURE {
    let own = cell_of(a.position);
    var sums = vec3(0.0f, 0.0f, 0.0f);
    for (var i = 0u; i < stencil_cells(); i += 1u) {
      let c = stencil_cell(own, i);
      let end = cell_start[c] + head.counter[c];
      for (var j = cell_start[c]; j < end; j += 1u) {
        let b = local(j);
        if is_near(a, b) { sums = sums + normal_divergence(a, b, normal, new_normal[j].xyz); }
      }
    }
    curvature = curvature_of_normals(normal, sums);
  }
  force_out[i] = vec4(flush3(force_out[i].xyz + tension_close(a, normal, curvature)), curvature);
}
