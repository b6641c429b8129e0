//! `integrators`: the ten of Pirovano, section 2.3.1 on its oscillators, against theory: limits of stability, orders, areas of phase
//! space, amplitudes and phases, and Pirovano's own tables 2.1 to 2.4 beside ours.
//!
//! [`oscillator`] steps a mass on a spring by core's terms, and [`theory`] says from Pirovano's equations what must come of it.
pub mod area;
pub mod limits;
pub mod orders;
pub mod oscillator;
mod plots;
pub mod scheme;
mod sweep;
mod swings;
mod tables;
pub mod theory;
mod thesis;

pub use scheme::Scheme;

use super::flow::larger;
use super::{Context, Metric, Outcome};
use crate::failure::Failure;
use millpond_core::Executor;
use millpond_core::backend::arithmetic::double::Double;
use orders::Order;
use swings::{STIFFNESSES, Swing, omega_dt};

const NAME: &str = "integrators";

/// Ratios of damping: none to critical.
pub const DAMPINGS: [f64; 4] = [0.0, 0.1, 0.5, 1.0];

/// That at which orders with damping are measured.
pub const DAMPED: f64 = 0.5;

/// How the spring stiffens on which areas are looked at, 1/m2: twice as stiff at a metre.
pub const HARDENING: f64 = 1.0;

/// Of the issue: of a limit, as a share of it; of an order.
const LIMIT_OFF: f64 = 0.01;
const ORDER_OFF: f64 = 0.1;

/// Of the growth in a step of those that are not stable from 0 on, as a share of it.
const GROWTH_OFF: f64 = 0.01;

/// Of an area that is kept, whose differences are exact to 1e-8; and how much one that is not kept must change.
const KEPT: f64 = 1e-6;
const NOT_KEPT: f64 = 1e-3;

/// Of a frequency, as a share of it: what a fit of 250 steps in f64 can be trusted with.
const FREQUENCY_OFF: f64 = 1e-6;

/// What was measured of a scheme.
struct Measured {
    scheme: Scheme,
    /// By damping: theory, runs in f64, runs in f32.
    limits: [[f64; 3]; 4],
    /// Without damping, with it, and of one step.
    orders: [Order; 3],
    /// Change of an area with a linear spring, and with one that stiffens.
    areas: [f64; 2],
    /// Pirovano's runs by stiffness, without damping and critically damped.
    undamped: Vec<Swing>,
    damped: Vec<Swing>,
}

pub(super) fn run(context: &Context) -> Result<Outcome, Failure> {
    let mut jobs: Vec<(Scheme, Option<Measured>)> = Scheme::all().into_iter().map(|scheme| (scheme, None)).collect();
    context.pool.run(&mut jobs, |(scheme, measured)| *measured = Some(measure(*scheme)));
    let all: Vec<Measured> = jobs.into_iter().filter_map(|(_, measured)| measured).collect();
    let mut figures = Vec::new();
    for one in &all {
        figures.push(Metric::below(format!("limit off theory, {}", one.scheme.name()), limit_off(one), LIMIT_OFF));
        figures.push(Metric::below(format!("order off, {}", one.scheme.name()), order_off(one), ORDER_OFF));
    }
    figures.extend(special(&all));
    if let Some(folder) = &context.folder {
        plots::draw(folder, &all)?;
        sweep::draw(folder)?;
    }
    let notes = [tables::all(&all), thesis::all(&all)].concat();
    Ok(Outcome::new(NAME, figures, notes))
}

fn measure(scheme: Scheme) -> Measured {
    let limits = DAMPINGS.map(|damping| {
        let theory = theory::limit(scheme, damping);
        // where there is none to find, growth itself is what is measured
        let none = theory == 0.0;
        let measured = if none {
            [0.0; 2]
        } else {
            [limits::measured::<Double>, limits::measured::<f32>].map(|f| f(scheme, damping))
        };
        [theory, measured[0], measured[1]]
    });
    let runs = |damping| STIFFNESSES.map(|k| Swing::of(scheme, omega_dt(k), damping)).into();
    Measured {
        scheme,
        limits,
        orders: [orders::global(scheme, 0.0), orders::global(scheme, DAMPED), orders::local(scheme)],
        areas: [area::change(scheme, 0.0), area::change(scheme, HARDENING)],
        undamped: runs(0.0),
        damped: runs(1.0),
    }
}

/// Worst miss of a limit, in both precisions, as a share of it.
fn limit_off(one: &Measured) -> f64 {
    let off = one.limits.iter().filter(|[theory, ..]| *theory > 0.0);
    off.flat_map(|[theory, double, single]| [double / theory, single / theory])
        .map(|x| (x - 1.0).abs())
        .fold(0.0, larger)
}

fn order_off(one: &Measured) -> f64 {
    let [undamped, damped, _] = one.orders;
    let off = |order: Order, damped: bool| (order.both - f64::from(one.scheme.order(damped))).abs();
    larger(off(undamped, false), off(damped, true))
}

/// What is promised of some only.
fn special(all: &[Measured]) -> Vec<Metric> {
    let once = || all.iter().filter(|one| !one.scheme.twice);
    let mut figures = Vec::new();
    for one in once().filter(|one| one.limits[0][0] == 0.0) {
        let off = one.undamped.iter().zip(STIFFNESSES).take(2).map(|(swing, k)| {
            let theory = theory::growth(one.scheme, omega_dt(k), 0.0) - 1.0;
            let [growth, _] = swing.growth_and_angle().unwrap_or([f64::NAN; 2]);
            ((growth - 1.0) / theory - 1.0).abs()
        });
        let name = format!("growth in a step off theory, {}, not stable from 0 on", one.scheme.name());
        figures.push(Metric::below(name, off.fold(0.0, larger), GROWTH_OFF));
    }
    let [kept, others] =
        [true, false].map(|kept| once().filter(move |one| one.scheme.integrator.is_symplectic() == kept));
    let most = kept.map(|one| larger(one.areas[0], one.areas[1])).fold(0.0, larger);
    let least = others.map(|one| one.areas[1]).fold(f64::INFINITY, |a, b| if a.is_nan() || a <= b { a } else { b });
    figures.push(Metric::below("change of an area, the symplectic ones", most, KEPT));
    figures.push(Metric::above("change of an area, the least of the others", least, NOT_KEPT));
    let verlets = once().filter(|one| one.scheme.integrator.is_symplectic());
    let off = verlets.flat_map(|one| one.undamped.iter().zip(STIFFNESSES).take(4)).map(|(swing, k)| {
        let p = omega_dt(k);
        let angle = swing.growth_and_angle().map_or(f64::NAN, |[_, angle]| angle);
        (angle / (2.0 * (p / 2.0).asin()) - 1.0).abs()
    });
    figures.push(Metric::below(
        "frequency off 2 asin(p / 2) / dt, the symplectic ones",
        off.fold(0.0, larger),
        FREQUENCY_OFF,
    ));
    figures
}
