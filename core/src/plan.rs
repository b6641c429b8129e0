//! The plan of a scene: which passes run, which terms are in them, and what is left out, with the reason.
//!
//! A pure function of the scene. What is left out is not computed at all, and what remains keeps its place in every sum,
//! so a plan never changes a bit: [`Plan::everything`] runs too, and a test compares.
use crate::layout::Model;
use crate::scene::{Dimension, GridStructure, ModelChoice, Reflection, Scene};
use crate::step::Pass;
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
pub type Terms = Vec<&'static str, 8>;

impl Plan {
    /// The plan of a scene: nothing that it does not need.
    #[must_use]
    pub fn of(scene: &Scene) -> Plan {
        let everything = Plan::everything(scene);
        Plan {
            model: Model {
                near_pressure: u32::from(scene.model.near_pressure && scene.fluid.near_stiffness != Some(0.0)),
                viscosity: u32::from(scene.fluid.dynamic_viscosity != 0.0),
                gravity: u32::from(scene.gravity != [0.0; 3]),
                walls: u32::from(scene.container.is_some()),
                ..everything.model
            },
            ..everything
        }
    }

    /// The same scene with every term that can be left out left in, at coefficient 0.
    #[must_use]
    pub fn everything(scene: &Scene) -> Plan {
        let choice = scene.model;
        Plan {
            choice,
            model: Model {
                density_kernel: choice.density_kernel as u32,
                pressure_kernel: choice.pressure_kernel as u32,
                pressure_force: choice.pressure_force as u32,
                equation_of_state: choice.equation_of_state as u32,
                suction: u32::from(choice.suction),
                near_pressure: 1,
                viscosity: 1,
                gravity: 1,
                walls: 1,
                reflection: scene.container.as_ref().map_or(Reflection::default(), |c| c.reflection) as u32,
                layers: u32::from(scene.dimension == Dimension::Three),
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
        match pass {
            Pass::CellLists => self.model.cell_places > 0,
            Pass::Place => self.model.cell_places == 0,
            _ => true,
        }
    }

    /// The passes that run, in order.
    pub fn passes(&self) -> impl Iterator<Item = Pass> + use<> {
        let plan = *self;
        Pass::ALL.into_iter().filter(move |&pass| plan.runs(pass))
    }

    /// The terms of a pass, in the order of its sums.
    #[must_use]
    pub fn terms(&self, pass: Pass) -> Terms {
        let (m, choice) = (&self.model, &self.choice);
        let [density_kernel, _] = choice.density_kernel.terms();
        let [_, pressure_slope] = choice.pressure_kernel.terms();
        let all: &[(&'static str, bool)] = match pass {
            Pass::IntegrateBefore => &[("kick", true), ("drift", true)],
            Pass::Density => &[
                (density_kernel, true),
                (choice.equation_of_state.term(), true),
                ("near_pressure", m.near_pressure == 1),
            ],
            Pass::Force => &[
                (choice.pressure_force.term(), true),
                (pressure_slope, true),
                ("near_slope", m.near_pressure == 1),
                ("viscosity_mueller", m.viscosity == 1),
                ("gravity", m.gravity == 1),
            ],
            Pass::IntegrateAfter => &[("kick", true), ("penalty_walls", m.walls == 1)],
            _ => &[],
        };
        all.iter().filter(|(_, runs)| *runs).map(|(name, _)| *name).collect()
    }

    /// What the scene does without.
    #[must_use]
    pub fn left_out(&self) -> Vec<LeftOut, 16> {
        let m = &self.model;
        let lists = m.cell_places > 0;
        let all = [
            (m.near_pressure == 0, "near pressure", "model.near_pressure is off, or its stiffness is 0"),
            (m.viscosity == 0, "viscosity", "fluid.dynamic_viscosity is 0"),
            (m.gravity == 0, "gravity", "gravity is 0"),
            (m.walls == 0, "penalty walls", "the scene has no container"),
            (m.layers == 0, "cells along z", "the scene is in 2D: a stencil of 9 cells"),
            (!lists, "cell lists", "grid.structure is the index sort"),
            (lists, "index sort", "grid.structure is cell lists"),
            (true, "surface tension", "no scene of this version can ask for it"),
            (true, "elasticity", "no scene of this version can ask for it"),
            (true, "bodies", "no scene of this version can ask for it"),
            (true, "boundary particles", "no scene of this version can ask for it"),
            (true, "emitters over time", "no scene of this version can ask for it"),
        ];
        all.into_iter().filter(|(left_out, ..)| *left_out).map(|(_, what, why)| LeftOut { what, why }).collect()
    }
}
