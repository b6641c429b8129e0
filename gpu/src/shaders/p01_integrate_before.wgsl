// Half kick and drift. The moved particles wait, unsorted, in two arrays that are not in use yet.
fn pass_body(a: u32) {
  if a >= p.particle_count || head.status.failed != 0u { return; }
  let velocity = old_velocity[a];
  let v = kick(velocity.xyz, old_acceleration[a].xyz, p.half_time_step);
  var way = v;
  if m.xsph == 1u { way = way + old_smoothing[a].xyz; }
  way = if_free(way, kind(velocity.w).y);
  let x = wrap(drift(old_position[a].xyz, way, p.time_step));
  new_acceleration[a] = vec4(v, velocity.w);
  new_density_pressure[a] = vec4(x, old_position[a].w);
}
