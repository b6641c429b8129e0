//! Choices of what surrounds the fluid: variable supports, walls, periodic sides, wind and acceleration fields; and
//! everything at once.
use super::Add;
use super::scenes::{falls, pulled, second_fluid, walls};
use millpond_core::glam::Vec3;
use millpond_core::scene::{
    AccelerationField, DensityForm, Face, Formulation, GridStructure, NearPressure, Periodic, PressureForce,
    PressureSolver, Reflection, SupportRange, SurfaceTension, Viscosity, WallPressure, Wind,
};

pub fn surroundings(add: Add<'_>) {
    add("variable_support".into(), &|s| {
        s.model.variable_support = Some(SupportRange { smallest: 0.7, largest: 1.3 });
    });
    add("ambient_density".into(), &|s| s.ambient_density = 400.0);
    add("wind".into(), &|s| s.wind = Some(Wind { velocity: Vec3::new(3.0, 1.0, 0.0), drag: 4.0 }));
    add("field".into(), &|s| {
        s.acceleration_field =
            Some(AccelerationField { low: Vec3::new(0.1, 0.1, 0.05), spacing: 0.13, counts: [4, 3, 3] });
    });
    add("falls".into(), &falls);
    add("no walls".into(), &|s| {
        falls(s);
        s.container = None;
    });
    add("open face".into(), &|s| {
        falls(s);
        s.container.iter_mut().for_each(|c| c.open = [Face::Floor].into_iter().collect());
    });
    add("full reflection".into(), &|s| {
        falls(s);
        s.container.iter_mut().for_each(|c| c.reflection = Reflection::Full);
    });
    add("cell lists".into(), &|s| s.grid.structure = GridStructure::CellLists { places: 64 });
    for axes in [[true, false, false], [false, true, false], [true, true, true]] {
        add(format!("periodic {axes:?}"), &|s| {
            falls(s);
            s.container = None;
            s.periodic = Some(Periodic { low: Vec3::new(0.05, 0.0, 0.0), high: Vec3::new(0.65, 0.6, 0.6), axes });
        });
    }
    add("everything at once".into(), &|s| {
        s.container = None;
        s.periodic = Some(Periodic { low: Vec3::ZERO, high: Vec3::new(0.8, 0.0, 0.7), axes: [true, false, true] });
        walls(s);
        s.model = Formulation {
            density: DensityForm::Continuity,
            initialize_hydrostatic: true,
            pressure_solver: PressureSolver::PressureCorrection,
            pressure_force: PressureForce::Monaghan,
            near_pressure: NearPressure::DoubleDensity,
            viscosity: Viscosity::Artificial,
            internal_energy: true,
            variable_support: Some(SupportRange { smallest: 0.8, largest: 1.2 }),
            wall_pressure: WallPressure::Dynamic,
            ..s.model
        };
        (s.model.xsph, s.model.radial_exchange, s.ambient_density) = (0.2, 0.1, 10.0);
        s.wind = Some(Wind { velocity: Vec3::new(1.0, 0.0, 0.0), drag: 1.0 });
        s.acceleration_field = Some(AccelerationField { low: Vec3::ZERO, spacing: 0.3, counts: [3, 3, 3] });
        s.blocks[0].dynamic_viscosity = Some(0.5);
        second_fluid(s);
        s.model.surface_tension = SurfaceTension::NormalCurvature;
        pulled(s);
        s.fluids[0].elastic_stiffness = 100.0;
        s.elasticity.break_at = Some(0.1);
    });
}
