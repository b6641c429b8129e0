// Is the pressure good enough? Then its force is to act once more, and after that there is nothing left to do. One thread.
fn pass_body(thread: u32) {
  if thread != 0u || atomicLoad(&head.status.failed) != 0u { return; }
  let settled = atomicLoad(&head.status.pressure_converged);
  if settled == 1u { atomicStore(&head.status.pressure_converged, 2u); }
  if settled != 0u { return; }
  atomicAdd(&head.status.iterations, 1u);
  let left = atomicExchange(&head.status.residual, 0u);
  atomicStore(&head.status.left, left);
  if bitcast<f32>(left) <= p.tolerance { atomicStore(&head.status.pressure_converged, 1u); }
}
