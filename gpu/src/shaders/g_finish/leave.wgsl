// Finds the particles that become inactive: air that is too thin, particles whose life has ended, and those that a
// drain takes. CPU counterpart: core/src/passes/g_finish/leave.rs.
fn drains(position: vec3<f32>) -> bool {
  for (var i = 0u; i < p.drain_count; i += 1u) {
    let one = p.drains[2u * i];
    let other = p.drains[2u * i + 1u];
    if is_drained(position, one.xyz, other.xyz, one.w) > 0.0f { return true; }
  }
  return false;
}

fn pass_body(a: u32) {
  if a >= p.particle_count || head.status.failed != 0u { return; }
  fate[a] = 0u;
  let w = new_velocity[a].w;
  if properties_of(w).y > 0.0f || new_id[a] < p.first_spare { return; }
  let is_air = m.has_air == 1u && material_index(w) == u32(p.air_fluid);
  var leaves = is_air && is_thin(new_density_pressure[a].x) > 0.0f;
  if m.has_turnover == 1u {
    let left = life_after(new_life[a].y);
    new_life[a].y = left;
    leaves = leaves || left <= 0.0f || drains(new_position[a].xyz);
  }
  if leaves { fate[a] = 1u; }
}
