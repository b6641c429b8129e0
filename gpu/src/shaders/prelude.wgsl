// The intrinsics of the terms that WGSL lacks, and the names of the shared types. One of the two files with the
// intrinsics div and root comes first. CPU counterpart: core/src/arithmetic/real.rs.
alias R = f32;
alias f32x4 = vec4<f32>;
alias u32x4 = vec4<u32>;
alias u32x2 = vec2<u32>;
fn real(x: R) -> R { return x; }
fn less(x: R, y: R) -> bool { return x < y; }
fn larger(x: R, y: R) -> R { return select(x, y, x < y); }
fn smaller(x: R, y: R) -> R { return select(x, y, y < x); }
fn flush(x: R) -> R { return select(x, 0.0f, abs(x) < 1.1754944e-38f); }
