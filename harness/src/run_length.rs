//! How long a scene runs: so many steps, or, where steps change, until so many seconds have passed.
use crate::failure::Failure;
use millpond_core::TimeReport;
use millpond_core::scene::Scene;

/// More steps than anybody means who names a time: a week of them.
const MOST_STEPS: f64 = 1e9;

/// How long a scene runs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum RunLength {
    /// So many steps.
    Steps(u64),
    /// To the first step at whose end so many seconds have passed.
    Seconds(f64),
}

impl RunLength {
    /// So many seconds of a scene; of one whose steps are alike the steps that come nearest.
    ///
    /// # Errors
    /// A time that is none.
    pub fn of_seconds(scene: &Scene, seconds: f64) -> Result<RunLength, Failure> {
        let step = f64::from(scene.adaptive.map_or(scene.time_step, |adaptive| adaptive.largest));
        let steps = (seconds / step).round();
        if steps.is_nan() || steps < 0.0 {
            return Err(Failure::Call(format!("--time {seconds} is no length of time")));
        }
        if steps < MOST_STEPS && scene.adaptive.is_some() {
            return Ok(RunLength::Seconds(seconds));
        }
        if steps < MOST_STEPS {
            return Ok(RunLength::Steps(steps as u64));
        }
        Err(Failure::Call(format!("{seconds} s in steps of {step} s are {steps:e} steps: name --steps")))
    }

    /// Its length, in its own unit.
    #[must_use]
    pub fn length(self) -> f64 {
        match self {
            RunLength::Steps(steps) => steps as f64,
            RunLength::Seconds(seconds) => seconds,
        }
    }

    /// How much of it has passed, in its own unit.
    #[must_use]
    pub fn passed(self, steps: u64, time: f64) -> f64 {
        match self {
            RunLength::Steps(_) => steps as f64,
            RunLength::Seconds(_) => time,
        }
    }

    /// Steps that can be made at once and do not come beyond `until`, in its own unit: one at least, `most` at most.
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
