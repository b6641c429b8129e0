//! The stability limit as measured in runs: bisection of omega dt between runs whose amplitude grows and runs whose
//! amplitude does not.
use super::oscillator::{Motion, Oscillator, Precision};
use super::scheme::Scheme;

/// Time step, s. Only omega dt matters; a power of two makes dt^2 and 1 / dt exact as well.
const TIME_STEP: f32 = 0.125;

/// Position at the start, m, and velocity over omega, m. Both are nonzero, so that every mode of every scheme is
/// excited.
const START: [f64; 2] = [0.5, 0.3];

/// Steps of the first stretch of a run, and number of further stretches, each as long as all before it together.
const FIRST_STRETCH: u32 = 512;
const DOUBLINGS: u32 = 8;

/// Growth of the amplitude from one stretch to the next that counts as exponential. At the limit itself roots coincide
/// and the amplitude may grow in proportion to time, by a factor of 2. Anything that grows faster grows exponentially.
const GROWS: f64 = 4.0;

/// Share of the amplitude at the start below which a motion has decayed.
const DEAD: f64 = 1e-6;

/// Spacing and number of the values of omega dt that are tried in ascending order.
const RUNG: f64 = 0.1;
const RUNGS: u32 = 40;

/// Number of bisections between two of them: to 1e-4.
const HALVINGS: u32 = 10;

/// Returns whether the amplitude of an oscillator grows exponentially at this omega dt.
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
            // a motion that is no longer finite stays so
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

/// Returns the largest omega dt up to which no run grows, from 0 on.
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
