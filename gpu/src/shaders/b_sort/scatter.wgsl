// Enters each particle into the slots of its cell.
fn pass_body(a: u32) {
  if a >= p.particle_count || head.status.failed != 0u { return; }
  cell_members[cell_start[cell[a]] + rank[a]] = a;
}
