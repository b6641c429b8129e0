//! One iteration of pressure: how far the next density would miss, and what mends it. Only where pressure is corrected.
use crate::arithmetic::real::{Real, less, real, select, vec3};
use crate::executor::Executor;
use crate::layout::f32x4;
use crate::passes::context::Step;
use crate::passes::lanes::{is_dormant, load, load_own};
use crate::passes::local::particles;
use crate::passes::pairs::{self, Block, Job, PairPass, fold, lists};
use crate::terms::correction::{density_miss, inverse_correction, predicted_velocity, pressure_corrected, residual};
use crate::terms::density::{continuity_neighbour, deviation_rate};
use crate::terms::kernel::if_inside;
use crate::terms::pair::{pair_scale, separation, squared_ratio};
use crate::terms::wall::{MIRRORED, mass_seen};

/// Corrects the pressures, and notes the largest miss.
pub(crate) fn run(step: &mut Step<'_, '_, impl Executor>) {
    let (particles, lists) = (particles!(step but density), lists!(step));
    let pass = PressureCorrect { acceleration: step.new.acceleration };
    let residual = pairs::run(step.setup, step.executor, particles, lists, &pass, step.new.density_pressure);
    step.found.residual = f32::from_bits(residual);
}

/// Corrects the pressures of `density_pressure`; returns the largest miss, as the bits of a number that is not negative.
struct PressureCorrect<'a> {
    acceleration: &'a [f32x4],
}

impl PairPass for PressureCorrect<'_> {
    fn work(job: &mut Job<'_, Self>) {
        job.run();
    }

    #[inline(always)]
    fn block<R: Real>(&self, block: &Block<'_>, own: &mut [f32x4]) -> u32 {
        let (setup, particles) = (block.setup, block.particles);
        let (m, p, u, t) = (setup.model, setup.parameters, setup.uniform, setup.tables);
        let (first, last) = (block.first, block.last);
        // those of a cell are all of air that is not there, or none
        let absent = m.air == 1 && is_dormant(setup.materials, particles.velocity[first][3]);
        if absent || (m.wall_particles == MIRRORED && particles.are_walls(setup, first, last)) {
            return 0;
        }
        let a = particles.receivers::<R>(setup, first, last);
        let v_a = predicted_velocity(u, a.velocity, load(self.acceleration, first, last));
        let rate = fold!(block, real::<R>(0.0), |rate, index| {
            let b = particles.neighbour::<R>(setup, index);
            let x_ab = separation(m, p, a.position, b.position);
            let scale = pair_scale(m, a.support, b.support);
            let v_ab = v_a - predicted_velocity(u, b.velocity, vec3::splat(self.acceleration[index]));
            let q2 = squared_ratio(m, p, x_ab, scale);
            let mass = mass_seen(m, a.rest, b.mass, b.rest, b.wall);
            rate + if_inside(q2, continuity_neighbour(m, p, t, x_ab, v_ab, mass, scale))
        });
        let (deviation, before) = (load_own(own, 0), load_own(own, 1));
        let k = particles.stiffness::<R>(setup, first, last);
        let rate = deviation_rate(m, p, rate, a.mass, a.rest);
        let miss = density_miss(m, p, u, before, deviation, rate, k.compressibility);
        let inverse = inverse_correction(u, k.thinning, k.offset);
        let mut after = pressure_corrected(m, before, miss, inverse);
        if m.wall_particles == MIRRORED {
            after = select(after, real(0.0), less(real(0.0), a.wall));
        }
        let left = residual(before, after, inverse);
        let mut largest = 0;
        for (lane, own) in own.iter_mut().enumerate() {
            own[1] = after.lane(lane);
            largest = largest.max(left.lane(lane).to_bits());
        }
        largest
    }
}
