//! The oscillators of Pirovano, sections 2.3.2 and 2.3.3, stepped with the same terms as particles.
use super::scheme::Scheme;
use millpond_core::backend::arithmetic::double::Double;
use millpond_core::backend::arithmetic::real::{Real, real, vec3};
use millpond_core::backend::layout::{Model, StepUniform};
use millpond_core::backend::terms::integrate::{
    MODIFIED_VELOCITY_VERLET, history_after, history_reversed, is_beeman, moved, position_after, velocity_after,
    velocity_for_forces,
};

/// Precision in which a motion is computed.
pub trait Precision: Real {
    /// Returns the nearest number of this precision.
    fn of(x: f64) -> Self;
    /// Returns the number as f64.
    fn value(self) -> f64;
}

impl Precision for f32 {
    fn of(x: f64) -> f32 {
        x as f32
    }
    fn value(self) -> f64 {
        f64::from(self)
    }
}

impl Precision for Double {
    fn of(x: f64) -> Double {
        Double(x)
    }
    fn value(self) -> f64 {
        self.0
    }
}

/// A mass on a spring: `a = -omega^2 (1 + s x^2) x - 2 zeta omega v`.
#[derive(Clone, Copy, Debug)]
pub struct Oscillator {
    /// Frequency omega, 1/s.
    pub omega: f64,
    /// Damping ratio zeta: 0 is undamped, 1 critically damped.
    pub damping: f64,
    /// Hardening s, 1/m2: how much stiffer the spring becomes as it is stretched; 0 in Pirovano.
    pub hardening: f64,
}

impl Oscillator {
    /// Returns an oscillator with a linear spring, as in Pirovano.
    #[must_use]
    pub fn linear(omega: f64, damping: f64) -> Oscillator {
        Oscillator { omega, damping, hardening: 0.0 }
    }

    /// Returns the acceleration, m/s2.
    fn acceleration<R: Precision>(&self, x: vec3<R>, v: vec3<R>) -> vec3<R> {
        // in this order: without hardening, the square of a diverged position would overflow, and 0 times infinity is
        // NaN
        let stiffness = -(x.x * R::of(self.hardening) * x.x + 1.0) * R::of(self.omega * self.omega);
        x * stiffness - v * R::of(2.0 * self.damping * self.omega)
    }

    /// Returns the exact position, m, and velocity, m/s, `t` seconds after the given ones: Pirovano, eqs. 2.39 and
    /// 2.40, corrected, and the solution for damping ratios between them. Valid for a linear spring with `damping` from
    /// 0 to 1.
    #[must_use]
    pub fn exact(&self, [x, v]: [f64; 2], t: f64) -> [f64; 2] {
        let decay = self.damping * self.omega;
        let swing = self.omega * (1.0 - self.damping * self.damping).max(0.0).sqrt();
        let (sin, cos) = (swing * t).sin_cos();
        // sin(swing t) / swing, whose limit without oscillation is t
        let sinc = if swing > 0.0 { sin / swing } else { t };
        let fall = (-decay * t).exp();
        let push = v + decay * x;
        [fall * (x * cos + push * sinc), fall * (v * cos - (self.omega * self.omega * x + decay * v) * sinc)]
    }
}

/// An oscillator that is stepped.
#[derive(Clone, Copy, Debug)]
pub struct Motion<R> {
    oscillator: Oscillator,
    twice: bool,
    model: Model,
    uniform: StepUniform,
    x: vec3<R>,
    v: vec3<R>,
    a: vec3<R>,
    history: vec3<R>,
}

impl<R: Precision> Motion<R> {
    /// Starts a motion at a position, m, with a velocity, m/s, in the way a solver starts its particles. The time step
    /// is in s.
    #[must_use]
    pub fn start(scheme: Scheme, oscillator: Oscillator, time_step: f32, [x, v]: [f64; 2]) -> Motion<R> {
        let model = Model { integrator: scheme.integrator as u32, ..bytemuck::Zeroable::zeroed() };
        let uniform = steps_of(time_step);
        let (x, v) = (along_x(x), along_x(v));
        let a = oscillator.acceleration(x, v);
        let history = if is_beeman(&model) {
            // as in the solver: the acceleration at the position one time step earlier
            let (back, p) = (Model { integrator: MODIFIED_VELOCITY_VERLET, ..model }, steps_of(-time_step));
            oscillator.acceleration(moved(&back, &p, x, v, a, a), velocity_for_forces(&back, &p, v, a, a))
        } else {
            history_reversed(&model, &uniform, v, a, a)
        };
        Motion { oscillator, twice: scheme.twice, model, uniform, x, v, a, history }
    }

    /// Returns the motion with another history: the last displacement, m, with Verlet, or the acceleration of the step
    /// before, m/s2, with the three Beeman integrators.
    #[must_use]
    pub fn remembering(self, history: f64) -> Motion<R> {
        Motion { history: along_x(history), ..self }
    }

    /// Makes one time step.
    pub fn step(&mut self) {
        let (m, p, earlier, history) = (&self.model, &self.uniform, self.a, self.history);
        let x = moved(m, p, self.x, self.v, earlier, history);
        let v = velocity_for_forces(m, p, self.v, earlier, history);
        let a = self.oscillator.acceleration(x, v);
        self.v = velocity_after(m, p, v, a, earlier, history);
        self.x = position_after(m, p, x, a, earlier, history);
        self.history = history_after(m, p, earlier, history);
        self.a = if self.twice { self.oscillator.acceleration(self.x, self.v) } else { a };
    }

    /// Returns the position, m.
    #[must_use]
    pub fn position(&self) -> f64 {
        self.x.x.value()
    }

    /// Returns the velocity, m/s.
    #[must_use]
    pub fn velocity(&self) -> f64 {
        self.v.x.value()
    }

    /// Returns the length of `(x, v / omega)`, m: the amplitude, independent of the phase.
    #[must_use]
    pub fn amplitude(&self) -> f64 {
        self.position().hypot(self.velocity() / self.oscillator.omega)
    }
}

fn steps_of(time_step: f32) -> StepUniform {
    let (half_time_step, inverse_time_step) = (0.5 * time_step, 1.0 / time_step);
    StepUniform { time_step, half_time_step, inverse_time_step, ..bytemuck::Zeroable::zeroed() }
}

fn along_x<R: Precision>(x: f64) -> vec3<R> {
    vec3(R::of(x), real(0.0), real(0.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_exact_motion_obeys_its_equation() {
        for damping in [0.0, 0.1, 0.5, 1.0] {
            let oscillator = Oscillator::linear(3.0, damping);
            let (start, t, step) = ([0.5, -0.7], 0.8, 1e-5);
            let [before, now, after] = [t - step, t, t + step].map(|t| oscillator.exact(start, t));
            let slope = [0, 1].map(|i| (after[i] - before[i]) / (2.0 * step));
            let a = -9.0 * now[0] - 6.0 * damping * now[1];
            assert!((slope[0] - now[1]).abs() < 1e-8 && (slope[1] - a).abs() < 1e-8, "{damping}: {slope:?}");
            assert_eq!(oscillator.exact(start, 0.0), start);
        }
    }
}
