//! What each kind of particle has of its own: a row for each fluid, for each block of another viscosity, for each wall.
use crate::guided::{CORRECTION_SOURCE, particle_mass, power, speed_of_sound, support_radius};
use crate::kernel::near_slope_constant;
use crate::lattice_sums::gradient_squares;
use crate::layout::{Kinds, SPECIES, f32x4};
use crate::scene::{
    DORMANT, DensityForm, EquationOfState, FIRST_BLOCK, FIRST_WALL, Fluid, Iteration, NearPressure, Scene,
};

/// Near stiffness over c0^2 where a scene does not name it. Our choice: see the errata of S0 section 3.1.
const DEFAULT_NEAR_SHARE: f64 = 0.1;

/// Written for the viscosity of a wall that takes the particle's.
const VISCOSITY_OF_PARTICLE: f32 = -1.0;

/// Half of the stiffness of a fluid's springs over the mass of its particles at rest, `k / (2 m)`, 1/s2.
#[must_use]
pub fn spring_pull(scene: &Scene, fluid: &Fluid) -> f64 {
    let mass = particle_mass(scene) * f64::from(fluid.rest_density) / f64::from(scene.fluid.rest_density);
    f64::from(fluid.elastic_stiffness) / (2.0 * mass)
}

/// Near pressure over density, m2/s2; 0 where near pressure is off.
#[must_use]
pub fn near_stiffness(scene: &Scene, fluid: &Fluid) -> f64 {
    if scene.model.near_pressure == NearPressure::Off {
        return 0.0;
    }
    let c0 = speed_of_sound(scene, fluid);
    fluid.near_stiffness.map_or(DEFAULT_NEAR_SHARE * c0 * c0, f64::from)
}

/// What air that is not there has where a particle of a wall has a 1: whatever is more than 0 is held, and this can be told
/// from a wall.
pub(crate) const NOT_THERE: f32 = 2.0;

/// `rho0 c0^2`, Pa.
fn bulk(scene: &Scene, fluid: &Fluid) -> f64 {
    let c0 = speed_of_sound(scene, fluid);
    f64::from(fluid.rest_density) * c0 * c0
}

/// How a fluid's pressure follows from its density.
fn equation(scene: &Scene, fluid: &Fluid) -> EquationOfState {
    fluid.equation_of_state.unwrap_or(scene.model.equation_of_state)
}

/// Constant of a fluid's equation of state, Pa.
#[must_use]
pub fn state_stiffness(scene: &Scene, fluid: &Fluid) -> f64 {
    match equation(scene, fluid) {
        EquationOfState::Tait => fluid.stiffness.map_or(bulk(scene, fluid) / 7.0, f64::from),
        _ => bulk(scene, fluid),
    }
}

/// What makes an iteration of pressure: how much a pascal thins the density around it in a step, over the step's square, in
/// 1/(Pa s2), and what is added to that, in 1/Pa.
///
/// A pressure at `a` accelerates its neighbours by `m P / rho^2 grad W`, which within a step thins the density at `a` by
/// `dt^2 V^2 / rho0 sum |grad W|^2` of itself for each pascal. By the letter the full stiffness is taken, `1 / (rho0 c0^2)` being
/// twice what is added.
fn thinning(scene: &Scene, fluid: &Fluid) -> [f64; 2] {
    let compressibility = 1.0 / bulk(scene, fluid);
    match scene.model.correction.iteration {
        Iteration::Literal => [0.0, 0.5 * compressibility],
        Iteration::Relaxed => {
            let source = f64::from(CORRECTION_SOURCE) * compressibility;
            [gradient_squares(scene) / f64::from(fluid.rest_density), source]
        }
    }
}

/// A row for each kind, of its fluid; those that a scene has no use for are of its first.
fn rows(scene: &Scene, of: impl Fn(&Fluid) -> f32x4) -> Kinds {
    let mut kinds = [of(&scene.fluid); SPECIES];
    let mut set = |kind: u32, fluid: &Fluid| kinds[kind as usize] = of(fluid);
    for (kind, fluid) in (0..).zip(scene.fluids()) {
        set(kind, fluid);
    }
    for (kind, block) in (FIRST_BLOCK..).zip(&scene.blocks) {
        set(kind, scene.fluid_of(block.fluid));
    }
    for (kind, wall) in (FIRST_WALL..).zip(&scene.walls) {
        set(kind, scene.fluid_of(wall.fluid));
    }
    kinds
}

/// Viscosity (negative: that of the particle), 1 for a wall and 2 for air that is not there, rest density over the first fluid's, number of the fluid.
pub(crate) fn species(scene: &Scene) -> Kinds {
    let ratio = |fluid: &Fluid| fluid.rest_density / scene.fluid.rest_density;
    let mut kinds = rows(scene, |fluid| [fluid.dynamic_viscosity, 0.0, ratio(fluid), 0.0]);
    for (number, kind) in kinds.iter_mut().enumerate().take(FIRST_BLOCK as usize) {
        kind[3] = number as f32;
    }
    for (kind, block) in kinds[FIRST_BLOCK as usize..].iter_mut().zip(&scene.blocks) {
        kind[0] = block.dynamic_viscosity.unwrap_or(kind[0]);
        kind[3] = block.fluid as f32;
    }
    for (kind, wall) in kinds[FIRST_WALL as usize..].iter_mut().zip(&scene.walls) {
        *kind = [wall.dynamic_viscosity.unwrap_or(VISCOSITY_OF_PARTICLE), 1.0, kind[2], wall.fluid as f32];
    }
    // nobody acts on air that is not there
    kinds[DORMANT as usize][1] = NOT_THERE;
    kinds
}

/// Constant of the equation of state, near pressure, speed of sound, number of the equation.
pub(crate) fn states(scene: &Scene) -> Kinds {
    let d = scene.dimension.count();
    let mass = particle_mass(scene) / f64::from(scene.fluid.rest_density);
    let sum_to_density = near_slope_constant(d) / 3.0 / power(support_radius(scene), d);
    let masses = matches!(scene.model.density, DensityForm::Summation | DensityForm::Continuity);
    rows(scene, |fluid| {
        // a sum over masses counts in those of the first fluid, one over numbers in its own
        let counted = if masses { scene.fluid.rest_density } else { fluid.rest_density };
        let near = near_stiffness(scene, fluid)
            * match scene.model.near_pressure {
                NearPressure::Article => mass * f64::from(counted) * sum_to_density,
                _ => f64::from(fluid.rest_density),
            };
        let number = equation(scene, fluid) as u32 as f32;
        [state_stiffness(scene, fluid) as f32, near as f32, speed_of_sound(scene, fluid) as f32, number]
    })
}

/// What corrects pressure, and surface tension.
pub(crate) fn corrections(scene: &Scene) -> Kinds {
    // sums over the lattice are only for who needs them; 1 is a number that nobody uses
    let corrects = scene.model.equation_of_state == EquationOfState::PressureCorrection;
    rows(scene, |fluid| {
        let [thinning, offset] = if corrects { thinning(scene, fluid) } else { [0.0, 1.0] };
        let compressibility = (1.0 / bulk(scene, fluid)) as f32;
        [thinning as f32, offset as f32, compressibility, fluid.surface_tension]
    })
}
