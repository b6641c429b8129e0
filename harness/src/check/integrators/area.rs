//! Is a scheme symplectic: does it keep areas of phase space?
//!
//! A small parallelogram of neighbouring motions is carried along, and its area compared with that after the first step, when
//! what is remembered has become the scheme's own. A linear spring is a special case: what Beeman's velocity has beside Verlet's
//! is then a constant factor of the area. With a spring that stiffens it is none.
use super::oscillator::{Motion, Oscillator};
use super::scheme::Scheme;
use millpond_core::backend::arithmetic::double::Double;

/// s, and 1/s: omega dt = 0.5.
const TIME_STEP: f32 = 0.125;
const OMEGA: f64 = 4.0;
/// Steps, about three periods.
const STEPS: u32 = 40;

/// m, m/s.
const START: [f64; 2] = [0.5, 0.3];
/// Half of a side of the parallelogram, m and m/s: differences across the middle are exact to its square.
const SIDE: f64 = 1e-5;

/// Largest change of an area over some periods, as a share of it, without damping. `hardening` as in [`Oscillator`], 1/m2.
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
    // a motion that has left all numbers has changed its areas beyond all bounds
    let change = |area: f64| if area.is_finite() { (area / first - 1.0).abs() } else { f64::INFINITY };
    (0..STEPS).map(|_| change(area())).fold(0.0, f64::max)
}
