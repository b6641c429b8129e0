// Words of the terms that read a scene's constants.
// An entry of one of the kernel tables, its index being a whole number.
fn lookup(table: u32, entry: R) -> R {
  let i = table * TABLE_ENTRIES + u32(entry);
  return tables[i / 4u][i % 4u];
}
// The kind of a particle: dynamic viscosity, and 1 for a wall's. Twin: core/src/passes/mod.rs.
fn kind(w: f32) -> f32x4 { return p.species[min(u32(w), SPECIES - 1u)]; }
