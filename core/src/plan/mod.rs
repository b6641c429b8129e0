//! The plan of a scene: which arrays exist, which passes run in which order, which terms they contain, and what is left
//! out, with the reason.
//!
//! A plan is a pure function of the scene. What is left out is not computed at all, and what remains keeps its place in
//! every sum, so leaving out terms does not change a single bit of the result. [`Plan::everything`] can be run too, and
//! a test compares the two.
pub mod arrays;
mod explain;
mod features;
pub(crate) mod known;
pub mod passes;
pub mod schedule;

pub use explain::{LeftOut, Terms};

use crate::layout::Model;
use crate::scene::{
    Adjustable, DensityForm, Dimension, Evaluation, Fluid, Formulation, GridStructure, NearPressure, Reflection,
    Shifting, Solid, SolidModel, SurfaceTension, Traversal, Viscosity,
};
use crate::terms::{diffusion, near, shifting, tension, viscosity, wall};
use crate::validate::Checked;
use glam::Vec3;
use passes::Pass;
use schedule::{Schedule, schedule};

/// What a step of a scene consists of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plan {
    /// The choices as numbers, which the terms compare.
    pub model: Model,
    /// The choices by name.
    pub choice: Formulation,
}

impl Plan {
    /// The plan of a scene, with only what the scene needs.
    #[must_use]
    pub fn of(scene: &Checked<'_>) -> Plan {
        let everything = Plan::everything(scene);
        let choice = &scene.model;
        let shears = choice.viscosity == Viscosity::VelocityExchange && choice.velocity_exchange != 0.0;
        let live = |term: Adjustable| scene.adjustable.contains(&term);
        let rubs = live(Adjustable::Viscosity)
            || scene.fluids.iter().any(|fluid| fluid.dynamic_viscosity != 0.0)
            || scene.blocks.iter().any(|b| b.dynamic_viscosity.is_some_and(|mu| mu != 0.0))
            || scene.walls.iter().any(|w| w.dynamic_viscosity.is_some_and(|mu| mu != 0.0))
            || scene.solids.iter().any(|s| s.dynamic_viscosity.is_some_and(|mu| mu != 0.0))
            || scene.container.iter().any(|c| c.dynamic_viscosity.is_some_and(|mu| mu != 0.0));
        let damps = choice.alpha != 0.0 || choice.beta != 0.0;
        let viscosity = match choice.viscosity {
            Viscosity::Artificial if damps => viscosity::ARTIFICIAL,
            Viscosity::Artificial | Viscosity::VelocityExchange => viscosity::NO_VISCOSITY,
            Viscosity::MorrisAndArtificial if rubs && !damps => viscosity::MORRIS,
            // alone it acts at walls of particles too
            Viscosity::MorrisAndArtificial if damps && !rubs && !scene.has_wall_particles() => viscosity::ARTIFICIAL,
            form if rubs || (damps && form == Viscosity::MorrisAndArtificial) => form as u32,
            _ => viscosity::NO_VISCOSITY,
        };
        let near = choice.near_pressure != NearPressure::Off
            && scene.fluids.iter().any(|fluid| fluid.near_stiffness != Some(0.0));
        let pulls = scene.fluids.iter().any(|fluid| fluid.surface_tension != 0.0);
        let several = scene.fluids.len() > 1;
        let pulls = pulls || live(Adjustable::SurfaceTension);
        let walls = scene.has_wall_particles();
        let blocks_differ = scene.blocks.iter().any(|b| b.dynamic_viscosity.is_some());
        Plan {
            model: Model {
                density_diffusion: if choice.diffusion == 0.0 {
                    diffusion::NO_DIFFUSION
                } else {
                    everything.model.density_diffusion
                },
                near_pressure: if near { everything.model.near_pressure } else { near::NEAR_OFF },
                viscosity,
                has_velocity_exchange: u32::from(shears || choice.radial_exchange != 0.0),
                has_gravity: u32::from(scene.gravity != Vec3::ZERO || live(Adjustable::Gravity)),
                has_buoyancy: u32::from(scene.ambient_density != 0.0),
                has_wind: u32::from(scene.wind.is_some_and(|w| w.drag != 0.0) || live(Adjustable::Wind)),
                has_container: u32::from(scene.container.is_some()),
                wall_particles: if walls { everything.model.wall_particles } else { wall::NO_WALLS },
                has_repelling_walls: u32::from(walls && choice.wall_pressure.repels()),
                has_variable_support: u32::from(choice.variable_support.is_some()),
                has_variable_mass: u32::from(choice.initialize_hydrostatic),
                has_materials: u32::from(blocks_differ || several || walls || scene.has_inactive()),
                is_multi_fluid: u32::from(several),
                tension: if pulls { everything.model.tension } else { tension::NO_TENSION },
                has_air: u32::from(scene.air.is_some()),
                has_turnover: u32::from(scene.has_turnover()),
                has_emitters: u32::from(!scene.emitters.is_empty()),
                has_inactive: u32::from(scene.has_inactive()),
                has_normals: u32::from(choice.surface_normals || pulls && everything.model.has_curvature()),
                has_springs: u32::from(scene.fluids.iter().any(is_elastic)),
                is_plastic: u32::from(scene.fluids.iter().any(is_elastic) && everything.model.is_plastic == 1),
                has_internal_energy: u32::from(choice.internal_energy),
                has_xsph: u32::from(choice.xsph != 0.0),
                shifting: if choice.shifting_coefficient == 0.0 {
                    shifting::NO_SHIFTING
                } else {
                    choice.shifting as u32
                },
                ..everything.model
            },
            ..everything
        }
    }

    /// The plan of the same scene that includes every optional term. The terms that the scene does not use have
    /// coefficient 0.
    #[must_use]
    pub fn everything(scene: &Checked<'_>) -> Plan {
        let choice = scene.model;
        let near = if choice.near_pressure == NearPressure::Off {
            NearPressure::DensityProportional
        } else {
            choice.near_pressure
        };
        let tensionless = choice.surface_tension == SurfaceTension::Off;
        let own_equation = |fluid: &Fluid| scene.equation_of(fluid);
        let adapted_density = !matches!(choice.density, DensityForm::Summation | DensityForm::Continuity);
        Plan {
            choice,
            model: Model {
                density_kernel: choice.density_kernel as u32,
                pressure_kernel: choice.pressure_kernel as u32,
                viscosity_kernel: choice.viscosity_kernel as u32,
                evaluation: choice.evaluation as u32,
                density: choice.density as u32,
                density_diffusion: choice.density_diffusion as u32,
                pressure_solver: choice.pressure_solver as u32,
                equation_of_state: own_equation(scene.first_fluid()) as u32,
                tait_exponent: choice.tait_exponent,
                iteration: choice.correction.iteration as u32,
                allows_negative_pressure: u32::from(choice.negative_pressure),
                pressure_force: choice.pressure_force as u32,
                near_pressure: near as u32,
                viscosity: choice.viscosity as u32,
                has_velocity_exchange: 1,
                has_gravity: 1,
                has_buoyancy: 1,
                has_wind: 1,
                has_acceleration_field: u32::from(scene.acceleration_field.is_some()),
                has_container: 1,
                has_conserving_reflection: scene.container.as_ref().map_or(Reflection::default(), |c| c.reflection)
                    as u32,
                has_closed_walls: u32::from(scene.has_closed_walls()),
                has_solids: u32::from(!scene.solids.is_empty()),
                has_repulsion: u32::from(scene.solids.iter().any(|solid| solid.model == SolidModel::Repulsion)),
                has_carried: u32::from(scene.solids.iter().any(Solid::carries)),
                wall_particles: choice.wall_pressure as u32,
                has_repelling_walls: u32::from(choice.wall_pressure.repels()),
                is_periodic: u32::from(scene.periodic_axes().next().is_some()),
                // kernel tables are made for a single support, and the half stencil searches with a single support
                has_variable_support: u32::from(
                    choice.evaluation == Evaluation::Direct && scene.grid.traversal == Traversal::FullStencil,
                ),
                has_variable_mass: 1,
                has_materials: 1,
                is_multi_fluid: 1,
                has_mixed_state_equations: u32::from(
                    scene.fluids.iter().skip(1).any(|fluid| own_equation(fluid) != own_equation(scene.first_fluid())),
                ),
                has_number_density_volume: u32::from(choice.pressure_force.is_adapted() && !adapted_density),
                tension: if tensionless { tension::ATTRACTION } else { choice.surface_tension as u32 },
                has_normals: 1,
                has_springs: 1,
                is_plastic: u32::from(scene.elasticity.plasticity.is_some() || scene.elasticity.break_at.is_some()),
                has_air: u32::from(scene.air.is_some()),
                has_turnover: u32::from(scene.has_turnover()),
                has_emitters: u32::from(!scene.emitters.is_empty()),
                has_inactive: u32::from(scene.has_inactive()),
                has_internal_energy: 1,
                has_xsph: 1,
                shifting: if choice.shifting == Shifting::Off { Shifting::Fickian } else { choice.shifting } as u32,
                has_shifting_speed: u32::from(choice.shifting_speed.is_some()),
                shifts_interfaces: u32::from(choice.shift_across_interfaces),
                has_tensile_control: u32::from(choice.tensile_control),
                is_3d: u32::from(scene.dimension == Dimension::Three),
                integrator: choice.integrator as u32,
                is_reevaluated: u32::from(choice.reevaluate),
                has_changing_step: u32::from(scene.changing_step().is_some()),
                most_halvings: scene.recovery.times(),
                cell_places: match scene.grid.structure {
                    GridStructure::IndexSort => 0,
                    GridStructure::CellLists { places } => places,
                },
                is_half_stencil: scene.grid.traversal as u32,
            },
        }
    }

    /// The commands of a step.
    #[must_use]
    pub fn schedule(&self) -> Schedule {
        schedule(&self.model, self.iterations())
    }

    /// The passes that run, in order, each listed once.
    pub fn passes(&self) -> impl Iterator<Item = Pass> + use<> {
        let model = self.model;
        Pass::ALL.into_iter().filter(move |pass| pass.runs(&model))
    }

    /// Largest number of pressure iterations in a step; 0 with an equation of state.
    #[must_use]
    pub fn iterations(&self) -> u32 {
        if self.model.corrects_pressure() { self.choice.correction.iterations } else { 0 }
    }
}

/// Returns whether springs join the particles of this fluid.
fn is_elastic(fluid: &Fluid) -> bool {
    fluid.elastic_stiffness != 0.0
}
