// Checks that an array of the new state is finite. Runs once for each array.
fn is_finite(x: f32x4) -> bool {
  return all((bitcast<vec4<u32>>(x) & vec4(0x7f800000u)) != vec4(0x7f800000u));
}

fn pass_body(a: u32) {
  if a >= p.particle_count || atomicLoad(&head.status.failed) != 0u { return; }
  if !is_finite(checked[a]) {
    atomicMin(&head.status.not_finite, QUANTITIES_OF_ID * new_id[a] + subject.x);
  }
}
