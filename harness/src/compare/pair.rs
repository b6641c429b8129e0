//! What comes of holding one path against another, and how it is told.
use super::difference::{Difference, PerQuantity};
use crate::failure::Failure;
use crate::timing::Milliseconds;
use millpond_core::scene::Scene;
use serde::Serialize;

/// How far a path that promises no bits may stray, as a share of the spacing and of the speed of sound. A difference of
/// one ULP grows with the fluid's chaos; this is where a picture begins to show it.
const TOLERANCE: f64 = 0.01;

/// One path held against another.
#[derive(Clone, Debug, Serialize)]
pub struct Pair {
    /// The path all others are held against.
    pub a: String,
    /// The other.
    pub b: String,
    /// Not a bit differed at any step.
    pub bit_equal: bool,
    /// The first step at which one did.
    pub first_divergent_step: Option<u64>,
    /// Largest distance in units in the last place, over all steps.
    pub max_ulp: PerQuantity<u32>,
    /// Largest distance, m and m/s.
    pub max_abs: PerQuantity<f64>,
    /// Close enough to look the same.
    pub within_tolerance: bool,
    /// The first value that differed, in words.
    pub first_difference: Option<String>,
    /// Does this path promise bits?
    pub promised: bool,
    /// Why it stopped early, if it did.
    pub failure: Option<String>,
    /// Time of a step of `b`, reading a device back included.
    pub ms_per_step: Milliseconds,
}

/// Result of `compare`.
#[derive(Clone, Debug, Serialize)]
pub struct Comparison {
    /// The scene.
    pub scene: String,
    /// Steps compared.
    pub steps: u64,
    /// Particles of the scene.
    pub particles: usize,
    /// State hash after the last step.
    pub hash: String,
    /// Time of a step of the path all others are held against.
    pub ms_per_step: Milliseconds,
    /// All pairs.
    pub pairs: Vec<Pair>,
}

impl Comparison {
    /// Did every path keep its promise?
    #[must_use]
    pub fn kept(&self) -> bool {
        self.pairs.iter().all(|p| p.bit_equal || (!p.promised && p.within_tolerance))
    }
}

impl Pair {
    /// A path of this name, about to start.
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
            promised,
            failure: None,
            ms_per_step: Milliseconds::default(),
        }
    }

    /// Writes down that a step differed.
    pub(super) fn note(&mut self, step: u64, found: Difference, scene: &Scene) {
        self.bit_equal = false;
        self.first_divergent_step.get_or_insert(step);
        self.first_difference.get_or_insert(found.first);
        self.max_ulp.position = self.max_ulp.position.max(found.max_ulp.position);
        self.max_ulp.velocity = self.max_ulp.velocity.max(found.max_ulp.velocity);
        // NaN must win
        let larger = |a: f64, b: f64| if b <= a { a } else { b };
        self.max_abs.position = larger(self.max_abs.position, found.max_abs.position);
        self.max_abs.velocity = larger(self.max_abs.velocity, found.max_abs.velocity);
        self.within_tolerance = self.max_abs.position <= TOLERANCE * f64::from(scene.particle_spacing)
            && self.max_abs.velocity <= TOLERANCE * f64::from(scene.fluid.speed_of_sound);
    }

    /// Writes down that the path stopped at a step.
    pub(super) fn stop(&mut self, step: u64, failure: &Failure) {
        self.bit_equal = false;
        self.within_tolerance = false;
        self.first_divergent_step.get_or_insert(step);
        self.failure = Some(failure.to_string());
    }
}

/// The comparison in words.
#[must_use]
pub fn table(comparison: &Comparison) -> String {
    let Comparison { scene, steps, particles, hash, pairs, ms_per_step } = comparison;
    let mut out = format!("{scene}: {particles} particles, {steps} steps, hash {hash}\n\n");
    out += "| path | ms a step, least | median | against cpu scalar |\n| --- | --- | --- | --- |\n";
    out += &format!("| cpu scalar | {:.2} | {:.2} | |\n", ms_per_step.min, ms_per_step.median);
    for pair in pairs {
        let verdict = match (&pair.first_divergent_step, &pair.first_difference) {
            (Some(_), None) => pair.failure.clone().unwrap_or_default(),
            (None, _) => "bit-equal at every step".to_owned(),
            (Some(step), first) => {
                let (ulp, abs) = (pair.max_ulp, pair.max_abs);
                format!(
                    "differs from step {step} on: {}; at most {} ULP, {:.2e} m, {:.2e} m/s",
                    first.as_deref().unwrap_or_default(),
                    ulp.position.max(ulp.velocity),
                    abs.position,
                    abs.velocity
                )
            }
        };
        let ms = pair.ms_per_step;
        out += &format!("| {} | {:.2} | {:.2} | {verdict} |\n", pair.b, ms.min, ms.median);
    }
    out
}
