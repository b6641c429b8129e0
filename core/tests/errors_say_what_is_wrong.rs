//! Promise: every error says in a whole sentence what is wrong, where, and by how much.
use millpond_core::{Axis, Quantity, RestoreError, SceneError, StepError};

#[test]
fn of_a_scene() {
    use SceneError::*;
    let (axis, field) = (Axis::Y, "model.xsph".into());
    let scenes = [
        (NotFinite { field, value: f32::NAN }, "model.xsph is NaN, but must be a finite number"),
        (NotFinite { field, value: f32::INFINITY }, "model.xsph is inf, but must be a finite number"),
        (NotPositive { field, value: 0.0 }, "model.xsph is 0, but must be larger than 0"),
        (Negative { field, value: -0.5 }, "model.xsph is -0.5, but must not be negative"),
        (NotAShare { field, value: 1.5 }, "model.xsph is 1.5, but must lie between 0 and 1"),
        (OutOfBounds { field, value: 3.0, least: 1.0, most: 2.0 }, "model.xsph is 3, but must lie between 1 and 2"),
        (EmptyContainer { axis, low: 1.0, high: 0.5 }, "container.low 1 m is not below container.high 0.5 m along y"),
        (OutOfPlane, "dimension is 2D: gravity, positions, velocities, normals need z = 0"),
        (
            EmptyBlock { block: 3, axis, size: 0.1 },
            "blocks[3].size is 0.1 m along y, but must be at least half a particle_spacing",
        ),
        (BlockOutside { block: 3, axis, by: 0.25 }, "blocks[3] reaches 0.25 m out of the container along y"),
        (EmptyDomain { axis, low: 1.0, high: 0.5 }, "periodic.low 1 m is not below periodic.high 0.5 m along y"),
        (LapsItself { what: "walls", index: 2, axis, by: 0.5 }, "walls[2] is 0.5 m longer than the period along y"),
        (
            WallAdvances { wall: 2, axis, velocity: -2.0 },
            "walls[2].velocity is -2 m/s along y, the wall's normal, but must be 0",
        ),
        (
            WallExtent { wall: 2, axis, size: 0.5 },
            "walls[2] extends 0.5 m along y; a plane must extend 0 m along its normal, and every other extent must be \
             half a particle_spacing to 2^28 particle_spacings",
        ),
        (TooFewPoints { axis, points: 1 }, "acceleration_field.counts is 1 along y, but must be at least 2"),
        (
            NoSuchFluid { field: "air.fluid".into(), fluid: 2, fluids: 2 },
            "air.fluid names fluid 2, but fluids has length 2, and fluids are counted from 0",
        ),
        (
            NotTogether { choice: "one".into(), other: "another".into(), why: "reason" },
            "one conflicts with another: reason",
        ),
        (
            LeftOut { field: "wind", item: "wind" },
            "wind cannot be changed, because the plan left out its term; list wind in adjustable",
        ),
        (
            CannotConverge { spacings: 2.0, most: 1.5 },
            "time_step lets sound travel 2 particle spacings, but model.correction.iteration Literal converges only \
             up to 1.5; use iteration Relaxed, or a smaller time step",
        ),
        (OutOfScale { field, value: 3.0 }, "model.xsph is 3, too large or too small for the constants derived from it"),
        (PlanOfAnotherScene, "the plan was made for another scene; make one for this scene"),
        (UnplannedParticle { particle: 7 }, "particle 7 has a material or a mass that the plan does not support"),
        (
            ParticleNotFinite { particle: 7, quantity: Quantity::Velocity },
            "Velocity of particle 7 is not a finite number",
        ),
        (TooFewCells { axis, cells: 2 }, "grid.cells has 2 along y, but needs at least 3 (lengthen a periodic axis)"),
        (
            TooManyCells { cells: [1, 2, 3], places: 4 },
            "grid.cells 1 x 2 x 3 with 4 places each exceed the limit of 2^31 - 1 places",
        ),
        (TooManyParticles { particles: 10, most: 9 }, "the scene has 10 particles, but at most 9 are possible"),
        (
            WrongLength { call: "with_particles", what: "particles", given: 1, expected: 2 },
            "`with_particles` got 1 particles, expected 2",
        ),
        (
            TooFewParticles { particles: 3, air: 4 },
            "air.capacity is 4, but only 3 particles were given; the last ones are the air",
        ),
        (
            CapacityExceeded { what: "position", needed: 9, capacity: 8 },
            "the scene needs 9 of position, but only 8 are available; provide more",
        ),
        (
            FirstStep(StepError::OutOfRange { particle: 7, axis, step: 1 }),
            "the scene cannot start: step 1: particle 7 is more than 2^22 cells away from the origin along y; the \
             fluid may have become unstable (use a smaller time_step) or fallen out of the scene",
        ),
    ];
    for (error, sentence) in scenes {
        assert_eq!(error.to_string(), sentence);
    }
}

#[test]
fn of_a_step() {
    let steps = [
        (
            StepError::OutOfRange { particle: 7, axis: Axis::Y, step: 9 },
            "step 9: particle 7 is more than 2^22 cells away from the origin along y; the fluid may have become \
             unstable (use a smaller time_step) or fallen out of the scene",
        ),
        (
            StepError::CellFull { cell: 5, count: 4, capacity: 3, step: 9 },
            "step 9: cell 5 holds 4 particles and has 3 places; increase places in grid.structure, or use a smaller \
             time_step",
        ),
        (
            StepError::NoTimeStep { attempts: 64, step: 9 },
            "step 9 was tried 64 times, each time shorter, and was always too long; increase adaptive.reject_ratio or \
             adaptive.smallest",
        ),
        (
            StepError::NotFinite { particle: 7, quantity: Quantity::Density, step: 9 },
            "step 9: Density of particle 7 is no longer finite; use a smaller time_step",
        ),
    ];
    for (error, sentence) in steps {
        assert_eq!(error.to_string(), sentence);
    }
}

#[test]
fn of_bytes() {
    let restores = [
        (RestoreError::NotSaved, "these bytes are not a saved fluid: their header is missing"),
        (
            RestoreError::WrongVersion { given: 9, known: 2 },
            "the fluid was saved in version 9 of the format, but this library reads version 2 only",
        ),
        (RestoreError::AnotherScene, "the fluid was saved from another scene; create the solver from that scene"),
        (
            RestoreError::WrongLength { given: 3, expected: 4 },
            "a saved fluid of this scene has 4 bytes, but 3 were given",
        ),
        (RestoreError::Damaged, "the saved bytes are damaged: their checksum does not match"),
        (
            RestoreError::Scene(SceneError::Negative { field: "model.xsph".into(), value: -0.5 }),
            "the saved values do not form a valid scene: model.xsph is -0.5, but must not be negative",
        ),
    ];
    for (error, sentence) in restores {
        assert_eq!(error.to_string(), sentence);
    }
}
