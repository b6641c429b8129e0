// Walls in closed form: adds up what lies beyond the planes and the solids around a particle. CPU counterpart:
// core/src/passes/beyond.rs.
struct Face { normal: vec3<f32>, height: f32, ratio: f32, velocity: vec3<f32>, viscosity: f32 }

fn of_pressure(position: vec3<f32>, velocity: vec3<f32>, support: f32, viscosity: f32) -> Beyond {
  return beyond_of(position, velocity, support, viscosity, PRESSURE_GAMMA, PRESSURE_SURFACE, PRESSURE_BENDING);
}

fn of_density(position: vec3<f32>, velocity: vec3<f32>, support: f32, viscosity: f32) -> Beyond {
  return beyond_of(position, velocity, support, viscosity, DENSITY_GAMMA, DENSITY_SURFACE, DENSITY_BENDING);
}

// Adds what a face contributes; `share` is the part of its surface that counts.
fn with_face(
  velocity: vec3<f32>, support: f32, viscosity: f32, surface: u32, before: Beyond, face: Face, share: f32,
) -> Beyond {
  var sum = before;
  let w1 = plane_surface(surface, abs(face.ratio), div(1.0f, support), share);
  let slip = velocity - face.velocity;
  sum.surface = sum.surface + face.normal * w1;
  sum.lever = sum.lever + normal_diagonal(face.normal) * (w1 * face.height);
  sum.lever_mixed = sum.lever_mixed + normal_mixed(face.normal) * (w1 * face.height);
  sum.approach = sum.approach - dot3(slip, face.normal) * w1;
  let height = larger(face.height, 0.0f);
  sum.drag = sum.drag + plane_drag(slip, face.normal, height, w1, face.viscosity, viscosity);
  return sum;
}

fn beyond_of(
  position: vec3<f32>, velocity: vec3<f32>, support: f32, viscosity: f32, gamma: u32, surface: u32, bending: u32,
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
  in_front = front_of_solids(position, support, gamma, bending, in_front);
  sum.gamma = 1.0f - in_front;
  for (var i = 0u; i < p.closed_planes; i += 1u) {
    let normal = p.planes[i].xyz;
    let height = height_in_front(position, normal, p.planes[i].w);
    let ratio = height * scale * p.inverse_support;
    if less(ratio, 1.0f) {
      let wall = p.plane_velocities[i];
      let face = Face(normal, height, ratio, wall.xyz, wall.w);
      sum = with_face(velocity, support, viscosity, surface, sum, face, div(in_front, parts[i]));
    }
  }
  return with_solids(position, velocity, support, viscosity, gamma, surface, bending, sum, in_front);
}
