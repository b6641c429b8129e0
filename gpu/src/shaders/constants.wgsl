// Functions of the terms that read the constants of a scene.
//
// Returns an entry of one of the kernel tables. The index of the entry is a whole number.
fn lookup(table: u32, entry: R) -> R {
  let i = table * TABLE_ENTRIES + u32(entry);
  return tables[i / 4u][i % 4u];
}
// The material of a particle and the constants of that material. CPU counterpart: core/src/passes/lanes.rs.
fn material_index(w: f32) -> u32 {
  if m.has_materials == 0u { return 0u; }
  return min(u32(w), MATERIALS - 1u);
}
fn properties_of(w: f32) -> f32x4 { return materials.properties[material_index(w)]; }
// Returns whether a particle is inactive.
fn is_inactive(w: f32) -> bool { return m.has_inactive == 1u && properties_of(w).y > 1.0f; }
fn stiffness_of(w: f32) -> Stiffness {
  let states = materials.states[material_index(w)];
  let corrections = materials.corrections[material_index(w)];
  return Stiffness(states.x, states.y, corrections.x, corrections.y, corrections.z);
}
