//! Promise: every refusal says in a whole sentence what is wrong, where and how much.
use millpond_core::{Axis, Quantity, RestoreError, SceneError, StepError};

#[test]
fn of_a_scene() {
    use SceneError::*;
    let (axis, field) = (Axis::Y, "model.xsph");
    let scenes = [
        (NotFinite { field, value: f32::NAN }, "model.xsph is NaN, which is not a finite number"),
        (NotFinite { field, value: f32::INFINITY }, "model.xsph is inf, which is not a finite number"),
        (NotPositive { field, value: 0.0 }, "model.xsph is 0, and must be larger than 0"),
        (Negative { field, value: -0.5 }, "model.xsph is -0.5, and must not be negative"),
        (NotAShare { field, value: 1.5 }, "model.xsph is 1.5, and must lie between 0 and 1"),
        (OutOfBounds { field, value: 3.0, least: 1.0, most: 2.0 }, "model.xsph is 3, and must lie between 1 and 2"),
        (EmptyContainer { axis, low: 1.0, high: 0.5 }, "container has no inside along y: low 1 m, high 0.5 m"),
        (OutOfPlane, "a scene in 2D has gravity, a place or a velocity along z"),
        (
            EmptyBlock { block: 3, axis, size: 0.1 },
            "blocks[3].size is 0.1 m along y: less than half a particle_spacing",
        ),
        (BlockOutside { block: 3, axis, by: 0.25 }, "blocks[3] reaches 0.25 m through a wall along y"),
        (EmptyDomain { axis, low: 1.0, high: 0.5 }, "periodic has no inside along y: low 1 m, high 0.5 m"),
        (LapsItself { what: "walls", index: 2, axis, by: 0.5 }, "walls[2] is 0.5 m longer than the period along y"),
        (
            WallAdvances { wall: 2, axis, velocity: -2.0 },
            "walls[2].velocity is -2 m/s along y, across it: a wall slides, and stays",
        ),
        (
            WallExtent { wall: 2, axis, size: 0.5 },
            "walls[2] is 0.5 m along y: give a plane 0 m across, and at least half a particle_spacing along all else",
        ),
        (TooFewPoints { axis, points: 1 }, "acceleration_field.counts has 1 along y, and must have at least 2"),
        (
            NoSuchFluid { field: "air.fluid", fluid: 2, fluids: 2 },
            "air.fluid names fluid 2, and the scene has 2, counted from 0",
        ),
        (NotTogether { choice: "one", other: "another", why: "they part" }, "one does not go with another: they part"),
        (
            LeftOut { field: "wind", live: "wind" },
            "wind cannot be changed, because the plan left its term out: list wind in the scene's live",
        ),
        (
            CannotConverge { spacings: 2.0, most: 1.5 },
            "time_step lets sound travel 2 spacings, and the literal pressure correction converges up to 1.5: use \
             model.correction.iteration Relaxed, or smaller steps",
        ),
        (OutOfScale { field, value: 3.0 }, "model.xsph is 3, which makes constants that no f32 can hold"),
        (PlanOfAnotherScene, "the plan was made for another scene"),
        (UnplannedParticle { particle: 7 }, "particle 7 has a kind or a mass that no particle of the scene has"),
        (
            ParticleNotFinite { particle: 7, quantity: Quantity::Velocity },
            "Velocity of particle 7 is not a finite number",
        ),
        (TooFewCells { axis, cells: 2 }, "grid.cells has 2 along y, and must have at least 3"),
        (
            TooManyCells { cells: [1, 2, 3], places: 4 },
            "grid.cells 1 x 2 x 3, with 4 places each, make more than 2^31 places",
        ),
        (TooManyParticles { particles: 10, most: 9 }, "the scene has 10 particles, and at most 9 are possible"),
        (
            WrongLength { call: "with_particles", what: "particles", given: 1, expected: 2 },
            "`with_particles` got 1 particles, expected 2",
        ),
        (
            TooFewParticles { particles: 3, air: 4 },
            "air.capacity is 4, and only 3 particles were given: the last ones are the air",
        ),
        (
            CapacityExceeded { what: "position", needed: 9, capacity: 8 },
            "the scene needs 9 of position, and the memory lent has 8",
        ),
        (
            FirstStep(StepError::OutOfRange { particle: 7, axis, step: 1 }),
            "the scene cannot start: step 1: particle 7 went beyond the grid's range along y",
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
            "step 9: particle 7 went beyond the grid's range along y",
        ),
        (
            StepError::CellFull { cell: 5, count: 4, capacity: 3, step: 9 },
            "step 9: cell 5 has 4 particles and 3 places",
        ),
        (
            StepError::NoTimeStep { attempts: 64, step: 9 },
            "step 9 was made 64 times, each shorter than the one before, and is still too long: increase \
             adaptive.reject_ratio or adaptive.smallest",
        ),
        (
            StepError::NotFinite { particle: 7, quantity: Quantity::Density, step: 9 },
            "step 9: Density of particle 7 is not finite any more",
        ),
    ];
    for (error, sentence) in steps {
        assert_eq!(error.to_string(), sentence);
    }
}

#[test]
fn of_bytes() {
    let restores = [
        (RestoreError::NotSaved, "these bytes are no saved fluid: their header is missing"),
        (
            RestoreError::WrongVersion { given: 9, known: 2 },
            "the fluid was saved in version 9 of the format, and this library reads version 2",
        ),
        (RestoreError::AnotherScene, "the fluid was saved from another scene: create the solver from that scene"),
        (
            RestoreError::WrongLength { given: 3, expected: 4 },
            "a saved fluid of this scene takes 4 bytes, and 3 were given",
        ),
        (RestoreError::Damaged, "the saved bytes are damaged: their checksum does not match"),
        (
            RestoreError::Scene(SceneError::Negative { field: "model.xsph", value: -0.5 }),
            "the values that were saved are not those of a scene: model.xsph is -0.5, and must not be negative",
        ),
    ];
    for (error, sentence) in restores {
        assert_eq!(error.to_string(), sentence);
    }
}
