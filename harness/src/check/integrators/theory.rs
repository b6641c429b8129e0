//! Theory of each scheme on an oscillator: its characteristic polynomial, derived from Pirovano, eqs. 2.29 to 2.38,
//! corrected, independently of the code of the terms, and the location of its roots.
//!
//! With `u = v dt`, `alpha = a dt^2`, `p = omega dt` and `c = 2 zeta p`, a damped spring has `alpha = -(p^2 x + c u)`.
//! Solutions that grow by a factor z per step turn a scheme into a polynomial in z. The scheme is stable if no root
//! lies outside of the unit circle.
use super::scheme::Scheme;
use millpond_core::scene::Integrator;

/// Distance outside of the unit circle at which a root still counts as on it. The slowest growth that must be detected
/// is that of the position-corrected Beeman integrator at the first value of omega dt, `p^4 / 24 = 7e-9`.
const ON_THE_CIRCLE: f64 = 1e-9;

/// Spacing and number of the values of omega dt that are tried in ascending order.
const RUNG: f64 = 0.02;
const RUNGS: u32 = 200;

/// Number of bisections of an interval.
const HALVINGS: u32 = 50;

/// Returns the coefficients of the characteristic polynomial, the highest power first.
#[must_use]
pub fn polynomial(scheme: Scheme, p: f64, damping: f64) -> Vec<f64> {
    use Integrator::*;
    let (p2, c) = (p * p, 2.0 * damping * p);
    match (scheme.integrator, scheme.twice) {
        // (z - 1) u = alpha, (z - 1) x = u
        (Euler, _) => vec![1.0, c - 2.0, 1.0 - c + p2],
        // (z - 1) u = alpha, (z - 1) x = z u; in half-step velocities the modified velocity Verlet is the same scheme
        (SemiImplicitEuler, _) | (ModifiedVelocityVerlet, false) => vec![1.0, p2 + c - 2.0, 1.0 - c],
        // (z - 1) x = z u, (z - 1) u = -p^2 (x + u) - c u
        (Clavet, _) => vec![1.0, 2.0 * p2 + c - 2.0, 1.0 - p2 - c],
        // x_{n+1} - 2 x_n + x_{n-1} = alpha_n, where alpha_n has the velocity (x_n - x_{n-2}) / 2
        (Verlet | VelocityVerlet | Leapfrog, false) => vec![1.0, p2 - 2.0 + c / 2.0, 1.0, -c / 2.0],
        // x_{n+1} - 2 x_n + x_{n-1} = alpha_n holds for both; u_n = x_{n+1} - x_n - (4 alpha_n - alpha_{n-1}) / 6
        (Beeman, false) => vec![6.0, 6.0 * p2 + 2.0 * c - 12.0, 6.0 + 3.0 * c, -6.0 * c, c],
        // here alpha_{n+1} has the velocity u_n + (3 alpha_n - alpha_{n-1}) / 2
        (VelocityCorrectedBeeman, false) => {
            vec![6.0, 6.0 * p2 + 11.0 * c - 12.0, 6.0 - 18.0 * c, 9.0 * c, -2.0 * c]
        }
        // 12 (z - 1) u = (5 z + 8 - 1 / z) alpha, (z - 1) x = u + (z + 2) alpha / 6, with alpha at the predicted
        // position and velocity
        (PositionCorrectedBeeman, _) => vec![
            12.0,
            -24.0 + 15.0 * p2 + 23.0 * c,
            12.0 - 8.0 * p2 - 39.0 * c,
            7.0 * p2 + 21.0 * c,
            -2.0 * p2 - 5.0 * c,
        ],
        // kick, drift, kick; each kick maps u to g u - h x
        (ModifiedVelocityVerlet, true) => {
            let (g, h) = (1.0 - c / 2.0, p2 / 2.0);
            vec![1.0, -(1.0 - h - h * g + g * g), g * g]
        }
        // x' = x + u + alpha / 2, u' = u + (alpha + alpha') / 2, where alpha' has the velocity u, and alpha has its own
        // velocity
        (VelocityVerlet | Leapfrog, true) => {
            let (g, h) = (1.0 - c / 2.0, p2 / 2.0);
            vec![1.0, -(2.0 - h - c - h * g), 1.0 - c + h * c / 2.0]
        }
        // alpha_n has the velocity u_n = x_n - x_{n-1} - (p^2 x_n + c u_{n-1}) / 2
        (Verlet, true) => vec![2.0, 3.0 * c + 2.0 * p2 - 4.0 - c * p2, 2.0 - 4.0 * c + c * p2, c],
        // as with one evaluation, but alpha_n and alpha_{n-1} have their own velocities, and only alpha_{n+1} has u_n
        (Beeman, true) => {
            let pc = p2 * c;
            vec![18.0, 18.0 * p2 - 36.0 + 21.0 * c - 4.0 * pc, 18.0 - 24.0 * c + 5.0 * pc, 3.0 * c - pc]
        }
        // as above, but alpha_{n+1} has the velocity u_n + (3 alpha_n - alpha_{n-1}) / 2
        (VelocityCorrectedBeeman, true) => {
            let (pc, c2) = (p2 * c, c * c);
            vec![
                18.0,
                18.0 * p2 - 36.0 + 21.0 * c - 9.0 * c2 - 4.0 * pc,
                18.0 - 24.0 * c + 12.0 * c2 - 4.0 * pc,
                3.0 * c - 3.0 * c2 + 2.0 * pc,
            ]
        }
    }
}

/// Returns whether all roots lie inside of the circle of this radius, by Jury's table: a multiple of the reversed
/// polynomial is subtracted, which lowers the degree. As long as the multiple is less than 1, the number of roots
/// inside falls by one as well. Repeat until the degree is zero.
fn inside(polynomial: &[f64], radius: f64) -> bool {
    // z = radius w maps the circle to the unit circle; a common power of the radius is left out
    let mut rest: Vec<f64> = polynomial.iter().zip(0i32..).map(|(a, power)| a / radius.powi(power)).collect();
    while let [first, .., last] = rest[..] {
        let share = last / first;
        if share.abs() >= 1.0 || share.is_nan() {
            return false;
        }
        rest = rest.iter().zip(rest.iter().rev()).map(|(a, mirrored)| a - share * mirrored).collect();
        rest.pop();
    }
    true
}

/// Returns the growth per step: the largest magnitude of a root.
#[must_use]
pub fn growth(scheme: Scheme, p: f64, damping: f64) -> f64 {
    let polynomial = polynomial(scheme, p, damping);
    // by Cauchy's bound no root is larger than 1 plus the largest ratio of another coefficient to the first
    let first = polynomial.first().copied().unwrap_or(1.0);
    let largest = polynomial.iter().skip(1).fold(0.0, |largest: f64, a| largest.max((a / first).abs()));
    halved([0.0, 1.0 + largest], |radius| inside(&polynomial, radius))[0]
}

/// Returns the largest omega dt up to which a scheme is stable, from 0 on; 0 if it is unstable at the smallest.
#[must_use]
pub fn limit(scheme: Scheme, damping: f64) -> f64 {
    let unstable = |p: f64| !inside(&polynomial(scheme, p, damping), 1.0 + ON_THE_CIRCLE);
    let mut rungs = (1..=RUNGS).map(|rung| RUNG * f64::from(rung));
    match rungs.find(|&p| unstable(p)) {
        Some(p) if p > RUNG => halved([p - RUNG, p], unstable)[1],
        Some(_) => 0.0,
        None => f64::INFINITY,
    }
}

/// Returns the interval in which `holds` becomes true, after repeated bisection.
fn halved([mut low, mut high]: [f64; 2], holds: impl Fn(f64) -> bool) -> [f64; 2] {
    for _ in 0..HALVINGS {
        let middle = f64::midpoint(low, high);
        if holds(middle) { high = middle } else { low = middle }
    }
    [low, high]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns the positive root of `a p^2 + b p = c`.
    fn positive([a, b, c]: [f64; 3]) -> f64 {
        2.0 * c / (b + (b * b + 4.0 * a * c).sqrt())
    }

    #[test]
    fn limits_are_those_in_closed_form() {
        use Integrator::*;
        for damping in [0.1, 0.5, 1.0] {
            let zeta = damping;
            let known = [
                (Euler, 2.0 * zeta),
                (SemiImplicitEuler, positive([1.0, 4.0 * zeta, 4.0])),
                (ModifiedVelocityVerlet, positive([1.0, 4.0 * zeta, 4.0])),
                (Verlet, positive([1.0, 2.0 * zeta, 2.0])),
                (VelocityVerlet, positive([1.0, 2.0 * zeta, 2.0])),
                (Leapfrog, positive([1.0, 2.0 * zeta, 2.0])),
                (Clavet, positive([3.0, 4.0 * zeta, 4.0])),
                (VelocityCorrectedBeeman, positive([3.0, 40.0 * zeta, 12.0])),
                (PositionCorrectedBeeman, positive([2.0, 11.0 * zeta, 3.0])),
            ];
            for (integrator, closed) in known {
                let found = limit(Scheme::once(integrator), damping);
                // where roots coincide, as those of Euler do at zeta = 1, a third of the digits is left
                assert!((found / closed - 1.0).abs() < 1e-5, "{integrator:?} at {damping}: {found}, {closed}");
            }
        }
        for integrator in Integrator::ALL.iter().copied() {
            let closed = match integrator {
                Euler | PositionCorrectedBeeman => 0.0,
                Clavet => 2.0 / 3f64.sqrt(),
                _ => 2.0,
            };
            let found = limit(Scheme::once(integrator), 0.0);
            assert!((found - closed).abs() < 1e-6, "{integrator:?}: {found}, {closed}");
        }
        // a numerical value, since there is no closed form
        for (damping, known) in [(0.1, 1.1615), (0.5, 0.795), (1.0, 0.5335)] {
            let found = limit(Scheme::once(Beeman), damping);
            assert!((found - known).abs() < 1e-3, "Beeman at {damping}: {found}");
        }
    }

    #[test]
    fn roots_are_found() {
        // (z - 1/2) (z + 3) (z - 2)
        let cubic = [1.0, 0.5, -6.5, 3.0];
        assert!(inside(&cubic, 3.01) && !inside(&cubic, 2.99));
        let p: f64 = 0.7;
        assert!((growth(Scheme::once(Integrator::Euler), p, 0.0) / (1.0 + p * p).sqrt() - 1.0).abs() < 1e-12);
    }
}
