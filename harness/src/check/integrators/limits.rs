//! The limit of stability as runs find it: bisection of omega dt between those that do not grow and those that do.
use super::oscillator::{Motion, Oscillator, Precision};
use super::scheme::Scheme;

/// s. Only omega dt matters; a power of two, so that dt^2 and 1 / dt are exact too.
const TIME_STEP: f32 = 0.125;

/// m, and over omega, so that no mode of any scheme is left out.
const START: [f64; 2] = [0.5, 0.3];

/// Steps of the first stretch of a run; each further one doubles them.
const FIRST_STRETCH: u32 = 512;
const DOUBLINGS: u32 = 8;

/// Growth of the amplitude from a stretch to the next. On the limit itself roots coincide and the amplitude may grow in
/// proportion to time, which is a factor of 2; all that grows faster grows exponentially.
const GROWS: f64 = 4.0;

/// Share of the start at which a motion has died away.
const DEAD: f64 = 1e-6;

/// Rungs at which stability is looked at from below, and the last of them.
const RUNG: f64 = 0.1;
const RUNGS: u32 = 40;

/// Halvings of a rung: to 1e-4.
const HALVINGS: u32 = 10;

/// Does an oscillator's amplitude grow exponentially at this omega dt?
#[must_use]
pub fn grows<R: Precision>(scheme: Scheme, damping: f64, omega_dt: f64) -> bool {
    let oscillator = Oscillator::linear(omega_dt / f64::from(TIME_STEP), damping);
    let start = [START[0], START[1] * oscillator.omega];
    let mut motion: Motion<R> = Motion::start(scheme, oscillator, TIME_STEP, start);
    let dead = DEAD * motion.amplitude();
    let mut stretch = |steps: u32| {
        (0..steps).fold(0.0, |largest: f64, _| {
            motion.step();
            let now = motion.amplitude();
            // a motion that left the numbers stays outside
            if now.is_nan() { f64::INFINITY } else { largest.max(now) }
        })
    };
    let mut before = stretch(FIRST_STRETCH);
    for doubling in 0..DOUBLINGS {
        let now = stretch(FIRST_STRETCH << doubling);
        if !now.is_finite() || now > GROWS * before {
            return true;
        }
        if now < dead {
            return false;
        }
        before = now;
    }
    false
}

/// Up to which omega dt, from 0 on, no run grows.
#[must_use]
pub fn measured<R: Precision>(scheme: Scheme, damping: f64) -> f64 {
    let mut rungs = (1..=RUNGS).map(|rung| RUNG * f64::from(rung));
    let Some(mut high) = rungs.find(|&p| grows::<R>(scheme, damping, p)) else { return f64::INFINITY };
    let mut low = high - RUNG;
    for _ in 0..HALVINGS {
        let middle = f64::midpoint(low, high);
        if grows::<R>(scheme, damping, middle) { high = middle } else { low = middle }
    }
    f64::midpoint(low, high)
}
