//! Formulas that tests start from. They do not follow the recipes, which may get better.
use millpond_core::scene::{DensityForm, Formulation, Kernel, NearPressure, PressureForce, Recipe, Viscosity};

/// Returns Pirovano's formulas with one Wendland kernel, the symmetric pressure gradient, the viscosity of Morris et al.
/// 1997 and no near pressure.
pub fn wendland() -> Formulation {
    let kernel = Kernel::WendlandC2;
    Formulation {
        density_kernel: kernel,
        pressure_kernel: kernel,
        viscosity_kernel: kernel,
        pressure_force: PressureForce::Monaghan,
        near_pressure: NearPressure::Off,
        viscosity: Viscosity::Morris,
        ..Formulation::of(Recipe::Pirovano)
    }
}

/// Returns the same for several fluids.
pub fn several_fluids() -> Formulation {
    Formulation { density: DensityForm::SummationAdapted, pressure_force: PressureForce::DensityWeighted, ..wendland() }
}
