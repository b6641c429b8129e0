//! Which choices are equivalent in theory.
use millpond_core::scene::{DensityForm, EquationOfState, PressureForce, Scene, Viscosity};

/// Returns the scene in its plainest form: of choices that are equivalent in theory, one replaces the others. All other
/// choices must make a difference.
pub fn plainest(scene: &Scene) -> Scene {
    use DensityForm as D;
    use PressureForce as P;
    let mut s = scene.clone();
    let m = &mut s.model;
    let one_mass = s.fluids.len() == 1 && !m.initialize_hydrostatic;
    if !m.initialize_hydrostatic {
        // the adapted sum is the number density times the particle's own mass
        m.density = if m.density == D::SummationAdapted { D::NumberDensity } else { m.density };
    }
    if !matches!(m.density, D::Summation | D::Continuity) {
        // with a number density, every form computes the volume as its inverse
        m.pressure_force = match m.pressure_force {
            P::MuellerAdapted => P::Mueller,
            P::MonaghanAdapted | P::NumberDensity => P::Monaghan,
            other => other,
        };
        m.viscosity = if m.viscosity == Viscosity::MuellerAdapted { Viscosity::Mueller } else { m.viscosity };
    }
    if one_mass {
        // if all particles have the same mass, a number density and a mass density are equivalent
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
    // an ideal gas has no negative pressure
    m.negative_pressure |= m.equation_of_state == EquationOfState::IdealGas;
    if m.viscosity != Viscosity::VelocityExchange {
        s.model.velocity_exchange = 0.0;
    }
    s
}
