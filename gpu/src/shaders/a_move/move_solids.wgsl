// Moves the solids to where they are at the end of the step. CPU counterpart: core/src/solids/motion.rs. Uses one work
// group.
// Moves a solid to its place on its course.
fn follow(i: u32) {
  let r = i * POSE_STRIDE;
  let time = clock_after(head.status.clock, head.status.clock_lost, u.time_step);
  let steady = solid_row(i, 5u);
  let amplitude = solid_row(i, 6u);
  let axis = solid_row(i, 7u);
  let phase = phase_at(solid_row(i, 3u).w, steady.w, time);
  let swing = sine_of_turns(phase);
  let rate = swing_rate(solid_row(i, 3u).w, phase);
  let place = wrap(course_position(solid_row(i, 3u).xyz, steady.xyz, amplitude.xyz, time, swing));
  let angle = course_angle(axis.w, amplitude.w, time, swing) * 0.5f;
  let turn = axis.xyz * sine_of_turns(angle);
  let cosine = cosine_of_turns(angle);
  let q = solid_row(i, 4u);
  let turned = flush3(turned_vector(turn, cosine, q.xyz, q.w));
  new_pose[r] = vec4(place, 0.0f);
  new_pose[r + 1u] = vec4(turned, flush(turned_scalar(turn, cosine, q.xyz, q.w)));
  new_pose[r + 2u] = vec4(course_velocity(steady.xyz, amplitude.xyz, rate), 0.0f);
  new_pose[r + 3u] = vec4(course_spin(axis.xyz, axis.w, amplitude.w, rate), 0.0f);
}

// Moves a solid by the velocities that it has.
fn coast(i: u32) {
  let r = i * POSE_STRIDE;
  let half = half_turn(old_pose[r + 3u].xyz);
  let q = old_pose[r + 1u];
  let turned = turned_vector(half, 1.0f, q.xyz, q.w);
  let scalar = turned_scalar(half, 1.0f, q.xyz, q.w);
  let norm = inverse_norm(turned, scalar);
  new_pose[r] = vec4(wrap(drift(old_pose[r].xyz, old_pose[r + 2u].xyz, u.time_step)), 0.0f);
  new_pose[r + 1u] = vec4(flush3(turned * norm), flush(scalar * norm));
  new_pose[r + 2u] = old_pose[r + 2u];
  new_pose[r + 3u] = old_pose[r + 3u];
}

fn pass_body(thread: u32) {
  if head.status.failed != 0u { return; }
  for (var i = thread; i < p.solid_counts.y; i += WORKGROUP) {
    let solid = i / POSE_STRIDE;
    var motion = 0.0f;
    if solid < p.solid_counts.x { motion = solid_row(solid, 0u).w; }
    if motion == 0.0f {
      new_pose[i] = old_pose[i];
    } else if i % POSE_STRIDE == 0u {
      if motion == ON_COURSE { follow(solid); } else { coast(solid); }
    }
  }
}
