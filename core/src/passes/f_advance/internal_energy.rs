//! Advances the internal energy of each particle. Runs only where a scene tracks internal energy.
use crate::arithmetic::lanes::{Lanes, xyz};
use crate::arithmetic::real::{less, real, select};
use crate::layout::f32x4;
use crate::passes::by_model;
use crate::passes::context::{Setup, Step};
use crate::passes::group::{Group, fold};
use crate::passes::local::{own_numbers, particles};
use crate::passes::pairs::{self, Job, PairPass, cells, lists};
use crate::terms::exchange::{exchange_close, exchange_share};
use crate::terms::internal_energy::{
    exchange_dissipation, internal_energy_close, internal_energy_neighbour, internal_energy_stepped,
};

/// Advances the internal energies.
pub(crate) fn run(step: &mut Step<'_, '_>) {
    let (particles, cells, lists) = (particles!(step), cells!(step), lists!(step));
    let pass = InternalEnergy { ahead: step.scratch.end_velocity };
    pairs::run(step.setup, step.executor, particles, cells, lists, &pass, step.new.internal_energy);
}

/// Advances entries that hold the internal energy and its rate before the step.
struct InternalEnergy<'a> {
    /// Velocities at the end of the step, with which the work of the forces is computed.
    ahead: &'a [f32x4],
}

impl PairPass for InternalEnergy<'_> {
    fn work(job: &mut Job<'_, Self>) {
        by_model::run_one_material_or_general(job);
    }

    /// Sets inactive air particles to the internal energy that new air particles start with.
    fn absent(&self, setup: &Setup<'_>, own: &mut [f32x4]) {
        own.fill([setup.parameters.air_internal_energy, 0.0, 0.0, 0.0]);
    }

    #[inline(always)]
    fn group<R: Lanes>(&self, group: &Group<'_>, own: &mut [f32x4]) -> u32 {
        let Setup { model: m, parameters: p, uniform: u, tables: t, .. } = *group.setup;
        if group.are_walls() {
            return 0;
        }
        let a = group.receivers::<R>();
        let none = real::<R>(0.0);
        let v_a = xyz(group.spread::<R>(self.ahead));
        let [sum, ..] = fold!(group: R, is zero with itself, |slots| {
            let v_ab = v_a - xyz(R::gather(self.ahead, slots));
            [internal_energy_neighbour(m, p, t, a, group.neighbours(slots), v_ab), none, none, none]
        });
        let mut rate = internal_energy_close(m, p, sum, a);
        if m.has_velocity_exchange == 1 {
            let [heat, shares, ..] = fold!(group: R, is zero with itself, |slots| {
                let b = group.neighbours(slots);
                let v_ab = v_a - xyz(R::gather(self.ahead, slots));
                [exchange_dissipation(m, p, a, b, v_ab), exchange_share(m, p, a, b), none, none]
            });
            rate = rate + heat * exchange_close(u, shares);
        }
        let [energy, rate_before, z, w] = own_numbers::<R>(own);
        let stepped = internal_energy_stepped(u, energy, rate_before, rate);
        // walls have no internal energy
        let is_wall = less(none, a.wall);
        let of = |before: R, after: R| select(after, before, is_wall);
        R::rows([of(energy, stepped), of(rate_before, rate), of(z, none), of(w, none)], own);
        0
    }
}
