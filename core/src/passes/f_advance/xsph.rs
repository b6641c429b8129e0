//! XSPH: the velocity that each particle moves with in the next step, beside its own. Only with XSPH.
use crate::arithmetic::real::{Real, real, vec3};
use crate::executor::Executor;
use crate::layout::f32x4;
use crate::passes::context::Step;
use crate::passes::lanes::{load, store};
use crate::passes::local::particles;
use crate::passes::pairs::{self, Block, Job, PairPass, fold, lists};
use crate::terms::wall::if_free;
use crate::terms::xsph::{xsph_close, xsph_neighbour};

/// Fills `xsph_velocity`.
pub(crate) fn run(step: &mut Step<'_, '_, impl Executor>) {
    let (particles, lists) = (particles!(step), lists!(step));
    let pass = Xsph { ahead: step.scratch.end_velocity };
    pairs::run(step.setup, step.executor, particles, lists, &pass, step.new.xsph_velocity);
}

/// With the velocities at the end of the step.
struct Xsph<'a> {
    ahead: &'a [f32x4],
}

impl PairPass for Xsph<'_> {
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
