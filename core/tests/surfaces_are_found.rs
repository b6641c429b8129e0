//! Promise: who is at the surface of a fluid, and where it points can be asked for each particle, between like fluids and in
//! nothing; how it is curved, between like fluids. A scene that does not ask finds none.
use millpond_core::glam::Vec3;
use millpond_core::scene::{Block, Dimension, Fluid, Formulation, InitialParticle, Kernel, Scene, SurfaceTension};
use millpond_core::{Particle, Plan, Solver};

mod support;
use support::{checked, heap_for};

/// Spacings, of the disc and of the square around it; m.
const RADIUS: f32 = 20.0;
const HALF: i16 = 32;
const SPACING: f32 = 0.01;

/// A disc of fluid 0 on a lattice, in fluid 1 or in nothing.
fn disc(model: Formulation, in_a_like_fluid: bool) -> Vec<Particle> {
    let fluid = Fluid { surface_tension: if model.surface_normals { 0.0 } else { 1.0 }, ..Fluid::default() };
    let mut scene =
        Scene::of(Dimension::Two, SPACING, 1e-4, fluid, Block { size: Vec3::new(1.0, 1.0, 0.0), ..Block::default() });
    let _ = scene.fluids.push(fluid);
    scene.average_neighbours = 50.0;
    scene.model = model;
    let lattice = (-HALF..HALF).flat_map(|y| (-HALF..HALF).map(move |x| [f32::from(x) + 0.5, f32::from(y) + 0.5]));
    let place = |[x, y]: [f32; 2]| {
        let outside = x.hypot(y) >= RADIUS;
        InitialParticle::of_fluid(u32::from(outside), [x * SPACING, y * SPACING, 0.0], [0.0; 3])
    };
    let places: Vec<InitialParticle> =
        lattice.map(place).filter(|place| in_a_like_fluid || place.material == 0).collect();
    let mut heap = heap_for(&scene, places.len());
    let solver =
        Solver::with_particles(&checked(&scene), Plan::of(&checked(&scene)), places.len(), places, heap.lend());
    solver.expect("a scene").particles().collect()
}

fn model(surface_tension: SurfaceTension) -> Formulation {
    let kernel = Kernel::WendlandC4;
    Formulation { surface_tension, density_kernel: kernel, pressure_kernel: kernel, ..Formulation::multiphase() }
}

#[test]
fn of_a_disc() {
    let alone = Formulation { surface_normals: true, ..model(SurfaceTension::Off) };
    for (model, in_a_like_fluid) in [
        (model(SurfaceTension::NormalCurvature), true),
        (model(SurfaceTension::NormalCurvature), false),
        (alone, true),
        (alone, false),
    ] {
        let name = format!("{:?}, in a like fluid {in_a_like_fluid}", model.surface_tension);
        let mut curvatures = Vec::new();
        for particle in disc(model, in_a_like_fluid).iter().filter(|particle| particle.fluid == 0) {
            let r = particle.position.length() / SPACING;
            // a support reaches over 4 spacings, the edge of a lattice is a staircase of one
            if r < RADIUS - 5.0 {
                assert!(!particle.at_surface && particle.curvature == 0.0, "{name}: {r} spacings out");
            }
            // in nothing the summed density falls towards the edge, so that the outermost row stands for twice its volume: seen
            // from the next one, the fluid is densest outside
            let rows = if in_a_like_fluid { 2.0 } else { 0.7 };
            if r > RADIUS - rows {
                let inward = -particle.normal.normalize().dot(particle.position.normalize());
                // the staircase has faces along the axes only, so it turns a normal by up to 45 degrees
                assert!(particle.at_surface && inward > 45f32.to_radians().cos(), "{name}: {r}, cosine {inward}");
                // of the circle through the particle
                curvatures.push(particle.curvature * particle.position.length());
            }
        }
        let mean = curvatures.iter().sum::<f32>() / curvatures.len() as f32;
        // the staircase puts the edge within a step and a half of the circle's; no tension, no curvature
        let expected = if model.surface_normals { 0.0 } else { 1.0 };
        // (and in nothing that second row spoils it)
        assert!(!in_a_like_fluid || (mean - expected).abs() < 1.5 / RADIUS, "{name}: curvature times radius {mean}");
    }
}

#[test]
fn and_none_where_nobody_asks() {
    let silent = Formulation { surface_tension: SurfaceTension::Attraction, ..model(SurfaceTension::Off) };
    let found = |p: &Particle| p.at_surface || p.curvature != 0.0 || p.normal.length() > 0.0;
    assert!(!disc(silent, true).iter().any(found));
}
