// Computes the density of each particle from its neighbours, and the pressures and volume that follow from it.
fn support_of(a: u32) -> f32 {
  if m.has_variable_support == 1u { return support_ratio[a]; }
  return 1.0f;
}

fn pass_body(a: u32) {
  if a >= p.particle_count || head.status.failed != 0u { return; }
  let x_a = new_position[a];
  let v_a = new_velocity[a];
  if is_inactive(v_a.w) {
    new_density_pressure[a] = vec4(0.0f, 0.0f, 0.0f, p.rest_volume);
    return;
  }
  // wall particles that follow the fluid have no density and no acceleration
  if follows_fluid() && properties_of(v_a.w).y > 0.0f {
    new_density_pressure[a] = vec4(0.0f, 0.0f, 0.0f, volume_close(x_a.w, 0.0f));
    return;
  }
  let own = cell_of(x_a.xyz);
  var sum = 0.0f;
  var near_sum = 0.0f;
  var number_sum = 0.0f;
  var wall_sum = 0.0f;
  let own_properties = properties_of(v_a.w);
  for (var i = 0u; i < stencil_cells(); i += 1u) {
    let c = stencil_cell(own, i);
    let end = cell_start[c] + head.counter[c];
    for (var b = cell_start[c]; b < end; b += 1u) {
      let x_b = new_position[b];
      let x_ab = separation(x_a.xyz, x_b.xyz);
      let scale = pair_scale(support_of(a), support_of(b));
      let q2 = squared_ratio(x_ab, scale);
      // wall particles that repel have no part in the density
      if repels_directly() && properties_of(new_velocity[b].w).y > 0.0f { continue; }
      if less(q2, 1.0f) {
        var mass_b = x_b.w;
        if m.is_multi_fluid == 1u {
          let properties_b = properties_of(new_velocity[b].w);
          mass_b = mass_seen(own_properties.z, x_b.w, properties_b.z, properties_b.y);
        }
        if is_stepped() {
          // separation in the middle of the step
          let v_ab = v_a.xyz - new_velocity[b].xyz;
          let x_mid = x_ab - v_ab * u.half_time_step;
          let q = root(squared_ratio(x_mid, scale));
          let slope = continuity_slope(q, scale);
          var rate = continuity_neighbour(dot3(x_mid, v_ab), mass_b, q, slope, scale);
          if m.density_diffusion != NO_DIFFUSION {
            let sound = materials.states[material_index(v_a.w)].z;
            var difference = previous_density_pressure[b].x - previous_density_pressure[a].x;
            if m.density_diffusion == HYDROSTATIC {
              difference = difference - hydrostatic_difference(x_mid, sound, own_properties.z);
            }
            if m.density_diffusion == RENORMALISED {
              difference = difference
                - linear_difference(x_mid, renormalised_gradient[a].xyz, renormalised_gradient[b].xyz);
            }
            let properties_b = properties_of(new_velocity[b].w);
            let part = diffusion_neighbour(difference, sound, mass_b, q, slope, scale);
            let diffused = if_diffusing(part, own_properties.w, properties_b.w, properties_b.y);
            if m.has_closed_walls == 1u { near_sum = near_sum + diffused; } else { rate = rate + diffused; }
          }
          sum = sum + rate;
        } else {
          sum = sum + density_neighbour(number_density_neighbour(q2, scale), mass_b);
        }
        if m.near_pressure == DOUBLE_DENSITY { near_sum = near_sum + near_density_neighbour(mass_b, q2, scale); }
        if sums_walls() {
          wall_sum = wall_sum + density_neighbour(number_density_neighbour(q2, scale), mass_b);
        }
        if m.has_number_density_volume == 1u { number_sum = number_sum + number_density_neighbour(q2, scale); }
      }
    }
  }
  let k = stiffness_of(v_a.w);
  var rate = 0.0f;
  if is_stepped() { rate = deviation_rate(sum, x_a.w, own_properties.z); }
  if m.has_closed_walls == 1u {
    let support = support_of(a);
    if is_stepped() {
      // in the middle of the step
      let x_mid = x_a.xyz - v_a.xyz * u.half_time_step;
      let beyond = of_pressure(x_mid, v_a.xyz, support, 0.0f);
      rate = completed(rate + rate_by_walls(previous_density_pressure[a].x, beyond), beyond.gamma);
      rate = rate + completed_twice_at_most(deviation_rate(near_sum, x_a.w, own_properties.z), beyond.gamma);
    } else {
      sum = completed(sum, of_density(x_a.xyz, v_a.xyz, support, 0.0f).gamma);
    }
    if m.has_number_density_volume == 1u {
      number_sum = completed(number_sum, of_density(x_a.xyz, v_a.xyz, support, 0.0f).gamma);
    }
  }
  var deviation = 0.0f;
  if is_stepped() {
    deviation = deviation_stepped(previous_density_pressure[a].x, rate);
  } else {
    deviation = deviation_of_sum(sum, x_a.w, own_properties.z);
  }
  if sums_walls() && own_properties.y > 0.0f {
    deviation = deviation_of_sum(wall_sum, x_a.w, own_properties.z);
  }
  var pressure = 0.0f;
  if m.pressure_solver == PRESSURE_CORRECTION {
    pressure = pressure_carried(previous_density_pressure[a].y);
  } else {
    pressure = pressure_of_state(deviation, k.state, materials.states[material_index(v_a.w)].w);
  }
  let near_pressure = near_pressure_close(deviation, near_sum, k.near);
  var volume = volume_close(x_a.w, deviation);
  if m.has_number_density_volume == 1u { volume = volume_by_number(volume, number_sum, own_properties.y); }
  new_density_pressure[a] = vec4(deviation, pressure_close(pressure), near_pressure, volume);
}
