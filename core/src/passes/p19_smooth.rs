//! XSPH: the velocity that each particle moves with in the next step, beside its own. Only with XSPH.
use super::pairs::{Block, Job, PairPass, fold};
use super::{load, store};
use crate::arithmetic::real::{Real, real, vec3};
use crate::layout::f32x4;
use crate::terms::wall::if_free;
use crate::terms::xsph::{xsph_close, xsph_neighbour};

/// With the velocities at the end of the step.
pub(crate) struct Smooth<'a> {
    pub ahead: &'a [f32x4],
}

impl PairPass for Smooth<'_> {
    fn work(job: &mut Job<'_, Self>) {
        job.run();
    }

    #[inline(always)]
    fn block<R: Real>(&self, block: &Block<'_>, own: &mut [f32x4]) -> u32 {
        let (setup, particles) = (block.setup, block.particles);
        let (m, p, t) = (setup.model, setup.parameters, setup.tables);
        if particles.are_walls(setup, block.first, block.last) {
            own.fill([0.0; 4]);
            return 0;
        }
        let mut a = particles.receivers::<R>(setup, block.first, block.last);
        a.velocity = load(self.ahead, block.first, block.last);
        let nothing = vec3(real::<R>(0.0), real(0.0), real(0.0));
        let sum = fold!(block, nothing, |sum, index| {
            let mut b = particles.neighbour::<R>(setup, index);
            b.velocity = vec3::splat(self.ahead[index]);
            sum + xsph_neighbour(m, p, t, a, b)
        });
        store(own, core::hint::black_box(if_free(m, xsph_close(p, sum), a.wall)));
        0
    }
}
