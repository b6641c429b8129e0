// The acceleration field supplied by the caller: linear interpolation between the surrounding nodes of a lattice, which
// has no nodes outside its bounds. CPU counterpart: core/src/passes/field.rs.
fn field_at(position: vec3<f32>) -> vec3<f32> {
  let place = field_place(position);
  let counts = vec3<i32>(p.field_counts.xyz);
  // clamping does not change the result, since no position outside the lattice has nodes; it keeps the indices small
  var first = vec3(
    smaller(larger(floor(place.x), -2.0f), f32(counts.x)),
    smaller(larger(floor(place.y), -2.0f), f32(counts.y)),
    0.0f);
  if m.is_3d == 1u { first.z = smaller(larger(floor(place.z), -2.0f), f32(counts.z)); }
  var sum = vec3(0.0f, 0.0f, 0.0f);
  for (var i = 0u; i < (4u << m.is_3d); i += 1u) {
    let node = vec3(first.x + f32(i & 1u), first.y + f32((i >> 1u) & 1u), first.z + f32(i >> 2u));
    let n = vec3<i32>(node);
    var value = vec3(0.0f, 0.0f, 0.0f);
    if all(n >= vec3<i32>(0)) && all(n < counts) {
      value = acceleration_field[n.x + counts.x * (n.y + counts.y * n.z)].xyz;
    }
    sum = sum + value * field_share(place, node);
  }
  return sum;
}
