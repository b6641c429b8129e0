// Functions of the terms that read a scene's constants.
// An entry of one of the kernel tables, its index being a whole number.
fn lookup(table: u32, entry: R) -> R {
  let i = table * TABLE_ENTRIES + u32(entry);
  return tables[i / 4u][i % 4u];
}
// The kind of a particle, and what it has of its own. Twin: core/src/passes/lanes.rs.
fn material_index(w: f32) -> u32 {
  if m.has_materials == 0u { return 0u; }
  return min(u32(w), MATERIALS - 1u);
}
fn properties_of(w: f32) -> f32x4 { return materials.properties[material_index(w)]; }
// Is it of air that is not there?
fn is_inactive(w: f32) -> bool { return m.has_air == 1u && properties_of(w).y > 1.0f; }
fn stiffness_of(w: f32) -> Stiffness {
  let states = materials.states[material_index(w)];
  let corrections = materials.corrections[material_index(w)];
  return Stiffness(states.x, states.y, corrections.x, corrections.y, corrections.z);
}
