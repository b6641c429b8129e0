//! The plan of a scene: which passes run, which terms are in them, and what is left out, with the reason.
//!
//! A pure function of the scene. What is left out is not computed at all, and what remains keeps its place in every sum,
//! so a plan never changes a bit: [`Plan::everything`] runs too, and a test compares.
use crate::layout::Model;
use crate::memory::Needs;
use crate::scene::{
    DensityForm, Dimension, EquationOfState, Evaluation, Fluid, GridStructure, ModelChoice, NearPressure, Reflection,
    SurfaceTension, Viscosity,
};
use crate::step::Pass;
use crate::terms::{integrate, near, tension, viscosity, wall};
use crate::validate::Checked;
use heapless::Vec;

/// What a step of a scene consists of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plan {
    /// The choices that the terms compare.
    pub model: Model,
    /// The choices by name.
    pub choice: ModelChoice,
}

/// Something that a scene does without.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LeftOut {
    /// What.
    pub what: &'static str,
    /// Why.
    pub why: &'static str,
}

/// Names of the terms of a pass.
pub type Terms = Vec<&'static str, 16>;

impl Plan {
    /// The plan of a scene: nothing that it does not need.
    #[must_use]
    pub fn of(scene: &Checked<'_>) -> Plan {
        let everything = Plan::everything(scene);
        let (fluid, choice) = (&scene.fluid, &scene.model);
        let shears = choice.viscosity == Viscosity::Exchange && fluid.velocity_exchange != 0.0;
        let viscous = scene.blocks.iter().any(|b| b.dynamic_viscosity.is_some_and(|mu| mu != 0.0))
            || scene.walls.iter().any(|w| w.dynamic_viscosity.is_some_and(|mu| mu != 0.0));
        let drags = match choice.viscosity {
            Viscosity::Artificial => fluid.alpha != 0.0 || fluid.beta != 0.0,
            Viscosity::Exchange => false,
            _ => viscous || scene.fluids().any(|fluid| fluid.dynamic_viscosity != 0.0),
        };
        let near =
            choice.near_pressure != NearPressure::Off && scene.fluids().any(|fluid| fluid.near_stiffness != Some(0.0));
        let pulls = scene.fluids().any(|fluid| fluid.surface_tension != 0.0);
        let several = !scene.other_fluids.is_empty();
        let blocks_differ = scene.blocks.iter().any(|b| b.dynamic_viscosity.is_some());
        Plan {
            model: Model {
                near_pressure: if near { everything.model.near_pressure } else { near::NEAR_OFF },
                viscosity: if drags { everything.model.viscosity } else { viscosity::NO_VISCOSITY },
                exchange: u32::from(shears || fluid.radial_exchange != 0.0),
                gravity: u32::from(scene.gravity != [0.0; 3]),
                buoyancy: u32::from(scene.ambient_density != 0.0),
                wind: u32::from(scene.wind.is_some_and(|w| w.drag != 0.0)),
                walls: u32::from(scene.container.is_some()),
                wall_particles: if scene.walls.is_empty() { wall::NO_WALLS } else { everything.model.wall_particles },
                variable_support: u32::from(choice.variable_support.is_some()),
                masses: u32::from(choice.hydrostatic_start),
                species: u32::from(blocks_differ || several || !scene.walls.is_empty()),
                fluids: u32::from(several),
                tension: if pulls { everything.model.tension } else { tension::NO_TENSION },
                air: u32::from(scene.air.is_some()),
                normals: u32::from(choice.surface_normals || pulls && everything.model.has_curvature()),
                springs: u32::from(scene.fluids().any(is_elastic)),
                plastic: u32::from(scene.fluids().any(is_elastic) && everything.model.plastic == 1),
                thermal_energy: u32::from(choice.thermal_energy),
                xsph: u32::from(fluid.xsph != 0.0),
                ..everything.model
            },
            ..everything
        }
    }

    /// The same scene with every term that can be left out left in, at coefficient 0.
    #[must_use]
    pub fn everything(scene: &Checked<'_>) -> Plan {
        let choice = scene.model;
        let near = if choice.near_pressure == NearPressure::Off { NearPressure::Thesis } else { choice.near_pressure };
        let tensionless = choice.surface_tension == SurfaceTension::Off;
        let own_equation = |fluid: &Fluid| fluid.equation_of_state.unwrap_or(choice.equation_of_state);
        let adapted_density = !matches!(choice.density, DensityForm::Summation | DensityForm::Continuity);
        Plan {
            choice,
            model: Model {
                density_kernel: choice.density_kernel as u32,
                pressure_kernel: choice.pressure_kernel as u32,
                viscosity_kernel: choice.viscosity_kernel as u32,
                evaluation: choice.evaluation as u32,
                density: choice.density as u32,
                equation_of_state: own_equation(&scene.fluid) as u32,
                iteration: choice.correction.iteration as u32,
                suction: u32::from(choice.suction),
                pressure_force: choice.pressure_force as u32,
                near_pressure: near as u32,
                viscosity: choice.viscosity as u32,
                exchange: 1,
                gravity: 1,
                buoyancy: 1,
                wind: 1,
                field: u32::from(scene.field.is_some()),
                walls: 1,
                reflection: scene.container.as_ref().map_or(Reflection::default(), |c| c.reflection) as u32,
                wall_particles: choice.wall_pressure as u32,
                periodic: u32::from(scene.periodic_axes().next().is_some()),
                // a table is made for one support
                variable_support: u32::from(choice.evaluation == Evaluation::Direct),
                masses: 1,
                species: 1,
                fluids: 1,
                states: u32::from(
                    scene.other_fluids.iter().any(|fluid| own_equation(fluid) != own_equation(&scene.fluid)),
                ),
                numbers: u32::from(choice.pressure_force.is_adapted() && !adapted_density),
                tension: if tensionless { tension::ATTRACTION } else { choice.surface_tension as u32 },
                normals: 1,
                springs: 1,
                plastic: u32::from(scene.elasticity.plasticity.is_some() || scene.elasticity.break_at.is_some()),
                air: u32::from(scene.air.is_some()),
                thermal_energy: 1,
                xsph: 1,
                layers: u32::from(scene.dimension == Dimension::Three),
                integrator: choice.integrator as u32,
                reevaluates: u32::from(choice.reevaluate),
                adaptive: u32::from(scene.adaptive.is_some()),
                cell_places: match scene.grid.structure {
                    GridStructure::IndexSort => 0,
                    GridStructure::CellLists { places } => places,
                },
            },
        }
    }

    /// Does this pass run?
    #[must_use]
    pub fn runs(&self, pass: Pass) -> bool {
        let m = &self.model;
        match pass {
            Pass::CellLists => m.cell_places > 0,
            Pass::Place => m.cell_places == 0,
            Pass::Support => m.variable_support == 1,
            Pass::Normals => m.normals == 1 || m.air == 1,
            Pass::Foresee => m.foresees(),
            Pass::Coat | Pass::Air => m.air == 1,
            Pass::IntegrateAfter => m.integrates_after(),
            Pass::Tension => m.has_curvature(),
            Pass::Springs => m.springs == 1,
            Pass::PressureForce | Pass::PressureCorrect | Pass::PressureSettle => m.corrects_pressure(),
            Pass::Heat => m.thermal_energy == 1,
            Pass::Smooth => m.xsph == 1,
            _ => true,
        }
    }

    /// The passes that run, in order, each once.
    pub fn passes(&self) -> impl Iterator<Item = Pass> + use<> {
        let plan = *self;
        Pass::ALL.into_iter().filter(move |&pass| plan.runs(pass))
    }

    /// Most iterations of pressure in a step; 0 with an equation of state.
    #[must_use]
    pub fn iterations(&self) -> u32 {
        if self.model.corrects_pressure() { self.choice.correction.iterations } else { 0 }
    }

    /// The terms of a pass, in the order of its sums.
    #[must_use]
    pub fn terms(&self, pass: Pass) -> Terms {
        let (m, choice) = (&self.model, &self.choice);
        let mut terms = Terms::new();
        let mut add = |names: &[&'static str], runs: bool| {
            if runs {
                // as many as a pass has terms at most
                let _ = terms.extend_from_slice(names);
            }
        };
        let value = &choice.density_kernel.terms()[..1];
        let slope = &choice.pressure_kernel.terms()[1..];
        let continuity = crate::terms::density::is_stepped(m);
        let corrects = m.corrects_pressure();
        match pass {
            Pass::IntegrateBefore => {
                add(&choice.integrator.terms()[..1], true);
                add(&["drift"], m.xsph == 1);
                add(&["wrap"], m.periodic == 1);
            }
            Pass::Support => add(&["support_close"], true),
            Pass::Density => {
                add(choice.density.terms(), true);
                add(if continuity { slope } else { value }, true);
                add(&["interpolated"], m.reads_tables());
                add(&["volume_by_number"], m.numbers == 1);
                add(choice.equation_of_state.terms(), !corrects);
                add(&choice.near_pressure.terms()[..choice.near_pressure.terms().len().min(1)], m.near_pressure != 0);
            }
            Pass::Force => {
                add(choice.pressure_force.terms(), !corrects);
                add(slope, !corrects);
                add(choice.wall_pressure.terms(), m.wall_particles != 0);
                add(&choice.near_pressure.terms()[choice.near_pressure.terms().len().min(1)..], m.near_pressure != 0);
                add(choice.viscosity.terms(), m.viscosity != 0 && choice.viscosity != Viscosity::Exchange);
                add(choice.surface_tension.terms(), m.tension != 0 && !m.has_curvature());
                add(&["exchange_neighbour"], m.exchange == 1);
                add(&["weight"], m.gravity == 1);
                add(&["buoyancy"], m.buoyancy == 1);
                add(&["wind_drag"], m.wind == 1);
                add(&["field_share"], m.field == 1);
            }
            Pass::Normals => {
                add(&["colour_gradient"], m.normals == 1);
                add(&["colour_laplacian", "curvature_of_colour"], m.tension == tension::CURVATURE);
                add(&["whole_gradient"], m.air == 1);
            }
            Pass::Tension => {
                add(&["normal_divergence", "curvature_of_normals"], m.tension == tension::NORMAL_CURVATURE);
                add(&["tension_close"], true);
            }
            Pass::Springs => {
                add(&["spring_pull"], true);
                add(&["spring_given_way"], m.plastic == 1);
            }
            Pass::PressureForce => {
                add(choice.pressure_force.terms(), true);
                add(slope, true);
            }
            Pass::PressureCorrect => add(&["continuity_neighbour", "density_miss", "pressure_corrected"], true),
            Pass::Coat => add(&["is_bare", "place_of_birth", "is_taken"], true),
            Pass::Air => add(&["is_thin", "place_of_birth"], true),
            Pass::Heat => add(&["heat_neighbour"], true),
            Pass::Foresee => add(&["velocity_after"], true),
            Pass::IntegrateAfter => {
                add(&choice.integrator.terms()[choice.integrator.terms().len().min(1)..], true);
                add(&["penalty_walls"], m.walls == 1);
            }
            Pass::Look => add(&["bounded_square", "bounded_sound"], m.adaptive == 1),
            Pass::Commit => add(&["step_wanted", "step_limited", "clock_after"], m.adaptive == 1),
            Pass::Smooth => add(&["xsph_neighbour"], true),
            _ => {}
        }
        terms
    }

    /// What the scene does without.
    #[must_use]
    pub fn left_out(&self) -> Vec<LeftOut, 32> {
        let (m, choice) = (&self.model, &self.choice);
        let lists = m.cell_places > 0;
        let all = [
            (m.near_pressure == 0, "near pressure", "model.near_pressure is Off, or its stiffness is 0"),
            (
                m.viscosity == 0,
                "viscosity",
                match choice.viscosity {
                    Viscosity::Artificial => "fluid.alpha and fluid.beta are 0",
                    Viscosity::Exchange => "velocities are exchanged instead",
                    _ => "fluid.dynamic_viscosity is 0",
                },
            ),
            (
                m.exchange == 0,
                "exchange of velocities",
                "fluid.velocity_exchange and fluid.radial_exchange are unused or 0",
            ),
            (m.gravity == 0, "gravity", "gravity is 0"),
            (m.buoyancy == 0, "buoyancy", "ambient_density is 0"),
            (m.wind == 0, "wind", "the scene has none"),
            (m.field == 0, "field of the host's", "the scene has none"),
            (m.walls == 0, "penalty walls", "the scene has no container"),
            (m.wall_particles == 0, "walls of particles", "the scene has none"),
            (m.periodic == 0, "periodic images", "no axis is periodic"),
            (m.variable_support == 0, "variable support", "model.variable_support is not set"),
            (m.masses == 0, "masses", "all particles have the same"),
            (m.species == 0, "kinds of particle", "there is one fluid and no wall of particles"),
            (m.thermal_energy == 0, "thermal energy", "model.thermal_energy is off"),
            (m.xsph == 0, "XSPH", "fluid.xsph is 0"),
            (!integrate::has_history(m), "integrator's history", "model.integrator remembers nothing"),
            (m.reevaluates == 0, "second evaluation", "model.reevaluate is off"),
            (m.adaptive == 0, "changing time step", "adaptive is not set"),
            (!m.reads_tables(), "kernel tables", "model.evaluation is Direct"),
            (
                choice.equation_of_state != EquationOfState::PressureCorrection,
                "pressure correction",
                "model.equation_of_state is an equation",
            ),
            (m.layers == 0, "cells along z", "the scene is in 2D: a stencil of 9 cells"),
            (!lists, "cell lists", "grid.structure is the index sort"),
            (lists, "index sort", "grid.structure is cell lists"),
            (m.fluids == 0, "several fluids", "there is one"),
            (m.tension == 0, "surface tension", "model.surface_tension is Off, or fluid.surface_tension is 0"),
            (m.normals == 0, "normals", "no tension needs them, and model.surface_normals is off"),
            (m.springs == 0, "elasticity", "fluid.elastic_stiffness is 0"),
            (m.plastic == 0, "plasticity", "elasticity.plasticity and elasticity.break_at are not set"),
            (m.air == 0, "air", "the scene has none"),
            (true, "bodies", "no scene of this version can ask for it"),
            (true, "emitters over time", "no scene of this version can ask for it"),
        ];
        all.into_iter().filter(|(left_out, ..)| *left_out).map(|(_, what, why)| LeftOut { what, why }).collect()
    }
}

/// Do springs join its particles?
fn is_elastic(fluid: &Fluid) -> bool {
    fluid.elastic_stiffness != 0.0
}

impl Needs {
    /// Of a scene, by its own plan.
    #[must_use]
    pub fn of(scene: &Checked<'_>) -> Needs {
        Needs::by_plan(scene, &Plan::of(scene))
    }

    /// Of a scene by this plan of it.
    #[must_use]
    pub fn by_plan(scene: &Checked<'_>, plan: &Plan) -> Needs {
        let (m, derived) = (&plan.model, scene.derived());
        // and one for air that is not there
        let cells = derived.cells.iter().map(|&n| n as usize).product::<usize>() + m.air as usize;
        Needs {
            particles: derived.particles(),
            cells,
            places: m.cell_places as usize * cells,
            smoothing: m.xsph == 1,
            heat: m.thermal_energy == 1,
            previous: m.needs_previous(),
            free: m.corrects_pressure(),
            normals: m.normals == 1,
            springs: m.springs == 1,
            spring_ends: if m.springs == 1 { derived.spring_ends } else { 0 },
            plastic: m.plastic == 1,
            air: m.air == 1,
            history: integrate::has_history(m),
            earlier: integrate::needs_earlier(m),
            ahead: m.foresees(),
            tables: m.reads_tables(),
            nodes: derived.field_counts[3] as usize,
        }
    }
}
