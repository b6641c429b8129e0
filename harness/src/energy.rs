//! The total mechanical energy of a fluid, including the energy stored in compression, and the speed of sound.
use glam::Vec3;
use millpond_core::backend::derive::{FluidConstants, speed_of_sound};
use millpond_core::backend::hash::tree_sum;
use millpond_core::scene::{EquationOfState, Fluid, PressureForce, Scene};
use millpond_core::{Checked, Particle, Solver};

/// Largest allowed rise of the mechanical energy above its smallest value so far, as a share of the available energy
/// ([`scale`]). The energy of an undriven fluid can only decrease. With a second-order integrator it fluctuates by
/// about 1 % as sound passes; with a time step that is too long it grows exponentially.
pub(crate) const GROWTH_LIMIT: f64 = 0.05;

/// Largest allowed mean compression, as a share of the rest density. The equations of state are meant for 1 % (Monaghan
/// 1994); at ten times that the fluid no longer behaves like water, and its equation of state is not valid.
pub(crate) const DENSITY_LIMIT: f64 = 0.1;

/// Returns the largest speed of sound of a scene, m/s; `None` with the pressure correction, where sound does not limit
/// the time step.
pub(crate) fn fastest_sound(scene: &Scene) -> Option<f64> {
    let iterated = scene.corrects_pressure();
    (!iterated).then(|| scene.fluids.iter().map(|fluid| speed_of_sound(scene, fluid)).fold(0.0, f64::max))
}

/// Returns the energy stored in a fluid at a relative density deviation e: the integral of `P / rho^2` over the
/// density, J/kg.
fn stored(scene: &Scene, fluid: &Fluid, constants: &FluidConstants, deviation: f64) -> f64 {
    // with the pressure correction, pressure is not a function of density
    if scene.corrects_pressure() {
        return 0.0;
    }
    let e = deviation;
    let by_state = constants.state_stiffness / f64::from(fluid.rest_density);
    // without negative pressure the pressure is 0 below the rest density
    let relaxed = e <= 0.0 && !scene.model.negative_pressure;
    let whole = match constants.equation_of_state {
        EquationOfState::Tait if !relaxed => by_state * (((1.0 + e).powi(6) - 1.0) / 6.0 + 1.0 / (1.0 + e) - 1.0),
        EquationOfState::Linear if !relaxed => by_state * (e.ln_1p() + 1.0 / (1.0 + e) - 1.0),
        EquationOfState::IdealGas => by_state * e.ln_1p(),
        _ => 0.0,
    };
    // Mueller's form gives half of the pressure gradient (Pirovano, eq. 2.19), so it does half of the work
    let half = matches!(scene.model.pressure_force, PressureForce::Mueller | PressureForce::MuellerAdapted);
    if half { whole * 0.5 } else { whole }
}

/// Returns the mechanical energy of the fluid, J (per metre of depth in 2D): kinetic, gravitational, elastic, and
/// stored in compression. The energies of surface tension and of near pressure are not included.
pub(crate) fn total(scene: &Checked<'_>, solver: &Solver<'_>) -> f64 {
    let energies = solver.energies();
    let compressed = sum(scene, solver, |fluid, constants, particle| {
        stored(scene, fluid, constants, f64::from(particle.density) / f64::from(fluid.rest_density) - 1.0)
    });
    energies.kinetic + energies.potential + energies.elastic + compressed
}

/// Returns the energy available to a scene at its start, J: kinetic energy, the potential energy of a fall by the
/// fluid's own height, and a bound on the energy of near pressure, which [`total`] does not include. If all of these
/// are 0, returns the energy of the largest allowed compression, [`DENSITY_LIMIT`].
pub(crate) fn scale(scene: &Checked<'_>, solver: &Solver<'_>) -> f64 {
    let gravity = scene.gravity.to_array().map(f64::from);
    let heights = || {
        let fluid = solver.particles().filter(|particle| !particle.is_wall && !particle.is_inactive);
        fluid.map(|p| -> f64 { p.position.to_array().iter().zip(gravity).map(|(x, g)| -g * f64::from(*x)).sum() })
    };
    let (low, high) = (heights().fold(f64::INFINITY, f64::min), heights().fold(f64::NEG_INFINITY, f64::max));
    let spent = solver.energies().kinetic
        + sum(scene, solver, |_, constants, _| (high - low).max(0.0) + constants.near_stiffness);
    // c^2 e^2 / 2, J/kg
    let compressed =
        |_: &Fluid, constants: &FluidConstants, _: &Particle| 0.5 * (DENSITY_LIMIT * constants.speed_of_sound).powi(2);
    if spent > 0.0 { spent } else { sum(scene, solver, compressed) }
}

/// Returns the sum of mass times `energy` (J/kg) over the particles of the fluid.
fn sum(scene: &Checked<'_>, solver: &Solver<'_>, energy: impl Fn(&Fluid, &FluidConstants, &Particle) -> f64) -> f64 {
    let fluid: Vec<Particle> =
        solver.particles().filter(|particle| !particle.is_wall && !particle.is_inactive).collect();
    let volume = scene.derived().particle_mass / f64::from(scene.fluids[0].rest_density);
    let (slots, state) = (solver.slots(), solver.state());
    let of = |i: usize| {
        let own = scene.fluid_of(fluid[i].fluid);
        let share = f64::from(state.position[slots[fluid[i].id as usize] as usize][3]);
        volume * f64::from(own.rest_density) * share * energy(own, scene.derived().fluid(fluid[i].fluid), &fluid[i])
    };
    tree_sum(fluid.len(), &of)
}

/// Returns what does work on the fluid from outside, so that its energy may grow; `None` if nothing does.
pub(crate) fn driven_by(scene: &Scene) -> Option<&'static str> {
    let along = |axis: usize| scene.gravity[axis] != 0.0 && scene.periodic.is_some_and(|periodic| periodic.axes[axis]);
    if (0..3).any(along) {
        return Some("gravity along a periodic axis");
    }
    if scene.air.is_some() {
        return Some("spawned air");
    }
    if !scene.emitters.is_empty() || !scene.drains.is_empty() {
        return Some("particles that come and go");
    }
    if scene.wind.is_some() {
        return Some("the wind");
    }
    let faces = scene.container.iter().flat_map(|container| &container.sliding);
    let moving = scene.walls.iter().map(|wall| wall.velocity).chain(faces.map(|face| face.velocity));
    moving.into_iter().any(|velocity| velocity != Vec3::ZERO).then_some("a sliding wall")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scenes::{Changes, load};
    use millpond_core::scene::PressureSolver;

    fn scene(name: &str) -> Scene {
        load(name, &Changes::default()).expect("it is built in").file.scene
    }

    #[test]
    fn what_is_stored_is_the_work_of_the_pressure() {
        let mut scene = scene("still-tank");
        for equation in [EquationOfState::Tait, EquationOfState::Linear, EquationOfState::IdealGas] {
            scene.model.equation_of_state = equation;
            // the hydrostatic start is not defined for an ideal gas
            scene.model.initialize_hydrostatic = false;
            let checked = scene.check().expect("a scene");
            let constants = checked.derived().fluid(0);
            let pressure = |e: f64| {
                let by_state = constants.state_stiffness / f64::from(scene.fluids[0].rest_density);
                match equation {
                    EquationOfState::Tait => by_state * ((1.0 + e).powi(7) - 1.0),
                    EquationOfState::Linear => by_state * e,
                    EquationOfState::IdealGas => by_state * (1.0 + e),
                }
            };
            // d u / d e = P / (rho0 (1 + e)^2)
            let (e, step) = (0.05, 1e-5);
            let at = |e: f64| stored(&scene, &scene.fluids[0], constants, e);
            let slope = (at(e + step) - at(e - step)) / (2.0 * step);
            let exact = pressure(e) / (1.0 + e).powi(2);
            assert!((slope / exact - 1.0).abs() < 1e-6, "{equation:?}: {slope} against {exact}");
        }
        scene.model.pressure_solver = PressureSolver::PressureCorrection;
        scene.model.pressure_force = PressureForce::Monaghan;
        let checked = scene.check().expect("a scene");
        assert_eq!(
            stored(&scene, &scene.fluids[0], checked.derived().fluid(0), 0.05),
            0.0,
            "pressure that is iterated"
        );
    }

    #[test]
    fn sound_follows_from_the_stiffness_that_there_is() {
        let mut scene = scene("still-tank");
        assert!((fastest_sound(&scene).expect("it has sound") - 22.0).abs() < 1e-3);
        // c^2 = 7 k / rho0
        scene.fluids[0].stiffness = Some(7e5);
        assert!((fastest_sound(&scene).expect("it has sound") - 70.0).abs() < 1e-3);
        scene.model.pressure_solver = PressureSolver::PressureCorrection;
        assert_eq!(fastest_sound(&scene), None);
    }

    #[test]
    fn what_is_driven_is_known() {
        assert!(driven_by(&scene("channel")).is_some());
        assert_eq!(driven_by(&scene("dam-break")), None);
    }
}
