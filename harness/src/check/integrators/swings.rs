//! The runs of Pirovano, section 2.3: a mass of 250 kg on springs of several stiffnesses, 30 s in time steps of 0.1 s.
use super::oscillator::{Motion, Oscillator};
use super::scheme::Scheme;
use crate::check::flow::larger;
use millpond_core::backend::arithmetic::double::Double;

/// Stiffnesses of Pirovano, N/m.
pub(super) const STIFFNESSES: [f64; 5] = [100.0, 10_000.0, 15_000.0, 20_000.0, 100_000.0];

/// Mass, kg; position at the start, m; time step, s.
const MASS: f64 = 250.0;
pub(super) const START: f64 = 0.5;
pub(super) const TIME_STEP: f64 = 0.1;

/// Number of steps in 30 s, and in the last 5 s, over which an amplitude is taken.
pub(super) const STEPS: usize = 300;
pub(super) const LAST: usize = 50;

/// Returns omega dt for a stiffness, N/m.
pub(super) fn omega_dt(stiffness: f64) -> f64 {
    (stiffness / MASS).sqrt() * TIME_STEP
}

/// A run from rest at 0.5 m.
pub(super) struct Swing {
    /// The oscillator, with its frequency omega.
    pub(super) oscillator: Oscillator,
    /// Positions from the start on, m.
    pub(super) positions: Vec<f64>,
    /// Velocities from the start on, m/s.
    pub(super) velocities: Vec<f64>,
}

impl Swing {
    pub(super) fn of(scheme: Scheme, omega_dt: f64, damping: f64) -> Swing {
        let (oscillator, motion) = Swing::start(scheme, omega_dt, damping);
        Swing::run(oscillator, motion)
    }

    /// Makes an undamped run with another history than a solver would start with: a displacement, m, with Verlet, or an
    /// acceleration, m/s2, with the Beeman integrators.
    pub(super) fn remembering(scheme: Scheme, omega_dt: f64, history: impl Fn(Oscillator) -> f64) -> Swing {
        let (oscillator, motion) = Swing::start(scheme, omega_dt, 0.0);
        Swing::run(oscillator, motion.remembering(history(oscillator)))
    }

    fn start(scheme: Scheme, omega_dt: f64, damping: f64) -> (Oscillator, Motion<Double>) {
        // the time step is the f32 nearest to 0.1 s; omega is adjusted so that omega dt is exact
        let time_step = TIME_STEP as f32;
        let oscillator = Oscillator::linear(omega_dt / f64::from(time_step), damping);
        (oscillator, Motion::start(scheme, oscillator, time_step, [START, 0.0]))
    }

    fn run(oscillator: Oscillator, mut motion: Motion<Double>) -> Swing {
        let mut swing = Swing { oscillator, positions: Vec::new(), velocities: Vec::new() };
        for _ in 0..=STEPS {
            swing.positions.push(motion.position());
            swing.velocities.push(motion.velocity());
            motion.step();
        }
        swing
    }

    /// Returns the largest position of the last 5 s over the position at the start.
    pub(super) fn amplitude(&self) -> f64 {
        largest(self.positions.iter().skip(STEPS - LAST)) / START
    }

    /// Returns the largest velocity of the last 5 s over `omega x_0`.
    pub(super) fn velocity_amplitude(&self) -> f64 {
        largest(self.velocities.iter().skip(STEPS - LAST)) / (START * self.oscillator.omega)
    }

    /// Returns the largest error of the position over the position at the start.
    pub(super) fn error(&self) -> f64 {
        let times = (0..).map(|step| TIME_STEP * f64::from(step));
        let miss = |(x, t): (&f64, f64)| (x - self.oscillator.exact([START, 0.0], t)[0]).abs();
        self.positions.iter().zip(times).map(miss).fold(0.0, larger) / START
    }

    /// Returns growth and phase angle per step, from the recurrence `x_{n+1} = 2 g cos(theta) x_n - g^2 x_{n-1}` that
    /// fits the positions best. The first positions are left out, because other roots of the scheme decay there.
    /// Returns `None` if the positions do not oscillate.
    pub(super) fn growth_and_angle(&self) -> Option<[f64; 2]> {
        let scale = largest(self.positions.iter());
        let mut sums = [0.0; 5];
        for window in self.positions.windows(3).skip(LAST) {
            let [a, b, c] = [0, 1, 2].map(|i| window[i] / scale);
            for (sum, product) in sums.iter_mut().zip([b * b, a * b, a * a, b * c, a * c]) {
                *sum += product;
            }
        }
        let [bb, ab, aa, bc, ac] = sums;
        let determinant = bb * aa - ab * ab;
        let [sum, product] = [bc * aa - ac * ab, bc * ab - ac * bb].map(|numerator| numerator / determinant);
        let growth = product.sqrt();
        let cos = sum / (2.0 * growth);
        // an oscillation needs two independent columns, and complex roots
        (determinant > 1e-9 * aa * bb && cos.abs() < 1.0).then(|| [growth, cos.acos()])
    }
}

fn largest<'a>(values: impl Iterator<Item = &'a f64>) -> f64 {
    values.fold(0.0, |most, value| larger(most, value.abs()))
}
