// What becomes of the step: it counts, or nothing does any more. One thread.
const NONE: u32 = 0xffffffffu;
fn pass_body(thread: u32) {
  if thread != 0u || atomicLoad(&head.status.failed) != 0u { return; }
  let full = atomicLoad(&head.status.cell_full);
  if full != NONE { atomicStore(&head.status.cell_count, atomicLoad(&head.counter[full])); }
  if full != NONE || atomicLoad(&head.status.out_of_range) != NONE || atomicLoad(&head.status.not_finite) != NONE {
    atomicStore(&head.status.failed, 1u);
  } else {
    atomicAdd(&head.status.steps, 1u);
    let iterations = atomicExchange(&head.status.iterations, 0u);
    atomicStore(&head.status.last_iterations, iterations);
    atomicAdd(&head.status.total_iterations, iterations);
    atomicStore(&head.status.settled, 0u);
    // a count that is full stays so
    let room = NONE - atomicLoad(&head.status.air_refused);
    atomicAdd(&head.status.air_refused, min(atomicExchange(&head.status.refused, 0u), room));
    atomicStore(&head.status.air_alive, atomicLoad(&head.status.alive));
  }
}
