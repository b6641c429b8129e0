//! Acceleration of each particle: pressure, viscosity and what acts from outside; without pressure where that is iterated
//! later.
use crate::arithmetic::real::{Real, real, vec3};
use crate::executor::Executor;
use crate::layout::f32x4;
use crate::passes::context::Step;
use crate::passes::field;
use crate::passes::lanes::store;
use crate::passes::local::particles;
use crate::passes::pairs::{self, Block, Job, PairPass, fold, lists};
use crate::terms::exchange::{exchange_close, exchange_neighbour, exchange_share};
use crate::terms::external::external_close;
use crate::terms::neighbour::{acceleration_close, force_neighbour};
use crate::terms::pair::density_ratio;
use crate::terms::wall::if_free;

/// Fills the accelerations, or those without pressure.
pub(crate) fn run(step: &mut Step<'_, '_, impl Executor>) {
    let (particles, lists) = (particles!(step), lists!(step));
    let corrects = step.setup.model.corrects_pressure();
    let out = if corrects { &mut *step.scratch.non_pressure_acceleration } else { &mut *step.new.acceleration };
    pairs::run(step.setup, step.executor, particles, lists, &Force, out);
}

/// What acts on each particle.
struct Force;

impl PairPass for Force {
    fn work(job: &mut Job<'_, Self>) {
        job.run();
    }

    #[inline(always)]
    fn block<R: Real>(&self, block: &Block<'_>, own: &mut [f32x4]) -> u32 {
        let (setup, particles) = (block.setup, block.particles);
        let (m, p, u, t) = (setup.model, setup.parameters, setup.uniform, setup.tables);
        if particles.are_walls(setup, block.first, block.last) {
            own.fill([0.0; 4]);
            return 0;
        }
        let a = particles.receivers::<R>(setup, block.first, block.last);
        let nothing = vec3(real::<R>(0.0), real(0.0), real(0.0));
        let force =
            fold!(block, nothing, |force, b| force + force_neighbour(m, p, t, a, particles.neighbour(setup, b)));
        let mut driven = acceleration_close(m, p, force, a);
        if m.exchange == 1 {
            let (change, shares) = fold!(block, (nothing, real::<R>(0.0)), |(change, shares), b| {
                let b = particles.neighbour(setup, b);
                (change + exchange_neighbour(m, p, a, b), shares + exchange_share(m, p, a, b))
            });
            driven = driven + change * exchange_close(u, shares);
        }
        if m.field == 1 {
            driven = driven + field::at(setup, a.position);
        }
        let acceleration = external_close(m, p, u, driven, a.velocity, density_ratio(m, a.deviation, a.rest));
        store(own, core::hint::black_box(if_free(m, acceleration, a.wall)));
        0
    }
}
