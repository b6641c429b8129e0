//! Finds the points of emitters at which a particle is to be made, and advances the emitters. Runs only with emitters.
//!
//! A particle is not made where another one is too close, or where air is requested in the same step. Points of one
//! layer are far enough from each other, and so are emitters (`validate/emission.rs`). There are few points, so the
//! pass does not use SIMD.
use crate::arithmetic::real::vec3;
use crate::executor::{Jobs, parts, shares, take};
use crate::layout::f32x4;
use crate::passes::context::{Setup, Step};
use crate::passes::pairs::cells;
use crate::passes::places::Places;
use crate::terms::air::is_taken;
use crate::terms::emission::{emitted_position, layer_leaves, time_lost_since_layer, time_since_layer};

/// What a row of `emission` says instead of how long a particle lives.
pub(crate) const NOT_MADE: f32 = 0.0;
pub(crate) const BLOCKED: f32 = -1.0;

/// The emitters, and what a particle of theirs must not come too close to.
#[derive(Clone, Copy)]
struct Openings<'a> {
    places: Places<'a>,
    /// Whether a particle requests air.
    requested: &'a [u32],
    points: &'a [f32x4],
    emitters: &'a [f32x4],
    state: &'a [f32x4],
}

/// Returns the time since the last layer of an emitter at the end of the step, s, and whether a layer leaves.
fn layer(setup: &Setup<'_>, state: f32x4, interval: f32) -> (f32, bool) {
    let [since, lost, rest, _] = state;
    let since = time_since_layer::<f32>(setup.uniform, since, lost);
    (since, layer_leaves::<f32>(setup.uniform, since, interval, rest) > 0.0)
}

impl Openings<'_> {
    /// Returns the two rows of a point.
    fn rows(&self, setup: &Setup<'_>, point: usize) -> [f32x4; 2] {
        let [place, velocity] = [self.points[2 * point], self.points[2 * point + 1]];
        let emitter = place[3] as usize;
        let [interval, life, ..] = self.emitters[emitter];
        let (since, leaves) = layer(setup, self.state[emitter], interval);
        let (x, v) = (vec3::splat(place), vec3::splat(velocity));
        let at = emitted_position::<f32>(setup.model, setup.parameters, x, v, since - interval);
        let life = match (leaves, leaves && self.is_free(setup, at)) {
            (false, _) => NOT_MADE,
            (true, false) => BLOCKED,
            (true, true) => life,
        };
        [[at.x, at.y, at.z, life], velocity]
    }

    fn is_free(&self, setup: &Setup<'_>, place: vec3<f32>) -> bool {
        let Some(around) = self.places.around(setup, place) else { return false };
        let air_comes = |b: usize| {
            self.requested[b] == 1 && is_taken(setup.model, setup.parameters, place, self.places.beside(setup, b)) > 0.0
        };
        self.places.is_free(setup, place, &around)
            && !(setup.model.has_air == 1 && around.runs().flatten().any(air_comes))
    }
}

/// Fills `emission` and the state of the emitters.
pub(crate) fn run(step: &mut Step<'_, '_>) {
    let (setup, given) = (step.setup, step.given);
    let sorted = cells!(step);
    let gradient = &*step.scratch.total_colour_gradient;
    let places = Places { sorted, position: &*step.new.position, gradient };
    let (points, emitters, state) = (&*given.emitter_points, &*given.emitters, &*step.old.emitter_state);
    let openings = Openings { places, requested: &*step.scratch.spawn_requested, points, emitters, state };
    let mut rest = &mut *step.scratch.emission;
    let mut jobs = Jobs::new();
    for points in shares(rest.len() / 2, parts(step.executor)) {
        let own = take(&mut rest, 2 * points.len());
        let _ = jobs.push((points.start, own));
    }
    step.executor.run(&mut jobs, |(first, own)| {
        for (i, own) in own.chunks_exact_mut(2).enumerate() {
            own.copy_from_slice(&openings.rows(&setup, *first + i));
        }
    });
    for ((new, &old), &[interval, ..]) in step.new.emitter_state.iter_mut().zip(state).zip(emitters) {
        *new = after(&setup, old, interval);
    }
}

/// Returns the state of an emitter at the end of the step.
fn after(setup: &Setup<'_>, old: f32x4, interval: f32) -> f32x4 {
    let [since, lost, rest, layers] = old;
    let (now, leaves) = layer(setup, old, interval);
    let lost = time_lost_since_layer::<f32>(setup.uniform, since, lost);
    let since = if leaves { now - interval } else { now };
    [since, lost, rest - setup.uniform.time_step, if leaves { layers + 1.0 } else { layers }]
}
