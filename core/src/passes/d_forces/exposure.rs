//! Which particles of liquid nothing covers: the gradient of the colour of all fluids together tells. Only with air.
use crate::arithmetic::real::{Real, real, vec3};
use crate::executor::Executor;
use crate::layout::f32x4;
use crate::passes::context::Step;
use crate::passes::local::particles;
use crate::passes::pairs::{self, Block, Job, PairPass, fold, lists};
use crate::terms::air::{is_bare, whole_gradient};
use crate::terms::geometry::flush3;

/// Fills the gradients.
pub(crate) fn run(step: &mut Step<'_, '_, impl Executor>) {
    let (particles, lists) = (particles!(step), lists!(step));
    pairs::run(step.setup, step.executor, particles, lists, &Exposure, step.scratch.total_colour_gradient);
}

/// The gradient of the colour of all that is there, and in w whether the particle is exposed: liquid, with nothing beside it.
struct Exposure;

impl PairPass for Exposure {
    fn work(job: &mut Job<'_, Self>) {
        job.run();
    }

    #[inline(always)]
    fn block<R: Real>(&self, block: &Block<'_>, own: &mut [f32x4]) -> u32 {
        let (setup, particles) = (block.setup, block.particles);
        let (m, p) = (setup.model, setup.parameters);
        if particles.are_walls(setup, block.first, block.last) {
            own.fill([0.0; 4]);
            return 0;
        }
        let a = particles.receivers::<R>(setup, block.first, block.last);
        let nothing = vec3(real::<R>(0.0), real(0.0), real(0.0));
        let sum = fold!(block, nothing, |sum, b| sum + whole_gradient(m, p, a, particles.neighbour(setup, b)));
        let normal = flush3(sum);
        let bare = is_bare(p, normal, a.wall, a.fluid);
        for (lane, own) in own.iter_mut().enumerate() {
            let of = |x: R| if a.wall.lane(lane) > 0.0 { 0.0 } else { x.lane(lane) };
            *own = [of(normal.x), of(normal.y), of(normal.z), of(bare)];
        }
        0
    }
}
