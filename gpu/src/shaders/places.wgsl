// Places for new particles: whether one is free, and where exposed particles of liquid request air. CPU counterpart:
// core/src/passes/places.rs.
fn place_of(a: u32) -> vec3<f32> { return spawn_position(new_position[a].xyz, total_colour_gradient[a].xyz); }

// Returns whether no particle is near a position and the position is not behind a penalty plane or in a solid.
fn is_free(place: vec3<f32>) -> bool {
  if axis_out_of_range(place) < 3u { return false; }
  if m.has_container == 1u {
    for (var i = 0u; i < p.plane_count; i += 1u) {
      let plane = p.planes[i];
      if depth_behind(place, plane.xyz, plane.w) > 0.0f { return false; }
    }
  }
  if m.has_solids == 1u && is_in_solid(place) { return false; }
  let own = cell_of(place);
  for (var i = 0u; i < stencil_cells(); i += 1u) {
    let c = stencil_cell(own, i);
    let end = cell_start[c] + head.counter[c];
    for (var b = cell_start[c]; b < end; b += 1u) {
      if is_taken(place, new_position[b].xyz) > 0.0f { return false; }
    }
  }
  return true;
}
