//! Computes the renormalised gradient of the density before the step, and the smallest eigenvalue lambda of the inverse
//! of the matrix that renormalises. Runs only where the diffusion of density, shifting or tensile control need them.
use crate::arithmetic::lanes::{Lanes, xyz};
use crate::arithmetic::real::{flush, real, vec3};
use crate::layout::f32x4;
use crate::passes::beyond::{self, Front};
use crate::passes::by_model;
use crate::passes::context::Step;
use crate::passes::field;
use crate::passes::group::{Group, fold};
use crate::passes::local::{Particles, particles};
use crate::passes::pairs::{self, Job, PairPass, cells, lists};
use crate::terms::beyond::deviation_beyond;
use crate::terms::diffusion::RENORMALISED;
use crate::terms::external::weight;
use crate::terms::geometry::flush3;
use crate::terms::pair::{density_ratio, separation};
use crate::terms::renormalisation::{
    deviation_gradient, gradient_weight, inverse_diagonal, inverse_mixed, renormalised, smallest_eigenvalue,
};

/// Fills `renormalised_gradient`.
pub(crate) fn run(step: &mut Step<'_, '_>) {
    let density_pressure = &*step.scratch.previous_density_pressure;
    let particles = Particles { density_pressure, ..particles!(step but density) };
    let (cells, lists) = (cells!(step), lists!(step));
    pairs::run(step.setup, step.executor, particles, cells, lists, &Renormalise, step.scratch.renormalised_gradient);
}

/// Computes the gradient of the density deviation, and lambda in w.
struct Renormalise;

impl PairPass for Renormalise {
    fn work(job: &mut Job<'_, Self>) {
        by_model::run(job);
    }

    #[inline(always)]
    fn group<R: Lanes>(&self, group: &Group<'_>, own: &mut [f32x4]) -> u32 {
        let (m, p, t) = (group.setup.model, group.setup.parameters, group.setup.tables);
        if group.are_walls() {
            own.fill([0.0; 4]);
            return 0;
        }
        let a = group.receivers::<R>();
        let none = real::<R>(0.0);
        let (diagonal, mixed) = if m.is_3d == 1 {
            let diagonal = fold!(group: R, is zero with itself, |slots| {
                let b = group.neighbours(slots);
                let x_ab = separation(m, p, a.position, b.position);
                let vec3 { x, y, z } = inverse_diagonal(x_ab, gradient_weight(m, p, t, a, b, x_ab));
                [x, y, z, none]
            });
            let mixed = fold!(group: R, is zero with itself, |slots| {
                let b = group.neighbours(slots);
                let x_ab = separation(m, p, a.position, b.position);
                let vec3 { x, y, z } = inverse_mixed(x_ab, gradient_weight(m, p, t, a, b, x_ab));
                [x, y, z, none]
            });
            (xyz(diagonal), xyz(mixed))
        } else {
            let [xx, yy, xy, _] = fold!(group: R, is zero with itself, |slots| {
                let b = group.neighbours(slots);
                let x_ab = separation(m, p, a.position, b.position);
                let weight = gradient_weight(m, p, t, a, b, x_ab);
                let vec3 { x, y, .. } = inverse_diagonal(x_ab, weight);
                [x, y, inverse_mixed(x_ab, weight).x, none]
            });
            (vec3(xx, yy, none), vec3(xy, none, none))
        };
        let (mut diagonal, mut mixed) = (diagonal, mixed);
        let beyond = (m.has_closed_walls == 1).then(|| beyond::of_pressure(group.setup, Front::of(a)));
        if let Some(beyond) = beyond {
            diagonal = diagonal + beyond.lever + vec3(beyond.gamma, beyond.gamma, beyond.gamma);
            mixed = mixed + beyond.lever_mixed;
        }
        let lambda = smallest_eigenvalue(m, diagonal, mixed);
        let mut gradient = vec3(none, none, none);
        if m.density_diffusion == RENORMALISED {
            let sum = fold!(group: R, is zero with itself, |slots| {
                let b = group.neighbours(slots);
                let x_ab = separation(m, p, a.position, b.position);
                let vec3 { x, y, z } = deviation_gradient(m, a, b, x_ab, gradient_weight(m, p, t, a, b, x_ab));
                [x, y, z, none]
            });
            let mut sum_beyond = vec3(none, none, none);
            if let Some(beyond) = beyond {
                let mut g = weight(m, p, group.setup.uniform, density_ratio(m, a.deviation, a.rest_ratio));
                if m.has_acceleration_field == 1 {
                    g = g + field::at(group.setup, a.position);
                }
                sum_beyond = deviation_beyond(a, beyond, g);
            }
            gradient = renormalised(m, diagonal, mixed, lambda, xyz(sum) + sum_beyond);
        }
        let vec3 { x, y, z } = flush3(gradient);
        R::rows([x, y, z, flush(lambda)], own);
        0
    }
}
