// Division and root as the device has them. WGSL lets it be off by some units in the last place; the words' test tells.
fn div(x: R, y: R) -> R { return x / y; }
fn root(x: R) -> R { return sqrt(x); }
