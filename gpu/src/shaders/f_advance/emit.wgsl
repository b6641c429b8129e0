// Finds the points of emitters at which a particle is to be made, and advances the emitters. CPU counterpart:
// core/src/passes/f_advance/emit.rs. A thread has a point and an emitter of the same number.
const NOT_MADE: f32 = 0.0f;
const BLOCKED: f32 = -1.0f;

// Returns whether a particle that requests air beside itself would put it near this place.
fn air_comes(place: vec3<f32>) -> bool {
  if m.has_air == 0u { return false; }
  let own = cell_of(place);
  for (var i = 0u; i < stencil_cells(); i += 1u) {
    let c = stencil_cell(own, i);
    let end = cell_start[c] + head.counter[c];
    for (var b = cell_start[c]; b < end; b += 1u) {
      if spawn_requested[b] == 1u && is_taken(place, place_of(b)) > 0.0f { return true; }
    }
  }
  return false;
}

fn point(i: u32) {
  let place = emitter_points[2u * i];
  let velocity = emitter_points[2u * i + 1u];
  let emitter = emitters[u32(place.w)];
  let state = old_emitter_state[u32(place.w)];
  let since = time_since_layer(state.x, state.y);
  let at = emitted_position(place.xyz, velocity.xyz, since - emitter.x);
  var life = NOT_MADE;
  if layer_leaves(since, emitter.x, state.z) > 0.0f {
    life = BLOCKED;
    if is_free(at) && !air_comes(at) { life = emitter.y; }
  }
  emission[2u * i] = vec4(at, life);
  emission[2u * i + 1u] = velocity;
}

fn pass_body(i: u32) {
  if head.status.failed != 0u { return; }
  if i < p.emitter_points { point(i); }
  if i < p.emitter_count {
    let state = old_emitter_state[i];
    let interval = emitters[i].x;
    let now = time_since_layer(state.x, state.y);
    let lost = time_lost_since_layer(state.x, state.y);
    var since = now;
    var layers = state.w;
    if layer_leaves(now, interval, state.z) > 0.0f {
      since = now - interval;
      layers = layers + 1.0f;
    }
    new_emitter_state[i] = vec4(since, lost, state.z - u.time_step, layers);
  }
}
