// Sets the particles that come and go. CPU counterpart: core/src/passes/g_finish/renew.rs.
//
// Resets a particle to rest density, without pressure or acceleration, and with this velocity and material.
fn reset(slot: u32, velocity: f32x4) {
  new_velocity[slot] = velocity;
  new_acceleration[slot] = vec4(0.0f, 0.0f, 0.0f, 0.0f);
  new_density_pressure[slot] = vec4(0.0f, 0.0f, 0.0f, p.rest_volume);
}

fn pass_body(a: u32) {
  if a >= p.particle_count || head.status.failed != 0u { return; }
  let own = fate[a];
  if own == 0u { return; }
  if own == 1u {
    reset(a, vec4(0.0f, 0.0f, 0.0f, f32(MATERIALS - 1u)));
    return;
  }
  let request = own - 2u;
  var life = 3.4028234663852886e38f;
  if request < p.particle_count {
    if m.has_air == 1u {
      // the particle beside which air was requested is active, so no other thread changes it
      let parent = spawn_position(new_position[request].xyz, total_colour_gradient[request].xyz);
      new_position[a] = vec4(parent, 1.0f);
      reset(a, vec4(new_velocity[request].xyz, p.air_fluid));
    }
  } else {
    let first = 2u * (request - p.particle_count);
    life = emission[first].w;
    new_position[a] = vec4(emission[first].xyz, 1.0f);
    reset(a, emission[first + 1u]);
  }
  if m.has_turnover == 1u {
    new_life[a].x = new_life[a].x + 1.0f;
    new_life[a].y = life;
  }
}
