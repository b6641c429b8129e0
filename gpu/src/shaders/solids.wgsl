// Solids: their constants and poses, and the point of their surface that is nearest to a particle. CPU counterpart:
// core/src/solids/mod.rs.
struct Pose { place: vec3<f32>, turn: vec4<f32>, velocity: vec3<f32>, spin: vec3<f32> }
struct Surface { distance: f32, normal: vec3<f32> }

fn solid_row(i: u32, r: u32) -> vec4<f32> { return p.solids[i * SOLID_STRIDE + r]; }
fn solid_kind(i: u32) -> u32 { return u32(solid_row(i, 0u).x); }
fn solid_side(i: u32) -> f32 { return solid_row(i, 0u).y; }
fn solid_size(i: u32) -> vec3<f32> { return solid_row(i, 1u).xyz; }

fn pose_now(i: u32) -> Pose {
  let r = i * POSE_STRIDE;
  return Pose(new_pose[r].xyz, new_pose[r + 1u], new_pose[r + 2u].xyz, new_pose[r + 3u].xyz);
}

fn local_of(pose: Pose, position: vec3<f32>) -> vec3<f32> {
  return rotated_back(pose.turn.xyz, pose.turn.w, separation(position, pose.place));
}
fn world_vector(pose: Pose, v: vec3<f32>) -> vec3<f32> { return rotated(pose.turn.xyz, pose.turn.w, v); }
fn world_point(pose: Pose, local: vec3<f32>) -> vec3<f32> { return pose.place + world_vector(pose, local); }
fn speed_of(pose: Pose, local: vec3<f32>) -> vec3<f32> {
  return velocity_at(pose.velocity, pose.spin, world_vector(pose, local));
}

fn polygon(i: u32, local: vec3<f32>) -> Surface {
  var nearest = vec3(3.4028235e38f, 0.0f, 0.0f);
  var least = 3.4028235e38f;
  var along = vec3(1.0f, 0.0f, 0.0f);
  var turns = 0.0f;
  let first = u32(solid_row(i, 8u).x);
  let count = u32(solid_row(i, 8u).y);
  for (var k = 0u; k < count; k += 1u) {
    let start = new_pose[first + 2u * k].xyz;
    let side = new_pose[first + 2u * k + 1u].xyz;
    let away = from_side(start, side, local);
    turns = turns + winding(start, side, local);
    if length2(away) < least {
      nearest = away;
      least = length2(away);
      along = side;
    }
  }
  var outside = -1.0f;
  if turns == 0.0f { outside = 1.0f; }
  let distance = root(length2(nearest)) * outside;
  let other = direction_or(vec3(along.y, -along.x, 0.0f), nearest);
  let normal = direction_or(nearest * outside, other);
  return Surface(distance * solid_side(i), normal * solid_side(i));
}

// Returns the distance of a point of a solid's frame from its surface, m; negative inside of the solid.
// Nothing is inside of a facet.
fn solid_distance(i: u32, local: vec3<f32>) -> f32 {
  if solid_kind(i) == FACET { return 3.4028235e38f; }
  if solid_kind(i) == POLYGON { return polygon(i, local).distance; }
  return shape_distance(solid_kind(i), solid_size(i), local) * solid_side(i);
}

// Returns what a solid looks like from a point of its frame.
fn solid_surface(i: u32, local: vec3<f32>) -> Surface {
  if solid_kind(i) == POLYGON { return polygon(i, local); }
  let normal = shape_normal(solid_kind(i), solid_size(i), local) * solid_side(i);
  return Surface(solid_distance(i, local), normal);
}

// Returns the acceleration with which the solids that repel act on a particle, m/s2.
fn repelled(position: vec3<f32>) -> vec3<f32> {
  var sum = vec3(0.0f, 0.0f, 0.0f);
  for (var i = 0u; i < p.solid_counts.x; i += 1u) {
    if solid_row(i, 0u).z != REPELS { continue; }
    let pose = pose_now(i);
    let local = local_of(pose, position);
    let strength = solid_row(i, 2u).w;
    if solid_kind(i) == FACET {
      var above = is_over_facet(solid_size(i), local);
      if less(local.y, 0.0f) { above = 0.0f; }
      sum = sum + world_vector(pose, vec3(0.0f, repulsion(strength, local.y) * above, 0.0f));
    } else {
      let seen = solid_surface(i, local);
      sum = sum + world_vector(pose, seen.normal * repulsion(strength, seen.distance));
    }
  }
  return sum;
}

fn solid_curvature(i: u32, local: vec3<f32>) -> f32 {
  return shape_curvature(solid_kind(i), solid_size(i), local) * solid_side(i);
}

// Returns whether a position lies in a solid.
fn is_in_solid(position: vec3<f32>) -> bool {
  for (var i = 0u; i < p.solid_counts.x; i += 1u) {
    if less(solid_distance(i, local_of(pose_now(i), position)), 0.0f) { return true; }
  }
  return false;
}
