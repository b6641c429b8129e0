// Half kick, drift, and the cell that each particle comes to. The moved particles wait, unsorted, in two arrays that are
// not in use yet.
fn pass_body(a: u32) {
  if a >= p.particle_count || atomicLoad(&head.status.failed) != 0u { return; }
  let v = kick(old_velocity[a].xyz, old_acceleration[a].xyz, p.half_time_step);
  let x = drift(old_position[a].xyz, v, p.time_step);
  new_acceleration[a] = vec4(v, 0.0f);
  new_density_pressure[a] = vec4(x, 0.0f);
  let axis = axis_out_of_range(x);
  if axis < 3u {
    atomicMin(&head.status.out_of_range, 4u * old_id[a] + axis);
  } else {
    cell[a] = cell_index(cell_of(x));
  }
}
