// Computes the rest lengths of springs after the step.
fn pass_body(i: u32) {
  if i >= p.particle_count || head.status.failed != 0u { return; }
  let x_a = new_position[i].xyz;
  let springs = spring_ranges[new_id[i]];
  for (var e = springs.x; e < springs.x + springs.y; e += 1u) {
    let end = old_spring_ends[e];
    let x_ab = separation(x_a, new_position[new_slot_of_id[end.x]].xyz);
    new_spring_ends[e] = vec2(end.x, bitcast<u32>(plastic_rest_length(x_ab, bitcast<f32>(end.y))));
  }
}
