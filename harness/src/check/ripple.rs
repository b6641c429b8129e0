//! Linear theory of a ripple on the interface of a heavy fluid over a light one (Rayleigh-Taylor instability).
use std::f64::consts::PI;

/// Rest densities below and above, kg/m3; kinematic viscosity of both fluids, m2/s; gravity, m/s2.
pub(super) const DENSITIES: [f64; 2] = [1000.0, 1800.0];
pub(super) const NU: f64 = 1.0 / 210.0;
pub(super) const GRAVITY: f64 = 1.0;

/// Depth of each fluid, m, and wave number, 1/m. The domain is one wavelength wide, which is 1 m.
pub(super) const DEPTH: f64 = 1.0;
pub(super) const WAVE_NUMBER: f64 = 2.0 * PI;

/// Returns the growth rate by the usual formula, 1/s: `sqrt(gamma^2 + nu^2 k^4) - nu k^2`, with
/// `gamma^2 = A g k tanh(k h)` and the Atwood number A.
pub(super) fn formula(nu: f64) -> f64 {
    let [below, above] = DENSITIES;
    let atwood = (above - below) / (above + below);
    let square = atwood * GRAVITY * WAVE_NUMBER * (WAVE_NUMBER * DEPTH).tanh();
    let lost = nu * WAVE_NUMBER * WAVE_NUMBER;
    (square + lost * lost).sqrt() - lost
}

/// A ripple on the interface of two deep fluids with the same kinematic viscosity (Chandrasekhar 1961, chapter 10). At
/// a distance d from the interface the upward displacement is `(a e^(-k d) + b e^(-q d)) sin(k x)`. The first part is
/// irrotational. The second part is the vorticity that viscosity spreads from the interface while the ripple grows,
/// with `q^2 = k^2 + n / nu`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Mode {
    /// Growth rate n, 1/s.
    pub(super) rate: f64,
    /// Decay q of the rotational part, 1/m.
    decay: f64,
    /// Amplitudes a and b, below and above.
    parts: [[f64; 2]; 2],
}

impl Mode {
    /// Returns the growing mode: the root of [`Mode::stress`], which falls as the rate rises.
    pub(super) fn growing(nu: f64) -> Mode {
        let (mut slow, mut fast) = (0.001 * formula(0.0), 1.001 * formula(0.0));
        for _ in 0..60 {
            let rate = f64::midpoint(slow, fast);
            if Mode::of_rate(rate, nu).stress(nu) > 0.0 {
                slow = rate;
            } else {
                fast = rate;
            }
        }
        Mode::of_rate(slow, nu)
    }

    /// Returns the motion with this rate whose velocities and shear stress are continuous across the interface.
    fn of_rate(rate: f64, nu: f64) -> Mode {
        let (k, [below, above]) = (WAVE_NUMBER, DENSITIES);
        let decay = (k * k + rate / nu).sqrt();
        // a + b = 1 on both sides; the velocity along x gives the sum of both b, and the stress gives their difference
        let sum = -2.0 * k / (decay - k);
        let b = (below * sum - 2.0 * k * k * nu * (above - below) / rate) / (above + below);
        Mode { rate, decay, parts: [sum - b, b].map(|b| [1.0 - b, b]) }
    }

    /// Returns the difference of normal stress across the interface, over the amplitude of the velocity there. A mode
    /// has none.
    fn stress(&self, nu: f64) -> f64 {
        let (k, [below, above], [[a_below, b_below], [a_above, _]]) = (WAVE_NUMBER, DENSITIES, self.parts);
        let weight = (above - below) * GRAVITY / self.rate;
        let inertia = self.rate * (below * a_below + above * a_above) / k;
        let viscous = 2.0 * nu * (above - below) * (k * a_below + self.decay * b_below);
        weight - inertia + viscous
    }

    /// Returns the displacement at a position in the fluid below (0) or above (1), for a ripple of amplitude 1. It
    /// conserves volume.
    pub(super) fn displacement(&self, [x, y]: [f64; 2], fluid: usize) -> [f64; 2] {
        let (k, [a, b]) = (WAVE_NUMBER, self.parts[fluid]);
        let up = if fluid == 1 { 1.0 } else { -1.0 };
        // a particle that has moved beyond the flat interface still belongs to its own fluid
        let d = up * (y - DEPTH);
        let (even, rotating) = (a * (-k * d).exp(), b * (-self.decay * d).exp());
        let slope = -up * (k * even + self.decay * rotating);
        [slope / k * (k * x).cos(), (even + rotating) * (k * x).sin()]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn viscosity_slows_the_mode_and_none_leaves_the_formula() {
        // a finite-element solution of the same equations, between walls, gives 1.04993
        assert!((Mode::growing(NU).rate - 1.04995).abs() < 1e-5);
        let ideal = Mode::growing(1e-9).rate;
        assert!((ideal / formula(0.0) - 1.0).abs() < 1e-3);
    }

    #[test]
    fn the_mode_keeps_volumes_and_does_not_tear() {
        let mode = Mode::growing(NU);
        for fluid in [0, 1] {
            let (at, step) = ([0.3, 1.1], 1e-5);
            let along = |axis: usize| {
                let mut beside = [at; 2];
                beside[0][axis] += step;
                beside[1][axis] -= step;
                let [after, before] = beside.map(|at| mode.displacement(at, fluid)[axis]);
                (after - before) / (2.0 * step)
            };
            assert!((along(0) + along(1)).abs() < 1e-6);
        }
        let [below, above] = [0, 1].map(|fluid| mode.displacement([0.3, DEPTH], fluid));
        assert!((below[0] - above[0]).abs() < 1e-9 && (below[1] - above[1]).abs() < 1e-9);
    }
}
