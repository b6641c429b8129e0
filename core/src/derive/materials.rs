//! The constants of each material: a row for each fluid, for each block with its own viscosity, for each wall and
//! each solid.
use super::fluid::FluidConstants;
use super::kernel_constants::{near_slope_constant, power};
use super::lattice_sums::gradient_squares;
use super::material::{FIRST_BLOCK, FIRST_SOLID, FIRST_WALL, INACTIVE, INACTIVE_ROLE};
use crate::layout::{MATERIALS, MaterialRows, Materials, f32x4};
use crate::scene::{DensityForm, Fluid, Iteration, NearPressure, Scene};

/// Share of the density deviation that one step of the pressure correction is to remove (our choice).
pub(super) const CORRECTION_SOURCE: f32 = 0.1;

/// Stored as the viscosity of a wall that takes the viscosity of the particle.
pub(super) const VISCOSITY_OF_PARTICLE: f32 = -1.0;

/// The constants of all materials; `mass` is the mass of a particle of the first fluid at rest, kg.
pub(super) fn materials(scene: &Scene, fluids: &[FluidConstants], mass: f64, support: f64) -> Materials {
    Materials {
        properties: properties(scene, fluids),
        states: states(scene, fluids, mass, support),
        corrections: corrections(scene, fluids, support),
    }
}

/// One row per material, computed from the material's fluid. Unused rows are those of the first fluid.
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
    for (material, solid) in (FIRST_SOLID..).zip(&scene.solids) {
        set(material, solid.fluid);
    }
    rows
}

/// Viscosity (negative for that of the particle); 0 for fluids, 1 for walls, 2 for inactive particles; rest density
/// over that of the first fluid; index of the fluid.
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
    let held = |material: &mut f32x4, viscosity: Option<f32>, fluid: u32| {
        *material = [viscosity.unwrap_or(VISCOSITY_OF_PARTICLE), 1.0, material[2], fluid as f32];
    };
    for (material, wall) in rows[FIRST_WALL as usize..].iter_mut().zip(&scene.walls) {
        held(material, wall.dynamic_viscosity, wall.fluid);
    }
    for (material, solid) in rows[FIRST_SOLID as usize..].iter_mut().zip(&scene.solids) {
        held(material, solid.dynamic_viscosity, solid.fluid);
    }
    // inactive particles are held, so nothing acts on them
    rows[INACTIVE as usize][1] = INACTIVE_ROLE;
    rows
}

/// Constant of the equation of state, near pressure, speed of sound, number of the equation of state; `mass` is the
/// mass of a particle of the first fluid at rest, kg.
fn states(scene: &Scene, fluids: &[FluidConstants], mass: f64, support: f64) -> MaterialRows {
    let d = scene.dimension.count();
    let mass = mass / f64::from(scene.first_fluid().rest_density);
    let sum_to_density = near_slope_constant(d) / 3.0 / power(support, d);
    let masses = matches!(scene.model.density, DensityForm::Summation | DensityForm::Continuity);
    rows(scene, fluids, |fluid, constants| {
        // a sum over masses is in units of the first fluid's mass, a number density in units of the particle's own mass
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

/// Constants of the pressure correction, and surface tension.
///
/// The first two are the relative decrease of density around a particle per pascal and step, divided by the square of
/// the time step, in 1/(Pa s2), and a term added to it, in 1/Pa. A pressure at `a` accelerates its neighbours by
/// `m P / rho^2 grad W`, which within a step decreases the density at `a` by the relative amount
/// `dt^2 V^2 / rho0 sum |grad W|^2` per pascal. The literal iteration uses the full stiffness `rho0 c0^2`, since the
/// term added is half of `1 / (rho0 c0^2)` and the formula doubles it.
fn corrections(scene: &Scene, fluids: &[FluidConstants], support: f64) -> MaterialRows {
    // lattice sums are computed only if needed; without pressure correction the offset of 1 is never used
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
