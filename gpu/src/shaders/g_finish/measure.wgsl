// Finds the largest speed, acceleration and speed of sound, which determine the next time step.
fn pass_body(a: u32) {
  if a >= p.particle_count || atomicLoad(&head.status.failed) != 0u { return; }
  let v = new_velocity[a];
  let states = materials.states[material_index(v.w)];
  let sound = bounded_sound(new_density_pressure[a].x, states.z, states.w);
  atomicMax(&head.status.max_speed_squared, bitcast<u32>(bounded_square(v.xyz)));
  atomicMax(&head.status.max_acceleration_squared, bitcast<u32>(bounded_square(new_acceleration[a].xyz)));
  atomicMax(&head.status.max_sound_speed, bitcast<u32>(sound));
}
