//! Pirovano's runs: a mass of 250 kg on springs of several stiffnesses for 30 s, 0.1 s a step.
use super::oscillator::{Motion, Oscillator};
use super::scheme::Scheme;
use crate::check::flow::larger;
use millpond_core::backend::arithmetic::double::Double;

/// Stiffnesses, N/m: Pirovano's.
pub(super) const STIFFNESSES: [f64; 5] = [100.0, 10_000.0, 15_000.0, 20_000.0, 100_000.0];

/// kg, m, s.
const MASS: f64 = 250.0;
pub(super) const START: f64 = 0.5;
pub(super) const TIME_STEP: f64 = 0.1;

/// Steps in 30 s, and in the last 5 s, over which an amplitude is taken.
pub(super) const STEPS: usize = 300;
pub(super) const LAST: usize = 50;

/// omega dt of a stiffness, N/m.
pub(super) fn omega_dt(stiffness: f64) -> f64 {
    (stiffness / MASS).sqrt() * TIME_STEP
}

/// A run from rest at 0.5 m.
pub(super) struct Swing {
    /// omega, 1/s.
    pub(super) oscillator: Oscillator,
    /// m, from the start on.
    pub(super) positions: Vec<f64>,
    /// m/s.
    pub(super) velocities: Vec<f64>,
}

impl Swing {
    pub(super) fn of(scheme: Scheme, omega_dt: f64, damping: f64) -> Swing {
        let (oscillator, motion) = Swing::start(scheme, omega_dt, damping);
        Swing::run(oscillator, motion)
    }

    /// Undamped, from a history of another start than a solver's: of Verlet a displacement, m, of Beeman's an acceleration,
    /// m/s2.
    pub(super) fn remembering(scheme: Scheme, omega_dt: f64, history: impl Fn(Oscillator) -> f64) -> Swing {
        let (oscillator, motion) = Swing::start(scheme, omega_dt, 0.0);
        Swing::run(oscillator, motion.remembering(history(oscillator)))
    }

    fn start(scheme: Scheme, omega_dt: f64, damping: f64) -> (Oscillator, Motion<Double>) {
        // the step is the f32 next to 0.1 s; omega makes up for it, so that omega dt is what was asked for
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

    /// Largest position of the last 5 s, over the first.
    pub(super) fn amplitude(&self) -> f64 {
        largest(self.positions.iter().skip(STEPS - LAST)) / START
    }

    /// Largest velocity of the last 5 s, over `omega x_0`.
    pub(super) fn velocity_amplitude(&self) -> f64 {
        largest(self.velocities.iter().skip(STEPS - LAST)) / (START * self.oscillator.omega)
    }

    /// Largest miss of the position, over the first.
    pub(super) fn error(&self) -> f64 {
        let times = (0..).map(|step| TIME_STEP * f64::from(step));
        let miss = |(x, t): (&f64, f64)| (x - self.oscillator.exact([START, 0.0], t)[0]).abs();
        self.positions.iter().zip(times).map(miss).fold(0.0, larger) / START
    }

    /// Growth and angle of a step, by the recurrence `x_{n+1} = 2 g cos(theta) x_n - g^2 x_{n-1}` that fits the positions best.
    /// The first ones are left out: other roots than the swing's die away there. `None` where positions follow no swing.
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
        // a swing needs two columns that differ, and complex roots
        (determinant > 1e-9 * aa * bb && cos.abs() < 1.0).then(|| [growth, cos.acos()])
    }
}

fn largest<'a>(values: impl Iterator<Item = &'a f64>) -> f64 {
    values.fold(0.0, |most, value| larger(most, value.abs()))
}
