// What the loops call in a scene without solids.
fn is_in_solid(position: vec3<f32>) -> bool { return false; }
fn repelled(position: vec3<f32>) -> vec3<f32> { return vec3(0.0f, 0.0f, 0.0f); }
