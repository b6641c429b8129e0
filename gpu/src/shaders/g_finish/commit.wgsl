// Ends the step: accepts it, has it repeated with a shorter time step, or records that it failed, after which all
// further steps do nothing. Also advances the clock; CPU counterpart of the clock: core/src/clock.rs. Uses one thread.
const NONE: u32 = 0xffffffffu;
fn set_step(step: f32) {
  head.status.time_step = step;
  head.status.half_time_step = step_half(step);
  head.status.inverse_time_step = step_inverse(step);
}

// Sets the next time step. Returns false if the current step must be repeated with it.
fn counts() -> bool {
  let step = u.time_step;
  var wanted = step;
  if m.has_changing_step == 1u {
    let fastest = bitcast<f32>(atomicExchange(&head.status.max_speed_squared, 0u));
    let hardest = bitcast<f32>(atomicExchange(&head.status.max_acceleration_squared, 0u));
    let loudest = bitcast<f32>(atomicExchange(&head.status.max_sound_speed, 0u));
    wanted = step_wanted(fastest, hardest, loudest);
    set_step(step_limited(wanted, step));
    if is_overlong(wanted, step) > 0.0f {
      atomicAdd(&head.status.undone, 1u);
      return false;
    }
    if wanted < p.smallest_time_step { atomicAdd(&head.status.clamped_steps, 1u); }
    atomicAdd(&head.status.rejected_steps, atomicExchange(&head.status.undone, 0u));
    atomicAdd(&head.status.halvings, atomicExchange(&head.status.halvings_of_step, 0u));
    head.status.first_time_step = head.status.time_step;
  }
  head.status.last_time_step = step;
  head.status.last_wanted = wanted;
  let before = head.status.clock;
  let clock = clock_after(before, head.status.clock_lost, step);
  head.status.clock_lost = clock_lost(before, head.status.clock_lost, step, clock);
  head.status.clock = clock;
  return true;
}

// Has a step that cannot be made tried again with half of its time step.
fn shorten() {
  atomicAdd(&head.status.halvings_of_step, 1u);
  atomicStore(&head.status.out_of_range, NONE);
  atomicStore(&head.status.cell_full, NONE);
  atomicStore(&head.status.not_finite, NONE);
  atomicStore(&head.status.iterations, 0u);
  atomicStore(&head.status.refused, 0u);
  atomicStore(&head.status.blocked, 0u);
  atomicStore(&head.status.born, 0u);
  atomicStore(&head.status.removed, 0u);
  atomicStore(&head.status.hits, 0u);
  atomicStore(&head.status.pressure_converged, 0u);
  atomicStore(&head.status.max_speed_squared, 0u);
  atomicStore(&head.status.max_acceleration_squared, 0u);
  atomicStore(&head.status.max_sound_speed, 0u);
  set_step(step_half(u.time_step));
  atomicStore(&head.status.failed, 2u);
}

fn pass_body(thread: u32) {
  if thread != 0u { return; }
  let failed = atomicLoad(&head.status.failed);
  if failed == 2u { atomicStore(&head.status.failed, 0u); }
  if failed != 0u { return; }
  let full = atomicLoad(&head.status.cell_full);
  if full != NONE { atomicStore(&head.status.cell_count, atomicLoad(&head.counter[full])); }
  if full != NONE || atomicLoad(&head.status.out_of_range) != NONE || atomicLoad(&head.status.not_finite) != NONE {
    if atomicLoad(&head.status.halvings_of_step) < m.most_halvings {
      shorten();
      return;
    }
    atomicStore(&head.status.failed, 1u);
    // the clock did not advance either, so the time step gets back its value from before this step
    if m.has_changing_step == 1u { set_step(head.status.first_time_step); }
    return;
  }
  let iterations = atomicExchange(&head.status.iterations, 0u);
  let refused = atomicExchange(&head.status.refused, 0u);
  let blocked = atomicExchange(&head.status.blocked, 0u);
  let born = atomicExchange(&head.status.born, 0u);
  let removed = atomicExchange(&head.status.removed, 0u);
  let hits = atomicExchange(&head.status.hits, 0u);
  atomicStore(&head.status.pressure_converged, 0u);
  if !counts() {
    if atomicLoad(&head.status.undone) < MOST_ATTEMPTS {
      atomicStore(&head.status.failed, 2u);
      return;
    }
    // the step was too long in every attempt, so it fails
    atomicStore(&head.status.failed, 1u);
    set_step(head.status.first_time_step);
    return;
  }
  atomicAdd(&head.status.steps, 1u);
  atomicStore(&head.status.last_iterations, iterations);
  atomicStore(&head.status.last_residual, atomicLoad(&head.status.left));
  atomicAdd(&head.status.total_iterations, iterations);
  // the counts saturate at their maximum
  atomicAdd(&head.status.air_refused, min(refused, NONE - atomicLoad(&head.status.air_refused)));
  atomicAdd(&head.status.total_blocked, min(blocked, NONE - atomicLoad(&head.status.total_blocked)));
  atomicAdd(&head.status.total_born, min(born, NONE - atomicLoad(&head.status.total_born)));
  atomicAdd(&head.status.total_removed, min(removed, NONE - atomicLoad(&head.status.total_removed)));
  atomicAdd(&head.status.total_hits, min(hits, NONE - atomicLoad(&head.status.total_hits)));
  atomicStore(&head.status.air_alive, atomicLoad(&head.status.alive));
}
