// Puts particles that came into a solid back to its surface, and reflects their velocities. CPU counterpart:
// core/src/passes/f_advance/contact.rs, which explains the method.

fn pose_before(i: u32) -> Pose {
  let r = i * POSE_STRIDE;
  return Pose(old_pose[r].xyz, old_pose[r + 1u], old_pose[r + 2u].xyz, old_pose[r + 3u].xyz);
}

struct Hit { is_hit: bool, foot: vec3<f32>, normal: vec3<f32> }

// Returns the point of the surface that is nearest to a point inside of the solid.
fn nearest_hit(i: u32, to: vec3<f32>) -> Hit {
  let seen = solid_surface(i, to);
  return Hit(less(seen.distance, 0.0f), to + seen.normal * -seen.distance, seen.normal);
}

// Returns where the path between two points of its frame comes to a solid.
fn first_hit(i: u32, touch: f32, start: vec3<f32>, to: vec3<f32>) -> Hit {
  let way = to - start;
  if solid_kind(i) == FACET {
    let share = facet_crossing(solid_size(i), touch, start, way);
    return Hit(less(share, 1.5f), start + way * share, vec3(0.0f, 1.0f, 0.0f));
  }
  let length = root(length2(way));
  let before = solid_distance(i, start);
  let after = solid_distance(i, to);
  if less(length, before + after) { return Hit(false, to, way); }
  if less(before, -touch) { return nearest_hit(i, to); }
  var traced = 0.0f;
  var at = start;
  for (var k = 0u; k < MOST_TRACED; k += 1u) {
    at = start + way * share_of_way(traced, length);
    let seen = solid_surface(i, at);
    if less(seen.distance, touch) && less(dot3(seen.normal, way), 0.0f) { return Hit(true, at, seen.normal); }
    traced = traced + larger(seen.distance, larger(touch, length * LEAST_STEP));
    if less(length, traced) { return nearest_hit(i, to); }
  }
  return Hit(true, at, direction_or(way, way) * -1.0f);
}

struct Path { start: vec3<f32>, position: vec3<f32>, velocity: vec3<f32>, is_moved: bool }

// Puts a particle back to the surface of a solid, if it came into it.
fn touched(path: Path, i: u32) -> Path {
  let before = pose_before(i);
  let now = pose_now(i);
  let to = local_of(now, path.position);
  var start = vec3(0.0f, 0.0f, 0.0f);
  if m.is_periodic == 0u {
    start = local_of(before, path.start);
  } else {
    let away = separation(path.position, now.place) + separation(path.start, path.position);
    start = rotated_back(before.turn.xyz, before.turn.w, away + separation(now.place, before.place));
  }
  let hit = first_hit(i, p.touch, start, to);
  if !hit.is_hit { return path; }
  let depth = dot3(hit.foot - to, hit.normal);
  if !less(0.0f, depth) { return path; }
  let position = flush3(world_point(now, to + hit.normal * depth));
  let normal = world_vector(now, hit.normal);
  let wall = speed_of(now, hit.foot);
  let relative = path.velocity - wall;
  let share = share_behind(relative, depth) * solid_row(i, 2u).x;
  let velocity = flush3(wall + reflected(relative, normal, share, solid_row(i, 2u).y));
  return Path(path.start, wrap(position), velocity, true);
}

// Returns a particle in front of all solids and of the planes of the container.
fn in_front_of_all(whole: Path) -> Path {
  var path = whole;
  var hit = false;
  for (var round = 0u; round < ROUNDS; round += 1u) {
    path.is_moved = false;
    for (var i = 0u; i < p.solid_counts.x; i += 1u) { path = touched(path, i); }
    if !path.is_moved { break; }
    hit = true;
    if m.has_container == 1u {
      for (var i = 0u; i < p.plane_count; i += 1u) {
        let plane = p.planes[i];
        path.position = put_back(path.position, plane.xyz, depth_behind(path.position, plane.xyz, plane.w));
      }
    }
  }
  if hit {
    for (var i = 0u; i < p.solid_counts.x; i += 1u) {
      let now = pose_now(i);
      if less(solid_distance(i, local_of(now, path.position)), -p.touch) {
        let at = local_of(pose_before(i), path.start);
        path.position = wrap(flush3(world_point(now, at)));
        path.velocity = flush3(speed_of(now, at));
      }
    }
  }
  path.is_moved = hit;
  return path;
}

fn pass_body(a: u32) {
  if a >= p.particle_count || atomicLoad(&head.status.failed) != 0u { return; }
  let x = new_position[a];
  let v = new_velocity[a];
  if m.has_materials == 1u && properties_of(v.w).y > 0.0f { return; }
  let path = in_front_of_all(Path(start_position[a].xyz, x.xyz, v.xyz, false));
  if !path.is_moved { return; }
  atomicAdd(&head.status.hits, 1u);
  new_position[a] = vec4(path.position, x.w);
  new_velocity[a] = vec4(path.velocity, v.w);
  if has_history() {
    let history = history_reversed(path.velocity, new_acceleration[a].xyz, new_history[a].xyz);
    new_history[a] = vec4(history, 0.0f);
  }
}
