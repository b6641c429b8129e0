//! Error types. An error says what is wrong, where (the field's path in the scene, or the particle), and what to
//! change. A call that returns an error leaves the state of the fluid unchanged.
mod field;
mod restore;
mod scene;
mod solid;
mod spawn;
mod step;

pub use field::Field;
pub use restore::RestoreError;
pub use scene::SceneError;
pub use solid::SolidError;
pub use spawn::SpawnError;
pub use step::StepError;
