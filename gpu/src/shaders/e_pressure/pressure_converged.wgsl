// Checks whether the pressure iteration has converged. If it has, pressure_converged becomes 1: the force of the last
// pressure still has to be computed. In the next iteration it becomes 2, and all further iterations do nothing. Uses
// one thread.
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
