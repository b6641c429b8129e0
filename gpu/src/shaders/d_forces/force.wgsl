// Computes the acceleration of each particle by pressure, viscosity and external forces. Where pressure is iterated
// later, pressure is left out.

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

fn pass_body(i: u32) {
  if i >= p.particle_count || head.status.failed != 0u { return; }
  let a = local(i);
  if a.wall > 0.0f {
    force_out[i] = vec4(0.0f, 0.0f, 0.0f, 0.0f);
    return;
  }
  let own = cell_of(a.position);
  var force = vec3(0.0f, 0.0f, 0.0f);
  var change = vec3(0.0f, 0.0f, 0.0f);
  var shares = 0.0f;
  for (var i = 0u; i < stencil_cells(); i += 1u) {
    let c = stencil_cell(own, i);
    let end = cell_start[c] + head.counter[c];
    for (var j = cell_start[c]; j < end; j += 1u) {
      let b = local(j);
      if is_near(a, b) {
        force = force + force_neighbour(a, b);
        if m.has_velocity_exchange == 1u {
          change = change + exchange_neighbour(a, b);
          shares = shares + exchange_share(a, b);
        }
      }
    }
  }
  var internal = acceleration_close(force, a);
  if m.has_velocity_exchange == 1u { internal = internal + change * exchange_close(shares); }
  if m.has_acceleration_field == 1u { internal = internal + field_at(a.position); }
  force_out[i] = vec4(external_close(internal, a.velocity, density_ratio(a.deviation, a.rest_ratio)), 0.0f);
}
