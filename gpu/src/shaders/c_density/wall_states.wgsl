// Sets pressure, density and volume of the wall particles, and fills the velocities that viscosity sees.
fn pass_body(i: u32) {
  if i >= p.particle_count || head.status.failed != 0u { return; }
  let v = new_velocity[i];
  if !(properties_of(v.w).y > 0.0f) || is_inactive(v.w) {
    seen_velocity[i] = v;
    return;
  }
  let seen = seen_velocity[i];
  let states = materials.states[material_index(v.w)];
  let deviation = wall_deviation(seen.w, states.x, states.w);
  new_density_pressure[i] = vec4(deviation, seen.w, 0.0f, volume_close(new_position[i].w, deviation));
  seen_velocity[i] = vec4(seen.xyz, v.w);
}
