//! Every way in which millpond can refuse: what, which, where, how much. Whatever refuses leaves the state as it was.
mod restore;
mod scene;
mod step;

pub use restore::RestoreError;
pub use scene::SceneError;
pub use step::StepError;
