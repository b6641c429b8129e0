// Walls in closed form: adds up what lies beyond the planes around a particle. CPU counterpart:
// core/src/passes/beyond.rs.
fn of_pressure(position: vec3<f32>, velocity: vec3<f32>, support: f32, viscosity: f32) -> Beyond {
  return beyond_of(position, velocity, support, viscosity, PRESSURE_GAMMA, PRESSURE_SURFACE);
}

fn of_density(position: vec3<f32>, velocity: vec3<f32>, support: f32, viscosity: f32) -> Beyond {
  return beyond_of(position, velocity, support, viscosity, DENSITY_GAMMA, DENSITY_SURFACE);
}

fn beyond_of(
  position: vec3<f32>, velocity: vec3<f32>, support: f32, viscosity: f32, gamma: u32, surface: u32,
) -> Beyond {
  let nothing = vec3(0.0f, 0.0f, 0.0f);
  var sum = Beyond(0.0f, nothing, nothing, nothing, 0.0f, nothing);
  let scale = div(1.0f, support);
  var parts = array<f32, PLANES>();
  var in_front = 1.0f;
  for (var i = 0u; i < p.closed_planes; i += 1u) {
    let height = height_in_front(position, p.planes[i].xyz, p.planes[i].w);
    parts[i] = 1.0f;
    if less(height * scale * p.inverse_support, 1.0f) {
      parts[i] = part_in_front(gamma, height * scale * p.inverse_support);
      in_front = in_front * parts[i];
    }
  }
  sum.gamma = 1.0f - in_front;
  for (var i = 0u; i < p.closed_planes; i += 1u) {
    let normal = p.planes[i].xyz;
    let height = height_in_front(position, normal, p.planes[i].w);
    if less(height * scale * p.inverse_support, 1.0f) {
      let wall = p.plane_velocities[i];
      let w1 = plane_surface(surface, height * scale * p.inverse_support, scale, div(in_front, parts[i]));
      let slip = velocity - wall.xyz;
      sum.surface = sum.surface + normal * w1;
      sum.lever = sum.lever + normal_diagonal(normal) * (w1 * height);
      sum.lever_mixed = sum.lever_mixed + normal_mixed(normal) * (w1 * height);
      sum.approach = sum.approach - dot3(slip, normal) * w1;
      sum.drag = sum.drag + plane_drag(slip, normal, height, w1, wall.w, viscosity);
    }
  }
  return sum;
}
