// Computes one iteration of pressure: predicts the density error of the next step, and corrects the pressure for it.
fn predicted(a: u32) -> vec3<f32> { return predicted_velocity(new_velocity[a].xyz, new_acceleration[a].xyz); }

fn pass_body(a: u32) {
  if a >= p.particle_count || atomicLoad(&head.status.failed) != 0u { return; }
  if atomicLoad(&head.status.pressure_converged) != 0u { return; }
  if is_inactive(new_velocity[a].w) { return; }
  if follows_fluid() && properties_of(new_velocity[a].w).y > 0.0f { return; }
  let x_a = new_position[a].xyz;
  let v_a = predicted(a);
  let own_properties = properties_of(new_velocity[a].w);
  let own = cell_of(x_a);
  var rate = 0.0f;
  for (var i = 0u; i < stencil_cells(); i += 1u) {
    let c = stencil_cell(own, i);
    let end = cell_start[c] + atomicLoad(&head.counter[c]);
    for (var b = cell_start[c]; b < end; b += 1u) {
      let x_b = new_position[b];
      let x_ab = separation(x_a, x_b.xyz);
      var scale = 1.0f;
      if m.has_variable_support == 1u { scale = pair_scale(support_ratio[a], support_ratio[b]); }
      if less(squared_ratio(x_ab, scale), 1.0f) {
        let properties_b = properties_of(new_velocity[b].w);
        let mass_b = mass_seen(own_properties.z, x_b.w, properties_b.z, properties_b.y);
        let q = root(squared_ratio(x_ab, scale));
        let approach = dot3(x_ab, v_a - predicted(b));
        rate = rate + continuity_neighbour(approach, mass_b, q, continuity_slope(q, scale), scale);
      }
    }
  }
  let state = new_density_pressure[a];
  let k = stiffness_of(new_velocity[a].w);
  rate = deviation_rate(rate, new_position[a].w, own_properties.z);
  if m.has_closed_walls == 1u {
    var support = 1.0f;
    if m.has_variable_support == 1u { support = support_ratio[a]; }
    let beyond = of_pressure(x_a, v_a, support, own_properties.x);
    rate = completed(rate + rate_by_walls(state.x, beyond), beyond.gamma);
  }
  let inverse = inverse_correction(k.pressure_response, k.response_offset);
  let after = pressure_corrected(state.y, predicted_density_error(state.y, state.x, rate, k.compressibility), inverse);
  new_density_pressure[a] = vec4(state.x, after, state.z, state.w);
  atomicMax(&head.status.residual, bitcast<u32>(residual(state.y, after, inverse)));
}
