// Gives each request for a new particle one that is inactive. CPU counterpart: core/src/passes/g_finish/spawn.rs. Uses
// one work group. Each thread visits a range of the ids of all particles that may request air, a range of the points of
// emitters, and a range of the ids that can be inactive. From the counts of the threads before it, it knows the index
// of its first request and of its first inactive particle. The requests are queued behind the entries of
// `spawn_requested`.
var<workgroup> births: array<u32, WORKGROUP>;
var<workgroup> emitted: array<u32, WORKGROUP>;
var<workgroup> sleepers: array<u32, WORKGROUP>;
var<workgroup> all_births: u32;

fn share_from(thread: u32, count: u32) -> u32 { return min(thread * ((count + WORKGROUP - 1u) / WORKGROUP), count); }

// Returns whether an air particle is requested beside the particle in this slot, which stays.
fn asks(slot: u32) -> bool { return spawn_requested[slot] == 1u && fate[slot] != 1u; }

fn pass_body(thread: u32) {
  let capacity = p.particle_count - p.first_spare;
  var parents = 0u;
  if m.has_air == 1u { parents = p.particle_count; }
  var points = 0u;
  if m.has_emitters == 1u { points = p.emitter_points; }
  let first_parent = share_from(thread, parents);
  let end_parent = share_from(thread + 1u, parents);
  let first_point = share_from(thread, points);
  let end_point = share_from(thread + 1u, points);
  let first_own = p.first_spare + share_from(thread, capacity);
  let end_own = p.first_spare + share_from(thread + 1u, capacity);

  var count = 0u;
  for (var id = first_parent; id < end_parent; id += 1u) { count += u32(asks(new_slot_of_id[id])); }
  births[thread] = count;
  var blocked = 0u;
  count = 0u;
  for (var i = first_point; i < end_point; i += 1u) {
    if emission[2u * i].w > 0.0f { count += 1u; }
    if emission[2u * i].w < 0.0f { blocked += 1u; }
  }
  emitted[thread] = count;
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
    for (var i = 0u; i < WORKGROUP; i += 1u) {
      let here = emitted[i];
      emitted[i] = before;
      before += here;
    }
    all_births = before;
    if atomicLoad(&head.status.failed) == 0u {
      atomicStore(&head.status.alive, 0u);
      atomicStore(&head.status.blocked, 0u);
      atomicStore(&head.status.removed, 0u);
      atomicStore(&head.status.born, min(before, asleep_before));
      atomicStore(&head.status.refused, before - min(before, asleep_before));
    }
  }
  workgroupBarrier();
  var next = births[thread];
  for (var id = first_parent; id < end_parent; id += 1u) {
    let slot = new_slot_of_id[id];
    if asks(slot) {
      if next < capacity { spawn_requested[p.particle_count + next] = slot; }
      next += 1u;
    }
  }
  next = emitted[thread];
  for (var i = first_point; i < end_point; i += 1u) {
    if emission[2u * i].w > 0.0f {
      if next < capacity { spawn_requested[p.particle_count + next] = p.particle_count + i; }
      next += 1u;
    }
  }
  storageBarrier();
  if atomicLoad(&head.status.failed) != 0u { return; }
  next = sleepers[thread];
  var alive = 0u;
  var removed = 0u;
  for (var id = first_own; id < end_own; id += 1u) {
    let slot = new_slot_of_id[id];
    let is_air = m.has_air == 1u && material_index(new_velocity[slot].w) == u32(p.air_fluid);
    if !is_inactive(new_velocity[slot].w) {
      if fate[slot] == 1u {
        removed += 1u;
      } else if is_air {
        alive += 1u;
      }
    } else {
      if next < all_births {
        let request = spawn_requested[p.particle_count + next];
        fate[slot] = 2u + request;
        if request < p.particle_count { alive += 1u; }
      }
      next += 1u;
    }
  }
  atomicAdd(&head.status.alive, alive);
  atomicAdd(&head.status.removed, removed);
  atomicAdd(&head.status.blocked, blocked);
}
