//! The length of a run: a number of steps or, with an adaptive time step, a simulated time.
use crate::failure::Failure;
use millpond_core::TimeReport;
use millpond_core::scene::Scene;

/// Limit of the number of steps of a run whose length is given as a time. It is about a week of steps, so a larger
/// number is taken for a mistake.
const MOST_STEPS: f64 = 1e9;

/// How long a scene runs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum RunLength {
    /// A number of steps.
    Steps(u64),
    /// Until the end of the first step after which this much time has passed, s.
    Seconds(f64),
}

impl RunLength {
    /// Returns the run length for a simulated time, s. With a fixed time step it is the nearest number of steps.
    ///
    /// # Errors
    /// A time that is negative or not a number, or one that would take 1e9 steps or more.
    pub fn of_seconds(scene: &Scene, seconds: f64) -> Result<RunLength, Failure> {
        let step = f64::from(scene.adaptive.map_or(scene.time_step, |adaptive| adaptive.largest));
        let steps = (seconds / step).round();
        if steps.is_nan() || steps < 0.0 {
            return Err(Failure::Call(format!("--time must be a non-negative number of seconds, not {seconds}")));
        }
        if steps < MOST_STEPS && scene.adaptive.is_some() {
            return Ok(RunLength::Seconds(seconds));
        }
        if steps < MOST_STEPS {
            return Ok(RunLength::Steps(steps as u64));
        }
        Err(Failure::Call(format!("{seconds} s in steps of {step} s are {steps:e} steps: use --steps")))
    }

    /// Returns the length, in steps or in seconds.
    #[must_use]
    pub fn length(self) -> f64 {
        match self {
            RunLength::Steps(steps) => steps as f64,
            RunLength::Seconds(seconds) => seconds,
        }
    }

    /// Returns how much of the length has passed, in steps or in seconds.
    #[must_use]
    pub fn passed(self, steps: u64, time: f64) -> f64 {
        match self {
            RunLength::Steps(_) => steps as f64,
            RunLength::Seconds(_) => time,
        }
    }

    /// Returns how many steps can be made at once without passing `until` (in steps or in seconds): at least one and at
    /// most `most`.
    #[must_use]
    pub fn steps_to(self, until: f64, steps: u64, time: TimeReport, scene: &Scene, most: u64) -> u64 {
        match (self, &scene.adaptive) {
            (RunLength::Seconds(_), Some(adaptive)) => {
                let (mut end, mut step, mut count) = (time.time, f64::from(time.next), 0);
                while count < most && end + step < until {
                    end += step;
                    step = (step * f64::from(adaptive.max_growth)).min(f64::from(adaptive.largest));
                    count += 1;
                }
                count.max(1)
            }
            _ => (until - steps as f64).clamp(1.0, most as f64) as u64,
        }
    }
}
