//! Promise: the lattice tests of Hinsch 2024, section 6.1, hold in 2D and in 3D: kernel values and gradients at lattice
//! distances, sums over an 11 x 11 lattice, neighbour counts, density and pressure at rest.
//!
//! Hinsch's kernel is the cubic spline with support 2 h, where h is the spacing, so the support radius here is 2
//! spacings.
use approx::{assert_abs_diff_eq, assert_relative_eq};
use millpond_core::backend::arithmetic::real::vec3;
use millpond_core::backend::derive::support_radius;
use millpond_core::backend::terms::kernel::cubic_spline::{cubic_spline_slope, cubic_spline_w};
use millpond_core::backend::terms::kernel::kernel_w;
use millpond_core::scene::{Block, Dimension, Fluid, Formulation, Kernel, NearPressure, PressureForce, Recipe, Scene};
use std::collections::BTreeMap;
use std::f64::consts::PI;

mod support;
use support::{at_rest, heap_for};

/// Spacing, m; Hinsch's h.
const H: f64 = 0.1;

/// Returns the scene of the lattice with this support radius, in spacings: water at rest with Tait's equation of state
/// and Hinsch's kernel.
fn lattice_scene(dimension: Dimension, support: f64) -> Scene {
    let n = if dimension == Dimension::Two { PI * support.powi(2) } else { 4.0 / 3.0 * PI * support.powi(3) };
    let water = Fluid { speed_of_sound: 22.0, dynamic_viscosity: 5.0, ..Fluid::default() };
    let mut scene = Scene::of(dimension, H as f32, 0.0002, water, Block::default());
    scene.model = Formulation::of(Recipe::Pirovano);
    scene.blocks.clear();
    scene.average_neighbours = Some(n as f32);
    scene.model.density_kernel = Kernel::CubicSpline;
    scene.model.pressure_kernel = Kernel::CubicSpline;
    scene.model.pressure_force = PressureForce::Monaghan;
    scene.model.near_pressure = NearPressure::Off;
    scene.grid.cells = if dimension == Dimension::Two { [16, 16, 1] } else { [16, 16, 16] };
    scene
}

/// Returns a lattice of 11 points along each axis around the origin.
fn lattice(dimension: Dimension) -> Vec<[f32; 3]> {
    let layers = if dimension == Dimension::Two { 0..=0 } else { -5..=5 };
    let at = |i: i32| (f64::from(i) * H) as f32;
    layers.flat_map(|z| (-5..=5).flat_map(move |y| (-5..=5).map(move |x| [at(x), at(y), at(z)]))).collect()
}

/// Returns both dimensions, each with the constant of Hinsch's kernel: 5 / (14 pi h^2) in 2D, 1 / (4 pi h^3) in 3D.
fn dimensions() -> [(Dimension, f64); 2] {
    [(Dimension::Two, 5.0 / (14.0 * PI * H * H)), (Dimension::Three, 1.0 / (4.0 * PI * H * H * H))]
}

/// Returns Hinsch's W, computed by the term; its support is 2 h.
fn w(dimension: Dimension, r: f64) -> f64 {
    let constant = Kernel::CubicSpline.normalisation(dimension.count()) / (2.0 * H).powi(dimension.count() as i32);
    constant * f64::from(cubic_spline_w((r / (2.0 * H)) as f32))
}

/// Returns the magnitude of Hinsch's gradient of W, computed by the term.
fn slope(dimension: Dimension, r: f64) -> f64 {
    let constant = Kernel::CubicSpline.normalisation(dimension.count()) / (2.0 * H).powi(dimension.count() as i32 + 1);
    constant * f64::from(cubic_spline_slope((r / (2.0 * H)) as f32))
}

#[test]
fn kernel_values_at_lattice_distances() {
    for (dimension, alpha) in dimensions() {
        assert_eq!(w(dimension, 3.0 * H), 0.0);
        // single precision: one rounding of q and a few products
        assert_relative_eq!(w(dimension, 0.0), 4.0 * alpha, max_relative = 1e-6);
        assert_relative_eq!(w(dimension, H), alpha, max_relative = 1e-6);
        for diagonal in [2f64.sqrt(), 3f64.sqrt()] {
            let value = alpha * (2.0 - diagonal).powi(3);
            assert_relative_eq!(w(dimension, diagonal * H), value, max_relative = 2e-6);
        }
    }
}

#[test]
fn gradients_at_lattice_distances() {
    for (dimension, alpha) in dimensions() {
        assert_eq!(slope(dimension, 0.0), 0.0);
        assert_relative_eq!(slope(dimension, H), 3.0 * alpha / H, max_relative = 1e-6);
        // along each axis of a diagonal: Hinsch's alpha beta / (h sqrt 2), beta = -3 (2 - sqrt 2)^2; the 3D diagonal
        // has sqrt 3 in place of sqrt 2
        for diagonal in [2f64.sqrt(), 3f64.sqrt()] {
            let beta = 3.0 * (2.0 - diagonal).powi(2);
            let expected = alpha * beta / (H * diagonal);
            assert_relative_eq!(slope(dimension, diagonal * H) / diagonal, expected, max_relative = 2e-6);
        }
    }
}

#[test]
fn sums_over_the_lattice() {
    for (dimension, alpha) in dimensions() {
        let volume = H.powi(dimension.count() as i32);
        // the expected sum: in 2D Hinsch's 1, which his kernel misses by 8.6e-4 on the square lattice; in 3D its
        // equivalent
        let neighbours = if dimension == Dimension::Two { [4.0, 4.0, 0.0] } else { [6.0, 12.0, 8.0] };
        let at = |d: f64| (2.0 - d).powi(3);
        let [edge, face, corner] = neighbours;
        let expected = alpha * volume * (4.0 + edge + face * at(2f64.sqrt()) + corner * at(3f64.sqrt()));
        if dimension == Dimension::Two {
            assert_abs_diff_eq!(expected, 1.000_862, epsilon = 1e-6);
        }
        let points = lattice(dimension);
        for a in points.iter().filter(|a| a.iter().all(|x| f64::from(x.abs()) < 4.5 * H)) {
            let mut sum = 0.0;
            let mut gradient = [0.0; 3];
            for b in &points {
                let d: [f64; 3] = core::array::from_fn(|i| f64::from(a[i]) - f64::from(b[i]));
                let r = d.iter().map(|d| d * d).sum::<f64>().sqrt();
                sum += w(dimension, r) * volume;
                if r > 0.0 {
                    gradient.iter_mut().zip(d).for_each(|(g, d)| *g -= slope(dimension, r) * d / r * volume * H);
                }
            }
            // positions and terms are in single precision, so each of up to 33 terms has an error of 1e-7
            assert_abs_diff_eq!(sum, expected, epsilon = 2e-6);
            // gradients cancel pairwise; the rounding of up to 33 terms remains, each of them at most 1
            assert!(gradient.iter().all(|g| g.abs() < 1e-5), "{gradient:?}");
        }
    }
}

#[test]
fn neighbours_of_the_middle_particle() {
    // in 2D from Hinsch 2024, section 6.1.2; in 3D the number of lattice points with |n|^2 up to 1, 3 and 4
    let expected =
        [(Dimension::Two, [(2.1, 13), (1.9, 9), (1.1, 5)]), (Dimension::Three, [(2.1, 33), (1.9, 27), (1.1, 7)])];
    for (dimension, counts) in expected {
        for (radius, count) in counts {
            let scene = lattice_scene(dimension, radius);
            assert_relative_eq!(support_radius(&scene), radius * H, max_relative = 1e-6);
            let points = lattice(dimension);
            let mut heap = heap_for(&scene, points.len());
            let mut solver = at_rest(&scene, &points, &mut heap);
            let mut neighbours = BTreeMap::<u32, usize>::new();
            solver.neighbours().each_pair(|a, _| *neighbours.entry(a).or_default() += 1);
            let middle = points.len() as u32 / 2;
            assert_eq!(neighbours[&middle], count, "{dimension:?}, {radius} spacings");
        }
    }
}

#[test]
fn density_and_pressure_at_rest() {
    // the density differs from the rest density by the error of the lattice sum, computed here by a plain sum in f64
    for dimension in [Dimension::Two, Dimension::Three] {
        let scene = lattice_scene(dimension, 2.0);
        let points = lattice(dimension);
        let mut heap = heap_for(&scene, points.len());
        let solver = at_rest(&scene, &points, &mut heap);
        let middle = solver.particles().nth(points.len() / 2).expect("a middle");
        let volume = H.powi(dimension.count() as i32);
        let lattice_sum: f64 = points
            .iter()
            .map(|b| {
                let q2 = b.iter().map(|x| f64::from(*x).powi(2)).sum::<f64>() / (4.0 * H * H);
                let constant =
                    Kernel::CubicSpline.normalisation(dimension.count()) / (2.0 * H).powi(dimension.count() as i32);
                f64::from(kernel_w(Kernel::CubicSpline as u32, q2 as f32)) * constant * volume
            })
            .sum();
        // 57 single-precision terms
        assert_relative_eq!(f64::from(middle.density) / 1000.0, lattice_sum, max_relative = 2e-6);
        if dimension == Dimension::Two {
            // Hinsch's claim, within the 8.6e-4 of the lattice sum
            assert_abs_diff_eq!(lattice_sum, 1.0, epsilon = 8.7e-4);
        }
        // Tait's equation at that density: it multiplies the rounding of the density by 7 c0^2 rho0 / 7, which makes
        // 22^2 * 1000 * 2e-6 Pa
        let c2 = f64::from(scene.fluids[0].speed_of_sound).powi(2);
        let tait = 1000.0 * c2 / 7.0 * (lattice_sum.powi(7) - 1.0);
        assert_abs_diff_eq!(f64::from(middle.pressure), tait, epsilon = c2 * 1000.0 * 2e-6);
        // in the middle of the lattice the forces cancel
        let acceleration = solver.state().acceleration[solver.slots()[points.len() / 2] as usize];
        let push = vec3(acceleration[0], acceleration[1], acceleration[2]);
        assert!(push.x.abs().max(push.y.abs()).max(push.z.abs()) < 1e-3, "{push:?} m/s2");
    }
}
