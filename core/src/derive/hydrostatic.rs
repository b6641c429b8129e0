//! Density and pressure of a fluid at rest under its own weight.
use super::fluid::FluidConstants;
use crate::scene::{Block, PressureForce, Scene};

/// Returns the relative deviation of density from the rest density, and the pressure in Pa, that support the weight of
/// the fluid above (Roy, section 3.1, corrected): `rho = rho0 (1 + rho0 g depth / B)^(1/gamma)` with Tait's equation.
/// Fluids lie in layers, each from the highest to the lowest point of its blocks. `own` are the constants of the fluid
/// with index `fluid`.
pub(super) fn hydrostatic_deviation(scene: &Scene, fluid: u32, own: &FluidConstants, position: [f32; 3]) -> (f64, f32) {
    let g = scene.gravity.to_array().map(f64::from);
    // g . x increases downwards
    let along = |x: [f64; 3]| -> f64 { g.iter().zip(x).map(|(g, x)| g * x).sum() };
    let corner = |b: &Block, highest: bool| {
        let far = |i: usize| (g[i] < 0.0) == highest;
        along([0, 1, 2].map(|i| f64::from(if far(i) { b.corner[i] + b.size[i] } else { b.corner[i] })))
    };
    let place = along(position.map(f64::from));
    let mut pressure = 0.0;
    for (number, above) in (0..).zip(&scene.fluids) {
        let blocks = || scene.blocks.iter().filter(|block| block.fluid == number);
        let top = blocks().map(|b| corner(b, true)).fold(f64::INFINITY, f64::min);
        let bottom = blocks().map(|b| corner(b, false)).fold(f64::NEG_INFINITY, f64::max);
        // the particle's own fluid counts down to the particle, fluids above it down to their lowest point
        let depth = if number == fluid { place } else { place.min(bottom) } - top;
        // the buoyancy of the ambient medium carries part of the weight
        let weighed = f64::from(above.rest_density) - f64::from(scene.ambient_density);
        pressure += weighed * depth.max(0.0);
    }
    // with Mueller's pressure force, equilibrium needs twice the hydrostatic pressure
    if matches!(scene.model.pressure_force, PressureForce::Mueller | PressureForce::MuellerAdapted) {
        pressure *= 2.0;
    }
    (own.deviation_at(pressure), pressure as f32)
}
