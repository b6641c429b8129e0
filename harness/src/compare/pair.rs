//! The result of comparing one path with another, and its report.
use super::difference::{Difference, PerQuantity, larger};
use crate::failure::Failure;
use crate::timing::Milliseconds;
use millpond_core::scene::Scene;
use serde::Serialize;

/// Largest allowed deviation of a path that does not promise equal bits: of positions as a share of the spacing, of
/// velocities as a share of the speed of sound. A difference of one ULP grows because the flow is chaotic; at this size
/// it begins to be visible in a picture.
const TOLERANCE: f64 = 0.01;

/// One path compared with another.
#[derive(Clone, Debug, Serialize)]
pub struct Pair {
    /// Name of the reference path.
    pub a: String,
    /// Name of the other path.
    pub b: String,
    /// Whether all bits were equal after every step.
    pub bit_equal: bool,
    /// The first step after which a bit differed.
    pub first_divergent_step: Option<u64>,
    /// Largest difference over all steps, ULP.
    pub max_ulp: PerQuantity<u32>,
    /// Largest difference over all steps, m and m/s.
    pub max_abs: PerQuantity<f64>,
    /// Whether the differences stayed within the tolerance.
    pub within_tolerance: bool,
    /// The first difference, as text.
    pub first_difference: Option<String>,
    /// Arrays of the state that differed in a bit after any step.
    pub differing_arrays: Vec<&'static str>,
    /// Whether this path promises equal bits.
    pub promised: bool,
    /// Why the path stopped early, if it did.
    pub failure: Option<String>,
    /// Time of a step of `b`, including reading back from a GPU.
    pub ms_per_step: Milliseconds,
}

/// Result of `compare`.
#[derive(Clone, Debug, Serialize)]
pub struct Comparison {
    /// Name of the scene.
    pub scene: String,
    /// Number of steps compared.
    pub steps: u64,
    /// Number of particles.
    pub particles: usize,
    /// State hash after the last step.
    pub hash: String,
    /// Time of a step of the reference path.
    pub ms_per_step: Milliseconds,
    /// All pairs.
    pub pairs: Vec<Pair>,
}

impl Comparison {
    /// Returns whether every path kept its promise: equal bits, or else differences within the tolerance.
    #[must_use]
    pub fn kept(&self) -> bool {
        self.pairs.iter().all(|p| p.bit_equal || (!p.promised && p.within_tolerance))
    }
}

impl Pair {
    /// Returns the pair of the scalar path and another path, before the first step.
    pub(super) fn new(b: String, promised: bool) -> Pair {
        Pair {
            a: "cpu scalar".into(),
            b,
            bit_equal: true,
            first_divergent_step: None,
            max_ulp: PerQuantity::default(),
            max_abs: PerQuantity::default(),
            within_tolerance: true,
            first_difference: None,
            differing_arrays: Vec::new(),
            promised,
            failure: None,
            ms_per_step: Milliseconds::default(),
        }
    }

    /// Records that the states differ after a step.
    pub(super) fn note(&mut self, step: u64, found: Difference, scene: &Scene) {
        self.bit_equal = false;
        self.first_divergent_step.get_or_insert(step);
        self.first_difference.get_or_insert(found.first);
        for name in found.arrays.iter().map(|array| array.name()) {
            if !self.differing_arrays.contains(&name) {
                self.differing_arrays.push(name);
            }
        }
        self.max_ulp.position = self.max_ulp.position.max(found.max_ulp.position);
        self.max_ulp.velocity = self.max_ulp.velocity.max(found.max_ulp.velocity);
        self.max_abs.position = larger(self.max_abs.position, found.max_abs.position);
        self.max_abs.velocity = larger(self.max_abs.velocity, found.max_abs.velocity);
        self.within_tolerance = self.max_abs.position <= TOLERANCE * f64::from(scene.particle_spacing)
            && self.max_abs.velocity <= TOLERANCE * f64::from(scene.fluids[0].speed_of_sound);
    }

    /// Records that the path stopped at a step.
    pub(super) fn stop(&mut self, step: u64, failure: &Failure) {
        self.bit_equal = false;
        self.within_tolerance = false;
        self.first_divergent_step.get_or_insert(step);
        self.failure = Some(failure.to_string());
    }
}

/// Formats the comparison as text.
#[must_use]
pub fn table(comparison: &Comparison) -> String {
    let Comparison { scene, steps, particles, hash, pairs, ms_per_step } = comparison;
    let mut out = format!("{scene}: {particles} particles, {steps} steps, hash {hash}\n\n");
    out += "| path | ms per step, minimum | median | compared with cpu scalar |\n| --- | --- | --- | --- |\n";
    out += &format!("| cpu scalar | {:.2} | {:.2} | |\n", ms_per_step.min, ms_per_step.median);
    for pair in pairs {
        let verdict = match (&pair.first_divergent_step, &pair.first_difference) {
            (Some(_), None) => pair.failure.clone().unwrap_or_default(),
            (None, _) => "bit-equal at every step".to_owned(),
            (Some(step), first) => {
                let (ulp, abs) = (pair.max_ulp, pair.max_abs);
                format!(
                    "differs from step {step} on, in {}: {}; at most {} ULP, {:.2e} m, {:.2e} m/s{}",
                    pair.differing_arrays.join(", "),
                    first.as_deref().unwrap_or_default(),
                    ulp.position.max(ulp.velocity),
                    abs.position,
                    abs.velocity,
                    pair.failure.as_ref().map_or(String::new(), |failure| format!("; stopped: {failure}"))
                )
            }
        };
        let ms = pair.ms_per_step;
        out += &format!("| {} | {:.2} | {:.2} | {verdict} |\n", pair.b, ms.min, ms.median);
    }
    out
}

#[cfg(test)]
mod tests {
    //! Promise: a path that does not promise equal bits may deviate by 1 % of the spacing and of the speed of sound,
    //! not by more, and not by a value that is not finite. A path that promises equal bits may not deviate at all.
    use super::*;
    use crate::compare::difference::difference;
    use crate::snapshot::Snapshot;
    use millpond_core::backend::layout::f32x4;
    use millpond_core::scene::{Block, Dimension, Fluid};

    const SPACING: f32 = 0.025;
    const SOUND: f32 = 30.0;

    fn scene() -> Scene {
        let fluid = Fluid { speed_of_sound: SOUND, ..Fluid::default() };
        Scene::of(Dimension::Three, SPACING, 0.001, fluid, Block::default())
    }

    /// Returns a state of two particles at rest at the origin, the second of which deviates along an axis in position
    /// and velocity.
    fn strayed(axis: usize, place: f32, velocity: f32) -> Snapshot {
        let of = |by: f32| {
            let mut vectors = [f32x4::default(); 2];
            vectors[1][axis] = by;
            vectors
        };
        Snapshot::of_particles(&of(place), &of(velocity))
    }

    /// Compares a path that has these states after its steps with a path that stays at rest.
    fn held(promised: bool, steps: &[Snapshot]) -> Comparison {
        let mut pair = Pair::new("another".into(), promised);
        for (step, got) in (1..).zip(steps) {
            if let Some(found) = difference(&strayed(0, 0.0, 0.0), got) {
                pair.note(step, found, &scene());
            }
        }
        Comparison {
            scene: "made up".into(),
            steps: steps.len() as u64,
            particles: 2,
            hash: String::new(),
            pairs: vec![pair],
            ms_per_step: Milliseconds::default(),
        }
    }

    #[test]
    fn a_path_without_a_promise_strays_by_one_percent_and_no_more() {
        let (place, velocity) = (0.01 * SPACING, 0.01 * SOUND);
        for axis in 0..3 {
            for sign in [1.0, -1.0] {
                let kept = |place: f32, velocity: f32| {
                    let comparison = held(false, &[strayed(axis, sign * place, sign * velocity)]);
                    assert!(!comparison.pairs[0].bit_equal);
                    comparison.kept()
                };
                let (under, over) = (0.9999, 1.0001);
                assert!(
                    kept(under * place, 0.0) && kept(0.0, under * velocity) && kept(under * place, under * velocity)
                );
                assert!(!kept(over * place, 0.0), "the place, by more than 1 % of the spacing");
                assert!(!kept(0.0, over * velocity), "the velocity, by more than 1 % of the speed of sound");
                assert!(!kept(over * place, under * velocity) && !kept(under * place, over * velocity));
            }
        }
    }

    #[test]
    fn and_what_it_strayed_once_it_has_strayed() {
        let (near, far) = (strayed(0, 0.0, 1e-6), strayed(0, 0.02 * SPACING, 0.0));
        let comparison = held(false, &[near.clone(), far, near.clone(), strayed(0, 0.0, 0.0)]);
        assert!(!comparison.kept(), "it came back");
        assert_eq!(comparison.pairs[0].first_divergent_step, Some(1));
        assert!(held(false, &[near.clone(), near]).kept());
    }

    #[test]
    fn and_what_is_no_number_has_strayed_whatever_follows() {
        let near = strayed(0, 1e-6, 1e-6);
        for none in [f32::NAN, f32::INFINITY] {
            for step in [strayed(1, none, 0.0), strayed(1, 0.0, none)] {
                assert!(!held(false, std::slice::from_ref(&step)).kept(), "{none}");
                assert!(!held(false, &[step, near.clone()]).kept(), "{none}");
            }
        }
    }

    #[test]
    fn what_differed_and_then_stopped_says_both() {
        let mut comparison = held(true, &[strayed(0, 1e-6, 0.0)]);
        comparison.pairs[0].stop(2, &Failure::Call("no device any more".into()));
        let words = table(&comparison);
        assert!(words.contains("differs from step 1 on, in position:"), "{words}");
        assert!(words.contains("stopped: no device any more"), "{words}");
    }

    #[test]
    fn a_path_that_promises_bits_may_not_stray_by_one() {
        let least = f32::from_bits(1);
        for step in [strayed(2, least, 0.0), strayed(2, 0.0, least), strayed(2, -0.0, 0.0)] {
            let comparison = held(true, std::slice::from_ref(&step));
            assert!(comparison.pairs[0].within_tolerance && !comparison.kept());
            assert!(held(false, &[step]).kept());
        }
    }
}
