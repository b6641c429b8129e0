// Finds the liquid particles beside which an air particle is to be made. CPU counterpart:
// core/src/passes/f_advance/spawn_requests.rs.
//
// Returns whether an exposed particle with a smaller id gets an air particle at nearly the same position.
fn is_late(a: u32, place: vec3<f32>) -> bool {
  let own = cell_of(place);
  for (var i = 0u; i < stencil_cells(); i += 1u) {
    let c = stencil_cell(own, i);
    let end = cell_start[c] + head.counter[c];
    for (var b = cell_start[c]; b < end; b += 1u) {
      if total_colour_gradient[b].w > 0.0f && new_id[b] < new_id[a] {
        let other = place_of(b);
        if is_taken(place, other) > 0.0f && is_free(other) { return true; }
      }
    }
  }
  return false;
}

fn pass_body(a: u32) {
  if a >= p.particle_count || head.status.failed != 0u { return; }
  var born = 0u;
  if total_colour_gradient[a].w > 0.0f {
    let place = place_of(a);
    if is_free(place) && !is_late(a, place) { born = 1u; }
  }
  spawn_requested[a] = born;
}
