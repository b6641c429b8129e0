//! Thermal energy of each particle. Only where a scene keeps account of it.
use super::load;
use super::pairs::{Block, Job, PairPass, fold};
use crate::arithmetic::real::{Real, real, vec3};
use crate::layout::f32x4;
use crate::terms::exchange::{exchange_close, exchange_share};
use crate::terms::heat::{exchange_heat, heat_close, heat_neighbour, heat_stepped};

/// Steps `heat`, whose entries are the energy and its rate before the step.
pub(crate) struct Heat<'a> {
    /// Velocities at the end of the step: forces worked along these.
    pub ahead: &'a [f32x4],
}

impl PairPass for Heat<'_> {
    fn work(job: &mut Job<'_, Self>) {
        job.run();
    }

    #[inline(always)]
    fn block<R: Real>(&self, block: &Block<'_>, own: &mut [f32x4]) -> u32 {
        let (setup, particles) = (block.setup, block.particles);
        let (m, p, t) = (setup.model, setup.parameters, setup.tables);
        let (first, last) = (block.first, block.last);
        if m.air == 1 && super::is_dormant(p, particles.velocity[first][3]) {
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
            rate = rate + heat * exchange_close(p, shares);
        }
        let of = |i: usize| R::from_lanes(|lane| own[lane.min(last - first)][i]);
        let energy = heat_stepped(p, of(0), of(1), rate);
        for (lane, own) in own.iter_mut().enumerate() {
            // a wall keeps no account
            let velocity = particles.velocity[first + lane];
            if !super::is_wall(p, velocity[3]) {
                *own = [energy.lane(lane), rate.lane(lane), 0.0, 0.0];
            }
        }
        0
    }
}
