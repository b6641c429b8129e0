// Cells and the stencil around them. Twin: core/src/grid/mod.rs.
const FARTHEST_CELL: f32 = 4194304.0f;

// Euclidean remainder of each coordinate by the cells along its axis.
fn cell_index(c: vec3<i32>) -> u32 {
  let n = vec3<i32>(p.cells.xyz);
  let wrapped = vec3<u32>((c % n + n) % n);
  return wrapped.x + p.cells.x * (wrapped.y + p.cells.y * wrapped.z);
}

// The cell before wrapping; only for positions in range.
fn cell_of(x: vec3<f32>) -> vec3<i32> { return vec3<i32>(floor((x - p.domain_low.xyz) * p.inverse_cell.xyz)); }

// First axis along which a position lies beyond the range, 3 where none does. NaN compares false, so it is beyond.
fn axis_out_of_range(x: vec3<f32>) -> u32 {
  let scaled = abs((x - p.domain_low.xyz) * p.inverse_cell.xyz);
  if !(scaled.x < FARTHEST_CELL) { return 0u; }
  if !(scaled.y < FARTHEST_CELL) { return 1u; }
  if !(scaled.z < FARTHEST_CELL) { return 2u; }
  return 3u;
}

// Cells in a stencil, and the i-th of them: z, then y, then x ascending.
fn stencil_cells() -> u32 { return 9u + 18u * m.is_3d; }
fn stencil_cell(own: vec3<i32>, i: u32) -> u32 {
  let layer = i32(i / 9u) - i32(m.is_3d);
  return cell_index(own + vec3<i32>(i32(i % 3u) - 1, i32(i / 3u % 3u) - 1, layer));
}
