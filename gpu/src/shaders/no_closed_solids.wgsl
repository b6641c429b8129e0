// What walls in closed form call in a scene without solids.
fn front_of_solids(position: vec3<f32>, support: f32, gamma: u32, bending: u32, in_front: f32) -> f32 {
  return in_front;
}

fn with_solids(
  position: vec3<f32>, velocity: vec3<f32>, support: f32, viscosity: f32, gamma: u32, surface: u32, bending: u32,
  sum: Beyond, in_front: f32,
) -> Beyond {
  return sum;
}
