//! Thermal energy of each particle. Only where a scene keeps account of it.
use crate::arithmetic::real::{Real, real, vec3};
use crate::executor::Executor;
use crate::layout::f32x4;
use crate::passes::context::Step;
use crate::passes::lanes::{is_dormant, is_wall, load, load_own};
use crate::passes::local::particles;
use crate::passes::pairs::{self, Block, Job, PairPass, fold, lists};
use crate::terms::exchange::{exchange_close, exchange_share};
use crate::terms::heat::{exchange_heat, heat_close, heat_neighbour, heat_stepped};

/// Steps the energies.
pub(crate) fn run(step: &mut Step<'_, '_, impl Executor>) {
    let (particles, lists) = (particles!(step), lists!(step));
    let pass = InternalEnergy { ahead: step.scratch.end_velocity };
    pairs::run(step.setup, step.executor, particles, lists, &pass, step.new.internal_energy);
}

/// Steps entries that are the energy and its rate before the step.
struct InternalEnergy<'a> {
    /// Velocities at the end of the step: forces worked along these.
    ahead: &'a [f32x4],
}

impl PairPass for InternalEnergy<'_> {
    fn work(job: &mut Job<'_, Self>) {
        job.run();
    }

    #[inline(always)]
    fn block<R: Real>(&self, block: &Block<'_>, own: &mut [f32x4]) -> u32 {
        let (setup, particles) = (block.setup, block.particles);
        let (m, p, u, t) = (setup.model, setup.parameters, setup.uniform, setup.tables);
        let (first, last) = (block.first, block.last);
        if m.air == 1 && is_dormant(setup.materials, particles.velocity[first][3]) {
            // as fresh as whoever is made of it next
            own.fill([p.air_heat, 0.0, 0.0, 0.0]);
            return 0;
        }
        if particles.are_walls(setup, first, last) {
            return 0;
        }
        let a = particles.receivers::<R>(setup, first, last);
        let v_a = load::<R>(self.ahead, first, last);
        let sum = fold!(block, real::<R>(0.0), |sum, index| {
            let b = particles.neighbour(setup, index);
            let v_ab = v_a - vec3::splat(self.ahead[index]);
            sum + heat_neighbour(m, p, t, a, b, v_ab)
        });
        let mut rate = heat_close(m, p, sum, a);
        if m.exchange == 1 {
            let (heat, shares) = fold!(block, (real::<R>(0.0), real::<R>(0.0)), |(heat, shares), index| {
                let b = particles.neighbour(setup, index);
                let v_ab = v_a - vec3::splat(self.ahead[index]);
                (heat + exchange_heat(m, p, a, b, v_ab), shares + exchange_share(m, p, a, b))
            });
            rate = rate + heat * exchange_close(u, shares);
        }
        let energy = heat_stepped(u, load_own(own, 0), load_own(own, 1), rate);
        for (lane, own) in own.iter_mut().enumerate() {
            // a wall keeps no account
            let velocity = particles.velocity[first + lane];
            if !is_wall(setup.materials, velocity[3]) {
                *own = [energy.lane(lane), rate.lane(lane), 0.0, 0.0];
            }
        }
        0
    }
}
