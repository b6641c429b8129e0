//! Acceleration by the curvature of the surface, added to all else. Only with a tension by curvature.
use super::pairs::{Block, Job, PairPass, fold};
use super::{load, load_one};
use crate::arithmetic::real::{Real, real, vec3};
use crate::layout::f32x4;
use crate::terms::geometry::flush3;
use crate::terms::tension::{NORMAL_CURVATURE, curvature_of_normals, normal_divergence, tension_close};

/// Adds to the accelerations, and leaves the curvature in w.
pub(crate) struct Tension<'a> {
    pub normal: &'a [f32x4],
}

impl PairPass for Tension<'_> {
    fn work(job: &mut Job<'_, Self>) {
        job.run();
    }

    #[inline(always)]
    fn block<R: Real>(&self, block: &Block<'_>, own: &mut [f32x4]) -> u32 {
        let (setup, particles) = (block.setup, block.particles);
        let (m, p) = (setup.model, setup.parameters);
        let (first, last) = (block.first, block.last);
        if particles.are_walls(setup, first, last) {
            return 0;
        }
        let a = particles.receivers::<R>(setup, first, last);
        let normal: vec3<R> = load(self.normal, first, last);
        let curvature = if m.tension == NORMAL_CURVATURE {
            let nothing = vec3(real::<R>(0.0), real(0.0), real(0.0));
            let sums = fold!(block, nothing, |sums, index| {
                let b = particles.neighbour(setup, index);
                sums + normal_divergence(m, p, a, b, normal, vec3::splat(self.normal[index]))
            });
            curvature_of_normals(p, normal, sums)
        } else {
            load_one(self.normal, first, last, 3)
        };
        let pull = tension_close(m, p, a, normal, curvature);
        let of = |i: usize| R::from_lanes(|lane| own[lane.min(last - first)][i]);
        let all = core::hint::black_box(flush3(vec3(of(0), of(1), of(2)) + pull));
        for (lane, own) in own.iter_mut().enumerate() {
            if a.wall.lane(lane) == 0.0 {
                *own = [all.x.lane(lane), all.y.lane(lane), all.z.lane(lane), curvature.lane(lane)];
            }
        }
        0
    }
}
