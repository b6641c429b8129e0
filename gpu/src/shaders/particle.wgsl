// The data of a particle that sums over pairs read. CPU counterpart: core/src/passes/local.rs.
fn particle(a: u32, state: f32x4) -> Local {
  let x = new_position[a];
  let v = new_velocity[a];
  let own = properties_of(v.w);
  let states = materials.states[material_index(v.w)];
  let tension = materials.corrections[material_index(v.w)].w;
  var support = 1.0f;
  if m.has_variable_support == 1u { support = support_ratio[a]; }
  return Local(x.xyz, v.xyz, support, x.w, state.x, state.y, state.z, state.w,
    own.x, own.y, own.z, own.w, states.z, states.w, tension);
}

fn is_near(a: Local, b: Local) -> bool {
  let x_ab = separation(a.position, b.position);
  return less(squared_ratio(x_ab, pair_scale(a.support, b.support)), 1.0f);
}
