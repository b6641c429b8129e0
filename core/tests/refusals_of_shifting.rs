//! Promise: shifting, tensile control and renormalised diffusion are rejected with the choices that they cannot be
//! combined with, in a message that names both.
use millpond_core::glam::Vec3;
use millpond_core::scene::{
    DensityDiffusion, DensityForm, Face, PressureForce, PressureSolver, Scene, Shifting, Traversal, Wall, WallShape,
};

#[path = "support/combination.rs"]
mod combination;
#[path = "support/judged.rs"]
mod judged;
use combination::refused;
use judged::judged as scene;

#[test]
fn shifting_by_name() {
    assert_eq!(scene(|s| s.model.shifting = Shifting::Fickian), Ok(()));
    assert_eq!(scene(|s| s.model.shifting = Shifting::TransportVelocity), Ok(()));
    refused(
        "model.shifting_speed conflicts with a model.shifting other than Fickian: it is unused; omit it, or use \
         model.shifting Fickian",
        |s| s.model.shifting_speed = Some(1.0),
    );
    refused(
        "model.shift_across_interfaces conflicts with a model.shifting other than Fickian: it is unused; turn it off, \
         or use model.shifting Fickian",
        |s| s.model.shift_across_interfaces = true,
    );
    refused(
        "grid.traversal HalfStencil conflicts with model.shifting: it computes each pair once, and this needs another \
         pass over all neighbours of a particle; use FullStencil",
        |s| (s.grid.traversal, s.model.shifting) = (Traversal::HalfStencil, Shifting::Fickian),
    );
}

#[test]
fn tensile_control_by_name() {
    assert_eq!(scene(|s| s.model.tensile_control = true), Ok(()));
    refused(
        "model.tensile_control conflicts with model.negative_pressure false: without negative pressure there is no \
         tension; turn one of them off",
        |s| (s.model.tensile_control, s.model.negative_pressure) = (true, false),
    );
    refused(
        "model.tensile_control conflicts with model.pressure_solver PressureCorrection: its iteration counts on forces \
         that are equal and opposite; turn tensile_control off, or use pressure_solver EquationOfState",
        |s| {
            (s.model.tensile_control, s.model.pressure_solver) = (true, PressureSolver::PressureCorrection);
            s.model.pressure_force = PressureForce::Monaghan;
        },
    );
    for force in [PressureForce::Canonical, PressureForce::Difference] {
        refused(
            "model.tensile_control conflicts with model.pressure_force Canonical or Difference: it changes the sign of \
             a pressure in a sum of two, which these forms do not have; use another pressure_force",
            |s| (s.model.tensile_control, s.model.pressure_force) = (true, force),
        );
    }
    refused(
        "grid.traversal HalfStencil conflicts with model.tensile_control: it computes each pair once, and this needs \
         another pass over all neighbours of a particle; use FullStencil",
        |s| (s.grid.traversal, s.model.tensile_control) = (Traversal::HalfStencil, true),
    );
}

#[test]
fn renormalised_diffusion_by_name() {
    let diffused = |s: &mut Scene| {
        (s.model.density, s.model.density_diffusion) = (DensityForm::Continuity, DensityDiffusion::Renormalised);
    };
    assert_eq!(scene(diffused), Ok(()));
    refused(
        "model.density_diffusion Renormalised conflicts with model.wall_pressure Mirrored: mirrored walls have no \
         density from which a gradient could follow; use wall_pressure Extrapolated or Dynamic, or density_diffusion \
         Hydrostatic",
        |s| {
            diffused(s);
            let shape = WallShape::Plane { face: Face::Floor, low: Vec3::ZERO, high: Vec3::new(1.0, 0.0, 1.0) };
            s.walls = [Wall::still(shape)].into_iter().collect();
        },
    );
}
