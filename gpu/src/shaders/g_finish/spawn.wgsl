// Makes air particles where the pass spawn_requests requested them, and removes those whose density is too low. Uses
// one work group. Each thread visits a range of the ids of all particles that may request air, and a range of the ids
// of the air layer. From the counts of the threads before it, it knows the index of its first request and of its first
// inactive particle. The slots of the particles that request air are queued behind the entries of `spawn_requested`.
var<workgroup> births: array<u32, WORKGROUP>;
var<workgroup> sleepers: array<u32, WORKGROUP>;
var<workgroup> all_births: u32;

// Resets a particle to rest density, without pressure or acceleration, and with this velocity and material.
fn renew(slot: u32, velocity: f32x4) {
  new_velocity[slot] = velocity;
  new_acceleration[slot] = vec4(0.0f, 0.0f, 0.0f, 0.0f);
  new_density_pressure[slot] = vec4(0.0f, 0.0f, 0.0f, p.rest_volume);
}

fn pass_body(thread: u32) {
  let capacity = p.particle_count - p.first_air;
  let parents = (p.first_air + WORKGROUP - 1u) / WORKGROUP;
  let own = (capacity + WORKGROUP - 1u) / WORKGROUP;
  let first_parent = min(thread * parents, p.first_air);
  let end_parent = min(first_parent + parents, p.first_air);
  let first_own = min(p.first_air + thread * own, p.particle_count);
  let end_own = min(first_own + own, p.particle_count);

  var count = 0u;
  for (var id = first_parent; id < end_parent; id += 1u) { count += spawn_requested[new_slot_of_id[id]]; }
  births[thread] = count;
  var asleep = 0u;
  for (var id = first_own; id < end_own; id += 1u) {
    if is_inactive(new_velocity[new_slot_of_id[id]].w) { asleep += 1u; }
  }
  sleepers[thread] = asleep;
  workgroupBarrier();
  if thread == 0u {
    var before = 0u;
    var asleep_before = 0u;
    for (var i = 0u; i < WORKGROUP; i += 1u) {
      let here = births[i];
      births[i] = before;
      before += here;
      let asleep_here = sleepers[i];
      sleepers[i] = asleep_before;
      asleep_before += asleep_here;
    }
    all_births = before;
    if atomicLoad(&head.status.failed) == 0u {
      atomicStore(&head.status.alive, 0u);
      atomicStore(&head.status.refused, before - min(before, asleep_before));
    }
  }
  workgroupBarrier();
  var next = births[thread];
  for (var id = first_parent; id < end_parent; id += 1u) {
    let slot = new_slot_of_id[id];
    if spawn_requested[slot] == 1u {
      if next < capacity { spawn_requested[p.particle_count + next] = slot; }
      next += 1u;
    }
  }
  storageBarrier();
  if atomicLoad(&head.status.failed) != 0u { return; }
  next = sleepers[thread];
  var alive = 0u;
  for (var id = first_own; id < end_own; id += 1u) {
    let slot = new_slot_of_id[id];
    if !is_inactive(new_velocity[slot].w) {
      if is_thin(new_density_pressure[slot].x) > 0.0f {
        renew(slot, vec4(0.0f, 0.0f, 0.0f, f32(MATERIALS - 1u)));
      } else {
        alive += 1u;
      }
    } else {
      if next < all_births {
        let parent = spawn_requested[p.particle_count + next];
        new_position[slot] = vec4(spawn_position(new_position[parent].xyz, total_colour_gradient[parent].xyz), 1.0f);
        renew(slot, vec4(new_velocity[parent].xyz, p.air_fluid));
        alive += 1u;
      }
      next += 1u;
    }
  }
  atomicAdd(&head.status.alive, alive);
}
