//! Acceleration by the pressure of an iteration, added to all else. Only where pressure is corrected.
use crate::arithmetic::real::{Real, real, vec3};
use crate::executor::Executor;
use crate::layout::f32x4;
use crate::passes::context::Step;
use crate::passes::lanes::{load, store};
use crate::passes::local::particles;
use crate::passes::pairs::{self, Block, Job, PairPass, fold, lists};
use crate::terms::geometry::flush3;
use crate::terms::neighbour::{acceleration_close, pressure_neighbour};
use crate::terms::wall::if_free;

/// Fills the accelerations.
pub(crate) fn run(step: &mut Step<'_, '_, impl Executor>) {
    let (particles, lists) = (particles!(step), lists!(step));
    let pass = PressureForce { free: step.scratch.non_pressure_acceleration };
    pairs::run(step.setup, step.executor, particles, lists, &pass, step.new.acceleration);
}

/// Makes accelerations of `free`, those without pressure.
struct PressureForce<'a> {
    free: &'a [f32x4],
}

impl PairPass for PressureForce<'_> {
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
        let a = particles.receivers::<R>(setup, block.first, block.last);
        let nothing = vec3(real::<R>(0.0), real(0.0), real(0.0));
        let force =
            fold!(block, nothing, |force, b| force + pressure_neighbour(m, p, t, a, particles.neighbour(setup, b)));
        let free = load::<R>(self.free, block.first, block.last);
        let all = flush3(free + acceleration_close(m, p, force, a));
        store(own, core::hint::black_box(if_free(m, all, a.wall)));
        for (own, free) in own.iter_mut().zip(&self.free[block.first..]) {
            own[3] = free[3];
        }
        0
    }
}
