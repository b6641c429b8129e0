// Adds the acceleration by the springs of elastic fluids to the other accelerations.
fn pass_body(i: u32) {
  if i >= p.particle_count || head.status.failed != 0u { return; }
  let x_a = new_position[i].xyz;
  let springs = spring_ranges[new_id[i]];
  let pull = bitcast<f32>(springs.z);
  var sum = vec3(0.0f, 0.0f, 0.0f);
  for (var e = springs.x; e < springs.x + springs.y; e += 1u) {
    let end = old_spring_ends[e];
    let x_ab = separation(x_a, new_position[new_slot_of_id[end.x]].xyz);
    sum = sum + spring_pull(x_ab, bitcast<f32>(end.y), pull);
  }
  force_out[i] = vec4(flush3(force_out[i].xyz + sum), force_out[i].w);
}
