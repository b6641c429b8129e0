// Advances the internal energy of each particle.
fn at_step(a: u32) -> vec3<f32> { return end_velocity[a].xyz; }

fn pass_body(i: u32) {
  if i >= p.particle_count || head.status.failed != 0u { return; }
  let a = local(i);
  if is_inactive(new_velocity[i].w) {
    // new air particles start with this internal energy
    new_internal_energy[i] = vec4(p.air_internal_energy, 0.0f, 0.0f, 0.0f);
    return;
  }
  if a.wall > 0.0f { return; }
  let v_a = at_step(i);
  let own = cell_of(a.position);
  var sum = 0.0f;
  var heat = 0.0f;
  var shares = 0.0f;
  for (var i = 0u; i < stencil_cells(); i += 1u) {
    let c = stencil_cell(own, i);
    let end = cell_start[c] + head.counter[c];
    for (var j = cell_start[c]; j < end; j += 1u) {
      let b = local(j);
      if is_near(a, b) {
        let v_ab = v_a - at_step(j);
        sum = sum + internal_energy_neighbour(a, b, v_ab);
        if m.has_velocity_exchange == 1u {
          heat = heat + exchange_dissipation(a, b, v_ab);
          shares = shares + exchange_share(a, b);
        }
      }
    }
  }
  var rate = internal_energy_close(sum, a);
  if m.has_velocity_exchange == 1u { rate = rate + heat * exchange_close(shares); }
  let before = new_internal_energy[i];
  new_internal_energy[i] = vec4(internal_energy_stepped(before.x, before.y, rate), rate, 0.0f, 0.0f);
}
