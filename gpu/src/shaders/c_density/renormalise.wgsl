// Computes the renormalised gradient of the density before the step, and the smallest eigenvalue lambda of the inverse
// of the matrix that renormalises.
fn before(i: u32) -> Local { return particle(i, previous_density_pressure[i]); }

fn pass_body(i: u32) {
  if i >= p.particle_count || head.status.failed != 0u { return; }
  let a = before(i);
  if a.wall > 0.0f {
    renormalised_gradient[i] = vec4(0.0f, 0.0f, 0.0f, 0.0f);
    return;
  }
  let own = cell_of(a.position);
  var diagonal = vec3(0.0f, 0.0f, 0.0f);
  var mixed = vec3(0.0f, 0.0f, 0.0f);
  var sum = vec3(0.0f, 0.0f, 0.0f);
  for (var i = 0u; i < stencil_cells(); i += 1u) {
    let c = stencil_cell(own, i);
    let end = cell_start[c] + head.counter[c];
    for (var j = cell_start[c]; j < end; j += 1u) {
      let b = before(j);
      if is_near(a, b) {
        let x_ab = separation(a.position, b.position);
        let of_pair = gradient_weight(a, b, x_ab);
        diagonal = diagonal + inverse_diagonal(x_ab, of_pair);
        mixed = mixed + inverse_mixed(x_ab, of_pair);
        if m.density_diffusion == RENORMALISED { sum = sum + deviation_gradient(a, b, x_ab, of_pair); }
      }
    }
  }
  if m.is_3d == 0u {
    diagonal = vec3(diagonal.x, diagonal.y, 0.0f);
    mixed = vec3(mixed.x, 0.0f, 0.0f);
  }
  var sum_beyond = vec3(0.0f, 0.0f, 0.0f);
  if m.has_closed_walls == 1u {
    let beyond = of_pressure(a.position, a.velocity, a.support, a.viscosity);
    diagonal = diagonal + beyond.lever + vec3(beyond.gamma, beyond.gamma, beyond.gamma);
    mixed = mixed + beyond.lever_mixed;
    var g = weight(density_ratio(a.deviation, a.rest_ratio));
    if m.has_acceleration_field == 1u { g = g + field_at(a.position); }
    sum_beyond = deviation_beyond(a, beyond, g);
  }
  let lambda = smallest_eigenvalue(diagonal, mixed);
  var gradient = vec3(0.0f, 0.0f, 0.0f);
  if m.density_diffusion == RENORMALISED { gradient = renormalised(diagonal, mixed, lambda, sum + sum_beyond); }
  renormalised_gradient[i] = vec4(flush3(gradient), flush(lambda));
}
