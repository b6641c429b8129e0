//! Asserts how a scene is rejected.
use super::judged::judged;
use millpond_core::SceneError;
use millpond_core::scene::Scene;

/// Asserts that a scene with this change is rejected, as a combination, with this message.
pub(crate) fn refused(sentence: &str, change: impl FnOnce(&mut Scene)) {
    let told = judged(change).expect_err(sentence);
    assert!(matches!(told, SceneError::NotTogether { .. }), "{told:?}");
    assert_eq!(told.to_string(), sentence);
}
