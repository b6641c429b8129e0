//! The choices of a scene and their options.
use super::scenes::{closed, falls, fed, pulled, second_fluid, solids, walls};
use millpond_core::glam::Vec3;
use millpond_core::scene::{
    AccelerationField, AdaptiveTimeStep, Adjustable, Air, Correction, DensityDiffusion, DensityForm, Elasticity,
    EquationOfState, Evaluation, Face, GridStructure, Integrator, Iteration, Kernel, NearPressure, Periodic,
    Plasticity, PressureForce, PressureSolver, Recovery, Reflection, Scene, Shifting, SolidModel, SupportRange,
    SurfaceTension, Viscosity, WallPressure, Wind,
};
use std::fmt::Debug;

/// A change of a scene.
type Change = Box<dyn Fn(&mut Scene)>;

/// A choice of a scene, such as that of the kernel.
pub(super) struct Choice {
    /// Its name, mostly that of the field of the scene.
    pub(super) name: &'static str,
    /// Its options, each by a name.
    pub(super) options: Vec<(String, Change)>,
}

/// A choice between the variants of an enumeration.
fn variants<T: Copy + Debug + 'static>(name: &'static str, all: &[T], set: fn(&mut Scene, T)) -> Choice {
    let option = |&value: &T| (format!("{value:?}"), Box::new(move |s: &mut Scene| set(s, value)) as Change);
    Choice { name, options: all.iter().map(option).collect() }
}

/// An option by name.
type Named = (&'static str, fn(&mut Scene));

/// A choice between named changes.
fn named<const N: usize>(name: &'static str, options: [Named; N]) -> Choice {
    let option = |(name, set): Named| (name.to_owned(), Box::new(set) as Change);
    Choice { name, options: options.map(option).into() }
}

/// A choice to use a feature or not.
fn whether(name: &'static str, set: fn(&mut Scene)) -> Choice {
    named(name, [("no", |_| {}), ("yes", set)])
}

/// Returns all choices, in the order in which a scene is changed.
pub(super) fn choices() -> Vec<Choice> {
    let mut all = surroundings();
    all.extend(pressure());
    all.extend(forces());
    all.extend(time());
    // these depend on the fluids and the walls that the choices before have made
    all.push(variants("surface_tension", SurfaceTension::ALL, |s, form| {
        s.model.surface_tension = form;
        pulled(s);
    }));
    all.push(named(
        "container",
        [
            ("none", |s| s.container = None),
            ("penalty", falls),
            ("penalty, full reflection, open floor", |s| {
                falls(s);
                s.container.iter_mut().for_each(|container| {
                    container.reflection = Reflection::Full;
                    container.open = [Face::Floor].into_iter().collect();
                });
            }),
            ("closed form", |s| {
                falls(s);
                closed(s);
            }),
        ],
    ));
    all.push(named(
        "periodic",
        [
            ("no", |_| {}),
            ("x", |s| periodic(s, [true, false, false])),
            ("y", |s| periodic(s, [false, true, false])),
            ("xyz", |s| periodic(s, [true, true, true])),
        ],
    ));
    all
}

fn periodic(s: &mut Scene, axes: [bool; 3]) {
    s.container = None;
    s.periodic = Some(Periodic { low: Vec3::new(0.05, 0.0, 0.0), high: Vec3::new(0.85, 0.6, 0.6), axes });
}

fn surroundings() -> Vec<Choice> {
    vec![
        named(
            "fluids",
            [
                ("one", |_| {}),
                ("two", second_fluid),
                ("two, the second an ideal gas", |s| {
                    second_fluid(s);
                    s.fluids[1].equation_of_state = Some(EquationOfState::IdealGas);
                }),
                ("two, the second with a smaller support", |s| {
                    second_fluid(s);
                    s.fluids[1].average_neighbours = Some(12.0);
                }),
                ("one, with air around it", |s| {
                    second_fluid(s);
                    s.blocks[1].fluid = 0;
                    s.air = Some(Air { fluid: 1, capacity: 60, threshold: 0.5, minimum_density: 0.6 });
                }),
            ],
        ),
        whether("viscosity of a block", |s| s.blocks[1].dynamic_viscosity = Some(20.0)),
        whether("no viscosity", |s| s.fluids.iter_mut().for_each(|fluid| fluid.dynamic_viscosity = 0.0)),
        named(
            "walls",
            [
                ("none", |_| {}),
                ("Mirrored", |s| walls_of(s, WallPressure::Mirrored)),
                ("Dynamic", |s| walls_of(s, WallPressure::Dynamic)),
                ("Extrapolated", |s| walls_of(s, WallPressure::Extrapolated)),
                ("LennardJones", |s| walls_of(s, WallPressure::LennardJones)),
                ("KernelForce", |s| walls_of(s, WallPressure::KernelForce)),
            ],
        ),
        named(
            "springs",
            [
                ("none", |_| {}),
                ("elastic", |s| springs(s, None, None)),
                ("plastic", |s| springs(s, Some(Plasticity { rate: 20.0, yield_strain: 0.01 }), None)),
                ("brittle", |s| springs(s, None, Some(0.02))),
            ],
        ),
        named(
            "solids",
            [
                ("none", |_| {}),
                ("Penalty", |s| solids(s, SolidModel::Penalty)),
                ("ClosedForm", |s| solids(s, SolidModel::ClosedForm)),
                ("Repulsion", |s| solids(s, SolidModel::Repulsion)),
                ("Particles", |s| solids(s, SolidModel::Particles)),
            ],
        ),
        whether("wind", |s| s.wind = Some(Wind { velocity: Vec3::new(3.0, 1.0, 0.0), drag: 4.0 })),
        whether("emitters and drains", fed),
        whether("ambient_density", |s| s.ambient_density = 400.0),
        whether("acceleration_field", |s| {
            s.acceleration_field = Some(AccelerationField { low: Vec3::ZERO, spacing: 0.3, counts: [3, 3, 3] });
        }),
        whether("cell lists", |s| s.grid.structure = GridStructure::CellLists { places: 64 }),
        whether("adjustable", |s| {
            use Adjustable::{Gravity, SurfaceTension, Viscosity, Wind};
            s.adjustable = [Gravity, Wind, Viscosity, SurfaceTension].into_iter().collect();
        }),
    ]
}

fn walls_of(s: &mut Scene, pressure: WallPressure) {
    walls(s);
    s.model.wall_pressure = pressure;
}

fn springs(s: &mut Scene, plasticity: Option<Plasticity>, break_at: Option<f32>) {
    s.fluids[0].elastic_stiffness = 2000.0;
    s.elasticity = Elasticity { reach: 1.8, plasticity, break_at, ..Elasticity::default() };
}

fn pressure() -> Vec<Choice> {
    let with_values: Vec<Kernel> = Kernel::ALL.iter().copied().filter(|kernel| kernel.has_value()).collect();
    let evaluations = [Evaluation::Direct, Evaluation::Table, Evaluation::SquaredTable];
    vec![
        variants("density_kernel", &with_values, |s, kernel| s.model.density_kernel = kernel),
        variants("pressure_kernel", Kernel::ALL, |s, kernel| s.model.pressure_kernel = kernel),
        variants("viscosity_kernel", Kernel::ALL, |s, kernel| s.model.viscosity_kernel = kernel),
        variants("evaluation", &evaluations, |s, evaluation| s.model.evaluation = evaluation),
        variants("density", DensityForm::ALL, |s, form| s.model.density = form),
        variants("density_diffusion", DensityDiffusion::ALL, |s, form| s.model.density_diffusion = form),
        whether("initialize_hydrostatic", |s| s.model.initialize_hydrostatic = true),
        whether("normalize_mass", |s| s.model.normalize_mass = true),
        named(
            "pressure_solver",
            [
                ("EquationOfState", |_| {}),
                ("Relaxed", |s| corrected(s, Iteration::Relaxed)),
                ("Literal", |s| corrected(s, Iteration::Literal)),
            ],
        ),
        variants("equation_of_state", EquationOfState::ALL, |s, state| s.model.equation_of_state = state),
        variants("tait_exponent", &[1, 2, 3, 4, 5, 6, 7], |s, exponent| s.model.tait_exponent = exponent),
        variants("negative_pressure", &[false, true], |s, allowed| s.model.negative_pressure = allowed),
        variants("pressure_force", PressureForce::ALL, |s, form| s.model.pressure_force = form),
        variants("near_pressure", NearPressure::ALL, |s, form| s.model.near_pressure = form),
        whether("tensile_control", |s| s.model.tensile_control = true),
        whether("variable_support", |s| {
            s.model.variable_support = Some(SupportRange { smallest: 0.7, largest: 1.3 });
        }),
    ]
}

fn corrected(s: &mut Scene, iteration: Iteration) {
    s.model.pressure_solver = PressureSolver::PressureCorrection;
    s.model.correction = Correction { iteration, iterations: 3, tolerance: 1e-3 };
}

fn forces() -> Vec<Choice> {
    vec![
        variants("viscosity", Viscosity::ALL, |s, form| {
            s.model.viscosity = form;
            s.model.velocity_exchange = if form == Viscosity::VelocityExchange { 0.1 } else { 0.0 };
        }),
        whether("radial_exchange", |s| s.model.radial_exchange = 0.2),
        whether("internal_energy", |s| {
            (s.model.internal_energy, s.model.heat_gain) = (true, 0.7);
        }),
        whether("surface_normals", |s| s.model.surface_normals = true),
        whether("xsph", |s| s.model.xsph = 0.2),
        named(
            "shifting",
            [
                ("Off", |_| {}),
                ("Fickian", |s| s.model.shifting = Shifting::Fickian),
                ("Fickian at a given speed, across interfaces", |s| {
                    (s.model.shifting, s.model.shifting_speed) = (Shifting::Fickian, Some(2.0));
                    s.model.shift_across_interfaces = true;
                }),
                ("TransportVelocity", |s| s.model.shifting = Shifting::TransportVelocity),
            ],
        ),
    ]
}

fn time() -> Vec<Choice> {
    fn adaptive(s: &mut Scene, reject_ratio: Option<f32>) {
        // short enough for the emitter
        s.adaptive = Some(AdaptiveTimeStep { largest: 0.002, reject_ratio, ..AdaptiveTimeStep::default() });
    }
    let adaptive = named(
        "adaptive",
        [("no", |_| {}), ("yes", |s| adaptive(s, None)), ("yes, and made again", |s| adaptive(s, Some(1.0)))],
    );
    vec![
        variants("integrator", Integrator::ALL, |s, integrator| s.model.integrator = integrator),
        whether("reevaluate", |s| s.model.reevaluate = true),
        adaptive,
        whether("steps that are shortened", |s| s.recovery = Recovery::ShortenStep { times: 3 }),
    ]
}
