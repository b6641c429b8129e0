// Half kick, then the walls; and a look at every number that is about to become the state.
fn is_finite(x: f32x4) -> bool {
  return all((bitcast<vec4<u32>>(x) & vec4(0x7f800000u)) != vec4(0x7f800000u));
}

fn pass_body(a: u32) {
  if a >= p.particle_count || atomicLoad(&head.status.failed) != 0u { return; }
  let kind_of_a = new_velocity[a].w;
  var v = kick(new_velocity[a].xyz, new_acceleration[a].xyz, p.half_time_step);
  if m.walls == 1u {
    var x = new_position[a].xyz;
    for (var i = 0u; i < p.plane_count; i += 1u) {
      let plane = p.planes[i];
      let depth = depth_if_free(depth_behind(x, plane.xyz, plane.w), kind(kind_of_a).y);
      v = reflect(v, plane.xyz, depth);
      x = put_back(x, plane.xyz, depth);
    }
    new_position[a] = vec4(x, new_position[a].w);
  }
  new_velocity[a] = vec4(v, kind_of_a);

  var quantity = 4u;
  if m.thermal_energy == 1u && !is_finite(new_heat[a]) { quantity = 3u; }
  if !is_finite(new_density_pressure[a]) { quantity = 3u; }
  if !is_finite(new_acceleration[a]) { quantity = 2u; }
  if !is_finite(new_velocity[a]) { quantity = 1u; }
  if !is_finite(new_position[a]) { quantity = 0u; }
  if quantity < 4u {
    atomicMin(&head.status.not_finite, 4u * new_id[a] + quantity);
  }
}
