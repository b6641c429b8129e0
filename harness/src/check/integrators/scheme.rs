//! A scheme: an integrator with the forces evaluated once or twice per step, as a scene can ask for it.
use millpond_core::scene::Integrator;

/// An integrator, and how often it evaluates forces.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Scheme {
    /// The integrator.
    pub integrator: Integrator,
    /// Whether forces are evaluated again with the velocity at the end of the step (`Formulation::reevaluate`).
    pub twice: bool,
}

impl Scheme {
    /// Returns the scheme with one evaluation per step.
    #[must_use]
    pub fn once(integrator: Integrator) -> Scheme {
        Scheme { integrator, twice: false }
    }

    /// Returns all schemes: the ten integrators with one evaluation, then those that support a second one.
    #[must_use]
    pub fn all() -> Vec<Scheme> {
        use Integrator::*;
        let once = Integrator::ALL.iter().copied().map(Scheme::once);
        let twice = [ModifiedVelocityVerlet, Verlet, VelocityVerlet, Leapfrog, Beeman, VelocityCorrectedBeeman];
        once.chain(twice.map(|integrator| Scheme { integrator, twice: true })).collect()
    }

    /// Returns its name in tables.
    #[must_use]
    pub fn name(self) -> String {
        format!("{}{}", self.integrator.name(), if self.twice { ", twice" } else { "" })
    }

    /// Returns the order that its global error should have, without or with damping.
    #[must_use]
    pub fn order(self, damped: bool) -> u32 {
        match (damped, self.twice) {
            (false, _) => self.integrator.order(),
            (true, false) => self.integrator.damped_order(),
            (true, true) => self.integrator.damped_order_twice(),
        }
    }
}
