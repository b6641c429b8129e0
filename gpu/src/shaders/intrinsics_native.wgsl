// Division and square root as the device computes them. WGSL allows errors of a few units in the last place; a test of
// the intrinsics on the device detects them.
fn div(x: R, y: R) -> R { return x / y; }
fn root(x: R) -> R { return sqrt(x); }
