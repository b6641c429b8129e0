//! Quantities derived for each fluid: speed of sound, stiffnesses, and the pull of its springs.
use super::scales::speed_of_sound;
use crate::scene::{EquationOfState, FLUIDS, Fluid, NearPressure, Scene};
use heapless::Vec;

/// Default of the near stiffness over c0^2. Our choice: larger values, near c0^2, make the fluid expand like a gas
/// (Pirovano, section 3.1, corrected).
const DEFAULT_NEAR_SHARE: f64 = 0.1;

/// The constants of a fluid.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct FluidConstants {
    /// Equation of state: the fluid's own, or that of the model.
    pub equation_of_state: EquationOfState,
    /// Density at rest, kg/m3.
    pub rest_density: f64,
    /// Speed of sound at rest, m/s.
    pub speed_of_sound: f64,
    /// `rho0 c0^2`, Pa.
    pub bulk_modulus: f64,
    /// Constant of the equation of state, Pa.
    pub state_stiffness: f64,
    /// Exponent of Tait's equation.
    pub tait_exponent: f64,
    /// Near pressure over density, m2/s2; 0 if near pressure is off.
    pub near_stiffness: f64,
    /// Half of the spring stiffness over the mass of the fluid's particles at rest, `k / (2 m)`, 1/s2.
    pub spring_pull: f64,
}

impl FluidConstants {
    fn of(scene: &Scene, particle_mass: f64, fluid: &Fluid) -> FluidConstants {
        let equation_of_state = scene.equation_of(fluid);
        let c0 = speed_of_sound(scene, fluid);
        let bulk_modulus = f64::from(fluid.rest_density) * c0 * c0;
        let exponent = f64::from(scene.model.tait_exponent);
        let mass = particle_mass * f64::from(fluid.rest_density) / f64::from(scene.first_fluid().rest_density);
        FluidConstants {
            equation_of_state,
            rest_density: f64::from(fluid.rest_density),
            speed_of_sound: c0,
            bulk_modulus,
            state_stiffness: match equation_of_state {
                EquationOfState::Tait => fluid.stiffness.map_or(bulk_modulus / exponent, f64::from),
                _ => bulk_modulus,
            },
            tait_exponent: exponent,
            near_stiffness: if scene.model.near_pressure == NearPressure::Off {
                0.0
            } else {
                fluid.near_stiffness.map_or(DEFAULT_NEAR_SHARE * c0 * c0, f64::from)
            },
            spring_pull: f64::from(fluid.elastic_stiffness) / (2.0 * mass),
        }
    }

    /// Returns the density at a pressure in Pa, kg/m3, by the equation of state.
    #[must_use]
    pub fn density_at(&self, pressure: f64) -> f64 {
        self.rest_density * (1.0 + self.deviation_at(pressure))
    }

    /// Returns the relative deviation of density from the rest density at a pressure in Pa.
    pub(super) fn deviation_at(&self, pressure: f64) -> f64 {
        match self.equation_of_state {
            EquationOfState::Tait => libm::pow(1.0 + pressure / self.state_stiffness, 1.0 / self.tait_exponent) - 1.0,
            EquationOfState::Linear => pressure / self.state_stiffness,
            // P = c0^2 rho
            EquationOfState::IdealGas => pressure / self.state_stiffness - 1.0,
        }
    }

    /// The constants of all fluids of a scene, by index; never empty.
    pub(crate) fn of_all(scene: &Scene, particle_mass: f64) -> Vec<FluidConstants, FLUIDS> {
        scene.fluids.iter().map(|fluid| FluidConstants::of(scene, particle_mass, fluid)).collect()
    }
}
