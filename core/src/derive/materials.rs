//! The constants of each material: a row for each fluid, for each block of another viscosity, for each wall.
use super::fluid::FluidConstants;
use super::kernel_constants::{near_slope_constant, power};
use super::lattice_sums::gradient_squares;
use super::material::{FIRST_BLOCK, FIRST_WALL, INACTIVE, NOT_THERE};
use crate::layout::{MATERIALS, MaterialRows, Materials, f32x4};
use crate::scene::{DensityForm, Fluid, Iteration, NearPressure, Scene};

/// Share of a deviation of density that a step of corrected pressure is to mend (our choice).
pub(super) const CORRECTION_SOURCE: f32 = 0.1;

/// Written for the viscosity of a wall that takes the particle's.
const VISCOSITY_OF_PARTICLE: f32 = -1.0;

/// The constants of all materials; `mass` is that of a particle of the first fluid.
pub(super) fn materials(scene: &Scene, fluids: &[FluidConstants], mass: f64, support: f64) -> Materials {
    Materials {
        properties: properties(scene, fluids),
        states: states(scene, fluids, mass, support),
        corrections: corrections(scene, fluids, support),
    }
}

/// A row for each material, of its fluid; those that a scene has no use for are of its first.
fn rows(scene: &Scene, fluids: &[FluidConstants], of: impl Fn(&Fluid, &FluidConstants) -> f32x4) -> MaterialRows {
    let own = |number: u32| of(scene.fluid_of(number), fluids.get(number as usize).unwrap_or(&fluids[0]));
    let mut rows = [own(0); MATERIALS];
    let mut set = |material: u32, fluid: u32| rows[material as usize] = own(fluid);
    (0..fluids.len() as u32).for_each(|number| set(number, number));
    for (material, block) in (FIRST_BLOCK..).zip(&scene.blocks) {
        set(material, block.fluid);
    }
    for (material, wall) in (FIRST_WALL..).zip(&scene.walls) {
        set(material, wall.fluid);
    }
    rows
}

/// Viscosity (negative: that of the particle), 1 for a wall and 2 for air that is not there, rest density over the first fluid's, number of the fluid.
fn properties(scene: &Scene, fluids: &[FluidConstants]) -> MaterialRows {
    let ratio = |fluid: &Fluid| fluid.rest_density / scene.first_fluid().rest_density;
    let mut rows = rows(scene, fluids, |fluid, _| [fluid.dynamic_viscosity, 0.0, ratio(fluid), 0.0]);
    for (number, material) in rows.iter_mut().enumerate().take(FIRST_BLOCK as usize) {
        material[3] = number as f32;
    }
    for (material, block) in rows[FIRST_BLOCK as usize..].iter_mut().zip(&scene.blocks) {
        material[0] = block.dynamic_viscosity.unwrap_or(material[0]);
        material[3] = block.fluid as f32;
    }
    for (material, wall) in rows[FIRST_WALL as usize..].iter_mut().zip(&scene.walls) {
        *material = [wall.dynamic_viscosity.unwrap_or(VISCOSITY_OF_PARTICLE), 1.0, material[2], wall.fluid as f32];
    }
    // nobody acts on air that is not there
    rows[INACTIVE as usize][1] = NOT_THERE;
    rows
}

/// Constant of the equation of state, near pressure, speed of sound, number of the equation; `mass` is that of a particle of the
/// first fluid.
fn states(scene: &Scene, fluids: &[FluidConstants], mass: f64, support: f64) -> MaterialRows {
    let d = scene.dimension.count();
    let mass = mass / f64::from(scene.first_fluid().rest_density);
    let sum_to_density = near_slope_constant(d) / 3.0 / power(support, d);
    let masses = matches!(scene.model.density, DensityForm::Summation | DensityForm::Continuity);
    rows(scene, fluids, |fluid, constants| {
        // a sum over masses counts in those of the first fluid, one over numbers in its own
        let counted = if masses { scene.first_fluid().rest_density } else { fluid.rest_density };
        let near = constants.near_stiffness
            * match scene.model.near_pressure {
                NearPressure::DoubleDensity => mass * f64::from(counted) * sum_to_density,
                _ => f64::from(fluid.rest_density),
            };
        let number = constants.equation_of_state as u32 as f32;
        [constants.state_stiffness as f32, near as f32, constants.speed_of_sound as f32, number]
    })
}

/// What corrects pressure, and surface tension.
///
/// How much a pascal thins the density around it in a step, over the step's square, in 1/(Pa s2), and what is added to that, in
/// 1/Pa. A pressure at `a` accelerates its neighbours by `m P / rho^2 grad W`, which within a step thins the density at `a` by
/// `dt^2 V^2 / rho0 sum |grad W|^2` of itself for each pascal. By the letter the full stiffness is taken, `1 / (rho0 c0^2)` being
/// twice what is added.
fn corrections(scene: &Scene, fluids: &[FluidConstants], support: f64) -> MaterialRows {
    // sums over the lattice are only for who needs them; 1 is a number that nobody uses
    let corrects = scene.corrects_pressure();
    let relaxed = corrects && scene.model.correction.iteration == Iteration::Relaxed;
    let squares = if relaxed { gradient_squares(scene, support) } else { 0.0 };
    rows(scene, fluids, |fluid, constants| {
        let compressibility = 1.0 / constants.bulk_modulus;
        let [pressure_response, offset] = match scene.model.correction.iteration {
            _ if !corrects => [0.0, 1.0],
            Iteration::Literal => [0.0, 0.5 * compressibility],
            Iteration::Relaxed => {
                [squares / f64::from(fluid.rest_density), f64::from(CORRECTION_SOURCE) * compressibility]
            }
        };
        [pressure_response as f32, offset as f32, compressibility as f32, fluid.surface_tension]
    })
}
