// Acceleration by the springs of elastic fluids, added to all else; and their lengths at rest after the step.
fn pass_body(i: u32) {
  if i >= p.particle_count || head.status.failed != 0u { return; }
  let x_a = new_position[i].xyz;
  let springs = springs_of[new_id[i]];
  let pull = bitcast<f32>(springs.z);
  var sum = vec3(0.0f, 0.0f, 0.0f);
  for (var e = springs.x; e < springs.x + springs.y; e += 1u) {
    let end = old_ends[e];
    let x_ab = separation(x_a, new_position[slot_of[end.x]].xyz);
    let rest_length = bitcast<f32>(end.y);
    sum = sum + spring_pull(x_ab, rest_length, pull);
    if m.plastic == 1u { new_ends[e] = vec2(end.x, bitcast<u32>(spring_given_way(x_ab, rest_length))); }
  }
  force_out[i] = vec4(flush3(force_out[i].xyz + sum), force_out[i].w);
}
