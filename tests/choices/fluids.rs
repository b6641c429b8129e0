//! Choices of several fluids in a scene, air, springs, and properties of a fluid.
use super::Add;
use super::scenes::{pulled, second_fluid, walls};
use crate::support::forms::several_fluids;
use millpond_core::glam::Vec3;
use millpond_core::scene::{
    Air, DensityForm, Elasticity, EquationOfState, Evaluation, Formulation, NearPressure, Periodic, Plasticity,
    PressureForce, PressureSolver, SurfaceTension, Viscosity,
};

pub fn fluids(add: Add<'_>) {
    add("normals alone".into(), &|s| s.model.surface_normals = true);
    for &near in NearPressure::ALL {
        for density in [DensityForm::Summation, DensityForm::SummationAdapted] {
            add(format!("near_pressure {near:?}, {density:?} of two fluids"), &|s| {
                (s.model.near_pressure, s.model.density) = (near, density);
                second_fluid(s);
            });
        }
    }
    for &state in EquationOfState::ALL {
        add(format!("equation_of_state {state:?} for two fluids"), &|s| {
            (s.model.equation_of_state, s.model.pressure_force) = (state, PressureForce::MonaghanAdapted);
            second_fluid(s);
        });
        add(format!("equation_of_state {state:?} for the second fluid alone"), &|s| {
            s.model.viscosity = Viscosity::Artificial;
            second_fluid(s);
            s.fluids[1].equation_of_state = Some(state);
        });
    }
    add("pressure_solver PressureCorrection for two fluids".into(), &|s| {
        s.model.pressure_solver = PressureSolver::PressureCorrection;
        s.model.pressure_force = PressureForce::MonaghanAdapted;
        second_fluid(s);
    });
    add("two fluids with everything that mixes them".into(), &|s| {
        second_fluid(s);
        s.model.internal_energy = true;
        s.model.evaluation = Evaluation::Table;
        (s.model.xsph, s.model.radial_exchange, s.ambient_density) = (0.4, 0.3, 20.0);
        s.blocks[1].dynamic_viscosity = Some(0.1);
    });
    for (name, tension, wall) in [
        ("air", SurfaceTension::Off, false),
        ("air and tension", SurfaceTension::NormalCurvature, false),
        ("air and walls of particles", SurfaceTension::Off, true),
    ] {
        add(name.into(), &|s| {
            s.model = Formulation { surface_tension: tension, ..several_fluids() };
            second_fluid(s);
            s.blocks[1].fluid = 0;
            s.air = Some(Air { fluid: 1, capacity: 60, threshold: 0.5, minimum_density: 0.6 });
            if wall {
                walls(s);
            }
            pulled(s);
        });
    }
    add("a fluid of smaller support".into(), &|s| {
        second_fluid(s);
        s.fluids[1].average_neighbours = Some(12.0);
    });
    let plasticity = Some(Plasticity { rate: 20.0, yield_strain: 0.01 });
    for (name, plasticity, break_at) in
        [("springs", None, None), ("plastic springs", plasticity, None), ("brittle springs", plasticity, Some(0.02))]
    {
        add(name.into(), &|s| {
            s.fluids[0].elastic_stiffness = 2000.0;
            s.elasticity = Elasticity { reach: 1.8, plasticity, break_at, ..Elasticity::default() };
        });
        add(format!("{name} of one of two fluids, across a periodic side"), &|s| {
            second_fluid(s);
            walls(s);
            s.model.pressure_solver = PressureSolver::PressureCorrection;
            s.model.pressure_force = PressureForce::Monaghan;
            s.fluids[1].elastic_stiffness = 500.0;
            s.elasticity = Elasticity { reach: 1.8, plasticity, break_at, ..Elasticity::default() };
            s.container = None;
            s.periodic = Some(Periodic { low: Vec3::ZERO, high: Vec3::new(0.8, 0.6, 0.6), axes: [true, false, false] });
            s.blocks[1].corner[0] = 0.6;
        });
    }
    add("two viscosities".into(), &|s| s.blocks[1].dynamic_viscosity = Some(20.0));
    add("radial_exchange".into(), &|s| s.model.radial_exchange = 0.8);
    add("xsph".into(), &|s| s.model.xsph = 0.5);
}
