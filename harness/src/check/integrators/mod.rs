//! `integrators`: compares the ten integrators of Pirovano, section 2.3.1 with theory, on oscillators: stability
//! limits, orders, areas in phase space, amplitudes and phases. It also compares tables 2.1 to 2.4 of Pirovano with the
//! measured results.
//!
//! [`oscillator`] steps a mass on a spring with the terms of millpond_core, and [`theory`] derives the expected results
//! from Pirovano's equations.
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

/// Damping ratios zeta, from undamped to critically damped.
pub const DAMPINGS: [f64; 4] = [0.0, 0.1, 0.5, 1.0];

/// Damping ratio at which orders with damping are measured.
pub const DAMPED: f64 = 0.5;

/// Hardening of the spring with which areas are measured, 1/m2: at 1 m the spring is twice as stiff.
pub const HARDENING: f64 = 1.0;

/// Largest relative error of a stability limit, and largest error of an order.
const LIMIT_OFF: f64 = 0.01;
const ORDER_OFF: f64 = 0.1;

/// Largest relative error of the growth per step, for integrators that are unstable at the smallest time steps.
const GROWTH_OFF: f64 = 0.01;

/// Largest relative change of an area that a symplectic integrator preserves (the differences are exact to 1e-8), and
/// smallest change with the other integrators.
const KEPT: f64 = 1e-6;
const NOT_KEPT: f64 = 1e-3;

/// Largest relative error of a frequency: the accuracy of a fit to 250 steps in f64.
const FREQUENCY_OFF: f64 = 1e-6;

/// Measured results of a scheme.
struct Measured {
    scheme: Scheme,
    /// Stability limits for each damping ratio: by theory, by runs in f64, by runs in f32.
    limits: [[f64; 3]; 4],
    /// Orders without damping, with damping, and of a single step.
    orders: [Order; 3],
    /// Relative change of an area with a linear spring, and with a hardening one.
    areas: [f64; 2],
    /// Runs with Pirovano's stiffnesses, undamped and critically damped.
    undamped: Vec<Swing>,
    damped: Vec<Swing>,
}

pub(super) fn run(context: &Context) -> Result<Outcome, Failure> {
    let mut jobs: Vec<(Scheme, Option<Measured>)> = Scheme::all().into_iter().map(|scheme| (scheme, None)).collect();
    context.pool.run(&mut jobs, |(scheme, measured)| *measured = Some(measure(*scheme)));
    let all: Vec<Measured> = jobs.into_iter().filter_map(|(_, measured)| measured).collect();
    let mut figures = Vec::new();
    for one in &all {
        figures.push(Metric::below(format!("error of the limit, {}", one.scheme.name()), limit_off(one), LIMIT_OFF));
        figures.push(Metric::below(format!("error of the order, {}", one.scheme.name()), order_off(one), ORDER_OFF));
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
        // a scheme without a limit is judged by its growth per step instead
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

/// Returns the largest relative error of a stability limit, in both precisions.
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

/// Returns the figures that concern only some of the schemes.
fn special(all: &[Measured]) -> Vec<Metric> {
    let once = || all.iter().filter(|one| !one.scheme.twice);
    let mut figures = Vec::new();
    for one in once().filter(|one| one.limits[0][0] == 0.0) {
        let off = one.undamped.iter().zip(STIFFNESSES).take(2).map(|(swing, k)| {
            let theory = theory::growth(one.scheme, omega_dt(k), 0.0) - 1.0;
            let [growth, _] = swing.growth_and_angle().unwrap_or([f64::NAN; 2]);
            ((growth - 1.0) / theory - 1.0).abs()
        });
        let name = format!("error of the growth per step, {}, unstable at small steps", one.scheme.name());
        figures.push(Metric::below(name, off.fold(0.0, larger), GROWTH_OFF));
    }
    let [kept, others] =
        [true, false].map(|kept| once().filter(move |one| one.scheme.integrator.is_symplectic() == kept));
    let most = kept.map(|one| larger(one.areas[0], one.areas[1])).fold(0.0, larger);
    let least = others.map(|one| one.areas[1]).fold(f64::INFINITY, |a, b| if a.is_nan() || a <= b { a } else { b });
    figures.push(Metric::below("change of an area, symplectic integrators, largest", most, KEPT));
    figures.push(Metric::above("change of an area, other integrators, smallest", least, NOT_KEPT));
    let verlets = once().filter(|one| one.scheme.integrator.is_symplectic());
    let off = verlets.flat_map(|one| one.undamped.iter().zip(STIFFNESSES).take(4)).map(|(swing, k)| {
        let p = omega_dt(k);
        let angle = swing.growth_and_angle().map_or(f64::NAN, |[_, angle]| angle);
        (angle / (2.0 * (p / 2.0).asin()) - 1.0).abs()
    });
    figures.push(Metric::below(
        "error of the frequency against 2 asin(p / 2) / dt, symplectic integrators",
        off.fold(0.0, larger),
        FREQUENCY_OFF,
    ));
    figures
}
