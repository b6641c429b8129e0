//! Measures whether a scheme is symplectic, that is, preserves areas in phase space.
//!
//! Four motions that start close together span a small parallelogram in phase space. Its area is compared with its area
//! after the first step, when the remembered acceleration or displacement comes from the scheme itself. A linear spring
//! is a special case: there, what distinguishes Beeman's velocity from Verlet's is a constant factor of the area. With
//! a hardening spring this factor is not constant.
use super::oscillator::{Motion, Oscillator};
use super::scheme::Scheme;
use millpond_core::backend::arithmetic::double::Double;

/// Time step, s, and frequency, 1/s: omega dt = 0.5.
const TIME_STEP: f32 = 0.125;
const OMEGA: f64 = 4.0;
/// Number of steps, about three periods.
const STEPS: u32 = 40;

/// Position, m, and velocity, m/s, at the start.
const START: [f64; 2] = [0.5, 0.3];
/// Half of a side of the parallelogram, m and m/s. Central differences have an error of the order of its square.
const SIDE: f64 = 1e-5;

/// Returns the largest relative change of an area over some periods, without damping. `hardening` is that of
/// [`Oscillator`], 1/m2.
#[must_use]
pub fn change(scheme: Scheme, hardening: f64) -> f64 {
    let oscillator = Oscillator { omega: OMEGA, damping: 0.0, hardening };
    let start = |dx: f64, dv: f64| -> Motion<Double> {
        Motion::start(scheme, oscillator, TIME_STEP, [START[0] + dx, START[1] + dv])
    };
    let mut corners = [start(SIDE, 0.0), start(-SIDE, 0.0), start(0.0, SIDE), start(0.0, -SIDE)];
    let mut area = || {
        corners.iter_mut().for_each(Motion::step);
        let [a, b, c, d] = &corners;
        let across =
            |a: &Motion<Double>, b: &Motion<Double>| [a.position() - b.position(), a.velocity() - b.velocity()];
        let ([ax, av], [bx, bv]) = (across(a, b), across(c, d));
        ax * bv - bx * av
    };
    let first = area();
    // a motion that is no longer finite counts as an infinite change
    let change = |area: f64| if area.is_finite() { (area / first - 1.0).abs() } else { f64::INFINITY };
    (0..STEPS).map(|_| change(area())).fold(0.0, f64::max)
}
