//! Inward normal of the surface of each particle's fluid, and its curvature where that follows from the same colour. Only
//! where a tension or the host needs them.
use crate::arithmetic::real::{Real, real, vec3};
use crate::executor::Executor;
use crate::layout::f32x4;
use crate::passes::context::Step;
use crate::passes::local::particles;
use crate::passes::pairs::{self, Block, Job, PairPass, fold, lists};
use crate::terms::geometry::flush3;
use crate::terms::tension::{CURVATURE, colour_gradient, colour_laplacian, curvature_of_colour};

/// Fills the normals.
pub(crate) fn run(step: &mut Step<'_, '_, impl Executor>) {
    let (particles, lists) = (particles!(step), lists!(step));
    pairs::run(step.setup, step.executor, particles, lists, &Normals, step.new.normal);
}

/// The gradient of the colour, and in w the curvature.
struct Normals;

impl PairPass for Normals {
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
        let none = real::<R>(0.0);
        let (sum, laplacian) = fold!(block, (vec3(none, none, none), none), |(sum, laplacian), b| {
            let b = particles.neighbour(setup, b);
            let sum = sum + colour_gradient(m, p, a, b);
            if m.tension == CURVATURE { (sum, laplacian + colour_laplacian(m, p, a, b)) } else { (sum, laplacian) }
        });
        let normal = flush3(sum);
        let curvature = if m.tension == CURVATURE { curvature_of_colour(p, normal, laplacian) } else { none };
        for (lane, own) in own.iter_mut().enumerate() {
            let of = |x: R| if a.wall.lane(lane) > 0.0 { 0.0 } else { x.lane(lane) };
            *own = [of(normal.x), of(normal.y), of(normal.z), of(curvature)];
        }
        0
    }
}
