//! Promise: emitters, drains and spare particles that cannot be are rejected by name before the first step.
use millpond_core::glam::Vec3;
use millpond_core::scene::{
    Container, Drain, Emitter, GridStructure, Integrator, Opening, PlaneModel, Scene, Viscosity,
};

#[path = "support/combination.rs"]
mod combination;
#[path = "support/judged.rs"]
mod judged;
use combination::refused;
use judged::judged as scene;

#[test]
fn emitters_and_drains_by_name() {
    let jet = Emitter::jet([0.5, 0.8, 0.5], Vec3::NEG_Y, 1.0, Opening::Square(0.1));
    let with = |change: fn(&mut Scene)| {
        move |s: &mut Scene| {
            s.container = Some(Container { model: PlaneModel::Penalty, ..Container::closed(Vec3::ZERO, Vec3::ONE) });
            s.emitters = [jet].into_iter().collect();
            s.spare_particles = 100;
            change(s);
        }
    };
    assert_eq!(scene(with(|_| ())), Ok(()));
    refused(
        "emitters[0].position conflicts with container: a part of the opening lies behind a plane of the container, \
         where nothing is made; move the emitter into the container, make its opening smaller, or leave that face open",
        with(|s| s.emitters[0].position.x = 0.02),
    );
    refused(
        "emitters[0].position conflicts with drains: a drain would take the particles of this emitter as soon as they \
         are made; move one of them",
        with(|s| s.drains = [Drain::Ball { centre: Vec3::new(0.5, 0.8, 0.5), radius: 0.1 }].into_iter().collect()),
    );
    refused(
        "emitters[1].position conflicts with another emitter: their openings overlap; move one of them, or make it \
         smaller",
        with(|s| {
            let other = Emitter { position: s.emitters[0].position + 0.03, ..s.emitters[0] };
            s.emitters.push(other).expect("room");
        }),
    );
    refused(
        "emitters conflicts with grid.structure CellLists: inactive particles share one cell, which would need a place \
         for each of them; use grid.structure IndexSort",
        with(|s| s.grid.structure = GridStructure::CellLists { places: 64 }),
    );
    refused(
        "emitters conflicts with model.internal_energy: the internal energy of new particles is not set yet; turn \
         internal_energy off",
        with(|s| (s.model.internal_energy, s.model.viscosity) = (true, Viscosity::Artificial)),
    );
    refused(
        "spare_particles conflicts with model.integrator Verlet or any variant of Beeman: they need a history of the \
         last step, which new particles do not have; use another integrator, such as ModifiedVelocityVerlet",
        with(|s| {
            s.emitters.clear();
            s.model.integrator = Integrator::Beeman;
        }),
    );
    // more than one layer in a step
    let told = scene(with(|s| s.emitters[0].speed = 51.0)).expect_err("a speed");
    assert_eq!(told.to_string(), "emitters[0].speed is 51, but must lie between 0 and 50");
    // too few spare particles for a layer
    let told = scene(with(|s| s.spare_particles = 1)).expect_err("one particle");
    assert!(told.to_string() == "spare_particles is 1, but must be at least 4", "{told}");
}
