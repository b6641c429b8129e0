//! Promise: the matrix that renormalises a gradient is the inverse of the sum it is computed from, so that a linear
//! field has its exact gradient; and lambda is the smallest eigenvalue of that sum.
use millpond_core::backend::arithmetic::real::vec3;
use millpond_core::backend::layout::Model;
use millpond_core::backend::terms::renormalisation::{renormalised, smallest_eigenvalue, symmetric_determinant};

/// Returns numbers between 0 and 1 (Numerical Recipes).
fn random() -> impl FnMut() -> f32 {
    let mut seed = 1u32;
    move || {
        seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (seed >> 8) as f32 / (1u32 << 24) as f32
    }
}

/// Calls `check` for sums `sum w x x` of random directions x, as a diagonal and the rest, with their trace.
fn for_sums(d: usize, mut check: impl FnMut(&Model, vec3<f32>, vec3<f32>)) {
    let model = Model { is_3d: u32::from(d == 3), ..bytemuck::Zeroable::zeroed() };
    let mut random = random();
    for neighbours in 1..40 {
        for _ in 0..20 {
            let (mut diagonal, mut mixed) = (vec3(0.0, 0.0, 0.0), vec3(0.0, 0.0, 0.0));
            for _ in 0..neighbours {
                let (x, y) = (random() * 2.0 - 1.0, random() * 2.0 - 1.0);
                let z = if d == 3 { random() * 2.0 - 1.0 } else { 0.0 };
                let w = random() / neighbours as f32 * 3.0;
                diagonal = diagonal + vec3(x * x * w, y * y * w, z * z * w);
                mixed = mixed + vec3(x * y * w, x * z * w, y * z * w);
            }
            check(&model, diagonal, mixed);
        }
    }
}

/// Returns the product of the sum with a vector.
fn product(d: vec3<f32>, o: vec3<f32>, v: vec3<f32>) -> vec3<f32> {
    vec3(d.x * v.x + o.x * v.y + o.y * v.z, o.x * v.x + d.y * v.y + o.z * v.z, o.y * v.x + o.z * v.y + d.z * v.z)
}

#[test]
fn a_linear_field_has_its_gradient() {
    for d in [2, 3] {
        let mut exact = 0;
        for_sums(d, |m, diagonal, mixed| {
            let lambda = smallest_eigenvalue(m, diagonal, mixed);
            let slope = vec3(1.0, -2.0, if d == 3 { 0.5 } else { 0.0 });
            let found = renormalised(m, diagonal, mixed, lambda, product(diagonal, mixed, slope));
            if lambda >= 0.1 {
                let miss = found - slope;
                let miss = (miss.x * miss.x + miss.y * miss.y + miss.z * miss.z).sqrt();
                // rounding, times the condition of the matrix: at most trace over lambda, 3 / 0.1
                assert!(miss < 2e-5, "{d}D, lambda {lambda}: off by {miss}");
                exact += 1;
            }
        });
        assert!(exact > 300, "{d}D: {exact} of 780 sums have enough neighbours");
    }
}

#[test]
fn lambda_is_the_smallest_eigenvalue() {
    for (d, most) in [(2, 1e-5), (3, 0.02)] {
        let mut worst = 0.0f32;
        for_sums(d, |m, diagonal, mixed| {
            let lambda = smallest_eigenvalue(m, diagonal, mixed);
            // by bisection: below the smallest eigenvalue all leading minors of `sum - x` are positive
            let is_below = |x: f32| {
                let e = vec3(diagonal.x - x, diagonal.y - x, diagonal.z - x);
                let second = e.x * e.y - mixed.x * mixed.x;
                e.x > 0.0 && second > 0.0 && (d == 2 || symmetric_determinant(e, mixed) > 0.0)
            };
            let (mut low, mut high) = (-1.0, 4.0);
            for _ in 0..40 {
                let middle = 0.5 * (low + high);
                if is_below(middle) {
                    low = middle;
                } else {
                    high = middle;
                }
            }
            worst = worst.max((lambda - low).abs() / (diagonal.x + diagonal.y + diagonal.z));
        });
        assert!(worst < most, "{d}D: off by {worst} of the trace");
    }
}
