// Cells and the stencil of cells around a cell. CPU counterpart: core/src/grid/mod.rs.
const FARTHEST_CELL: f32 = 4194304.0f;

// Returns the index of a cell, after taking the Euclidean remainder of each coordinate by the number of cells along its
// axis.
fn cell_index(c: vec3<i32>) -> u32 {
  let n = vec3<i32>(p.cells.xyz);
  let wrapped = vec3<u32>((c % n + n) % n);
  return wrapped.x + p.cells.x * (wrapped.y + p.cells.y * wrapped.z);
}

// Returns the cell of a position before wrapping; only for positions in range.
fn cell_of(x: vec3<f32>) -> vec3<i32> { return vec3<i32>(floor((x - p.domain_low.xyz) * p.inverse_cell.xyz)); }

// Returns the first axis along which a position is out of range, or 3 if there is none. NaN compares false, so it is
// out of range.
fn axis_out_of_range(x: vec3<f32>) -> u32 {
  let scaled = abs((x - p.domain_low.xyz) * p.inverse_cell.xyz);
  if !(scaled.x < FARTHEST_CELL) { return 0u; }
  if !(scaled.y < FARTHEST_CELL) { return 1u; }
  if !(scaled.z < FARTHEST_CELL) { return 2u; }
  return 3u;
}

// The number of cells in a stencil, and the i-th of them, by z, then y, then x, each ascending.
fn stencil_cells() -> u32 { return 9u + 18u * m.is_3d; }
fn stencil_cell(own: vec3<i32>, i: u32) -> u32 {
  let layer = i32(i / 9u) - i32(m.is_3d);
  return cell_index(own + vec3<i32>(i32(i % 3u) - 1, i32(i / 3u % 3u) - 1, layer));
}
