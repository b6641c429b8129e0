//! Tables of the measured results.
use super::swings::{STIFFNESSES, omega_dt};
use super::{DAMPED, DAMPINGS, HARDENING, Measured};
use crate::outcome::table;

/// Returns the tables of limits, orders, areas and runs, each with an explanation.
pub(super) fn all(all: &[Measured]) -> Vec<String> {
    vec![
        "Each cell: theory / runs in f64 / runs in f32. Without damping, Euler grows at any step, and the \
         position-corrected Beeman integrator at all steps but those between 0.738 and sqrt(3 / 2); for these two, \
         the growth per step is compared with theory."
            .into(),
        limits(all),
        format!(
            "Orders of the error after 3 s without damping and at zeta = {DAMPED}, and of one step without damping; \
             each for position / velocity. Areas: largest relative change in 40 steps at omega dt = 0.5, with a \
             linear spring and with a hardening one (s = {HARDENING} per m2). Beeman and its velocity-corrected form \
             give Verlet's positions. Their velocities differ from Verlet's by a multiple of a difference of \
             accelerations. On a linear spring that is a constant factor of each area. On another spring it is not: \
             areas then oscillate, but the energy does not drift."
        ),
        orders(all),
        "Undamped, 30 s of Pirovano's oscillators: amplitude of the position / of the velocity in the last 5 s, over \
         the first, and error of the frequency. K = 100000 N/m is exactly at omega dt = 2."
            .into(),
        undamped(all),
        "Critically damped, 30 s: largest error of the position over the first position; for a motion that has not \
         decayed, its amplitude at the end."
            .into(),
        damped(all),
    ]
}

fn limits(all: &[Measured]) -> String {
    let titles = DAMPINGS.map(|damping| format!("zeta = {damping}"));
    let [a, b, c, d] = titles.each_ref().map(String::as_str);
    let cell =
        |limits: [f64; 3]| if limits[0] > 0.0 { limits.map(|x| format!("{x:.4}")).join(" / ") } else { "0".into() };
    let row = |one: &Measured| {
        let [a, b, c, d] = one.limits.map(cell);
        [one.scheme.name(), a, b, c, d]
    };
    table(["largest stable omega dt", a, b, c, d], all.iter().map(row))
}

fn orders(all: &[Measured]) -> String {
    let row = |one: &Measured| {
        let [undamped, damped, local] =
            one.orders.map(|order| format!("{:.2} / {:.2}", order.position, order.velocity));
        let [linear, stiffening] = one.areas.map(|change| format!("{change:.1e}"));
        [one.scheme.name(), undamped, damped, local, linear, stiffening]
    };
    let titles = ["orders", "undamped", "damped", "one step", "area, linear", "area, stiffening"];
    table(titles, all.iter().map(row))
}

fn undamped(all: &[Measured]) -> String {
    by_stiffness("undamped", all, |one, i| {
        let Some(swing) = one.undamped.get(i) else { return String::new() };
        let p = STIFFNESSES.get(i).copied().map_or(f64::NAN, omega_dt);
        let phase = swing.growth_and_angle().map(|[_, angle]| format!(", {:+.2} %", (angle / p - 1.0) * 100.0));
        let [x, v] = [swing.amplitude(), swing.velocity_amplitude()].map(number);
        format!("{x} / {v}{}", phase.unwrap_or_default())
    })
}

fn damped(all: &[Measured]) -> String {
    by_stiffness("critically damped", all, |one, i| {
        let Some(swing) = one.damped.get(i) else { return String::new() };
        let amplitude = swing.amplitude();
        if amplitude < 1e-3 { number(swing.error()) } else { format!("ends at {}", number(amplitude)) }
    })
}

/// Returns a table with a row for each scheme and a column for each stiffness.
fn by_stiffness(title: &str, all: &[Measured], cell: impl Fn(&Measured, usize) -> String) -> String {
    let titles = STIFFNESSES.map(|k| format!("K = {k}, p = {:.4}", omega_dt(k)));
    let [a, b, c, d, e] = titles.each_ref().map(String::as_str);
    let row = |one: &Measured| {
        let [a, b, c, d, e] = [0, 1, 2, 3, 4].map(|i| cell(one, i));
        [one.scheme.name(), a, b, c, d, e]
    };
    table([title, a, b, c, d, e], all.iter().map(row))
}

/// Formats a number with three digits, in decimal or exponential notation.
pub(super) fn number(value: f64) -> String {
    if !value.is_finite() {
        return "not finite".into();
    }
    if value == 0.0 || (1e-3..1e3).contains(&value.abs()) { format!("{value:.3}") } else { format!("{value:.1e}") }
}
