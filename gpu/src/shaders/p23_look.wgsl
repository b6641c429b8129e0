// A look at every number that is about to become the state: is it one, and, where the time step follows from that, how large?
fn is_finite(x: f32x4) -> bool {
  return all((bitcast<vec4<u32>>(x) & vec4(0x7f800000u)) != vec4(0x7f800000u));
}

fn pass_body(a: u32) {
  if a >= p.particle_count || atomicLoad(&head.status.failed) != 0u { return; }
  var quantity = 4u;
  if has_history() && !is_finite(new_history[a]) { quantity = 3u; }
  if m.thermal_energy == 1u && !is_finite(new_heat[a]) { quantity = 3u; }
  if !is_finite(new_density_pressure[a]) { quantity = 3u; }
  if !is_finite(new_acceleration[a]) { quantity = 2u; }
  if !is_finite(new_velocity[a]) { quantity = 1u; }
  if !is_finite(new_position[a]) { quantity = 0u; }
  if quantity < 4u {
    atomicMin(&head.status.not_finite, 4u * new_id[a] + quantity);
  }
  if m.adaptive == 1u {
    let v = new_velocity[a];
    let states = p.states[kind_index(v.w)];
    let sound = bounded_sound(new_density_pressure[a].x, states.z, states.w);
    atomicMax(&head.status.fastest, bitcast<u32>(bounded_square(v.xyz)));
    atomicMax(&head.status.hardest, bitcast<u32>(bounded_square(new_acceleration[a].xyz)));
    atomicMax(&head.status.loudest, bitcast<u32>(sound));
  }
}
