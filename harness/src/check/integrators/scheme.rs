//! What is compared: an integrator, with the forces evaluated once or twice a step, as a scene can ask for it.
use millpond_core::scene::Integrator;

/// An integrator and how often it evaluates forces.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Scheme {
    /// By which positions and velocities are moved.
    pub integrator: Integrator,
    /// Are forces evaluated again with the velocity at the end of the step (`Formulation::reevaluate`)?
    pub twice: bool,
}

impl Scheme {
    /// One evaluation a step.
    #[must_use]
    pub fn once(integrator: Integrator) -> Scheme {
        Scheme { integrator, twice: false }
    }

    /// All that a scene can ask for: the ten, then those that may evaluate twice.
    #[must_use]
    pub fn all() -> Vec<Scheme> {
        use Integrator::*;
        let once = Integrator::ALL.iter().copied().map(Scheme::once);
        let twice = [ModifiedVelocityVerlet, Verlet, VelocityVerlet, Leapfrog, Beeman, VelocityCorrectedBeeman];
        once.chain(twice.map(|integrator| Scheme { integrator, twice: true })).collect()
    }

    /// Its name in tables.
    #[must_use]
    pub fn name(self) -> String {
        format!("{}{}", self.integrator.name(), if self.twice { ", twice" } else { "" })
    }

    /// Order that its global error should have without damping, or with it.
    #[must_use]
    pub fn order(self, damped: bool) -> u32 {
        match (damped, self.twice) {
            (false, _) => self.integrator.order(),
            (true, false) => self.integrator.damped_order(),
            (true, true) => self.integrator.damped_order_twice(),
        }
    }
}
