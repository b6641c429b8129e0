//! A look at every number that is about to become the state: is it one, and, where the time step follows from that, how large?
use super::{Setup, kind};
use crate::arithmetic::real::vec3;
use crate::error::Quantity;
use crate::executor::{Executor, Jobs, parts, shares};
use crate::layout::{NONE, f32x4};
use crate::memory::State;
use crate::terms::time_step::{bounded_sound, bounded_square};

/// What was seen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Seen {
    /// Smallest `4 id + quantity` that is not finite, or [`NONE`].
    pub not_finite: u32,
    /// Largest squared speed, (m/s)^2. This and the next two only where the time step follows from them, else 0.
    pub fastest: f32,
    /// Largest squared acceleration, (m/s2)^2.
    pub hardest: f32,
    /// Largest speed of sound, m/s.
    pub loudest: f32,
}

impl Seen {
    const NOTHING: Seen = Seen { not_finite: NONE, fastest: 0.0, hardest: 0.0, loudest: 0.0 };

    fn and(self, other: Seen) -> Seen {
        // none of them is NaN where it counts: a step with one fails
        Seen {
            not_finite: self.not_finite.min(other.not_finite),
            fastest: self.fastest.max(other.fastest),
            hardest: self.hardest.max(other.hardest),
            loudest: self.loudest.max(other.loudest),
        }
    }
}

struct Job<'a> {
    setup: Setup<'a>,
    position: &'a [f32x4],
    velocity: &'a [f32x4],
    acceleration: &'a [f32x4],
    density_pressure: &'a [f32x4],
    heat: &'a [f32x4],
    history: &'a [f32x4],
    id: &'a [u32],
    seen: Seen,
}

/// Looks at `new`.
pub(crate) fn run(setup: Setup<'_>, executor: &impl Executor, new: &State<'_>) -> Seen {
    let mut jobs = Jobs::new();
    for slots in shares(new.id.len(), parts(executor)) {
        let job = Job {
            setup,
            position: &new.position[slots.clone()],
            velocity: &new.velocity[slots.clone()],
            acceleration: &new.acceleration[slots.clone()],
            density_pressure: &new.density_pressure[slots.clone()],
            heat: new.heat.get(slots.clone()).unwrap_or_default(),
            history: new.history.get(slots.clone()).unwrap_or_default(),
            id: &new.id[slots],
            seen: Seen::NOTHING,
        };
        let _ = jobs.push(job);
    }
    executor.run(&mut jobs, Job::look);
    jobs.iter().fold(Seen::NOTHING, |all, job| all.and(job.seen))
}

impl Job<'_> {
    /// Finds the smallest offender; sums of exponents keep the usual case, nothing wrong, free of branches.
    fn look(&mut self) {
        let adaptive = self.setup.model.adaptive == 1;
        for (i, id) in self.id.iter().enumerate() {
            let heat = self.heat.get(i).copied().unwrap_or_default();
            let history = self.history.get(i).copied().unwrap_or_default();
            let (x, v, a) = (self.position[i], self.velocity[i], self.acceleration[i]);
            let all = [x, v, a, self.density_pressure[i], heat, history];
            if !all.as_flattened().iter().fold(true, |fine, x| fine & x.is_finite()) {
                let first = all.iter().position(|a| !a.iter().all(|x| x.is_finite()));
                let quantity = first.unwrap_or(0).min(Quantity::Density as usize) as u32;
                self.seen.not_finite = self.seen.not_finite.min(4 * id + quantity);
            }
            if adaptive {
                self.measure(i);
            }
        }
    }

    fn measure(&mut self, i: usize) {
        let (m, p) = (self.setup.model, self.setup.parameters);
        let [.., sound, equation] = p.states[if m.species == 1 { kind(self.velocity[i][3]) } else { 0 }];
        let here = Seen {
            not_finite: NONE,
            fastest: bounded_square(vec3::<f32>::splat(self.velocity[i])),
            hardest: bounded_square(vec3::<f32>::splat(self.acceleration[i])),
            loudest: bounded_sound::<f32>(m, self.density_pressure[i][0], sound, equation),
        };
        self.seen = self.seen.and(here);
    }
}
