//! Acceleration by the curvature of the surface, added to all else. Only with a tension by curvature.
use crate::arithmetic::real::{Real, real, vec3};
use crate::executor::Executor;
use crate::layout::f32x4;
use crate::passes::context::Step;
use crate::passes::lanes::{load, load_one, load_own};
use crate::passes::local::particles;
use crate::passes::pairs::{self, Block, Job, PairPass, fold, lists};
use crate::terms::geometry::flush3;
use crate::terms::tension::{NORMAL_CURVATURE, curvature_of_normals, normal_divergence, tension_close};

/// Adds to the accelerations, or to those without pressure.
pub(crate) fn run(step: &mut Step<'_, '_, impl Executor>) {
    let (particles, lists) = (particles!(step), lists!(step));
    let corrects = step.setup.model.corrects_pressure();
    let out = if corrects { &mut *step.scratch.non_pressure_acceleration } else { &mut *step.new.acceleration };
    pairs::run(step.setup, step.executor, particles, lists, &Tension { normal: step.new.normal }, out);
}

/// Adds to the accelerations, and leaves the curvature in w.
struct Tension<'a> {
    normal: &'a [f32x4],
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
        let before = vec3(load_own(own, 0), load_own(own, 1), load_own(own, 2));
        let all = core::hint::black_box(flush3(before + pull));
        for (lane, own) in own.iter_mut().enumerate() {
            if a.wall.lane(lane) == 0.0 {
                *own = [all.x.lane(lane), all.y.lane(lane), all.z.lane(lane), curvature.lane(lane)];
            }
        }
        0
    }
}
