//! Orders of accuracy, measured by halving the time step: of the error at a fixed time, and of the error of a single
//! step.
use super::oscillator::{Motion, Oscillator};
use super::scheme::Scheme;
use millpond_core::backend::arithmetic::double::Double;
use millpond_core::scene::Integrator;

/// Frequency omega, 1/s.
const OMEGA: f64 = 1.3;

/// Position, m, and velocity, m/s, at the start. The velocity is nonzero, so that the initial history is tested too.
const START: [f64; 2] = [0.5, 0.3];

/// Steps per second of the coarser run; a power of two, which makes the time step exact in f32.
const STEPS: u32 = 1024;
/// Simulated time, s.
const SECONDS: u32 = 3;
/// Steps per second for the error of a single step. It is smaller, since an error of fourth order would be lost in
/// rounding otherwise.
const SINGLE: u32 = 64;

/// Orders: the powers of the time step with which an error falls.
#[derive(Clone, Copy, Debug)]
pub struct Order {
    /// Order of the position.
    pub position: f64,
    /// Order of the velocity.
    pub velocity: f64,
    /// Order of both together.
    pub both: f64,
}

impl Order {
    fn of(coarse: [f64; 2], fine: [f64; 2]) -> Order {
        let [position, velocity] = [0, 1].map(|i| (coarse[i] / fine[i]).abs().log2());
        let length = |[x, v]: [f64; 2]| x.hypot(v / OMEGA);
        Order { position, velocity, both: (length(coarse) / length(fine)).log2() }
    }
}

/// Returns the order of the error after three seconds, started as in a solver.
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

/// Returns the order of the error of one step that starts from an exact history, without damping. It is one more than
/// the global order where errors accumulate.
#[must_use]
pub fn local(scheme: Scheme) -> Order {
    let oscillator = Oscillator::linear(OMEGA, 0.0);
    let error = |steps: u32| {
        let dt = 1.0 / f64::from(steps);
        let [before, _] = oscillator.exact(START, -dt);
        let motion: Motion<Double> = Motion::start(scheme, oscillator, dt as f32, START);
        let verlet = scheme.integrator == Integrator::Verlet;
        // Beeman's three integrators remember the acceleration of the step before; the remaining ones ignore the
        // history
        let history = if verlet { START[0] - before } else { -OMEGA * OMEGA * before };
        let mut motion = motion.remembering(history);
        motion.step();
        off(&motion, oscillator, dt)
    };
    Order::of(error(SINGLE), error(2 * SINGLE))
}

/// Returns the difference of a motion from the exact one after `t` seconds, m and m/s.
fn off(motion: &Motion<Double>, oscillator: Oscillator, t: f64) -> [f64; 2] {
    let [x, v] = oscillator.exact(START, t);
    [motion.position() - x, motion.velocity() - v]
}
