//! Choices that do not go together, refused by name before anything is touched.
use super::check::positive;
use super::{
    Correction, DensityForm, EquationOfState, Evaluation, Iteration, Kernel, NearPressure, PressureForce, Scene,
    Viscosity, WallPressure,
};
use crate::error::SceneError;

/// Spacings that sound may travel in a step of the literal pressure correction: beyond, its iteration grows (errata of S0
/// section 3.2.2).
const LITERAL_SPACINGS: f32 = 1.5;

impl Scene {
    pub(super) fn check_combinations(&self) -> Result<(), SceneError> {
        self.check_kernels()?;
        self.check_pressure()?;
        self.check_correction()?;
        self.check_support()?;
        let model = &self.model;
        let one_sided = matches!(model.pressure_force, PressureForce::Canonical | PressureForce::Difference);
        if model.thermal_energy && one_sided {
            return Err(not_together(
                "model.thermal_energy",
                "a canonical or difference model.pressure_force",
                "its pairs do not act on each other alike, so their work is nobody's",
            ));
        }
        if self.ambient_density > 0.0 && self.gravity == [0.0; 3] {
            return Err(not_together("ambient_density", "no gravity", "nothing would be buoyant"));
        }
        if model.hydrostatic_start && model.equation_of_state == EquationOfState::IdealGas {
            return Err(not_together(
                "model.hydrostatic_start",
                "model.equation_of_state IdealGas",
                "a gas has no surface to measure depth from",
            ));
        }
        if model.hydrostatic_start && self.ambient_density >= self.fluid.rest_density {
            return Err(not_together(
                "model.hydrostatic_start",
                "an ambient_density as large as the fluid's",
                "its surface would be at the other end",
            ));
        }
        if model.hydrostatic_start && self.gravity == [0.0; 3] {
            return Err(not_together("model.hydrostatic_start", "no gravity", "there is no weight to hold"));
        }
        Ok(())
    }

    fn check_kernels(&self) -> Result<(), SceneError> {
        let model = &self.model;
        if model.density_kernel == Kernel::Viscosity {
            return Err(not_together(
                "model.density_kernel Viscosity",
                "any density",
                "its value at no distance, and so a particle's own share, is infinite",
            ));
        }
        if model.evaluation != Evaluation::Direct {
            if model.variable_support.is_some() {
                return Err(not_together(
                    "model.variable_support",
                    "model.evaluation from tables",
                    "a table is made for one support (S0 section 4.2.3)",
                ));
            }
            let endless = model.pressure_kernel == Kernel::Viscosity
                || match model.viscosity {
                    Viscosity::Mueller => {
                        model.viscosity_kernel.is_cusped() && model.viscosity_kernel != Kernel::Viscosity
                    }
                    Viscosity::Exchange => false,
                    _ => model.viscosity_kernel == Kernel::Viscosity,
                };
            if endless {
                return Err(not_together(
                    "model.evaluation from tables",
                    "a kernel whose slope or Laplacian is infinite at no distance",
                    "no table ends there",
                ));
            }
        }
        Ok(())
    }

    fn check_pressure(&self) -> Result<(), SceneError> {
        let model = &self.model;
        let on_numbers = model.pressure_force == PressureForce::NumberDensity;
        if on_numbers && model.density != DensityForm::NumberDensity {
            return Err(not_together(
                "model.pressure_force NumberDensity",
                "a model.density other than NumberDensity",
                "it is the gradient on that density",
            ));
        }
        let mirrored = !self.walls.is_empty() && model.wall_pressure == WallPressure::Mirrored;
        if mirrored && model.pressure_force == PressureForce::Difference {
            return Err(not_together(
                "model.pressure_force Difference",
                "model.wall_pressure Mirrored",
                "a mirrored pressure makes no difference, so nothing would hold the fluid",
            ));
        }
        if model.density == DensityForm::NumberDensity && model.hydrostatic_start {
            return Err(not_together(
                "model.hydrostatic_start",
                "model.density NumberDensity",
                "masses that differ change no number",
            ));
        }
        if self.fluid.stiffness.is_some() && model.equation_of_state != EquationOfState::Tait {
            return Err(not_together(
                "fluid.stiffness",
                "a model.equation_of_state other than Tait",
                "it is the constant of that equation",
            ));
        }
        if model.near_pressure == NearPressure::Off && self.fluid.near_stiffness.is_some_and(|k| k > 0.0) {
            return Err(not_together("fluid.near_stiffness", "model.near_pressure Off", "nothing would use it"));
        }
        Ok(())
    }

    fn check_correction(&self) -> Result<(), SceneError> {
        let Correction { iteration, iterations, tolerance } = self.model.correction;
        positive("model.correction.tolerance", tolerance)?;
        if iterations == 0 || iterations > Correction::MOST {
            return Err(SceneError::CapacityExceeded {
                what: "model.correction.iterations, 1 at least,",
                needed: iterations as usize,
                capacity: Correction::MOST as usize,
            });
        }
        if self.model.equation_of_state != EquationOfState::PressureCorrection {
            return Ok(());
        }
        if !matches!(self.model.pressure_force, PressureForce::Monaghan | PressureForce::Difference) {
            return Err(not_together(
                "model.equation_of_state PressureCorrection",
                "a model.pressure_force other than Monaghan or Difference",
                "its iteration is one of these two (S0 section 3.2.2)",
            ));
        }
        let spacings = self.fluid.speed_of_sound * self.time_step / self.particle_spacing;
        if iteration == Iteration::Literal && spacings > LITERAL_SPACINGS {
            return Err(SceneError::CannotConverge { spacings, most: LITERAL_SPACINGS });
        }
        Ok(())
    }

    fn check_support(&self) -> Result<(), SceneError> {
        let Some(range) = self.model.variable_support else { return Ok(()) };
        let bounds = [
            ("model.variable_support.smallest", range.smallest, 0.5, 1.0),
            ("model.variable_support.largest", range.largest, 1.0, 2.0),
        ];
        for (field, value, least, most) in bounds {
            if !(least..=most).contains(&value) {
                return Err(SceneError::OutOfBounds { field, value, least, most });
            }
        }
        Ok(())
    }
}

fn not_together(choice: &'static str, other: &'static str, why: &'static str) -> SceneError {
    SceneError::NotTogether { choice, other, why }
}
