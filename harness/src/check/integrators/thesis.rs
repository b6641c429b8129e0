//! Tables 2.1 to 2.4 of Pirovano beside the measured ones, and the reasons for the differences.
use super::swings::{LAST, START, STEPS, STIFFNESSES, Swing, omega_dt};
use super::tables::number;
use super::{Measured, Scheme};
use crate::check::flow::larger;
use crate::outcome::table;
use millpond_core::scene::Integrator::{self, *};

/// Table 2.1, from worst to best.
const UNDAMPED_POSITION: &[&[Integrator]] = &[
    &[Euler],
    &[PositionCorrectedBeeman, Leapfrog],
    &[Verlet, SemiImplicitEuler],
    &[VelocityVerlet, Beeman, VelocityCorrectedBeeman],
];

/// Table 2.2, whose caption says "damped" by mistake.
const UNDAMPED_VELOCITY: &[&[Integrator]] = &[
    &[Euler],
    &[PositionCorrectedBeeman, Leapfrog],
    &[SemiImplicitEuler],
    &[VelocityVerlet],
    &[Verlet, Beeman, VelocityCorrectedBeeman],
];

/// Table 2.3.
const DAMPED: &[&[Integrator]] = &[
    &[Beeman, PositionCorrectedBeeman, VelocityCorrectedBeeman],
    &[Leapfrog, Verlet, VelocityVerlet],
    &[SemiImplicitEuler],
    &[ModifiedVelocityVerlet],
    &[Euler],
];

/// Table 2.4.
const ACCURACY: [(&str, &[Integrator]); 4] = [
    ("1st", &[Euler, SemiImplicitEuler]),
    ("4th position, 2nd velocity", &[Verlet, VelocityVerlet]),
    ("4th position, 3rd velocity", &[Leapfrog, Beeman]),
    ("4th position, 4th velocity", &[ModifiedVelocityVerlet]),
];

/// Limits with a smaller relative difference share a rank.
const SAME: f64 = 0.01;

/// Returns the four tables, each with an explanation.
pub(super) fn all(all: &[Measured]) -> Vec<String> {
    vec![
        stability(all),
        undamped_words(all),
        damped_table(all),
        damped_words(all),
        accuracy(all),
        ACCURACY_WORDS.into(),
    ]
}

/// Ranks the integrators with one evaluation, from the lowest measured limit to the highest. Equal limits share a rank.
/// Integrators without a limit are ranked by their growth at the second stiffness.
fn ranks(all: &[Measured], damping: usize) -> Vec<(f64, Vec<Integrator>)> {
    let mut sorted: Vec<&Measured> = all.iter().filter(|one| !one.scheme.twice).collect();
    let limit = |one: &Measured| one.limits.get(damping).map_or(f64::NAN, |limits| limits[1]);
    let growth = |one: &Measured| one.undamped.get(1).map_or(f64::NAN, Swing::amplitude);
    // faster growth is worse; it counts only without a limit
    let grown = |one: &Measured| if limit(one) > 0.0 { 0.0 } else { -growth(one) };
    sorted.sort_by(|a, b| limit(a).total_cmp(&limit(b)).then(grown(a).total_cmp(&grown(b))));
    let mut ranks: Vec<(f64, Vec<Integrator>)> = Vec::new();
    for one in sorted {
        let limit = limit(one);
        match ranks.last_mut() {
            Some((last, same)) if limit > 0.0 && limit <= *last * (1.0 + SAME) => same.push(one.scheme.integrator),
            _ => ranks.push((limit, vec![one.scheme.integrator])),
        }
    }
    ranks
}

fn names(integrators: &[Integrator]) -> String {
    let names: Vec<&str> = integrators.iter().map(|integrator| integrator.name()).collect();
    names.join(", ")
}

fn of_thesis(table: &[&[Integrator]], row: usize) -> String {
    table.get(row).map_or(String::new(), |integrators| names(integrators))
}

fn ours(ranks: &[(f64, Vec<Integrator>)], row: usize) -> String {
    ranks.get(row).map_or(String::new(), |(limit, integrators)| format!("{limit:.3}: {}", names(integrators)))
}

fn stability(all: &[Measured]) -> String {
    let ranks = ranks(all, 0);
    let titles = ["Pirovano, table 2.1, worst first", "Pirovano, table 2.2", "measured limit of omega dt, undamped"];
    let row = |i| [of_thesis(UNDAMPED_POSITION, i), of_thesis(UNDAMPED_VELOCITY, i), ours(&ranks, i)];
    table(titles, (0..ranks.len().max(UNDAMPED_VELOCITY.len())).map(row))
}

fn damped_table(all: &[Measured]) -> String {
    let ranks = ranks(all, 3);
    let titles = ["Pirovano, table 2.3, worst first", "measured limit of omega dt, critically damped"];
    table(titles, (0..ranks.len().max(DAMPED.len())).map(|i| [of_thesis(DAMPED, i), ours(&ranks, i)]))
}

/// Returns a run with one of the stiffnesses of Pirovano, undamped or critically damped.
fn swing(all: &[Measured], integrator: Integrator, damped: bool, stiffness: usize) -> Option<&Swing> {
    let one = all.iter().find(|one| one.scheme == Scheme::once(integrator))?;
    let swings = if damped { &one.damped } else { &one.undamped };
    swings.get(stiffness)
}

fn undamped_words(all: &[Measured]) -> String {
    let amplitude = |integrator, k| number(swing(all, integrator, false, k).map_or(f64::NAN, Swing::amplitude));
    let last = STIFFNESSES.len() - 1;
    let p = STIFFNESSES.map(omega_dt);
    // started with x_{-1} = x_0 - v_0 dt and with a_{-1} = a_0
    let verlet = Swing::remembering(Scheme::once(Verlet), p[last], |_| 0.0);
    let beeman = Swing::remembering(Scheme::once(Beeman), p[last], |o| -o.omega * o.omega * START);
    format!(
        "Table 2.1 differs from the measurements in three places. (1) It ranks Verlet and semi-implicit Euler below \
         velocity Verlet and the Beeman integrators. All of them solve x_{{n+1}} - 2 x_n + x_{{n-1}} = a_n dt^2 and \
         share the limit 2, and K = 100000 N/m is exactly at this limit. Both roots are -1 there, so an inexact start \
         grows in proportion to time. After 30 s the amplitude of semi-implicit Euler is {}, that of Verlet {} when \
         started from x_{{-1}} = x_0 - v_0 dt and {} with millpond's start of second order, that of velocity Verlet \
         {}, that of Beeman {} when started from a_{{-1}} = a_0 and {} with millpond's a_{{-1}}, found by a step \
         backwards. The start decides, not the integrator. (2) It ranks leapfrog beside the position-corrected Beeman \
         integrator. The leapfrog of Pirovano, eq. 2.34, corrected, gives the positions of velocity Verlet (amplitude \
         {} at K = 10000 N/m). What Pirovano saw fits the two-step midpoint rule, which is also called leapfrog and \
         is stable up to omega dt = 1: {} at K = 10000 N/m, {} at 100000. (3) Clavet is missing in Pirovano, who \
         takes it for leapfrog. Its limit is 2 / sqrt 3, and it loses amplitude below it (to {} at K = 10000 N/m). \
         Two results are reproduced: Euler is worst, and the position-corrected Beeman integrator grows, though \
         slowly, to {} in 30 s at K = 10000 N/m.\n\n\
         Table 2.2 differs for the same reasons: position and velocity are two components of one linear map and have \
         one limit. It ranks Verlet above velocity Verlet, and both apart from semi-implicit Euler, because of how \
         each was started on the double root. From rest, at K = 100000 N/m, the measured velocity amplitudes over \
         omega x_0 are {} for Verlet, {} for velocity Verlet, {} for Beeman, {} for semi-implicit Euler.",
        amplitude(SemiImplicitEuler, last),
        number(verlet.amplitude()),
        amplitude(Verlet, last),
        amplitude(VelocityVerlet, last),
        number(beeman.amplitude()),
        amplitude(Beeman, last),
        amplitude(Leapfrog, 1),
        number(midpoint(p[1])),
        number(midpoint(p[last])),
        amplitude(Clavet, 1),
        amplitude(PositionCorrectedBeeman, 1),
        velocity(all, Verlet),
        velocity(all, VelocityVerlet),
        velocity(all, Beeman),
        velocity(all, SemiImplicitEuler),
    )
}

/// Returns the amplitude after 30 s of the two-step midpoint rule, started with a step of Euler:
/// `x_{n+1} = x_{n-1} + 2 v_n dt` and `v_{n+1} = v_{n-1} + 2 a_n dt`.
fn midpoint(p: f64) -> f64 {
    let (mut before, mut now) = ([1.0, 0.0], [1.0, -p * p]);
    let mut largest = 0.0;
    for step in 1..STEPS {
        (before, now) = (now, [before[0] + 2.0 * now[1], before[1] - 2.0 * p * p * now[0]]);
        if step >= STEPS - LAST {
            largest = larger(largest, now[0].abs());
        }
    }
    largest
}

/// Returns the amplitude of the velocity at the largest stiffness, undamped.
fn velocity(all: &[Measured], integrator: Integrator) -> String {
    swing(all, integrator, false, STIFFNESSES.len() - 1)
        .map_or(String::new(), |swing| number(swing.velocity_amplitude()))
}

fn damped_words(all: &[Measured]) -> String {
    let error = |integrator, k| number(swing(all, integrator, true, k).map_or(f64::NAN, Swing::error));
    let grown = |integrator, k| number(swing(all, integrator, true, k).map_or(f64::NAN, Swing::amplitude));
    let twice = all.iter().find(|one| one.scheme == Scheme { integrator: ModifiedVelocityVerlet, twice: true });
    let twice = twice.map_or(f64::NAN, |one| one.limits[3][1]);
    format!(
        "Table 2.3 is reproduced except in two places. (1) It ranks semi-implicit Euler below the modified velocity \
         Verlet. Their limits are equal, 2 (sqrt 2 - 1), since in half-step velocities they are the same scheme. At K \
         = 15000 N/m both are stable, with errors of {} and {}; at 20000 N/m both grow, to {} and {}. Semi-implicit \
         Euler starts from a larger error and leaves the frame of the figure earlier. With forces evaluated twice, \
         the modified velocity Verlet is stable up to {:.3}. (2) It gives the Beeman integrators one rank, since all \
         of them fail at 10000 N/m; their limits differ by a factor of two. Clavet is missing in Pirovano. The five \
         stiffnesses lie between the limits, which is why Pirovano finds this order. That Euler is best holds for \
         critical damping only: its limit is 2 zeta for zeta < 1.",
        error(SemiImplicitEuler, 2),
        error(ModifiedVelocityVerlet, 2),
        grown(SemiImplicitEuler, 3),
        grown(ModifiedVelocityVerlet, 3),
        twice,
    )
}

fn accuracy(all: &[Measured]) -> String {
    let once = all.iter().filter(|one| !one.scheme.twice);
    let row = |one: &Measured| {
        let own = ACCURACY.iter().find(|(_, integrators)| integrators.contains(&one.scheme.integrator));
        let thesis = own.map_or("-", |(order, _)| order);
        let [undamped, damped, local] = one.orders.map(|order| [order.position, order.velocity].map(f64::round));
        let pair = |[x, v]: [f64; 2]| format!("{x} position, {v} velocity");
        [one.scheme.name(), thesis.into(), pair(local), pair(undamped), pair(damped)]
    };
    table(["", "Pirovano, table 2.4", "one step", "undamped", "damped"], once.map(row))
}

const ACCURACY_WORDS: &str = "Table 2.4 mixes orders of one step with orders of a whole run. Its orders 4 and 2 of \
    Verlet, and 4 and 3 of Beeman, are those of one step that starts from an exact history; its order 1 of both \
    Euler integrators is that of a run. In a run without damping every Verlet, leapfrog or Beeman integrator is of \
    order 2, and the position-corrected Beeman integrator of order 3. In one step velocity Verlet, leapfrog and the \
    modified velocity Verlet have a position of order 3, not 4: Verlet has order 4 because of its history. The \
    velocities of leapfrog and of the modified velocity Verlet are of order 3 too, not of order 4 in the latter: \
    without damping all three are the same map. With damping the force takes an older velocity, or in the modified \
    velocity Verlet that of half a step, and all but the two corrected Beeman integrators are of order 1. Pirovano \
    does not rank these two and Clavet; section 2.3.1 promises them order 4 in position and velocity, which holds \
    for one step of the position-corrected form, and for the position of the velocity-corrected form.";
