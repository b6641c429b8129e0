//! Orders of accuracy as halved steps show them: of the error at a fixed time, and of that of a single step.
use super::oscillator::{Motion, Oscillator};
use super::scheme::Scheme;
use millpond_core::backend::arithmetic::double::Double;
use millpond_core::scene::Integrator;

/// 1/s.
const OMEGA: f64 = 1.3;

/// m and m/s: with a velocity, so that the start of a history is tested too.
const START: [f64; 2] = [0.5, 0.3];

/// Steps in a second of the coarse run; powers of two, as f32 has them exactly.
const STEPS: u32 = 1024;
/// s.
const SECONDS: u32 = 3;
/// Those of a single step, whose errors of fourth order would drown in rounding at the others.
const SINGLE: u32 = 64;

/// Powers of the time step in which an error falls.
#[derive(Clone, Copy, Debug)]
pub struct Order {
    /// That of the position.
    pub position: f64,
    /// That of the velocity.
    pub velocity: f64,
    /// That of both together.
    pub both: f64,
}

impl Order {
    fn of(coarse: [f64; 2], fine: [f64; 2]) -> Order {
        let [position, velocity] = [0, 1].map(|i| (coarse[i] / fine[i]).abs().log2());
        let length = |[x, v]: [f64; 2]| x.hypot(v / OMEGA);
        Order { position, velocity, both: (length(coarse) / length(fine)).log2() }
    }
}

/// Order of the error after three seconds, from the start that a solver has.
#[must_use]
pub fn global(scheme: Scheme, damping: f64) -> Order {
    let oscillator = Oscillator::linear(OMEGA, damping);
    let error = |steps: u32| {
        let mut motion: Motion<Double> = Motion::start(scheme, oscillator, 1.0 / steps as f32, START);
        (0..SECONDS * steps).for_each(|_| motion.step());
        off(&motion, oscillator, f64::from(SECONDS))
    };
    Order::of(error(STEPS), error(2 * STEPS))
}

/// Order of the error of one step that begins with all it remembers exact, without damping. One more than the global order
/// where errors add up.
#[must_use]
pub fn local(scheme: Scheme) -> Order {
    let oscillator = Oscillator::linear(OMEGA, 0.0);
    let error = |steps: u32| {
        let dt = 1.0 / f64::from(steps);
        let [before, _] = oscillator.exact(START, -dt);
        let motion: Motion<Double> = Motion::start(scheme, oscillator, dt as f32, START);
        let verlet = scheme.integrator == Integrator::Verlet;
        // the others than Verlet's remember the acceleration before, or do not look
        let history = if verlet { START[0] - before } else { -OMEGA * OMEGA * before };
        let mut motion = motion.remembering(history);
        motion.step();
        off(&motion, oscillator, dt)
    };
    Order::of(error(SINGLE), error(2 * SINGLE))
}

/// How far a motion is from the exact one after `t` seconds, m and m/s.
fn off(motion: &Motion<Double>, oscillator: Oscillator, t: f64) -> [f64; 2] {
    let [x, v] = oscillator.exact(START, t);
    [motion.position() - x, motion.velocity() - v]
}
