//! Promise: guided creation reproduces the report of Pirovano's figure 4.1, and names the number to change.
use millpond_core::SceneError;
use millpond_core::glam::Vec3;
use millpond_core::guide::{Guide, Guided};
use millpond_core::scene::{Dimension, Fluid, Scene};

const WATER: Fluid = Fluid { speed_of_sound: 10.0, ..Fluid::WATER };

fn guide(size: [f32; 3], number_class: u32) -> Result<(Guided, Scene), SceneError> {
    let dimension = Dimension::Three;
    Guide { dimension, size: size.into(), number_class, fluid: WATER, average_neighbours: None }.derive()
}

#[test]
fn figure_4_1_is_reproduced() {
    let (guided, scene) = guide([1.0; 3], 0).expect("a scene");
    assert_eq!((guided.particles, guided.fixed_distance, guided.average_neighbours), (125, 0.25, 40.0));
    assert_eq!(format!("{:.6}", guided.support_radius), "0.424314");
    assert_eq!(guided.total_mass, 1000.0);
    // and the scene is what the report says
    let checked = scene.check().expect("a scene");
    assert_eq!(checked.derived().particles(), 125);
    assert_eq!(format!("{:.6}", checked.derived().support_radius), "0.424314");
}

#[test]
fn the_other_sides_have_particles_in_proportion() {
    // source code 4.1: n + (n - 1) (length / shortest - 1)
    assert_eq!(guide([1.0, 2.0, 1.0], 0).expect("a scene").0.counts, [5, 9, 5]);
    assert_eq!(guide([1.5, 1.0, 1.0], 3).expect("a scene").0.counts, [47, 32, 32]);
    assert_eq!(guide([1.0; 3], 3).expect("a scene").0.particles, 32_768, "the water jet of section 5.1.3");
    assert_eq!(guide([0.2; 3], 2).expect("a scene").0.particles, 4096, "the performance test of section 5.2");
    let plane = Guide {
        dimension: Dimension::Two,
        size: Vec3::new(2.0, 1.0, 0.0),
        number_class: 0,
        fluid: WATER,
        average_neighbours: Some(20.0),
    };
    let (guided, _) = plane.derive().expect("a scene");
    assert_eq!((guided.counts, guided.particles, guided.total_mass), ([9, 5, 1], 45, 2000.0));
}

#[test]
fn ill_choices_get_the_number_to_change() {
    let told = |size, class| guide(size, class).expect_err("refused").to_string();
    assert_eq!(told([1.0; 3], 11), "number_class is 11, but must lie between 0 and 10");
    assert_eq!(told([1.0, 0.0, 1.0], 3), "size is 0, but must be larger than 0");
    assert!(told([1e9, 1.0, 1e9], 10).contains("particles"), "{}", told([1e9, 1.0, 1e9], 10));
    let fluid = Fluid { speed_of_sound: -1.0, ..WATER };
    let dimension = Dimension::Three;
    let ill = Guide { dimension, size: Vec3::ONE, number_class: 0, fluid, average_neighbours: None };
    let told = ill.derive().expect_err("refused").to_string();
    assert_eq!(told, "fluids[0].speed_of_sound is -1, but must be larger than 0");
}
