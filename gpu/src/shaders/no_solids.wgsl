// What the loops call in a scene without solids.
fn is_in_solid(position: vec3<f32>) -> bool { return false; }
