//! What a plan consists of, by name: the terms of its passes, and the features that the scene does not use.
use super::Plan;
use super::passes::Pass;
use crate::scene::{PressureSolver, Viscosity};
use crate::terms::diffusion::RENORMALISED;
use crate::terms::extrapolation::extrapolates_velocity;
use crate::terms::shifting::{NO_SHIFTING, drifts};
use crate::terms::viscosity::has_friction;
use crate::terms::{density, integrate, tension};
use heapless::Vec;

/// A feature that the scene does not use.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LeftOut {
    /// Name of the feature.
    pub what: &'static str,
    /// Why it is left out.
    pub why: &'static str,
}

/// Names of the terms of a pass.
pub type Terms = Vec<&'static str, 16>;

impl Plan {
    /// The terms of a pass, in the order of summation.
    #[must_use]
    pub fn terms(&self, pass: Pass) -> Terms {
        let (m, choice) = (&self.model, &self.choice);
        let mut terms = Terms::new();
        let mut add = |names: &[&'static str], runs: bool| {
            if runs {
                // a pass never has more terms than fit
                let _ = terms.extend_from_slice(names);
            }
        };
        let value = &choice.density_kernel.terms()[..1];
        let slope = &choice.pressure_kernel.terms()[1..];
        let continuity = density::is_stepped(m);
        let corrects = m.corrects_pressure();
        match pass {
            Pass::MoveSolids => add(&["course_position", "course_angle"], true),
            Pass::Contact => add(&["shape_distance", "reflected"], true),
            Pass::IntegrateBefore => {
                add(&choice.integrator.terms()[..1], true);
                add(&["drift"], drifts(m));
                add(&["wrap"], m.is_periodic == 1);
            }
            Pass::Support => add(&["support_close"], true),
            Pass::Density => {
                add(choice.density.terms(), true);
                add(if continuity { slope } else { value }, true);
                add(choice.density_diffusion.terms(), m.density_diffusion != 0);
                add(&["interpolated"], m.reads_tables());
                add(&["completed"], m.has_closed_walls == 1);
                add(&["volume_by_number"], m.has_number_density_volume == 1);
                add(choice.equation_of_state.terms(), !corrects);
                add(&choice.near_pressure.terms()[..choice.near_pressure.terms().len().min(1)], m.near_pressure != 0);
            }
            Pass::WallSums => {
                add(&["wall_weight", "wall_pressure_neighbour"], true);
                add(&["wall_velocity"], extrapolates_velocity(m));
            }
            Pass::WallStates => add(&["wall_deviation"], true),
            Pass::Force => {
                add(choice.pressure_force.terms(), !corrects);
                add(&["pressure_without_tension"], m.has_tensile_control == 1);
                add(slope, !corrects);
                add(choice.wall_pressure.terms(), m.wall_particles != 0);
                add(&choice.near_pressure.terms()[choice.near_pressure.terms().len().min(1)..], m.near_pressure != 0);
                let form = Viscosity::ALL.iter().find(|form| **form as u32 == m.viscosity);
                add(form.map_or(&[], |form| form.terms()), form != Some(&Viscosity::VelocityExchange));
                add(choice.surface_tension.terms(), m.tension != 0 && !m.has_curvature());
                add(&["wall_push"], m.has_closed_walls == 1 && !corrects);
                add(&["wall_rub"], m.has_closed_walls == 1 && has_friction(m));
                add(&["repulsion"], m.has_repulsion == 1);
                add(&["exchange_neighbour"], m.has_velocity_exchange == 1);
                add(&["weight"], m.has_gravity == 1);
                add(&["buoyancy"], m.has_buoyancy == 1);
                add(&["wind_drag"], m.has_wind == 1);
                add(&["field_share"], m.has_acceleration_field == 1);
            }
            Pass::Normals => {
                add(&["colour_gradient"], true);
                add(&["colour_laplacian", "curvature_of_colour"], m.tension == tension::CURVATURE);
            }
            Pass::Exposure => add(&["total_gradient", "is_exposed"], true),
            Pass::Tension => {
                add(&["normal_divergence", "curvature_of_normals"], m.tension == tension::NORMAL_CURVATURE);
                add(&["tension_close"], true);
            }
            Pass::Springs => add(&["spring_pull"], true),
            Pass::SpringLengths => add(&["plastic_rest_length"], true),
            Pass::PressureForce => {
                add(choice.pressure_force.terms(), true);
                add(slope, true);
                add(&["wall_push"], m.has_closed_walls == 1);
            }
            Pass::PressureCorrect => {
                add(&["continuity_neighbour", "predicted_density_error", "pressure_corrected"], true);
            }
            Pass::SpawnRequests => add(&["spawn_position", "is_taken"], true),
            Pass::Emit => add(&["layer_leaves", "emitted_position", "is_taken"], true),
            Pass::Leave => {
                add(&["is_thin"], m.has_air == 1);
                add(&["is_drained"], m.has_turnover == 1);
            }
            Pass::Renew => add(&["spawn_position"], m.has_air == 1),
            Pass::InternalEnergy => add(&["internal_energy_neighbour"], true),
            Pass::PredictVelocity => add(&["velocity_after"], true),
            Pass::IntegrateAfter => {
                add(&choice.integrator.terms()[choice.integrator.terms().len().min(1)..], true);
                add(&["penalty_walls"], m.has_container == 1);
            }
            Pass::Measure => add(&["bounded_square", "bounded_sound"], true),
            Pass::Commit => add(&["step_wanted", "step_limited", "clock_after"], m.has_changing_step == 1),
            Pass::Renormalise => {
                add(&["gradient_weight", "smallest_eigenvalue"], true);
                add(&["renormalised"], m.density_diffusion == RENORMALISED);
            }
            Pass::Xsph => add(&["xsph_neighbour"], true),
            Pass::Shift => add(choice.shifting.terms(), true),
            _ => {}
        }
        terms
    }

    /// The features that the scene does not use.
    #[must_use]
    pub fn left_out(&self) -> Vec<LeftOut, 40> {
        let (m, choice) = (&self.model, &self.choice);
        let lists = m.cell_places > 0;
        let all = [
            (m.near_pressure == 0, "near pressure", "model.near_pressure is Off, or near_stiffness is 0 in all fluids"),
            (
                m.density_diffusion == 0,
                "diffusion of density",
                "model.density_diffusion is Off, or model.diffusion is 0",
            ),
            (
                m.viscosity == 0,
                "viscosity",
                match choice.viscosity {
                    Viscosity::Artificial => "model.alpha and model.beta are 0",
                    Viscosity::MorrisAndArtificial => {
                        "model.alpha and model.beta are 0, and dynamic_viscosity is 0 in every fluid"
                    }
                    Viscosity::VelocityExchange => "model.viscosity is VelocityExchange",
                    _ => "dynamic_viscosity is 0 in every fluid",
                },
            ),
            (
                m.has_velocity_exchange == 0,
                "velocity exchange",
                "model.radial_exchange is 0, and model.velocity_exchange is 0 or not used by model.viscosity",
            ),
            (m.has_gravity == 0, "gravity", "gravity is 0"),
            (m.has_buoyancy == 0, "buoyancy", "ambient_density is 0"),
            (m.has_wind == 0, "wind", "wind is not set, or its drag is 0"),
            (m.has_acceleration_field == 0, "acceleration field", "acceleration_field is not set"),
            (m.has_container == 0, "penalty planes", "container is not set"),
            (m.has_solids == 0, "solids", "solids is empty"),
            (
                m.has_closed_walls == 0,
                "walls in closed form",
                "neither container.model nor the model of a solid is ClosedForm",
            ),
            (m.wall_particles == 0, "wall particles", "the scene has no walls"),
            (m.is_periodic == 0, "periodic images", "no axis is periodic"),
            (m.has_variable_support == 0, "variable support", "model.variable_support is not set"),
            (m.has_variable_mass == 0, "variable masses", "model.initialize_hydrostatic is off"),
            (m.has_materials == 0, "materials", "one fluid, no walls, and no block with its own dynamic_viscosity"),
            (m.has_internal_energy == 0, "internal energy", "model.internal_energy is off"),
            (m.has_xsph == 0, "XSPH", "model.xsph is 0"),
            (m.shifting == NO_SHIFTING, "shifting", "model.shifting is Off, or model.shifting_coefficient is 0"),
            (m.has_tensile_control == 0, "tensile control", "model.tensile_control is off"),
            (!m.renormalises(), "renormalised gradients", "no other choice needs them"),
            (!integrate::has_history(m), "integrator history", "model.integrator needs nothing of previous steps"),
            (m.is_reevaluated == 0, "second force evaluation", "model.reevaluate is off"),
            (m.has_changing_step == 0, "changing time step", "adaptive is not set, and recovery is Refuse"),
            (!m.reads_tables(), "kernel tables", "model.evaluation is Direct"),
            (
                choice.pressure_solver != PressureSolver::PressureCorrection,
                "pressure correction",
                "model.pressure_solver is EquationOfState",
            ),
            (m.is_3d == 0, "cells along z", "the scene is in 2D: the stencil has 9 cells"),
            (!lists, "cell lists", "grid.structure is IndexSort"),
            (lists, "index sort", "grid.structure is CellLists"),
            (!m.makes_lists(), "neighbour lists", "grid.traversal is HalfStencil"),
            (m.is_multi_fluid == 0, "multiple fluids", "the scene has one fluid"),
            (m.tension == 0, "surface tension", "model.surface_tension is Off, or surface_tension is 0 in every fluid"),
            (m.has_normals == 0, "normals", "surface tension does not need them, and model.surface_normals is off"),
            (m.has_springs == 0, "elasticity", "elastic_stiffness is 0 in every fluid"),
            (m.is_plastic == 0, "plasticity", "elasticity.plasticity and elasticity.break_at are not set"),
            (m.has_air == 0, "air", "air is not set"),
            (m.has_emitters == 0, "emitters", "the scene has no emitters"),
            (m.has_turnover == 0, "particles that come and go", "the scene has no emitters, drains or spare_particles"),
            (true, "bodies", "this version does not support them"),
        ];
        all.into_iter().filter(|(left_out, ..)| *left_out).map(|(_, what, why)| LeftOut { what, why }).collect()
    }
}
