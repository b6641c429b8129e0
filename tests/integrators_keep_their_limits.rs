//! Promise: an integrator is stable up to the omega dt that theory predicts, has the order of accuracy that it claims,
//! and conserves area in phase space where it claims to.
//!
//! The test system is a mass on a spring, moved by the same terms that move particles. The theory is the characteristic
//! polynomial of each scheme; the unit tests of `millpond::check::integrators::theory` check its closed forms.
//! `millpond check integrators` reports more.
use millpond::check::integrators::limits::{grows, measured};
use millpond::check::integrators::orders::global;
use millpond::check::integrators::{DAMPED, DAMPINGS, HARDENING, Scheme, area, theory};
use millpond_core::backend::arithmetic::double::Double;
use millpond_core::scene::Integrator;

/// Tolerances of the study: 1 % of a limit, 0.1 of an order.
const LIMIT_OFF: f64 = 0.01;
const ORDER_OFF: f64 = 0.1;

#[test]
fn runs_grow_beyond_the_limit_of_theory_and_not_below() {
    for scheme in Scheme::all() {
        for damping in DAMPINGS {
            let limit = theory::limit(scheme, damping);
            if limit == 0.0 {
                continue; // tested below
            }
            let name = format!("{} at zeta = {damping}", scheme.name());
            let found = [measured::<Double>(scheme, damping), measured::<f32>(scheme, damping)];
            let off = found.map(|found| (found / limit - 1.0).abs());
            assert!(off.iter().all(|off| *off < LIMIT_OFF), "{name}: {found:?}, theory {limit}");
        }
    }
}

#[test]
fn the_limits_are_known_numbers() {
    // without damping, and with critical damping; Pirovano's five stiffnesses lie between these
    let known = [
        (Integrator::ModifiedVelocityVerlet, [2.0, 0.8284]),
        (Integrator::Euler, [0.0, 2.0]),
        (Integrator::SemiImplicitEuler, [2.0, 0.8284]),
        (Integrator::Verlet, [2.0, 0.7321]),
        (Integrator::VelocityVerlet, [2.0, 0.7321]),
        (Integrator::Leapfrog, [2.0, 0.7321]),
        (Integrator::Clavet, [1.1547, 0.6667]),
        (Integrator::Beeman, [2.0, 0.5339]),
        (Integrator::VelocityCorrectedBeeman, [2.0, 0.2935]),
        (Integrator::PositionCorrectedBeeman, [0.0, 0.2604]),
    ];
    assert_eq!(known.map(|(integrator, _)| integrator), *Integrator::ALL);
    for (integrator, limits) in known {
        for (limit, damping) in limits.into_iter().zip([0.0, 1.0]) {
            let found = theory::limit(Scheme::once(integrator), damping);
            assert!((found - limit).abs() < 1e-4, "{integrator:?} at zeta = {damping}: {found}");
        }
    }
}

#[test]
fn two_of_them_grow_at_small_steps_without_damping() {
    // theory gives a growth per step of p^2 / 2 and of p^4 / 24, with p = omega dt
    for (integrator, power, share) in
        [(Integrator::Euler, 2, 0.5), (Integrator::PositionCorrectedBeeman, 4, 1.0 / 24.0)]
    {
        let scheme = Scheme::once(integrator);
        let p: f64 = 0.05;
        assert_eq!(theory::limit(scheme, 0.0), 0.0);
        let found = theory::growth(scheme, p, 0.0) - 1.0;
        assert!((found / (share * p.powi(power)) - 1.0).abs() < 0.01, "{integrator:?}: {found}");
        assert!(grows::<Double>(scheme, 0.0, 0.4), "{integrator:?}");
    }
}

#[test]
fn on_the_limit_what_grows_in_proportion_to_time_counts_as_stable() {
    // Pirovano's stiffest spring has a double root at -1
    let scheme = Scheme::once(Integrator::SemiImplicitEuler);
    assert!(!grows::<Double>(scheme, 0.0, 2.0));
    assert!(grows::<Double>(scheme, 0.0, 2.001));
}

#[test]
fn every_integrator_is_of_its_order() {
    for scheme in Scheme::all() {
        for (damping, damped) in [(0.0, false), (DAMPED, true)] {
            let (found, order) = (global(scheme, damping).both, f64::from(scheme.order(damped)));
            assert!((found - order).abs() < ORDER_OFF, "{} at zeta = {damping}: {found}, not {order}", scheme.name());
        }
    }
}

#[test]
fn the_symplectic_ones_keep_areas_and_no_others_do() {
    for integrator in Integrator::ALL.iter().copied() {
        let change = area::change(Scheme::once(integrator), HARDENING);
        let keeps = integrator.is_symplectic();
        assert!(if keeps { change < 1e-6 } else { change > 1e-3 }, "{integrator:?}: {change}");
    }
}
