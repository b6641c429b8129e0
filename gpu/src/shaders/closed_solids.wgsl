// Solids as walls in closed form: what of a kernel lies in them. CPU counterpart: core/src/passes/closed_solids.rs.
struct Near { is_near: bool, local: vec3<f32>, surface: Surface, inverse: f32 }

fn near_solid(i: u32, pose: Pose, position: vec3<f32>, support: f32) -> Near {
  let inverse = div(1.0f, support) * p.inverse_support;
  let local = local_of(pose, position);
  let seen = solid_surface(i, local);
  let is_near = solid_row(i, 0u).z == CLOSED_FORM && less(seen.distance * inverse, 1.0f);
  if less(seen.distance, 0.0f) {
    return Near(is_near, local + seen.normal * -seen.distance, Surface(0.0f, seen.normal), inverse);
  }
  return Near(is_near, local, seen, inverse);
}

// Returns the parts of a kernel between the pairs of sides of a box.
fn between(i: u32, near: Near, gamma: u32) -> vec3<f32> {
  let half = solid_size(i);
  let x = part_between(gamma, half.x * near.inverse, near.local.x * near.inverse);
  let y = part_between(gamma, half.y * near.inverse, near.local.y * near.inverse);
  if m.is_3d == 0u { return vec3(x, y, 1.0f); }
  return vec3(x, y, part_between(gamma, half.z * near.inverse, near.local.z * near.inverse));
}

// Returns how far a particle lies within the round side of a cylinder, over its support radius, and half of the
// curvature of that side.
fn round_side(i: u32, near: Near) -> vec2<f32> {
  let size = solid_size(i);
  return vec2(-beyond_cylinder(size, near.local).x * near.inverse, div(0.5f, size.x * near.inverse));
}

// Returns the parts of a kernel between the ends of a cylinder, and within its side.
fn in_cylinder(i: u32, near: Near, gamma: u32, bending: u32) -> vec2<f32> {
  let side = round_side(i, near);
  let ends = part_between(gamma, solid_size(i).y * near.inverse, near.local.y * near.inverse);
  return vec2(ends, part_within(gamma, bending, side.x, side.y));
}

fn bend_of(i: u32, near: Near) -> f32 { return div(solid_curvature(i, near.local) * 0.5f, near.inverse); }

fn front_of_solid(i: u32, near: Near, gamma: u32, bending: u32) -> f32 {
  if solid_kind(i) == BOX || solid_kind(i) == CYLINDER {
    var inside = 0.0f;
    if solid_kind(i) == BOX {
      let parts = between(i, near, gamma);
      inside = parts.x * parts.y * parts.z;
    } else {
      let parts = in_cylinder(i, near, gamma, bending);
      inside = parts.x * parts.y;
    }
    if solid_side(i) < 0.0f { return inside; }
    return 1.0f - inside;
  }
  return part_in_front_of_curved(gamma, bending, near.surface.distance * near.inverse, bend_of(i, near));
}

// Returns the part of a kernel in front of all walls; `in_front` is the part in front of the planes.
fn front_of_solids(position: vec3<f32>, support: f32, gamma: u32, bending: u32, in_front: f32) -> f32 {
  var all = in_front;
  for (var i = 0u; i < p.solid_counts.x; i += 1u) {
    let near = near_solid(i, pose_now(i), position, support);
    if near.is_near { all = all * front_of_solid(i, near, gamma, bending); }
  }
  return all;
}

// Adds what the solids contribute.
fn with_solids(
  position: vec3<f32>, velocity: vec3<f32>, support: f32, viscosity: f32, gamma: u32, surface: u32, bending: u32,
  before: Beyond, in_front: f32,
) -> Beyond {
  var sum = before;
  for (var i = 0u; i < p.solid_counts.x; i += 1u) {
    let pose = pose_now(i);
    let near = near_solid(i, pose, position, support);
    if !near.is_near { continue; }
    let others = div(in_front, front_of_solid(i, near, gamma, bending));
    let speed = speed_of(pose, near.local);
    let rough = solid_row(i, 2u).z;
    if solid_kind(i) == CYLINDER {
      let parts = in_cylinder(i, near, gamma, bending);
      let round = round_side(i, near);
      let side = solid_side(i);
      let size = solid_size(i);
      let up = vec3(0.0f, side, 0.0f);
      let high = (near.local.y - size.y) * side;
      let low = (-near.local.y - size.y) * side;
      let top = Face(world_vector(pose, up), high, high * near.inverse, speed, rough);
      sum = with_face(velocity, support, viscosity, surface, sum, top, others * parts.y);
      let bottom = Face(world_vector(pose, up * -1.0f), low, low * near.inverse, speed, rough);
      sum = with_face(velocity, support, viscosity, surface, sum, bottom, others * parts.y);
      let away = direction_or(vec3(near.local.x, 0.0f, near.local.z), vec3(1.0f, 0.0f, 0.0f)) * side;
      let height = beyond_cylinder(size, near.local).x * side;
      let around = Face(world_vector(pose, away), height, height * near.inverse, speed, rough);
      let share = others * parts.x * curved_share(-round.x, round.y);
      sum = with_face(velocity, support, viscosity, surface, sum, around, share);
      continue;
    }
    if solid_kind(i) != BOX {
      let ratio = near.surface.distance * near.inverse;
      let share = others * curved_share(ratio, bend_of(i, near));
      let face = Face(world_vector(pose, near.surface.normal), near.surface.distance, ratio, speed, rough);
      sum = with_face(velocity, support, viscosity, surface, sum, face, share);
      continue;
    }
    let parts = between(i, near, gamma);
    let side = solid_side(i);
    let half = solid_size(i);
    for (var axis = 0u; axis < 2u + m.is_3d; axis += 1u) {
      var normal = vec3(side, 0.0f, 0.0f);
      var share = parts.y * parts.z;
      if axis == 1u {
        normal = vec3(0.0f, side, 0.0f);
        share = parts.x * parts.z;
      }
      if axis == 2u {
        normal = vec3(0.0f, 0.0f, side);
        share = parts.x * parts.y;
      }
      let high = (near.local[axis] - half[axis]) * side;
      let low = (-near.local[axis] - half[axis]) * side;
      let high_face = Face(world_vector(pose, normal), high, high * near.inverse, speed, rough);
      sum = with_face(velocity, support, viscosity, surface, sum, high_face, others * share);
      let low_face = Face(world_vector(pose, normal * -1.0f), low, low * near.inverse, speed, rough);
      sum = with_face(velocity, support, viscosity, surface, sum, low_face, others * share);
    }
  }
  return sum;
}
