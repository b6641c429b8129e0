//! Choices of emitters and drains.
use super::Add;
use super::scenes::{closed, falls, fed, second_fluid, walls};
use crate::support::forms::several_fluids;
use millpond_core::glam::Vec3;
use millpond_core::scene::{
    AdaptiveTimeStep, Air, DensityForm, Drain, Emitter, Integrator, Opening, Periodic, Recovery, Scene, Shifting,
    WallPressure,
};

/// A jet from the right to the left, which does not meet the one of [`fed`].
fn other_jet(s: &mut Scene) -> Emitter {
    Emitter::jet([0.7, 0.6, s.emitters[0].position.z], [-1.0, 0.2, 0.0], 3.0, Opening::Square(0.1))
}

pub fn turnover(add: Add<'_>) {
    add("emitters and drains".into(), &fed);
    add("a drain alone".into(), &|s| {
        s.drains = [Drain::Box { low: Vec3::new(0.3, 0.0, 0.0), high: Vec3::new(0.5, 0.2, 0.4) }].into_iter().collect();
    });
    add("a spray that starts late and ends, two fluids, walls".into(), &|s| {
        second_fluid(s);
        fed(s);
        walls(s);
        s.model.wall_pressure = WallPressure::Extrapolated;
        let jet = other_jet(s);
        s.emitters[0].fluid = 1;
        s.emitters[0].spread_degrees = 30.0;
        (s.emitters[0].start, s.emitters[0].duration) = (0.002, Some(0.004));
        s.emitters.push(jet).expect("room");
    });
    add("emitters beyond the number of spare particles".into(), &|s| {
        fed(s);
        s.emitters[0].life = None;
        s.spare_particles = 10;
    });
    add("emitters, closed walls, shifting, a density that is integrated".into(), &|s| {
        closed(s);
        falls(s);
        fed(s);
        (s.model.density, s.model.shifting, s.model.xsph) = (DensityForm::Continuity, Shifting::Fickian, 0.1);
    });
    for integrator in [Integrator::SemiImplicitEuler, Integrator::Leapfrog, Integrator::Clavet] {
        add(format!("emitters, integrator {integrator:?}, adaptive, across a periodic side"), &|s| {
            fed(s);
            s.model.integrator = integrator;
            s.container = None;
            s.periodic = Some(Periodic { low: Vec3::ZERO, high: Vec3::new(0.8, 0.6, 0.6), axes: [true, false, false] });
            (s.emitters[0].position.x, s.emitters[0].direction) = (0.77, Vec3::X);
            let reject_ratio = Some(1.0);
            s.adaptive = Some(AdaptiveTimeStep { reject_ratio, largest: 0.002, ..AdaptiveTimeStep::default() });
        });
    }
    add("emitters, steps that can be shortened".into(), &|s| {
        fed(s);
        s.recovery = Recovery::ShortenStep { times: 2 };
        s.emitters[0].speed = 15.0;
    });
    add("emitters, evaluated again".into(), &|s| {
        fed(s);
        s.model.reevaluate = true;
    });
    add("emitters and air".into(), &|s| {
        s.model = several_fluids();
        second_fluid(s);
        s.blocks[1].fluid = 0;
        s.air = Some(Air { fluid: 1, capacity: 60, threshold: 0.5, minimum_density: 0.6 });
        fed(s);
    });
}
