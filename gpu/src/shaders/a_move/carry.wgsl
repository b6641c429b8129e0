// Carries the particles of solids along with them.
fn pass_body(a: u32) {
  if a >= p.particle_count || head.status.failed != 0u { return; }
  let own = anchor[old_id[a]];
  if own.w < 0.0f { return; }
  let pose = pose_now(u32(own.w));
  moved_position[a] = vec4(wrap(flush3(world_point(pose, own.xyz))), moved_position[a].w);
  moved_velocity[a] = vec4(flush3(speed_of(pose, own.xyz)), moved_velocity[a].w);
}
