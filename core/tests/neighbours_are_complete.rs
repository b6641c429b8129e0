//! Promise: the grid finds exactly the pairs that brute force finds, for any point cloud, grid structure and wrapping.
use millpond_core::OwnedMemory;
use millpond_core::scene::{Dimension, GridStructure, Periodic, Scene};
use millpond_core::{Serial, Solver};

mod support;
use support::{Random, at_rest, checked, heap_for};

/// Returns the scene of the thesis cube in either dimension.
fn scene_in(dimension: Dimension) -> Scene {
    Scene { dimension, ..support::thesis_cube(0.8) }
}

/// Returns every pair of points within each other's support, by testing all pairs with the distance that the solver
/// uses.
fn brute_force(scene: &Scene, points: &[[f32; 3]]) -> Vec<(u32, u32)> {
    let p = checked(scene).derived().parameters;
    let (scale, period) = (p.inverse_support_squared, p.period);
    let image = |d: f32, period: f32| {
        let images = [d - period, d, d + period].into_iter();
        images.min_by(|a, b| a.abs().total_cmp(&b.abs())).unwrap_or(d)
    };
    let mut pairs = Vec::new();
    for (i, a) in points.iter().enumerate() {
        for (j, b) in points.iter().enumerate() {
            let [x, y, z] = [0, 1, 2].map(|axis| image(a[axis] - b[axis], period[axis]));
            if (x * x + y * y + z * z) * scale < 1.0 {
                pairs.push((i as u32, j as u32));
            }
        }
    }
    pairs
}

/// Returns the pairs that the grid finds, sorted. A pair that is found twice appears twice.
fn by_grid(scene: &Scene, points: &[[f32; 3]]) -> Vec<(u32, u32)> {
    let mut heap = heap_for(scene, points.len());
    let mut pairs = Vec::new();
    at_rest(scene, points, &mut heap).neighbours().each_pair(|a, b| pairs.push((a, b)));
    pairs.sort_unstable();
    pairs
}

fn check(name: &str, dimension: Dimension, points: &[[f32; 3]]) {
    let mut scene = scene_in(dimension);
    for cells in [[3, 3, 3], [4, 3, 5], [32, 32, 32]] {
        scene.grid.cells = cells;
        for structure in [GridStructure::IndexSort, GridStructure::CellLists { places: 512 }] {
            scene.grid.structure = structure;
            let (want, got) = (brute_force(&scene, points), by_grid(&scene, points));
            assert!(want.len() > points.len(), "{name}: a cloud without neighbours tests nothing");
            assert_eq!(want, got, "{name}, {dimension:?}, cells {cells:?}, {structure:?}");
        }
    }
}

fn cloud(seed: u64, count: usize, dimension: Dimension, centre: f32, size: f32) -> Vec<[f32; 3]> {
    let mut random = Random(seed);
    let mut at = || centre + (random.unit() - 0.5) * size;
    (0..count).map(|_| [at(), at(), if dimension == Dimension::Two { 0.0 } else { at() }]).collect()
}

#[test]
fn in_random_clouds_with_negative_coordinates() {
    for (seed, dimension) in [(1, Dimension::Two), (2, Dimension::Three)] {
        check("around the origin", dimension, &cloud(seed, 400, dimension, 0.0, 0.8));
        check("far below it", dimension, &cloud(seed, 400, dimension, -37.0, 0.8));
    }
}

#[test]
fn in_clouds_that_wrap_onto_each_other() {
    for dimension in [Dimension::Two, Dimension::Three] {
        // 960 is a multiple of 3, 4 and 32, so two clouds that are 960 cells apart share all their cells
        let mut points = cloud(3, 200, dimension, 0.0, 0.6);
        let cell = 1.0 / checked(&scene_in(dimension)).derived().parameters.inverse_cell[0];
        points.extend(cloud(3, 200, dimension, 0.0, 0.6).iter().map(|p| [p[0] + 960.0 * cell, p[1], p[2]]));
        check("two clouds in the same cells", dimension, &points);
    }
}

#[test]
fn for_points_exactly_on_cell_faces() {
    for dimension in [Dimension::Two, Dimension::Three] {
        let cell = 1.0 / checked(&scene_in(dimension)).derived().parameters.inverse_cell[0];
        // points half a cell apart, on faces, edges and corners, and points one ULP beside them
        let layers = if dimension == Dimension::Two { 0..=0 } else { -3..=3 };
        let mut points = Vec::new();
        for z in layers {
            for y in -3..=3 {
                for x in -3..=3 {
                    let at = |i: i32| i as f32 * 0.5 * cell;
                    points.push([at(x), at(y), at(z)]);
                    points.push([at(x).next_down(), at(y), at(z)]);
                }
            }
        }
        check("points on faces", dimension, &points);
    }
}

#[test]
fn after_walls_have_moved_particles_across_cell_faces() {
    let scene = support::dam_break(0.3625);
    let mut heap = OwnedMemory::of(&scene.check().expect("a scene"));
    let mut solver = Solver::new(&scene, heap.lend()).expect("a scene");
    (0..150).for_each(|_| solver.step(&Serial).expect("a step"));
    let points: Vec<[f32; 3]> = solver.particles().map(|p| p.position.to_array()).collect();
    let on_a_wall = points.iter().filter(|p| p.contains(&0.0)).count();
    assert!(on_a_wall > 50, "{on_a_wall}: a fluid that touches no wall tests nothing");
    let mut pairs = Vec::new();
    solver.neighbours().each_pair(|a, b| pairs.push((a, b)));
    pairs.sort_unstable();
    assert_eq!(pairs, brute_force(&scene, &points));
}

#[test]
fn across_the_seams_of_a_periodic_domain() {
    for (dimension, axes) in
        [(Dimension::Two, [true, false, false]), (Dimension::Two, [true; 3]), (Dimension::Three, [true; 3])]
    {
        let mut scene = scene_in(dimension);
        scene.blocks.clear();
        // in 2D, three cells of 0.147 m fit along each axis, but not four
        let (low, high) = ([-0.1, 0.2, -0.3], [0.4, 0.7, 0.2]);
        scene.periodic = Some(Periodic { low: low.into(), high: high.into(), axes });
        let mut random = Random(5);
        let mut at = |axis: usize| low[axis] + random.unit() * (high[axis] - low[axis]);
        let flat = dimension == Dimension::Two;
        let points: Vec<[f32; 3]> = (0..300).map(|_| [at(0), at(1), if flat { 0.0 } else { at(2) }]).collect();
        let (want, got) = (brute_force(&scene, &points), by_grid(&scene, &points));
        scene.periodic = None;
        assert!(want.len() > brute_force(&scene, &points).len(), "pairs across the seams");
        assert_eq!(want, got, "{dimension:?}, {axes:?}");
    }
}
