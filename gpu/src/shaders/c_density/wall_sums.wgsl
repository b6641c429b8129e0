// Takes pressure and velocity from the fluid to the wall particles in it.
fn pass_body(i: u32) {
  if i >= p.particle_count || head.status.failed != 0u { return; }
  let a = local(i);
  if !(a.wall > 0.0f) || is_inactive(new_velocity[i].w) { return; }
  let own = cell_of(a.position);
  var field = vec3(0.0f, 0.0f, 0.0f);
  if m.has_acceleration_field == 1u { field = field_at(a.position); }
  var sum = 0.0f;
  var weights = 0.0f;
  var velocities = vec3(0.0f, 0.0f, 0.0f);
  for (var i = 0u; i < stencil_cells(); i += 1u) {
    let c = stencil_cell(own, i);
    let end = cell_start[c] + head.counter[c];
    for (var j = cell_start[c]; j < end; j += 1u) {
      let b = local(j);
      if is_near(a, b) {
        let w = wall_weight(a, b);
        sum = sum + wall_pressure_neighbour(a, b, field, w);
        weights = weights + w;
        if extrapolates_velocity() { velocities = velocities + b.velocity * w; }
      }
    }
  }
  var seen = a.velocity;
  if extrapolates_velocity() { seen = wall_velocity(a.velocity, velocities, weights); }
  seen_velocity[i] = vec4(seen, wall_pressure(sum, weights));
}
