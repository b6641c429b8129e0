//! Choices of solids: shapes, models, motions, and what they act on.
use super::Add;
use super::scenes::{closed, falls, fed, second_fluid, solids, walls};
use millpond_core::glam::Vec3;
use millpond_core::scene::{
    AdaptiveTimeStep, Course, DensityDiffusion, DensityForm, Dimension, Integrator, Motion, NearPressure, Periodic,
    PressureForce, Recovery, Scene, Shape, Shifting, Solid, SolidModel, WallPressure,
};

const MODELS: [SolidModel; 4] =
    [SolidModel::Penalty, SolidModel::ClosedForm, SolidModel::Particles, SolidModel::Repulsion];

pub fn solid_choices(add: Add<'_>) {
    for model in MODELS {
        add(format!("solids, {model:?}"), &|s| solids(s, model));
        add(format!("solids, {model:?}, two fluids, no container, adaptive"), &|s| {
            second_fluid(s);
            solids(s, model);
            s.container = None;
            s.adaptive =
                Some(AdaptiveTimeStep { reject_ratio: Some(1.0), largest: 0.002, ..AdaptiveTimeStep::default() });
        });
        add(format!("solids, {model:?}, walls of particles, emitters, steps that are shortened"), &|s| {
            walls(s);
            fed(s);
            solids(s, model);
            s.recovery = Recovery::ShortenStep { times: 2 };
        });
    }
    for &pressure in WallPressure::ALL {
        add(format!("particles of solids, {pressure:?}"), &|s| {
            solids(s, SolidModel::Particles);
            s.model.wall_pressure = pressure;
        });
    }
    for &density in DensityForm::ALL {
        for pressure in [WallPressure::LennardJones, WallPressure::KernelForce] {
            add(format!("walls that repel, {pressure:?}, {density:?}"), &|s| {
                falls(s);
                walls(s);
                (s.model.density, s.model.wall_pressure, s.model.wall_rigidity) = (density, pressure, 0.1);
            });
        }
        add(format!("solids in closed form and a container, {density:?}"), &|s| {
            closed(s);
            falls(s);
            solids(s, SolidModel::ClosedForm);
            s.model.density = density;
        });
    }
    for &integrator in Integrator::ALL {
        add(format!("solids, Penalty, integrator {integrator:?}"), &|s| {
            solids(s, SolidModel::Penalty);
            s.model.integrator = integrator;
        });
    }
    for shifting in [Shifting::Fickian, Shifting::TransportVelocity] {
        add(format!("solids in closed form, shifting {shifting:?}, renormalised diffusion"), &|s| {
            solids(s, SolidModel::ClosedForm);
            (s.model.shifting, s.model.tensile_control) = (shifting, true);
            (s.model.density, s.model.pressure_force) = (DensityForm::Continuity, PressureForce::Monaghan);
            s.model.density_diffusion = DensityDiffusion::Renormalised;
        });
    }
    add("a plane as a piston, and a driven ball, across a periodic side".into(), &|s: &mut Scene| {
        s.model.near_pressure = NearPressure::Off;
        s.container = None;
        s.periodic = Some(Periodic { low: Vec3::ZERO, high: Vec3::new(0.8, 0.6, 0.6), axes: [true, false, false] });
        let z = if s.dimension == Dimension::Two { 0.0 } else { 0.2 };
        let ball = Solid { motion: Motion::Driven, ..Solid::still(Shape::Ball { radius: 0.14 }, [0.75, 0.62, z]) };
        s.solids = [ball].into_iter().collect();
    });
    add("a plane as a piston".into(), &|s: &mut Scene| {
        let push = Course { velocity: Vec3::new(4.0, 0.0, 0.0), ..Course::default() };
        let piston = Solid {
            turned: Vec3::new(0.0, 0.0, -90.0),
            motion: Motion::Prescribed(push),
            model: SolidModel::Penalty,
            ..Solid::still(Shape::Plane, [0.08, 0.0, 0.0])
        };
        s.solids = [piston].into_iter().collect();
    });
}
