//! Which choices theory says are the same.
use millpond_core::scene::{DensityForm, EquationOfState, PressureForce, Scene, Viscosity};

/// The scene in the plainest words: choices that theory says are the same become one. All others must make a difference.
pub fn plainest(scene: &Scene) -> Scene {
    use DensityForm as D;
    use PressureForce as P;
    let mut s = scene.clone();
    let m = &mut s.model;
    let one_mass = s.fluids.len() == 1 && !m.initialize_hydrostatic;
    if !m.initialize_hydrostatic {
        // a number density times the own mass is the adapted sum
        m.density = if m.density == D::SummationAdapted { D::NumberDensity } else { m.density };
    }
    if !matches!(m.density, D::Summation | D::Continuity) {
        // on a density that counts numbers a volume is one over it in any form
        m.pressure_force = match m.pressure_force {
            P::MuellerAdapted => P::Mueller,
            P::MonaghanAdapted | P::NumberDensity => P::Monaghan,
            other => other,
        };
        m.viscosity = if m.viscosity == Viscosity::MuellerAdapted { Viscosity::Mueller } else { m.viscosity };
    }
    if one_mass {
        // where all particles weigh the same, numbers are masses
        m.density = match m.density {
            D::NumberDensity => D::Summation,
            D::ContinuityAdapted => D::Continuity,
            other => other,
        };
        if m.density == D::Summation {
            m.pressure_force = match m.pressure_force {
                P::MuellerAdapted => P::Mueller,
                P::MonaghanAdapted => P::Monaghan,
                other => other,
            };
        }
    }
    // a gas has no negative pressure
    m.negative_pressure |= m.equation_of_state == EquationOfState::IdealGas;
    if m.viscosity != Viscosity::VelocityExchange {
        s.model.velocity_exchange = 0.0;
    }
    s
}
