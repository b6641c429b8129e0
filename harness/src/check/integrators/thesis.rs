//! Tables 2.1 to 2.4 of Pirovano beside ours, and why they differ.
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

/// Table 2.2 (which calls itself damped).
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

/// Limits closer than this are one.
const SAME: f64 = 0.01;

/// The four tables, each with what explains it.
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

/// Those with one evaluation, from the lowest measured limit to the highest, equal ones together. Those without one by
/// their growth at the second stiffness.
fn ranks(all: &[Measured], damping: usize) -> Vec<(f64, Vec<Integrator>)> {
    let mut sorted: Vec<&Measured> = all.iter().filter(|one| !one.scheme.twice).collect();
    let limit = |one: &Measured| one.limits.get(damping).map_or(f64::NAN, |limits| limits[1]);
    let growth = |one: &Measured| one.undamped.get(1).map_or(f64::NAN, Swing::amplitude);
    // faster growth is worse; with a limit the amplitude does not count
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
    let titles =
        ["Pirovano table 2.1, worst first", "Pirovano table 2.2", "ours, by the measured limit of omega dt, undamped"];
    let row = |i| [of_thesis(UNDAMPED_POSITION, i), of_thesis(UNDAMPED_VELOCITY, i), ours(&ranks, i)];
    table(titles, (0..ranks.len().max(UNDAMPED_VELOCITY.len())).map(row))
}

fn damped_table(all: &[Measured]) -> String {
    let ranks = ranks(all, 3);
    let titles = ["Pirovano table 2.3, worst first", "ours, by the measured limit of omega dt, critically damped"];
    table(titles, (0..ranks.len().max(DAMPED.len())).map(|i| [of_thesis(DAMPED, i), ours(&ranks, i)]))
}

/// What a run of Pirovano's came to, undamped or critically damped.
fn swing(all: &[Measured], integrator: Integrator, damped: bool, stiffness: usize) -> Option<&Swing> {
    let one = all.iter().find(|one| one.scheme == Scheme::once(integrator))?;
    let swings = if damped { &one.damped } else { &one.undamped };
    swings.get(stiffness)
}

fn undamped_words(all: &[Measured]) -> String {
    let amplitude = |integrator, k| number(swing(all, integrator, false, k).map_or(f64::NAN, Swing::amplitude));
    let last = STIFFNESSES.len() - 1;
    let p = STIFFNESSES.map(omega_dt);
    // x_{-1} = x_0 - v_0 dt, and a_{-1} = a_0
    let verlet = Swing::remembering(Scheme::once(Verlet), p[last], |_| 0.0);
    let beeman = Swing::remembering(Scheme::once(Beeman), p[last], |o| -o.omega * o.omega * START);
    format!(
        "Table 2.1 differs in three places. (1) Verlet and semi-implicit Euler below velocity Verlet and the Beemans: all of \
         them make x_{{n+1}} - 2 x_n + x_{{n-1}} = a_n dt^2 and share the limit 2, and K = 100000 N/m lies on it. Both roots are -1 \
         there, and a start that is a little off grows in proportion to time. After 30 s semi-implicit Euler's amplitude is {}, \
         Verlet's {} from x_{{-1}} = x_0 - v_0 dt and {} from our start of second order, velocity Verlet's {}, Beeman's {} from \
         a_{{-1}} = a_0 and {} from our a_{{-1}}, a step back. That is the start, not the integrator. (2) Leapfrog beside the \
         position-corrected Beeman: the leapfrog of eq. 2.34, corrected makes velocity Verlet's positions (amplitude {} at K = \
         10000 N/m). What Pirovano saw fits the two-step midpoint rule, which has the same name and is stable to omega dt = 1: {} at K \
         = 10000 N/m, {} at 100000. (3) Clavet's is missing in Pirovano, which takes it for leapfrog: its limit is 2 / sqrt 3, and \
         it loses amplitude below it (to {} at K = 10000 N/m). Reproduced: Euler is worst, and the position-corrected Beeman grows, \
         though slowly, to {} in 30 s at K = 10000 N/m.\n\n\
         Table 2.2 differs for the same reasons: position and velocity are two components of one linear map and have one \
         limit. Verlet above velocity Verlet, and both apart from semi-implicit Euler, again is how each was started on the \
         double root; from rest, at K = 100000 N/m, our velocity amplitudes over omega x_0 are {} for Verlet, {} for velocity \
         Verlet, {} for Beeman, {} for semi-implicit Euler.",
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

/// Amplitude after 30 s of the two-step midpoint rule, `x_{n+1} = x_{n-1} + 2 v_n dt` and `v_{n+1} = v_{n-1} + 2 a_n dt`, begun with
/// a step of Euler's.
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

/// Amplitude of the velocity at the largest stiffness, undamped.
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
        "Table 2.3 is reproduced but for two places. (1) Semi-implicit Euler below the modified velocity Verlet: their limits \
         are the same, 2 (sqrt 2 - 1), since with half-step velocities one is the other. At K = 15000 N/m both hold, with errors of \
         {} and {}; at 20000 N/m both grow, to {} and {}: semi-implicit Euler starts from a larger error and leaves the frame \
         earlier. With forces evaluated twice the modified velocity Verlet holds to {:.3}. (2) The Beemans are one rank in Pirovano, as all of \
         them fail at 10000 N/m; their limits differ by a factor of two. Clavet's is missing in Pirovano. The five stiffnesses lie \
         between the limits, which is why Pirovano finds this order. That Euler leads belongs to critical damping alone: its limit is 2 \
         zeta where zeta < 1.",
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
    table(["", "Pirovano table 2.4", "ours, one step", "ours, undamped", "ours, damped"], once.map(row))
}

const ACCURACY_WORDS: &str = "Table 2.4 mixes orders of one step with orders of a run. Its 4 and 2 of Verlet, and 4 and 3 of Beeman, \
    are those of the error of one step that begins with an exact history; its 1 of the Eulers is that of a run. A run of any \
    Verlet, leapfrog or Beeman is of order 2 undamped, of the position-corrected Beeman of order 3. Velocity Verlet, leapfrog and \
    the modified velocity Verlet have a position of order 3 in one step, not 4: what makes 4 of Verlet's is the history. Leapfrog's \
    and the modified velocity Verlet's velocities are of order 3 too, the latter not of 4: without damping all three are the same \
    map. With damping the force has an older velocity, or in the modified velocity Verlet one of half a step, and all but the two \
    corrected Beemans are of order 1. Pirovano does not rank these two and Clavet's; section 2.3.1 promises them 4 in position and \
    velocity, which holds for one step of the position-corrected form, and for the other's position.";
