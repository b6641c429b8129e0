//! Inward normal of the surface of each particle's fluid, and its curvature where that follows from the same colour. Only
//! where a tension or the host needs them. With air also the gradient of the colour of all that is there.
use super::pairs::{Block, Job, PairPass, fold};
use crate::arithmetic::real::{Real, real, vec3};
use crate::layout::f32x4;
use crate::terms::air::{is_bare, whole_gradient};
use crate::terms::geometry::flush3;
use crate::terms::tension::{CURVATURE, colour_gradient, colour_laplacian, curvature_of_colour};

/// The gradient of the colour, and in w the curvature.
pub(crate) struct Normals;

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

/// The gradient of the colour of all that is there, and in w whether the particle is bare: liquid, with nothing beside it.
pub(crate) struct Bare;

impl PairPass for Bare {
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
